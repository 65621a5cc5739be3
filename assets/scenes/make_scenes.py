#!/usr/bin/env python3
"""Makes the scenes of rough glass in this folder.

    python3 make_scenes.py [FOLDER]

Plain Python 3, nothing to install; the same bytes every time. SOURCES.md lists what each file shows
and its checksum.

What stands behind the glass is unlit in the measured scenes (ball-grid, slabs, glass-behind-glass):
its radiance is then the same in every method and in the truth, so that an error over a glass object
is an error of the glass. `wineglass` and `etched` are lit, for pictures.
"""

import json
import math
import struct
import sys
import zlib
from pathlib import Path

ALPHAS = [0.0, 0.05, 0.15, 0.35, 0.7]


# ---- pictures -------------------------------------------------------------------------------------
def png(width, height, pixels):
    """8-bit PNG of rows of bytes: one (grey) or three (RGB) per pixel."""
    kind = {1: 0, 3: 2}[len(pixels) // (width * height)]

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    stride = len(pixels) // height
    rows = b"".join(b"\0" + pixels[y * stride : (y + 1) * stride] for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, kind, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def checkerboard(columns, rows, colour):
    """One texel per square: light and dark in turn, the light ones tinted by `colour(u, v)`."""
    pixels = bytearray()
    for y in range(rows):
        for x in range(columns):
            light = (x + y) % 2 == 0
            tint = colour((x + 0.5) / columns, (y + 0.5) / rows)
            pixels += bytes(round(255 * c) for c in (tint if light else [0.13 * t + 0.06 for t in tint]))
    return png(columns, rows, bytes(pixels))


def hues(u, v):
    """Warm above, cool below, and left unlike right: an upside-down or mirrored picture shows."""
    return 0.95 - 0.55 * v * u, 0.85 - 0.35 * abs(u - 0.5), 0.35 + 0.6 * v


def sand(u, v):
    return 0.93, 0.90 - 0.12 * u, 0.82 - 0.2 * u


# Five columns of seven bits for each letter, lowest bit on top.
FONT = {"R": (0x7F, 0x09, 0x19, 0x29, 0x46), "O": (0x3E, 0x41, 0x41, 0x41, 0x3E), "U": (0x3F, 0x40, 0x40, 0x40, 0x3F),
        "G": (0x3E, 0x41, 0x49, 0x49, 0x7A), "H": (0x7F, 0x08, 0x08, 0x08, 0x7F), " ": (0, 0, 0, 0, 0)}


def etching(width, height, clear, etched):
    """Roughness over longitude and latitude: a word and rings on one half, centred a quarter of the way round. The
    other half is clear, as what is etched there would be seen through the first."""
    text = "ROUGH"
    cell = width / 104
    left = width / 4 - (6 * len(text) - 1) / 2 * cell
    pixels = bytearray()
    for y in range(height):
        latitude = 90.0 - 180.0 * (y + 0.5) / height
        for x in range(width):
            column, row = math.floor((x - left) / cell), math.floor((y - height / 2) / (1.5 * cell) + 3.5)
            letter = FONT[text[column // 6]] if 0 <= column < 6 * len(text) - 1 else FONT[" "]
            lettered = 0 <= row < 7 and column % 6 < 5 and letter[column % 6] >> row & 1
            ring = x < width / 2 and any(low < abs(latitude) < low + 4.0 for low in (30.0, 40.0, 50.0))
            pixels.append(round(255 * (etched if lettered or ring else clear)))
    return png(width, height, bytes(pixels))


# ---- shapes: (positions, normals, texture coordinates or None, triangles) -------------------------
def normalised(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def geodesic(frequency):
    """The unit sphere: an icosahedron whose faces are divided evenly. Its normals are its positions."""
    g = (1 + math.sqrt(5)) / 2
    corners = [normalised(v) for v in
               [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    numbers, points, triangles = {}, [], []

    def number(weights):
        # Points on an edge are named by its corners alone, so that both its faces find the same one.
        key = tuple(sorted((c, w) for c, w in weights if w > 0))
        if key not in numbers:
            numbers[key] = len(points)
            points.append(normalised([sum(w * corners[c][k] for c, w in key) for k in range(3)]))
        return numbers[key]

    n = frequency
    for a, b, c in faces:
        at = {(i, j): number([(a, n - i - j), (b, i), (c, j)]) for i in range(n + 1) for j in range(n + 1 - i)}
        for i in range(n):
            for j in range(n - i):
                triangles.append((at[i, j], at[i + 1, j], at[i, j + 1]))
                if i + j < n - 1:
                    triangles.append((at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]))
    return points, points, None, triangles


def globe(segments, rings):
    """The unit sphere by longitude and latitude, with texture coordinates."""
    points, uvs = [], []
    for j in range(rings + 1):
        for i in range(segments + 1):
            phi, theta = 2 * math.pi * (i % segments) / segments, math.pi * j / rings
            s = math.sin(theta) if 0 < j < rings else 0.0
            points.append((s * math.sin(phi), math.cos(theta), s * math.cos(phi)))
            uvs.append((i / segments, j / rings))
    return points, points, uvs, lattice(segments, rings, poles=True)


def lattice(segments, rings, poles):
    """Triangles between rings of segments + 1 points each; at poles the triangles of no area are left out."""
    triangles = []
    for j in range(rings):
        for i in range(segments):
            a, b = j * (segments + 1) + i, j * (segments + 1) + i + 1
            c, d = a + segments + 1, b + segments + 1
            if not (poles and j == rings - 1):
                triangles.append((a, c, d))
            if not (poles and j == 0):
                triangles.append((a, d, b))
    return triangles


def box():
    """A cube of side 1 with flat faces."""
    points, normals, triangles = [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            base = len(points)
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for du, dv in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p = [0.0] * 3
                p[axis], p[u], p[v] = 0.5 * sign, 0.5 * du, 0.5 * dv
                points.append(tuple(p))
                normals.append(tuple(float(sign) if k == axis else 0.0 for k in range(3)))
            quad = [(0, 1, 2), (0, 2, 3)] if sign > 0 else [(0, 2, 1), (0, 3, 2)]
            triangles += [tuple(base + k for k in t) for t in quad]
    return points, normals, None, triangles


def rectangle():
    """From -1/2 to 1/2 in x and y, facing +z; v runs down."""
    points = [(-0.5, -0.5, 0.0), (0.5, -0.5, 0.0), (0.5, 0.5, 0.0), (-0.5, 0.5, 0.0)]
    return points, [(0.0, 0.0, 1.0)] * 4, [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)], [(0, 1, 2), (0, 2, 3)]


def revolved(profile, steps, segments, textured=False):
    """Turns a uniform cubic B-spline about y. `profile`: control points (radius, height) from the axis and back to
    it, outside first going up; the spline starts and ends on the axis, at right angles to it. Normals are the
    spline's own; texture coordinates, if wanted, go round and along it."""
    first, last = profile[0], profile[-1]
    control = [(-profile[1][0], profile[1][1]), first, *profile[1:-1], last, (-profile[-2][0], profile[-2][1])]
    curve = []
    spans = len(control) - 3
    for k in range(spans * steps + 1):
        s, t = min(k // steps, spans - 1), k / steps - min(k // steps, spans - 1)
        b = ((1 - t) ** 3 / 6, (3 * t**3 - 6 * t**2 + 4) / 6, (-3 * t**3 + 3 * t**2 + 3 * t + 1) / 6, t**3 / 6)
        d = (-((1 - t) ** 2) / 2, (3 * t**2 - 4 * t) / 2, (-3 * t**2 + 2 * t + 1) / 2, t**2 / 2)
        p = [sum(w * control[s + m][c] for m, w in enumerate(b)) for c in (0, 1)]
        slope = [sum(w * control[s + m][c] for m, w in enumerate(d)) for c in (0, 1)]
        if k in (0, spans * steps):
            p[0], slope[1] = 0.0, 0.0
        curve.append((p, normalised((slope[1], -slope[0]))))
    points, normals, uvs = [], [], []
    for k, ((radius, height), (nr, ny)) in enumerate(curve):
        for i in range(segments + 1):
            phi = 2 * math.pi * (i % segments) / segments
            uvs.append((i / segments, k / (len(curve) - 1)))
            points.append((radius * math.sin(phi), height, radius * math.cos(phi)))
            normals.append((nr * math.sin(phi), ny, nr * math.cos(phi)))
    triangles = [(a, c, b) for a, b, c in lattice(segments, len(curve) - 1, poles=True)]
    return points, normals, uvs if textured else None, triangles


# ---- glTF -----------------------------------------------------------------------------------------
class Document:
    def __init__(self):
        self.body = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": "make_scenes.py", "copyright": "CC0 1.0"}, "scene": 0,
                     "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": [], "accessors": [],
                     "bufferViews": [], "cameras": []}
        self.shapes, self.meshes = {}, {}

    def view(self, data, target=None):
        self.body += b"\0" * (-len(self.body) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.body), "byteLength": len(data)}
                                        | ({"target": target} if target else {}))
        self.body += data
        return len(self.json["bufferViews"]) - 1

    def accessor(self, rows, kind, bounded=False):
        flat = [c for row in rows for c in (row if isinstance(row, tuple) else (row,))]
        indices = kind == "SCALAR"
        assert not indices or max(flat) < 65535
        data = struct.pack(f"<{len(flat)}{'H' if indices else 'f'}", *flat)
        entry = {"bufferView": self.view(data, 34963 if indices else 34962), "componentType": 5123 if indices else 5126,
                 "count": len(rows), "type": kind}
        if bounded:
            stored = list(struct.iter_unpack("<3f", data))
            entry |= {"min": [min(c) for c in zip(*stored)], "max": [max(c) for c in zip(*stored)]}
        self.json["accessors"].append(entry)
        return len(self.json["accessors"]) - 1

    def shape(self, name, make):
        """The attributes and indices of a shape, stored once however many materials it is drawn with."""
        if name not in self.shapes:
            points, normals, uvs, triangles = make()
            attributes = {"POSITION": self.accessor(points, "VEC3", bounded=True)}
            attributes["NORMAL"] = (attributes["POSITION"] if normals is points
                                    else self.accessor(normals, "VEC3"))
            if uvs:
                attributes["TEXCOORD_0"] = self.accessor(uvs, "VEC2")
            self.shapes[name] = (attributes, self.accessor([i for t in triangles for i in t], "SCALAR"))
        return self.shapes[name]

    def texture(self, image, sampler):
        for name in ("images", "samplers", "textures"):
            self.json.setdefault(name, [])
        self.json["images"].append({"bufferView": self.view(image), "mimeType": "image/png"})
        self.json["samplers"].append(sampler)
        self.json["textures"].append({"source": len(self.json["images"]) - 1, "sampler": len(self.json["samplers"]) - 1})
        return len(self.json["textures"]) - 1

    def material(self, name, pbr, extensions=None, extras=None):
        entry = {"name": name, "pbrMetallicRoughness": pbr}
        if extensions:
            entry["extensions"] = extensions
            used = set(self.json.get("extensionsUsed", [])) | set(extensions)
            self.json["extensionsUsed"] = sorted(used)
        if extras:
            entry["extras"] = {"groundglass": extras}
        self.json["materials"].append(entry)
        return len(self.json["materials"]) - 1

    def place(self, name, shape, material, translation=(0, 0, 0), scale=(1, 1, 1), rotation=None):
        key = (shape[0], material)
        if key not in self.meshes:
            attributes, indices = self.shape(*shape)
            self.json["meshes"].append({"name": name, "primitives": [
                {"attributes": attributes, "indices": indices, "material": material}]})
            self.meshes[key] = len(self.json["meshes"]) - 1
        node = {"name": name, "mesh": self.meshes[key], "translation": list(translation), "scale": list(scale)}
        if rotation:
            node["rotation"] = list(rotation)
        self.node(node)

    def node(self, node):
        self.json["nodes"].append(node)
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def camera(self, eye, target, fovy):
        back = normalised([e - t for e, t in zip(eye, target)])
        right = normalised((back[2], 0.0, -back[0]))
        up = (back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
              back[0] * right[1] - back[1] * right[0])
        self.json["cameras"].append({"name": "Camera", "type": "perspective",
                                     "perspective": {"yfov": math.radians(fovy), "znear": 0.1, "zfar": 100.0}})
        matrix = [*right, 0.0, *up, 0.0, *back, 0.0, *(float(e) for e in eye), 1.0]
        self.node({"name": "Camera", "camera": 0, "matrix": matrix})

    def glass(self, name, alpha, thickness, colour=None, distance=None, extras=None, pbr=None):
        """Solid glass, index 1.5. `thickness` in the mesh's own units, before the node's scale."""
        volume = {"thicknessFactor": thickness}
        if colour:
            volume |= {"attenuationColor": colour, "attenuationDistance": distance}
        return self.material(name, {"metallicFactor": 0.0, "roughnessFactor": math.sqrt(alpha)} | (pbr or {}),
                             {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_volume": volume,
                              "KHR_materials_ior": {"ior": 1.5}}, extras)

    def metal(self, name, preset, alpha):
        return self.material(name, {"metallicFactor": 1.0, "roughnessFactor": math.sqrt(alpha)},
                             extras={"preset": preset, "alpha": alpha})

    def plain(self, name, colour, roughness, metallic=0.0):
        return self.material(name, {"baseColorFactor": [*colour, 1.0], "metallicFactor": metallic,
                                    "roughnessFactor": roughness})

    def light(self, kind, eye, target, colour, intensity, cones=None):
        """KHR_lights_punctual: looks from `eye` to `target`; lux if directional, else candela."""
        used = set(self.json.get("extensionsUsed", [])) | {"KHR_lights_punctual"}
        self.json["extensionsUsed"] = sorted(used)
        lights = self.json.setdefault("extensions", {"KHR_lights_punctual": {"lights": []}})["KHR_lights_punctual"]["lights"]
        entry = {"name": f"{kind} light", "type": kind, "color": colour, "intensity": intensity}
        if cones:
            entry["spot"] = {"innerConeAngle": cones[0], "outerConeAngle": cones[1]}
        lights.append(entry)
        back = normalised([e - t for e, t in zip(eye, target)])
        side = normalised((back[2], 0.0, -back[0]))
        up = (back[1] * side[2] - back[2] * side[1], back[2] * side[0] - back[0] * side[2],
              back[0] * side[1] - back[1] * side[0])
        self.node({"name": entry["name"], "matrix": [*side, 0.0, *up, 0.0, *back, 0.0, *(float(e) for e in eye), 1.0],
                   "extensions": {"KHR_lights_punctual": {"light": len(lights) - 1}}})

    def board(self, name, columns, rows, colour, unlit):
        """A checkerboard. Its texels are squares and unfiltered, so that every method reads the same edges."""
        sampler = {"magFilter": 9728, "minFilter": 9728, "wrapS": 33071, "wrapT": 33071}
        texture = self.texture(checkerboard(columns, rows, colour), sampler)
        return self.material(name, {"baseColorTexture": {"index": texture}, "metallicFactor": 0.0,
                                    "roughnessFactor": 0.8}, {"KHR_materials_unlit": {}} if unlit else None)

    def floor(self, material, size, centre):
        half = math.sqrt(0.5)
        self.place("Floor", ("rectangle", rectangle), material, centre, (*size, 1), (-half, 0, 0, half))

    def wall(self, material, size, centre):
        self.place("Wall", ("rectangle", rectangle), material, centre, (*size, 1))

    def bytes(self):
        self.body += b"\0" * (-len(self.body) % 4)
        self.json["buffers"] = [{"byteLength": len(self.body)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self.body)) + struct.pack("<I4s", len(text), b"JSON")
                + text + struct.pack("<I4s", len(self.body), b"BIN\0") + bytes(self.body))


BALL = ("ball", lambda: geodesic(16))
FINE_BALL = ("fine ball", lambda: geodesic(24))
BOX = ("box", box)


# ---- scenes ---------------------------------------------------------------------------------------
def ball_grid():
    d = Document()
    d.wall(d.board("Wall", 24, 16, hues, unlit=True), (12, 8), (0, 4, -3))
    d.floor(d.board("Floor", 24, 18, sand, unlit=True), (12, 9), (0, 0, 1.5))
    rows = [("Clear", 2.8, lambda n, a: d.glass(n, a, 2.0)), ("Gold", 1.7, lambda n, a: d.metal(n, "gold", a)),
            ("Amber", 0.6, lambda n, a: d.glass(n, a, 2.0, [0.9, 0.45, 0.1], 0.5))]
    for kind, y, make in rows:
        for i, alpha in enumerate(ALPHAS):
            name = f"{kind} {alpha:g}"
            d.place(name, BALL, make(name, alpha), (1.1 * (i - 2), y, 0), (0.5, 0.5, 0.5))
    d.camera((0, 2.5, 9), (0, 1.7, 0), 36)
    return d


def slabs(gap):
    """Four slabs `gap` metres before a wall."""
    d = Document()
    d.wall(d.board("Wall", 32, 32, hues, unlit=True), (8, 8), (0, 0, -gap - 0.06))
    kinds = [("Clear", 0.0, None), ("Rough .25", 0.25, None), ("Rough .5", 0.5, None), ("Green", 0.1, [0.25, 0.8, 0.35])]
    for i, (name, alpha, colour) in enumerate(kinds):
        material = d.glass(name, alpha, 1.0, colour, 0.05)
        d.place(name, BOX, material, (1.1 * (i - 1.5), 0, 0), (1, 1, 0.12))
    d.camera((0.4, 0.8, 6), (0, 0, 0), 44)
    return d


def panes():
    """Walls of no thickness before a wall: above four that face the viewer, below the same turned by 60 degrees."""
    d = Document()
    d.wall(d.board("Wall", 32, 32, hues, unlit=True), (8, 8), (0, 0, -0.6))
    half = math.radians(60) / 2
    for i, alpha in enumerate((0.0, 0.1, 0.25, 0.5)):
        material = d.glass(f"Pane {alpha:g}", alpha, 0.0)
        for y, turn in ((0.65, 0.0), (-0.65, half)):
            d.place(f"Pane {alpha:g}", ("rectangle", rectangle), material, (1.1 * (i - 1.5), y, 0), (1, 1.1, 1),
                    (math.sin(turn), 0, 0, math.cos(turn)))
    d.camera((0.4, 0.8, 6), (0, 0, 0), 44)
    return d


def glass_behind_glass():
    d = Document()
    d.wall(d.board("Wall", 24, 16, hues, unlit=True), (9, 6), (0, 2, -2.5))
    d.floor(d.board("Floor", 24, 18, sand, unlit=True), (9, 6.75), (0, 0, 0.875))
    d.place("Rough slab", BOX, d.glass("Rough slab", 0.15, 1.0), (-0.85, 0.75, 1.2), (1.2, 1.4, 0.1))
    d.place("Clear ball", FINE_BALL, d.glass("Clear ball", 0.0, 2.0), (-0.75, 0.7, 0), (0.6, 0.6, 0.6))
    d.place("Ball around", FINE_BALL, d.glass("Ball around", 0.0, 2.0), (0.75, 0.8, 0), (0.7, 0.7, 0.7))
    red = d.material("Red", {"baseColorFactor": [0.75, 0.05, 0.04, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.6})
    d.place("Red ball", FINE_BALL, red, (0.75, 0.8, 0), (0.3, 0.3, 0.3))
    d.place("Gold ball", FINE_BALL, d.metal("Gold", "gold", 0.15), (0.1, 0.3, 1.5), (0.3, 0.3, 0.3))
    d.camera((0.2, 1.5, 5.5), (-0.1, 0.75, 0), 38)
    return d


# Half of the wine glass, in metres: foot, stem, bowl outside, rim, bowl inside, and down to its bottom.
WINEGLASS = [(0.0, 0.0), (0.012, 0.0), (0.026, 0.0), (0.0335, 0.0), (0.036, 0.0006), (0.036, 0.0022), (0.033, 0.0034),
             (0.024, 0.0046), (0.013, 0.0068), (0.0065, 0.0115), (0.0046, 0.02), (0.0041, 0.035), (0.004, 0.052),
             (0.0042, 0.068), (0.0052, 0.079), (0.0095, 0.0865), (0.0195, 0.0935), (0.0295, 0.104), (0.0358, 0.119),
             (0.038, 0.135), (0.0372, 0.151), (0.0347, 0.167), (0.0318, 0.181), (0.0308, 0.1858), (0.0300, 0.1872),
             (0.0290, 0.1862), (0.0295, 0.181), (0.0325, 0.167), (0.0350, 0.151), (0.0358, 0.135), (0.0337, 0.1195),
             (0.0278, 0.1062), (0.0185, 0.0968), (0.0095, 0.0917), (0.0, 0.0905)]


def wineglass():
    d = Document()
    d.floor(d.board("Table", 20, 20, sand, unlit=False), (0.6, 0.6), (0, 0, 0))
    material = d.glass("Glass", 0.0, 0.002)
    d.place("Wine glass", ("wine glass", lambda: revolved(WINEGLASS, 3, 48)), material, (0, 0.0002, 0))
    d.camera((0, 0.21, 0.46), (0, 0.088, 0), 28)
    return d


def etched():
    """Two balls before a dark cloth: what is etched scatters the light from the sides, what is clear shows the cloth."""
    d = Document()
    cloth = d.material("Cloth", {"baseColorFactor": [0.012, 0.012, 0.015, 1.0], "metallicFactor": 0.0, "roughnessFactor": 1.0})
    d.floor(cloth, (3, 3), (0, 0, -0.2))
    d.wall(cloth, (3, 2.4), (0, 1.2, -1.2))
    linear = {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 33071}
    texture = d.texture(etching(1024, 512, 0.0, math.sqrt(0.5)), linear)
    for distribution, x in (("ggx", -0.56), ("beckmann", 0.56)):
        name = {"ggx": "Etched, GGX", "beckmann": "Etched, Beckmann"}[distribution]
        material = d.glass(name, 1.0, 2.0, extras={"distribution": distribution},
                           pbr={"metallicRoughnessTexture": {"index": texture}})
        # The word, at 90 degrees of longitude, comes to the front and is then tilted up towards the camera.
        turn, tilt = math.radians(-90) / 2, math.radians(-8) / 2
        d.place(name, ("globe", lambda: globe(96, 48)), material, (x, 0.501, 0), (0.5, 0.5, 0.5),
                (math.sin(tilt) * math.cos(turn), math.cos(tilt) * math.sin(turn), math.sin(tilt) * math.sin(turn),
                 math.cos(tilt) * math.cos(turn)))
    d.camera((0, 1.0, 4.2), (0, 0.5, 0), 24)
    return d


def contact():
    """Things that touch each other and a glossy floor, beside a steel plate: contacts darken, colours bleed."""
    d = Document()
    d.floor(d.plain("Floor", [0.55, 0.53, 0.5], 0.3), (7, 7), (0, 0, 0))
    d.place("Plate", BOX, d.plain("Steel", [0.6, 0.58, 0.56], 0.4, 1.0), (0, 0.8, -1.1), (3.4, 1.6, 0.04))
    d.place("Rough metal", FINE_BALL, d.plain("Rough metal", [0.7, 0.68, 0.66], 0.7, 1.0), (-0.9, 0.5, -0.1), (0.5, 0.5, 0.5))
    d.place("Gold ball", FINE_BALL, d.metal("Gold", "gold", 0.04), (0.1, 0.5, -0.1), (0.5, 0.5, 0.5))
    d.place("Red box", BOX, d.plain("Red", [0.7, 0.06, 0.04], 0.5), (1.0, 0.4, -0.1), (0.8, 0.8, 0.8))
    d.place("White ball", FINE_BALL, d.plain("White", [0.85, 0.85, 0.85], 0.6), (0.45, 0.3, 0.75), (0.3, 0.3, 0.3))
    d.camera((0.3, 1.7, 4.6), (0.1, 0.45, 0), 34)
    return d


def suzanne():
    """Positions, normals and triangles of Suzanne/Suzanne.gltf."""
    data = (Path(__file__).parent / "Suzanne" / "Suzanne.bin").read_bytes()
    indices = [i[0] for i in struct.iter_unpack("<H", data[:23616])]
    points = list(struct.iter_unpack("<3f", data[23616:165312]))
    normals = list(struct.iter_unpack("<3f", data[165312:307008]))
    return points, normals, None, [tuple(indices[i : i + 3]) for i in range(0, len(indices), 3)]


def odd_neighbours():
    """Two heads, which are no balls, among metal balls."""
    d = Document()
    head = ("suzanne", suzanne)
    d.place("Copper head", head, d.metal("Copper", "copper", 0.2), (-0.95, 0.0, 0.1), (0.6, 0.6, 0.6), (0, 0.17, 0, 0.985))
    d.place("Red head", head, d.plain("Red", [0.7, 0.07, 0.05], 0.4), (0.95, 0.1, 0.0), (0.6, 0.6, 0.6), (0, -0.25, 0, 0.968))
    d.place("Gold ball", FINE_BALL, d.metal("Gold", "gold", 0.04), (0.0, -0.45, 0.75), (0.4, 0.4, 0.4))
    d.place("Steel ball", FINE_BALL, d.plain("Steel", [0.6, 0.58, 0.56], 0.5, 1.0), (0.0, 0.6, 0.1), (0.4, 0.4, 0.4))
    d.place("Rough ball", FINE_BALL, d.plain("Rough", [0.75, 0.75, 0.75], 0.85, 1.0), (0.0, -0.1, -0.9), (0.5, 0.5, 0.5))
    d.camera((0.2, 0.6, 5.2), (0, 0.05, 0), 30)
    return d


def lamp():
    """Two lamps: shadows of balls, of a box, and through coloured glass."""
    d = Document()
    d.floor(d.plain("Floor", [0.7, 0.69, 0.67], 0.6), (7, 7), (0, 0, 0))
    d.place("Amber glass", FINE_BALL, d.glass("Amber", 0.1, 2.0, [0.9, 0.5, 0.12], 0.6), (-1.0, 0.5, 0.2), (0.5, 0.5, 0.5))
    d.place("Green pane", BOX, d.glass("Green", 0.05, 1.0, [0.25, 0.8, 0.35], 0.1), (1.15, 0.6, -0.2), (1.0, 1.2, 0.08),
            (0, 0.26, 0, 0.966))
    d.place("Copper ball", FINE_BALL, d.metal("Copper", "copper", 0.15), (0.05, 0.45, -0.3), (0.45, 0.45, 0.45))
    d.place("White ball", FINE_BALL, d.plain("White", [0.85, 0.85, 0.85], 0.6), (0.2, 0.25, 0.8), (0.25, 0.25, 0.25))
    d.place("Blue box", BOX, d.plain("Blue", [0.08, 0.15, 0.6], 0.5), (1.1, 0.2, 0.9), (0.4, 0.4, 0.4))
    d.light("spot", (-2.2, 3.2, 1.6), (0, 0.2, 0), [1.0, 0.93, 0.82], 40.0, (0.35, 0.6))
    d.light("directional", (2.0, 3.0, -1.2), (0, 0, 0), [0.8, 0.9, 1.0], 1.2)
    d.camera((0.1, 2.0, 4.8), (0.05, 0.35, 0), 36)
    return d


# Half of a bottle, in metres: bottom, outside up to the lip, inside down to the bottom.
BOTTLE = [(0.0, 0.004), (0.012, 0.003), (0.026, 0.0005), (0.0335, 0.001), (0.0365, 0.006), (0.037, 0.02), (0.037, 0.06),
          (0.037, 0.105), (0.0355, 0.125), (0.029, 0.142), (0.0185, 0.155), (0.0138, 0.170), (0.0132, 0.195), (0.0132, 0.214),
          (0.0155, 0.218), (0.0155, 0.226), (0.0125, 0.229), (0.0096, 0.226), (0.0094, 0.214), (0.0096, 0.195),
          (0.0102, 0.172), (0.0150, 0.1565), (0.0262, 0.1415), (0.0325, 0.1235), (0.0338, 0.105), (0.0338, 0.06),
          (0.0338, 0.022), (0.0325, 0.012), (0.024, 0.008), (0.0, 0.009)]

# Half of a tumbler with a thick bottom.
TUMBLER = [(0.0, 0.0), (0.018, 0.0), (0.031, 0.0), (0.0355, 0.0015), (0.037, 0.006), (0.0378, 0.02), (0.0388, 0.045),
           (0.0400, 0.075), (0.0408, 0.092), (0.0408, 0.0955), (0.0398, 0.0972), (0.0388, 0.0955), (0.0386, 0.092),
           (0.0378, 0.075), (0.0366, 0.045), (0.0356, 0.026), (0.0335, 0.0175), (0.024, 0.0145), (0.0, 0.014)]


def frosted_bottle():
    """A frosted bottle, and a clear one behind it, on a lit table with lemons."""
    d = Document()
    d.floor(d.board("Table", 16, 16, sand, unlit=False), (1.2, 1.2), (0, 0, 0))
    frosted = d.glass("Frosted", 0.2, 0.003, [0.55, 0.82, 0.75], 0.02)
    clear = d.glass("Clear", 0.0, 0.003, [0.93, 0.55, 0.25], 0.03)
    shape = ("bottle", lambda: revolved(BOTTLE, 3, 56))
    d.place("Frosted bottle", shape, frosted, (-0.03, 0.0002, 0.02))
    d.place("Clear bottle", shape, clear, (0.065, 0.0002, -0.06))
    lemon = d.plain("Lemon", [0.9, 0.68, 0.05], 0.45)
    d.place("Lemon", FINE_BALL, lemon, (0.055, 0.0265, 0.055), (0.033, 0.0265, 0.0265))
    d.place("Lemon behind", FINE_BALL, lemon, (-0.06, 0.0265, -0.07), (0.0265, 0.0265, 0.033))
    d.camera((0.0, 0.19, 0.62), (0.008, 0.103, 0), 24)
    return d


def garden():
    """Trees, grass, flowers and sky behind a window: radiance over u, v with v down."""
    state, width, height = 12345, 768, 576

    def draw():
        nonlocal state
        state = (1103515245 * state + 12345) % 2**31
        return state / 2**31

    pixels = []
    for y in range(height):
        v = y / height
        sky = (0.55 + 0.35 * v, 0.74 + 0.2 * v, 0.98)
        grass = (0.16 + 0.3 * (v - 0.4), 0.40 + 0.35 * (v - 0.4), 0.10)
        pixels.append([sky if v < 0.42 else grass for _ in range(width)])

    def spot(x, y, rx, ry, colour):
        """An ellipse whose edge is soft over a texel."""
        for j in range(max(int(y - ry - 1), 0), min(int(y + ry + 2), height)):
            for i in range(max(int(x - rx - 1), 0), min(int(x + rx + 2), width)):
                far = math.hypot((i - x) / rx, (j - y) / ry)
                share = min(max((1.0 - far) * min(rx, ry) + 0.5, 0.0), 1.0)
                pixels[j][i] = tuple(share * c + (1.0 - share) * p for c, p in zip(colour, pixels[j][i]))

    for x, y, reach, colour in ((400, 215, 60, (0.07, 0.22, 0.12)), (150, 180, 105, (0.09, 0.33, 0.09)),
                                (600, 160, 115, (0.15, 0.40, 0.08))):
        spot(x, 0.5 * (y + 360), 9 * reach / 100, 0.5 * (360 - y), (0.24, 0.16, 0.10))
        for _ in range(18 * reach):
            angle, far = 2 * math.pi * draw(), reach * math.sqrt(draw())
            lift = math.sin(angle) * far
            shade = 0.55 + 0.35 * draw() - 0.6 * lift / reach # light from above
            spot(x + 1.15 * math.cos(angle) * far, y + 0.85 * lift, 2 + 3 * draw(), 1.5 + 2 * draw(), tuple(max(shade, 0.25) * c for c in colour))
    flowers = ((0.85, 0.10, 0.12), (0.95, 0.75, 0.10), (0.90, 0.45, 0.70), (0.95, 0.95, 0.90))
    for y in sorted(345 + 225 * draw() ** 0.8 for _ in range(900)):
        size = 1.0 + 5.0 * (y - 345) / 230
        spot(width * draw(), y, size, 0.7 * size, flowers[int(4 * draw())] if draw() < 0.55 else (0.12, 0.36 + 0.1 * draw(), 0.08))
    return png(width, height, bytes(round(255 * min(c, 1.0)) for row in pixels for texel in row for c in texel))


def bathroom_window():
    """A window of four rough panes, from clear to ground, before a garden; a plant stands behind it and a bottle before it."""
    d = Document()
    linear = {"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}
    picture = d.material("Garden", {"baseColorTexture": {"index": d.texture(garden(), linear)}, "metallicFactor": 0.0},
                         {"KHR_materials_unlit": {}})
    d.wall(picture, (6.4, 4.8), (0, 1.5, -2.4))
    frame = d.plain("Frame", [0.86, 0.85, 0.82], 0.5)
    tile = d.plain("Tiles", [0.62, 0.76, 0.78], 0.3)
    for name, x, y, w, h in (("Wall left", -1.5, 1.5, 1.6, 3.6), ("Wall right", 1.5, 1.5, 1.6, 3.6),
                             ("Wall above", 0, 2.85, 1.4, 0.9), ("Wall below", 0, 0.15, 1.4, 0.9)):
        d.place(name, BOX, tile, (x, y, 0), (w, h, 0.2))
    for x in (-0.68, 0.0, 0.68):
        d.place("Bar", BOX, frame, (x, 1.5, 0), (0.05, 1.8, 0.1))
    for y in (0.62, 1.5, 2.38):
        d.place("Bar", BOX, frame, (0, y, 0), (1.4, 0.05, 0.1))
    d.place("Sill", BOX, frame, (0, 0.58, 0.18), (1.6, 0.05, 0.36))
    for name, alpha, x, y in (("Clear", 0.0, -0.34, 1.94), ("Satin", 0.04, 0.34, 1.94), ("Frosted", 0.12, -0.34, 1.06),
                              ("Ground", 0.3, 0.34, 1.06)):
        d.place(name, BOX, d.glass(name, alpha, 1.0), (x, y, 0), (0.63, 0.83, 0.012))
    d.place("Pot", BOX, d.plain("Clay", [0.6, 0.25, 0.12], 0.7), (0.34, 0.75, -0.16), (0.2, 0.25, 0.2))
    leaf = d.plain("Leaf", [0.12, 0.4, 0.1], 0.6)
    for x, y, z, r in ((0.34, 1.02, -0.17, 0.14), (0.24, 1.12, -0.2, 0.1), (0.45, 1.14, -0.2, 0.11), (0.35, 1.22, -0.22, 0.09)):
        d.place("Leaves", BALL, leaf, (x, y, z), (r, r, r))
    d.place("Bottle", ("bottle", lambda: revolved(BOTTLE, 3, 56)), d.glass("Amber", 0.0, 0.003, [0.93, 0.55, 0.25], 0.03),
            (-0.3, 0.606, 0.2), (1.4, 1.4, 1.4))
    d.camera((0.12, 1.6, 3.0), (0, 1.42, 0), 36)
    return d


def cut(width, height):
    """Roughness of a tumbler over turn and height of its outline: bands and lozenges that are etched, the rest clear."""
    pixels = bytearray()
    for y in range(height):
        v = y / height
        for x in range(width):
            s, t = 14 * x / width % 1.0, (v - 0.27) / 0.075
            lozenge = 0.0 < t < 1.0 and abs(s - 0.5) + abs(t - 0.5) < 0.42 and abs(s - 0.5) + abs(t - 0.5) > 0.16
            band = 0.245 < v < 0.255 or 0.36 < v < 0.37
            pixels.append(round(255 * (math.sqrt(0.4) if lozenge or band else 0.0)))
    return png(width, height, bytes(pixels))


def etched_tumbler():
    """A tumbler with an etched pattern, beside a copper ball."""
    d = Document()
    d.floor(d.plain("Slate", [0.09, 0.095, 0.1], 0.35), (1.2, 1.2), (0, 0, 0))
    linear = {"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 33071}
    texture = d.texture(cut(1024, 512), linear)
    glass = d.glass("Etched", 1.0, 0.004, pbr={"metallicRoughnessTexture": {"index": texture}})
    d.place("Tumbler", ("tumbler", lambda: revolved(TUMBLER, 4, 64, textured=True)), glass, (-0.02, 0.0002, 0))
    d.place("Copper ball", FINE_BALL, d.metal("Copper", "copper", 0.05), (0.055, 0.022, -0.035), (0.022, 0.022, 0.022))
    d.camera((0.0, 0.13, 0.36), (0.006, 0.044, 0), 22)
    return d


def brilliant():
    """A brilliant cut of unit girdle radius, flat faces: table, crown, girdle, pavilion (Tolkowsky's proportions)."""
    n, table, crown, girdle, pavilion = 16, 0.53, 0.324, 0.04, 0.862
    def ring(radius, y, count, offset):
        return [(radius * math.sin(2 * math.pi * (i + offset) / count), y, radius * math.cos(2 * math.pi * (i + offset) / count))
                for i in range(count)]
    top, star = ring(table, girdle / 2 + crown, 8, 0.0), ring(0.78, girdle / 2 + 0.6 * crown, 8, 0.5)
    upper, lower = ring(1.0, girdle / 2, n, 0.0), ring(1.0, -girdle / 2, n, 0.0)
    waist, tip = ring(0.5, -girdle / 2 - 0.52 * pavilion, 8, 0.0), (0.0, -girdle / 2 - pavilion, 0.0)
    faces = [[(0.0, girdle / 2 + crown, 0.0), top[i], top[(i + 1) % 8]] for i in range(8)]
    for i in range(8):
        j, a, b, c = (i + 1) % 8, upper[2 * i], upper[2 * i + 1], upper[(2 * i + 2) % n]
        faces += [[top[i], star[i], top[j]], [top[i], a, star[i]], [star[i], c, top[j]], [star[i], a, b], [star[i], b, c]]
        d, e, f = lower[2 * i], lower[2 * i + 1], lower[(2 * i + 2) % n]
        faces += [[waist[i], e, d], [waist[i], waist[j], e], [waist[j], f, e], [tip, waist[j], waist[i]]]
        faces += [[a, d, e], [a, e, b], [b, e, f], [b, f, c]]
    points, normals, triangles = [], [], []
    for p, q, r in faces:
        u, w = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        m = normalised((u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]))
        inwards = sum(a * b for a, b in zip(m, p)) < 0
        triangles.append(tuple(len(points) + k for k in ((0, 2, 1) if inwards else (0, 1, 2))))
        points += [p, q, r]
        normals += [tuple(-c for c in m) if inwards else m] * 3
    return points, normals, None, triangles


def gem():
    """A brilliant of a dispersive glass on dark velvet, and a rough one beside it."""
    d = Document()
    d.floor(d.plain("Velvet", [0.02, 0.02, 0.03], 1.0), (4, 4), (0, 0, 0))
    for name, alpha, x, turn in (("Clear", 0.0, -0.06, 0.0), ("Frosted", 0.15, 0.115, 0.35)):
        material = d.glass(name, alpha, 0.1)
        d.json["materials"][material]["extensions"]["KHR_materials_ior"]["ior"] = 1.9
        d.json["materials"][material]["extensions"]["KHR_materials_dispersion"] = {"dispersion": 0.8}
        d.json["extensionsUsed"] = sorted({*d.json["extensionsUsed"], "KHR_materials_dispersion"})
        d.place(name, ("brilliant", brilliant), material, (x, 0.072, 0), (0.08, 0.08, 0.08),
                (math.sin(0.2) * math.cos(turn), math.cos(0.2) * math.sin(turn), 0, math.cos(0.2) * math.cos(turn)))
    d.camera((0.0, 0.45, 0.75), (0.027, 0.045, 0), 18)
    return d


# Half of a jug without its handle: foot, belly, neck, lip; solid, as only its outside is seen.
JUG = [(0.0, 0.0), (0.02, 0.0), (0.033, 0.0), (0.036, 0.002), (0.036, 0.006), (0.034, 0.012), (0.042, 0.03), (0.049, 0.055),
       (0.047, 0.082), (0.036, 0.105), (0.027, 0.122), (0.026, 0.137), (0.031, 0.150), (0.0355, 0.156), (0.0365, 0.159),
       (0.034, 0.160), (0.027, 0.157), (0.0, 0.156)]


def brushed_metal():
    """A turned steel jug, brushed around, a copper one, brushed along its outline, and a gold ball without brushing."""
    d = Document()
    d.floor(d.plain("Slate", [0.09, 0.095, 0.1], 0.35), (1.2, 1.2), (0, 0, 0))
    shape = ("jug", lambda: revolved(JUG, 4, 64, textured=True))
    for name, colour, x, z, rotation in (("Steel jug", [0.62, 0.6, 0.58], -0.06, 0.0, math.pi / 2),
                                         ("Copper jug", [0.95, 0.64, 0.54], 0.065, -0.05, 0.0)):
        material = d.material(name, {"baseColorFactor": [*colour, 1.0], "metallicFactor": 1.0, "roughnessFactor": 0.3},
                              {"KHR_materials_anisotropy": {"anisotropyStrength": 0.75, "anisotropyRotation": rotation}})
        d.place(name, shape, material, (x, 0, z))
    d.place("Gold ball", FINE_BALL, d.metal("Gold", "gold", 0.09), (0.035, 0.028, 0.06), (0.028, 0.028, 0.028))
    d.camera((0.0, 0.2, 0.5), (0.005, 0.075, 0), 24)
    return d


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    scenes = {"ball-grid": ball_grid(), "slabs-0.02": slabs(0.02), "slabs-0.2": slabs(0.2), "slabs-2": slabs(2.0),
              "panes": panes(), "glass-behind-glass": glass_behind_glass(), "wineglass": wineglass(), "etched": etched(),
              "contact": contact(), "odd-neighbours": odd_neighbours(), "lamp": lamp(),
              "bottle": frosted_bottle(), "window": bathroom_window(), "tumbler": etched_tumbler(), "gem": gem(),
              "brushed": brushed_metal()}
    for name, document in scenes.items():
        data = document.bytes()
        (folder / f"{name}.glb").write_bytes(data)
        print(f"{name}.glb  {len(data)} bytes")


if __name__ == "__main__":
    main()
