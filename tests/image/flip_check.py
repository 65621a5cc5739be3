#!/usr/bin/env python3
"""Compares the program's FLIP with NVIDIA's flip-evaluator. Run on demand, outside the ordinary tests:

    python3 -m venv VENV && VENV/bin/pip install flip-evaluator numpy
    VENV/bin/python tests/image/flip_check.py build/groundglass [TEST REFERENCE ...]

Always over the pictures of formulas.h; further pairs of 8-bit PNG files may be named. Prints both means and the
largest difference between the means, and exits 1 if that is over 1e-3.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import flip_evaluator
import numpy as np

WIDTH, HEIGHT = 96, 72
NAMES = ["gradient", "checker", "noise", "colours", "bright"]


def scattered(x, y, c, salt):
    m = np.uint64(0xFFFFFFFF)
    x, y, c = (np.asarray(v, dtype=np.uint64) for v in (x, y, c))
    v = (x * np.uint64(73856093) & m) ^ (y * np.uint64(19349663) & m) ^ (c * np.uint64(83492791) & m)
    v ^= np.uint64(salt * 2654435761 & 0xFFFFFFFF)
    v = (v ^ (v >> np.uint64(15))) * np.uint64(2246822519) & m
    v = (v ^ (v >> np.uint64(13))) * np.uint64(3266489917) & m
    return ((v ^ (v >> np.uint64(16))) >> np.uint64(8)) / 16777216.0


def formula_pair(name):
    y, x, c = np.meshgrid(np.arange(HEIGHT), np.arange(WIDTH), np.arange(3), indexing="ij")
    u, v = x / 95.0, y / 71.0
    ramp = np.where(c == 0, u, np.where(c == 1, v, 0.25))
    if name == "gradient":
        r = ramp
        t = ramp * 0.9 + np.where(c == 0, 0.03, 0.0)
    elif name == "checker":
        r = np.where((x // 6 + y // 6) % 2 == 0, 0.8, 0.05)
        t = np.where(((x + 2) // 6 + y // 6) % 2 == 0, 0.8, 0.05)
    elif name == "noise":
        r = 0.1 + 0.6 * ramp
        t = r + 0.2 * (scattered(x, y, c, 1) - 0.5)
    elif name == "colours":
        r = ((x // 12 % 8) >> c & 1).astype(float)
        t = np.where(c == y // 24, 1.0 - r, r)
    else:
        r = np.where(x == 40, 5.0, 4.0 * u * v)
        t = 3.5 * u * v
    return t.astype(np.float32), r.astype(np.float32)


def write_pfm(path, image):
    with open(path, "wb") as out:
        out.write(b"PF\n%d %d\n-1.0\n" % (image.shape[1], image.shape[0]))
        out.write(image[::-1].astype("<f4").tobytes())


def encoded(linear):
    v = np.clip(linear.astype(np.float64), 0.0, 1.0)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055).astype(np.float32)


def ours(program, test, reference):
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        subprocess.run([program, "compare", test, reference, "--json", out.name], check=True,
                       stdout=subprocess.DEVNULL)
        return json.load(open(out.name))["frame"]["flip"]


def theirs(test, reference):
    return flip_evaluator.evaluate(reference, test, "LDR", applyMagma=False, parameters={"ppd": 67.0})[1]


def main():
    program, pairs = sys.argv[1], list(zip(sys.argv[2::2], sys.argv[3::2]))
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        rows = []
        for name in NAMES:
            t, r = formula_pair(name)
            paths = [str(Path(folder) / f"{name}-{which}.pfm") for which in ("test", "reference")]
            write_pfm(paths[0], t)
            write_pfm(paths[1], r)
            rows.append((name, ours(program, *paths), theirs(encoded(t), encoded(r))))
        for test, reference in pairs:
            rows.append((Path(test).name, ours(program, test, reference), theirs(test, reference)))
        print(f"{'pair':<24} {'groundglass':>12} {'NVIDIA':>12} {'difference':>12}")
        for name, mine, other in rows:
            worst = max(worst, abs(mine - other))
            print(f"{name:<24} {mine:12.6f} {other:12.6f} {mine - other:12.2e}")
    print(f"largest difference {worst:.2e}")
    return 1 if worst > 1e-3 else 0


if __name__ == "__main__":
    sys.exit(main())
