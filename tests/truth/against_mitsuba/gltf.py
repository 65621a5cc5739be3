"""A scene as we read it."""
import json

import numpy as np


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
    for index, ((p, n, t, *uv), material) in enumerate(objects):
        primitive = {
            "attributes": {
                "POSITION": stream(p, np.float32, "VEC3", 5126),
                "NORMAL": stream(n, np.float32, "VEC3", 5126),
            },
            "indices": stream(t, np.uint32, "SCALAR", 5125),
            "material": index,
        }
        if uv:
            primitive["attributes"]["TEXCOORD_0"] = stream(uv[0], np.float32, "VEC2", 5126)
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
