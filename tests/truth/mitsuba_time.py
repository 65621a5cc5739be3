#!/usr/bin/env python3
"""Time to equal error: `groundglass truth` beside Mitsuba 3 on two scenes of rough glass.

The material ball in ground glass, as in the gallery, and the two etched balls. Mitsuba (scalar_rgb, `path`, as its LLVM
variants want an LLVM of their own) has the same meshes, roughness map, environment and camera. Its rough glass cannot be
smooth: the clear parts of the etching have alpha 0.01 there; and the cloth is its `principled`.

Each draws every scene with SEEDS seeds. Printed per scene and renderer:

  mean      over the picture
  relMSE    variance of a pixel / (mean² + 0.01), over pixels and channels, 1 %-trimmed
  seconds   of processor time for one picture; ours with loading it, a third of a second
  equal     relMSE x seconds: time for a relMSE of 1; and how many times ours it is

It needs `pip install mitsuba numpy` (in an environment of its own) and a built groundglass:

  tests/truth/mitsuba_time.py --groundglass build/groundglass -o DIR [--spp N] [--mitsuba-spp N] [ball|etched...]
"""
import argparse
import resource
import subprocess
import sys
import time
from pathlib import Path

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")  # before anything else of Mitsuba's is used

from against_mitsuba.environment import for_mitsuba, read_map
from against_mitsuba.glb import read_glb
from against_mitsuba.places import ROOT
from against_mitsuba.theirs import write_ply

WIDTH, HEIGHT, SEEDS = 100, 75, 4
# What Mitsuba gives for smooth glass among rough: a width whose lobe is narrower than a texel of the environment.
LEAST_ALPHA = 0.01
SCENES = {
    "ball": {
        "file": "shaderball.glb", "environment": "royal_esplanade_1k.hdr", "turn": 0, "material": "*=glass,alpha=0.1",
        "eye": [2.3, 2.3, 3.7], "target": [-0.03, 1.02, 0], "fovy": 33,
    },
    "etched": {
        "file": "etched.glb", "environment": "studio_small_03_1k.hdr", "turn": 90, "material": None,
        "eye": [0, 1.0, 4.2], "target": [0, 0.5, 0], "fovy": 24,
    },
}


def ours(binary, scene, directory, spp):
    triple = lambda v: ",".join(str(x) for x in v)
    pictures, seconds = [], 0.0
    for seed in range(SEEDS):
        out = directory / f"ours{seed}.exr"
        command = [binary, "truth", ROOT / "assets/scenes" / scene["file"], "-o", out, "--size", f"{WIDTH}x{HEIGHT}"]
        command += ["--env", ROOT / "assets/environments" / scene["environment"], "--env-rotation", scene["turn"]]
        command += ["--eye", triple(scene["eye"]), "--target", triple(scene["target"]), "--fovy", scene["fovy"]]
        command += ["--spp", spp, "--seed", seed]
        if scene["material"]:
            command += ["--material", scene["material"]]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([str(c) for c in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds += after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        bitmap = mi.Bitmap(str(out))
        fields = [f.name for f in bitmap.struct_()]
        pictures.append(np.array(bitmap, dtype=np.float64)[..., [fields.index(c) for c in "RGB"]])
    return np.stack(pictures), seconds / SEEDS


def bsdf_of(name, images):
    if name == "Cloth":
        return {
            "type": "principled", "base_color": {"type": "rgb", "value": [0.012, 0.012, 0.015]}, "roughness": 1.0, "specular": 0.5,
        }
    glass = {"type": "roughdielectric", "int_ior": 1.5, "ext_ior": 1.0, "distribution": "ggx", "alpha": 0.1}
    if not images:
        return glass
    roughness = images[0]  # grey
    alpha = np.maximum(roughness**2, LEAST_ALPHA).astype(np.float32)
    glass["alpha"] = {"type": "bitmap", "bitmap": mi.Bitmap(alpha[..., None]), "raw": True}
    glass["distribution"] = "beckmann" if "Beckmann" in name else "ggx"
    return glass


def mitsubas(scene, directory, spp):
    parts, images = read_glb(ROOT / "assets/scenes" / scene["file"])
    picture = read_map(ROOT / "assets/environments" / scene["environment"], np.inf)
    picture = np.roll(picture, -round(scene["turn"] / 360 * picture.shape[1]), axis=1)
    loaded = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": -1, "rr_depth": 5},
        "sensor": {
            "type": "perspective", "fov": scene["fovy"], "fov_axis": "y",
            "to_world": mi.ScalarTransform4f().look_at(scene["eye"], scene["target"], [0, 1, 0]),
            "film": {
                "type": "hdrfilm", "width": WIDTH, "height": HEIGHT, "rfilter": {"type": "box"}, "pixel_format": "rgb",
                "component_format": "float32",
            },
            "sampler": {"type": "independent", "sample_count": spp},
        },
        "environment": {"type": "envmap", "bitmap": mi.Bitmap(for_mitsuba(picture))},
    }
    for i, (name, mesh) in enumerate(parts):
        path = directory / f"part{i}.ply"
        write_ply(path, mesh)
        loaded[f"part{i}"] = {"type": "ply", "filename": str(path), "bsdf": bsdf_of(name, images)}
    loaded = mi.load_dict(loaded)
    start = time.process_time()
    pictures = [np.array(mi.render(loaded, seed=1 + s), dtype=np.float64) for s in range(SEEDS)]
    return np.stack(pictures), (time.process_time() - start) / SEEDS


def relative_variance(pictures):
    values = (pictures.var(0, ddof=1) / (pictures.mean(0) ** 2 + 0.01)).mean(-1).ravel()
    return np.sort(values)[: int(0.99 * len(values))].mean()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--groundglass", default=str(ROOT / "build/groundglass"))
    parser.add_argument("-o", "--output", required=True, type=Path)
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--mitsuba-spp", type=int, help="as --spp if not given")
    parser.add_argument("scenes", nargs="*", choices=[[], *SCENES], help="all without")
    arguments = parser.parse_args()
    for name in arguments.scenes or SCENES:
        directory = arguments.output / name
        directory.mkdir(parents=True, exist_ok=True)
        a, ours_seconds = ours(arguments.groundglass, SCENES[name], directory, arguments.spp)
        b, theirs_seconds = mitsubas(SCENES[name], directory, arguments.mitsuba_spp or arguments.spp)
        np.savez(directory / "pictures.npz", ours=a.mean(0), mitsuba=b.mean(0))
        our_time = relative_variance(a) * ours_seconds
        for who, pictures, seconds in (("ours", a, ours_seconds), ("Mitsuba", b, theirs_seconds)):
            equal = relative_variance(pictures) * seconds
            print(
                f"{name:7} {who:8} mean {pictures.mean():.4f}  relMSE {relative_variance(pictures):.5f}"
                f"  {seconds:6.1f} s  equal {equal:.4f}, {equal / our_time:.2f} x ours",
                flush=True,
            )
    return 0


if __name__ == "__main__":
    sys.exit(main())
