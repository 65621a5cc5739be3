"""Meshes: (positions, normals, triangles), and texture coordinates where something is brushed along them."""
import json

import numpy as np

from .places import ROOT


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


def globe(centre, radius, rings):
    """The same ball with longitude and latitude as texture coordinates."""
    j, i = np.meshgrid(np.arange(rings + 1), np.arange(2 * rings + 1), indexing="ij")
    uv = np.stack([i / (2 * rings), j / rings], -1).reshape(-1, 2)
    return (*ball(centre, radius, rings), uv)


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
