#!/usr/bin/env python3
"""Does `groundglass truth` agree with Mitsuba 3, which knows nothing of our code?

The same meshes (written as glTF for us and as PLY for Mitsuba), the same environment, the same
camera; Mitsuba's own roughdielectric, dielectric, roughconductor, diffuse and homogeneous medium.
Both pictures carry their standard error per pixel: ours from the file, Mitsuba's from BATCHES
independent renders. Printed per scene:

  mean      mean radiance of the object's pixels, ours over Mitsuba's less 1, with the standard error
            of that difference
  rms Z     root mean square over pixels and channels of difference / its standard error: 1 if both
            are right and their errors too
  |Z| > 4   fraction of values; 6e-5 if Z were exactly normal

It needs `pip install mitsuba numpy` (in an environment of its own) and a built groundglass:

  tests/truth/mitsuba_scenes.py --groundglass build/groundglass -o DIR [--spp N] [--mitsuba-spp N] [--size N] [--seed N] [SCENE...]

Exit code 1 if a mean is off by more than 0.5 % and four standard errors, or Z says that pixels
differ by more than their noise.
"""
import argparse
import sys
import time
from pathlib import Path

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")  # before anything else of Mitsuba's is used

from against_mitsuba.environment import read_map
from against_mitsuba.ours import ours
from against_mitsuba.places import ROOT
from against_mitsuba.scenes import scenes
from against_mitsuba.theirs import BATCHES, mitsubas

# Seen through glass, the environment is clipped here, for both: light that only chance finds makes
# pixels whose noise no number of samples that one waits for describes. Metals see all of it.
CLIP = 4.0
# Of rms Z: pixels' standard errors are themselves estimates, and radiance is skewed.
Z_LIMIT = 1.25
FAR_LIMIT = 5e-3


def compare(a, ea, b, eb, ids):
    inside = ids > 0
    a, ea, b, eb = a[inside], ea[inside], b[inside], eb[inside]
    variance = ea**2 + eb**2
    known = variance > 0
    z = (a - b)[known] / np.sqrt(variance[known])
    mean = a.mean() / b.mean() - 1
    error = np.sqrt(variance.sum()) / a.size / b.mean() * np.sqrt(3)  # channels err together
    # Of a Student's t of n degrees of freedom the mean square is n / (n - 2); what counts here is a
    # mixture with our own, better known error.
    return mean, error, np.sqrt((z**2).mean()), (np.abs(z) > 4).mean(), inside.sum()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--groundglass", default=str(ROOT / "build/groundglass"))
    parser.add_argument("-o", "--output", required=True, type=Path)
    parser.add_argument("--spp", type=int, default=1024, help=f"a multiple of {BATCHES}")
    parser.add_argument("--mitsuba-spp", type=int, help="as --spp if not given")
    parser.add_argument("--seed", type=int, default=0, help="ours")
    parser.add_argument("--size", type=int, default=128)
    parser.add_argument("scenes", nargs="*", help="parts of names; all without")
    arguments = parser.parse_args()

    print(f"{'scene':38} {'pixels':>6}  {'mean':>17}  {'rms Z':>6}  {'|Z| > 4':>8}  {'ours':>7}  {'Mitsuba':>7}")
    good = True
    for name, (objects, camera, environment) in scenes().items():
        if arguments.scenes and not any(part in name for part in arguments.scenes):
            continue
        directory = arguments.output / name.replace(" ", "-")
        directory.mkdir(parents=True, exist_ok=True)
        picture = read_map(environment, np.inf if name.startswith("gold") else CLIP)
        mi.Bitmap(picture.astype(np.float32)).write(str(directory / "environment.exr"))
        start = time.time()
        a, ea, ids = ours(
            arguments.groundglass, directory, objects, camera, directory / "environment.exr", arguments.size, arguments.spp,
            arguments.seed,
        )
        middle = time.time()
        b, eb = mitsubas(directory, objects, camera, picture, arguments.size, arguments.mitsuba_spp or arguments.spp)
        end = time.time()
        np.savez(directory / "pictures.npz", ours=a, ours_error=ea, mitsuba=b, mitsuba_error=eb, ids=ids)
        mean, error, rms, far, pixels = compare(a, ea, b, eb, ids)
        bad = (abs(mean) > 0.005 and abs(mean) > 4 * error) or rms > Z_LIMIT or far > FAR_LIMIT
        good = good and not bad
        print(
            f"{name:38} {pixels:6d}  {100 * mean:+7.3f} +- {100 * error:.3f} %  {rms:6.3f}  {far:8.5f}"
            f"  {middle - start:6.1f}s  {end - middle:6.1f}s{'  DIFFERS' if bad else ''}",
            flush=True,
        )
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
