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
import json
import subprocess
import sys
import time
from pathlib import Path

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")

ROOT = Path(__file__).resolve().parents[2]
ENVIRONMENTS = sorted((ROOT / "assets/environments").glob("*.hdr"))
BATCHES = 32  # renders of Mitsuba, from whose scatter its error is known to 1 / sqrt(2 * 31)
GOLD = {"n": [0.14, 0.43, 1.38], "k": [3.697, 2.455, 1.914]}  # of our preset `gold`
# Seen through glass, the environment is clipped here, for both: light that only chance finds makes
# pixels whose noise no number of samples that one waits for describes. Metals see all of it.
CLIP = 4.0
# Of rms Z: pixels' standard errors are themselves estimates, and radiance is skewed.
Z_LIMIT = 1.25
FAR_LIMIT = 5e-3


# Meshes: (positions, normals, triangles)


def ball(centre, radius, rings):
    theta, phi = np.meshgrid(
        np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings + 1), indexing="ij"
    )
    n = np.stack([np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)], -1)
    n = n.reshape(-1, 3)
    at = lambda i, j: i * (2 * rings + 1) + j
    i, j = [a.ravel() for a in np.meshgrid(np.arange(rings), np.arange(2 * rings), indexing="ij")]
    upper = np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], -1)[i > 0]
    lower = np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], -1)[i < rings - 1]
    return np.array(centre) + radius * n, n, np.concatenate([upper, lower])


def flat(triangles):
    """Each triangle (an n x 3 x 3 array) with its own corners and normal."""
    t = np.asarray(triangles, float)
    n = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    return t.reshape(-1, 3), np.repeat(n, 3, axis=0), np.arange(3 * len(t)).reshape(-1, 3)


def rectangle(centre, x, y):
    c, x, y = np.array(centre, float), np.array(x, float), np.array(y, float)
    a, b, d, e = c - x - y, c + x - y, c + x + y, c - x + y
    return [[a, b, d], [a, d, e]]


def box(centre, half):
    faces = []
    for axis in range(3):
        for side in (-1, 1):
            out, x, y = np.zeros(3), np.zeros(3), np.zeros(3)
            out[axis] = side * half[axis]
            x[(axis + 1) % 3] = side * half[(axis + 1) % 3]
            y[(axis + 2) % 3] = half[(axis + 2) % 3]
            faces += rectangle(np.array(centre) + out, x, y)
    return flat(faces)


def checkers(n, tile, z, parity):
    tiles = []
    for i in range(n):
        for j in range(n):
            if (i + j) % 2 == parity:
                centre = [(i - (n - 1) / 2) * tile, (j - (n - 1) / 2) * tile, z]
                tiles += rectangle(centre, [tile / 2, 0, 0], [0, tile / 2, 0])
    return flat(tiles)


def join(meshes):
    offset, p, n, t = 0, [], [], []
    for mesh in meshes:
        p.append(mesh[0])
        n.append(mesh[1])
        t.append(mesh[2] + offset)
        offset += len(mesh[0])
    return np.concatenate(p), np.concatenate(n), np.concatenate(t)


def suzanne():
    """The model's triangles, flat: Mitsuba and we treat shading normals that disagree with the
    triangle differently, and that is not what is compared here."""
    directory = ROOT / "assets/scenes/Suzanne"
    gltf = json.loads((directory / "Suzanne.gltf").read_text())
    data = (directory / gltf["buffers"][0]["uri"]).read_bytes()

    def accessor(index, dtype, width):
        a = gltf["accessors"][index]
        view = gltf["bufferViews"][a["bufferView"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        return np.frombuffer(data, dtype, a["count"] * width, start).reshape(-1, width)

    primitive = gltf["meshes"][0]["primitives"][0]
    positions = accessor(primitive["attributes"]["POSITION"], np.float32, 3)
    width = {5123: np.uint16, 5125: np.uint32}[gltf["accessors"][primitive["indices"]]["componentType"]]
    triangles = positions[accessor(primitive["indices"], width, 1).reshape(-1, 3).astype(int)]
    size = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    return flat(triangles[size > 0])


# Materials, for both


def glass(alpha, distribution="ggx", color=None, distance=None):
    gltf = {
        "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
        "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1},
            "KHR_materials_volume": {"thicknessFactor": 1},
            "KHR_materials_ior": {"ior": 1.5},
        },
        "extras": {"groundglass": {"alpha": alpha, "distribution": distribution}},
    }
    bsdf = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}
    if alpha > 0:
        bsdf = {"type": "roughdielectric", "int_ior": 1.5, "ext_ior": 1.0, "alpha": alpha, "distribution": distribution}
    interior = None
    if color:
        gltf["extensions"]["KHR_materials_volume"] |= {"attenuationColor": color, "attenuationDistance": distance}
        interior = [float(s) for s in -np.log(color) / distance]  # absorption per metre, of each channel
    return {"gltf": gltf, "bsdf": bsdf, "interior": interior}


