"""Pictures, shapes and a glTF document for make_scenes.py: plain Python 3, the same bytes every time."""

import json
import math
import struct
import zlib


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
# Reflectance at normal incidence, ((n - 1)² + k²) / ((n + 1)² + k²), of the presets' n and k (app/scene/presets.cpp).
METALS = {"copper": [0.943, 0.619, 0.539], "gold": [0.963, 0.787, 0.408]}


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
        """The preset for this project; for other programs its colour: the reflectance at normal incidence."""
        return self.material(name, {"baseColorFactor": [*METALS[preset], 1.0], "metallicFactor": 1.0,
                                    "roughnessFactor": math.sqrt(alpha)},
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
