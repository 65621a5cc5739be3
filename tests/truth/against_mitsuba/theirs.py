"""A picture by Mitsuba: colour, and the standard error from the scatter of independent renders."""
import mitsuba as mi
import numpy as np

from .environment import for_mitsuba

BATCHES = 32  # renders, from whose scatter the error is known to 1 / sqrt(2 * 31)


def write_ply(path, mesh):
    p, n, t, *uv = mesh
    corners = np.concatenate([p, n, *uv], 1).astype("<f4")
    names = ("x", "y", "z", "nx", "ny", "nz") + (("u", "v") if uv else ())
    faces = np.zeros(len(t), dtype=[("count", "u1"), ("index", "<i4", 3)])
    faces["count"], faces["index"] = 3, t
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(p)}\n"
    header += "".join(f"property float {name}\n" for name in names)
    header += f"element face {len(t)}\nproperty list uchar int vertex_indices\nend_header\n"
    path.write_bytes(header.encode() + corners.tobytes() + faces.tobytes())


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