def diffuse(grey):
    # specularFactor 0: a coat that reflects nothing, so Lambert's law alone.
    return {
        "gltf": {
            "pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [grey, grey, grey, 1]},
            "extensions": {"KHR_materials_specular": {"specularFactor": 0}},
        },
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": grey}},
        "interior": None,
    }


def gold(alpha, distribution="ggx"):
    # Seen and met from both sides: the model has holes, and what is behind them must be the same.
    return {
        "gltf": {"doubleSided": True, "extras": {"groundglass": {"preset": "gold", "alpha": alpha, "distribution": distribution}}},
        "bsdf": {
            "type": "twosided",
            "bsdf": {
                "type": "roughconductor",
                "alpha": alpha,
                "distribution": distribution,
                "eta": {"type": "rgb", "value": GOLD["n"]},
                "k": {"type": "rgb", "value": GOLD["k"]},
            },
        },
        "interior": None,
    }


# Scenes: a list of (mesh, material), a camera, an environment


def scenes():
    camera = {"eye": [0, 0, 9], "target": [0, 0, 0], "fovy": 40}
    rings = 160
    alphas = [0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0]
    grid = [
        (ball([2.0 * (i % 3 - 1), 2.0 * (1 - i // 3), 0], 0.85, rings), glass(alpha))
        for i, alpha in enumerate(alphas)
    ]
    beckmann = [
        (ball([2.0 * (i % 3 - 1), 2.0 * (1 - i // 3), 0], 0.85, rings), glass(alpha, "beckmann"))
        for i, alpha in enumerate(alphas)
    ]
    board = [(checkers(8, 1.0, -1.5, 0), diffuse(0.8)), (checkers(8, 1.0, -1.5, 1), diffuse(0.1))]
    slabs = [
        (box([2.0 * i, 0, 0], [0.9, 2.4, 0.15]), glass(alpha)) for i, alpha in ((-1, 0.05), (0, 0.2), (1, 0.5))
    ]
    aslant = {"eye": [2.5, 3.0, 8], "target": [0, 0, -0.5], "fovy": 40}
    absorbing = [
        (ball([1.9 * (i - 1), 0, 0], 0.9, rings), glass(alpha, "ggx", [0.3, 0.7, 0.9], 0.8))
        for i, alpha in enumerate((0.0, 0.15, 0.5))
    ]
    close = {"eye": [0, 0, 7], "target": [0, 0, 0], "fovy": 25}
    face = {"eye": [1.0, 0.6, 4.2], "target": [0, 0, 0], "fovy": 38}
    sky = next(e for e in ENVIRONMENTS if "royal" in e.name)
    result = {
        "ball grid GGX": (grid, camera, sky),
        "ball grid Beckmann": (beckmann, camera, sky),
        "slabs over checkers": (board + slabs, aslant, sky),
        "absorbing glass": (absorbing, close, sky),
    }
    for i, environment in enumerate(ENVIRONMENTS):
        distribution = ("ggx", "beckmann")[i % 2]
        name = f"gold {distribution} {environment.stem.replace('_1k', '')}"
        result[name] = ([(suzanne(), gold(0.2, distribution))], face, environment)
    return result


# Files


def write_gltf(path, objects):
    blob, views, accessors, nodes, meshes, materials = b"", [], [], [], [], []

    def stream(values, dtype, kind, component):
        nonlocal blob
        values = np.ascontiguousarray(values, dtype)
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": values.nbytes})
        entry = {"bufferView": len(views) - 1, "componentType": component, "type": kind}
        entry["count"] = values.size if kind == "SCALAR" else len(values)
        if kind == "VEC3":
            entry |= {"min": values.min(0).tolist(), "max": values.max(0).tolist()}
        accessors.append(entry)
        blob += values.tobytes()
        return len(accessors) - 1

    used = set()
    for index, ((p, n, t), material) in enumerate(objects):
        primitive = {
            "attributes": {
                "POSITION": stream(p, np.float32, "VEC3", 5126),
                "NORMAL": stream(n, np.float32, "VEC3", 5126),
            },
            "indices": stream(t, np.uint32, "SCALAR", 5125),
            "material": index,
        }
        meshes.append({"primitives": [primitive]})
        nodes.append({"mesh": index})
        materials.append({"name": f"material {index}"} | material["gltf"])
        used |= set(material["gltf"].get("extensions", {}))
    path.with_suffix(".bin").write_bytes(blob)
    gltf = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": materials,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"uri": path.with_suffix(".bin").name, "byteLength": len(blob)}],
    }
    if used:
        gltf["extensionsUsed"] = sorted(used)
    path.write_text(json.dumps(gltf))


def write_ply(path, mesh):
    p, n, t = mesh
    corners = np.concatenate([p, n], 1).astype("<f4")
    faces = np.zeros(len(t), dtype=[("count", "u1"), ("index", "<i4", 3)])
    faces["count"], faces["index"] = 3, t
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(p)}\n"
    header += "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
    header += f"element face {len(t)}\nproperty list uchar int vertex_indices\nend_header\n"
    path.write_bytes(header.encode() + corners.tobytes() + faces.tobytes())


def read_map(path, largest):
    image = np.array(mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32), dtype=np.float64)
    return np.minimum(image, largest)


def for_mitsuba(image):
    """Mitsuba puts row j of h at v = j / (h - 1), we put it at (j + 1/2) / h; on 2 h + 1 rows both
    bilinear surfaces are the same one. Texel i of w is at (i + 1/2) / w for both, and its u is ours
    less a quarter: on 3 w columns ours are among its texels' centres."""
    h, w = image.shape[:2]
    rows = np.clip(np.arange(2 * h + 1) / 2 - 0.5, 0, h - 1)
    columns = (np.arange(3 * w) + 0.5) / 3 - 0.5 + w / 4
    r0, c0 = np.floor(rows).astype(int), np.floor(columns).astype(int)
    r1 = np.minimum(r0 + 1, h - 1)
    fr, fc = (rows - r0)[:, None, None], (columns - c0)[None, :, None]
    upper = image[r0][:, c0 % w] * (1 - fc) + image[r0][:, (c0 + 1) % w] * fc
    lower = image[r1][:, c0 % w] * (1 - fc) + image[r1][:, (c0 + 1) % w] * fc
    return (upper * (1 - fr) + lower * fr).astype(np.float32)


# Renders


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


def mitsubas(directory, objects, camera, environment, size, spp):
    """Mitsuba ends paths in an absorbing medium by chance; with one coefficient for all channels, by
    exactly that of the light. With three the channel that it goes by is itself drawn, and the few
    paths that live on against the odds of the others carry most of the variance. So an absorbing
    scene is rendered three times, as grey as each channel, and gives that channel."""
    if not any(material["interior"] for _, material in objects):
        pictures = batches(directory, objects, camera, environment, size, spp, None)
    else:
        pictures = np.stack(
            [batches(directory, objects, camera, environment, size, spp, c)[..., c] for c in range(3)], -1
        )
    return pictures.mean(0), pictures.std(0, ddof=1) / np.sqrt(BATCHES)


def batches(directory, objects, camera, environment, size, spp, channel):
    volumes = channel is not None
    transform = mi.ScalarTransform4f().look_at(camera["eye"], camera["target"], [0, 1, 0])
    scene = {
        "type": "scene",
        "integrator": {"type": "volpath" if volumes else "path", "max_depth": -1, "rr_depth": 32},
        "sensor": {
            "type": "perspective",
            "fov": camera["fovy"],
            "fov_axis": "y",
            "to_world": transform,
            "film": {
                "type": "hdrfilm",
                "width": size,
                "height": size,
                "rfilter": {"type": "box"},
                "pixel_format": "rgb",
                "component_format": "float32",
            },
            "sampler": {"type": "independent", "sample_count": spp // BATCHES},
        },
        "environment": {"type": "envmap", "bitmap": mi.Bitmap(for_mitsuba(environment))},
    }
    for index, (mesh, material) in enumerate(objects):
        path = directory / f"object{index}.ply"
        write_ply(path, mesh)
        shape = {"type": "ply", "filename": str(path), "bsdf": material["bsdf"]}
        if material["interior"]:
            shape["interior"] = {"type": "homogeneous", "albedo": 0.0, "sigma_t": material["interior"][channel]}
        scene[f"object{index}"] = shape
    loaded = mi.load_dict(scene)
    seed = 1000 * (2 + (channel or 0))
    return np.stack([np.array(mi.render(loaded, seed=seed + b), dtype=np.float64) for b in range(BATCHES)])


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
