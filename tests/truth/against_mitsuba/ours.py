"""A picture by groundglass truth: colour, standard error, object ids."""
import subprocess

import mitsuba as mi
import numpy as np

from .gltf import write_gltf


def ours(binary, directory, objects, camera, environment, size, spp, seed):
    write_gltf(directory / "scene.gltf", objects)
    out = directory / "ours.exr"
    triple = lambda v: ",".join(str(x) for x in v)
    command = [binary, "truth", directory / "scene.gltf", "-o", out, "--size", f"{size}x{size}", "--spp", spp]
    command += ["--env", environment, "--eye", triple(camera["eye"]), "--target", triple(camera["target"])]
    command += ["--fovy", camera["fovy"], "--seed", seed]
    subprocess.run([str(c) for c in command], check=True, stdout=subprocess.DEVNULL)
    bitmap = mi.Bitmap(str(out))
    fields = [f.name for f in bitmap.struct_()]
    values = np.array(bitmap, dtype=np.float64)
    pick = lambda names: np.stack([values[..., fields.index(n)] for n in names], -1)
    return pick(["R", "G", "B"]), pick(["stderr.R", "stderr.G", "stderr.B"]), values[..., fields.index("id")]
