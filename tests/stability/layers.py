#!/usr/bin/python3
"""Layers in their hard cases, in float32 and double, against 77 digits: brushing (D V of GGX with two widths), the reflectance of a
thin film (green), a coat's share and what it lets pass. Directions are taken as they are given; a reflectance below a thousandth counts as one.

    layers.py BUILD            the table
    layers.py BUILD --check    what ctest runs, on every tenth case: p99 in float32 within max(2e-6, 4 x noise), in double within max(1e-12, 1e-6 x noise)

noise: what half an ulp of float32 on each input does to the exact answer.
"""
import csv
import os
import subprocess
import sys

from mpmath import cos, exp, mp, mpf, pi, sqrt

mp.dps = 77


def brushing(x, y, z, u, v, w, along, across):
    def g1(a):
        return 2 / (1 + sqrt(1 + ((along * a[0]) ** 2 + (across * a[1]) ** 2) / a[2] ** 2))

    i, o = (x, y, z), (u, v, w)
    h = [a + b for a, b in zip(i, o)]
    length = sqrt(sum(c * c for c in h))
    h = [c / length for c in h]
    d = 1 / (pi * along * across * ((h[0] / along) ** 2 + (h[1] / across) ** 2 + h[2] ** 2) ** 2)
    return d * g1(i) * g1(o) / (4 * i[2] * o[2])


# Green of linear Rec.709 from the Gaussians of X, Y and Z, as shaders/bsdf/thin_film.glsl states them.
def green(opd):
    k = 2 * pi * opd
    gauss = lambda m, s: cos(mpf(m) * k) * exp(-mpf(s) * k * k)
    x = mpf("0.8462") * gauss("1.6810e6", "4.3278e9") + mpf("0.1538") * gauss("2.2399e6", "4.5282e9")
    y, z = gauss("1.7953e6", "9.3046e9"), gauss("2.2084e6", "6.6121e9")
    return mpf("-1.022107") * x + mpf("1.978286") * y + mpf("0.043821") * z


def film(c, ior, thickness, f0):
    r0 = sqrt(f0)
    base = (1 + r0) / (1 - r0)
    sin2 = 1 - c * c
    inner, below = sqrt(1 - sin2 / ior**2), sqrt(1 - sin2 / base**2)
    opd = 2 * ior * thickness * inner / 10**9
    fringes = [green(m * opd) for m in (1, 2, 3)]

    def of(a, b):
        q = -a * b
        return 1 - (1 - a * a) * (1 - b * b) / (1 - q * q) * (1 + 2 * sum(q ** (m + 1) * f for m, f in enumerate(fringes)))

    across = of((c - ior * inner) / (c + ior * inner), (ior * inner - base * below) / (ior * inner + base * below))
    within = of((ior * c - inner) / (ior * c + inner), (base * inner - ior * below) / (base * inner + ior * below))
    return min(max((across + within) / 2, 0), 1)  # three orders of interference leave the range


def coat(c, strength):
    t = sqrt(1 - (1 - c * c) / mpf("2.25"))
    s, p = (c - mpf("1.5") * t) / (c + mpf("1.5") * t), (mpf("1.5") * c - t) / (mpf("1.5") * c + t)
    return strength * (s * s + p * p) / 2


def passes(c, strength):
    return 1 - coat(c, strength)


TRUTH = {"passes": (passes, 2), "brushing": (brushing, 8), "film": (film, 4), "coat": (coat, 2)}


def half_ulp(x):
    return abs(x) * mpf(2) ** -24


def percentile(values, p):
    values = sorted(values)
    return values[min(int(p * len(values)), len(values) - 1)]


def main():
    build = sys.argv[1]
    out = os.path.join(build, "test-output", "stability", "layers.csv")
    os.makedirs(os.path.dirname(out), exist_ok=True)
    subprocess.run([os.path.join(build, "tests", "stability", "stability_layers"), out], check=True)
    errors = {}
    with open(out, newline="") as file:
        for place, row in enumerate(csv.DictReader(file)):
            if "--check" in sys.argv and place % 10 != 0:
                continue  # a tenth: the digits take their time
            formula, count = TRUTH[row["kind"]]
            inputs = [mpf(row[f"i{k}"]) for k in range(count)]
            exact = formula(*inputs)
            scale = abs(exact) if row["kind"] in ("brushing", "passes") else max(exact, mpf("1e-3"))
            noise = 0
            for k, x in enumerate(inputs):
                if row["kind"] in ("coat", "passes") and k == 1:
                    continue  # strength 1
                moved = inputs[:k] + [x - half_ulp(x)] + inputs[k + 1:]
                noise += abs(formula(*moved) - exact) / scale
            of = errors.setdefault(row["class"], ([], [], []))
            of[0].append(float(noise))
            of[1].append(float(abs(mpf(row["float"]) - exact) / scale))
            of[2].append(float(abs(mpf(row["double"]) - exact) / scale))
    bad = []
    print("| class | noise p99 | float median | p99 | max | double max |\n|---|---|---|---|---|---|")
    for name, (noise, single, double) in errors.items():
        n, p99 = percentile(noise, 0.99), percentile(single, 0.99)
        print(f"| {name} | {n:.1e} | {percentile(single, 0.5):.1e} | {p99:.1e} | {max(single):.1e} | {max(double):.1e} |")
        if not p99 <= max(2e-6, 4 * n) or not max(double) <= max(1e-12, 1e-6 * max(noise)):
            bad.append(name)
    if "--check" in sys.argv and bad:
        sys.exit("over the limit: " + ", ".join(bad))


if __name__ == "__main__":
    main()
