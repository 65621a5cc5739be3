"""The meshes of a .glb whose nodes have no children, in the world."""
import json
import struct

import mitsuba as mi
import numpy as np

TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


def rotation(q):
    x, y, z, w = q
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])


def read_glb(path):
    """[(name of the material, (positions, normals, triangles, texture coordinates))], and the images, 0 to 1."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    gltf, blob = json.loads(data[20 : 20 + length]), data[28 + length :]

    def accessor(index):
        a = gltf["accessors"][index]
        view = gltf["bufferViews"][a["bufferView"]]
        width = WIDTHS[a["type"]]
        start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
        return np.frombuffer(blob, TYPES[a["componentType"]], a["count"] * width, start).reshape(-1, width)

    parts = []
    for node in gltf["nodes"]:
        if "mesh" not in node:
            continue
        turn, scale = rotation(node.get("rotation", [0, 0, 0, 1])), np.array(node.get("scale", [1, 1, 1]))
        for primitive in gltf["meshes"][node["mesh"]]["primitives"]:
            p, n, uv = (accessor(primitive["attributes"][a]) for a in ("POSITION", "NORMAL", "TEXCOORD_0"))
            p = (p * scale) @ turn.T + np.array(node.get("translation", [0, 0, 0]))
            n = (n / scale) @ turn.T
            n /= np.linalg.norm(n, axis=1, keepdims=True)
            t = accessor(primitive["indices"]).reshape(-1, 3).astype(int)
            parts.append((gltf["materials"][primitive["material"]]["name"], (p, n, t, uv)))
    images = []
    for image in gltf.get("images", []):
        view = gltf["bufferViews"][image["bufferView"]]
        start = view.get("byteOffset", 0)
        stream = mi.MemoryStream()
        stream.write(blob[start : start + view["byteLength"]])
        stream.seek(0)
        images.append(np.array(mi.Bitmap(stream), dtype=np.float64) / 255)
    return parts, images
