#!/usr/bin/env python3
"""Makes the scenes of rough glass in this folder.

    python3 make_scenes.py [FOLDER]

Plain Python 3, nothing to install; the same bytes every time. Pictures, shapes and the glTF document
are in gltf_parts.py. SOURCES.md lists what each file shows and its checksum.

What stands behind the glass is unlit in the measured scenes (ball-grid, slabs, glass-behind-glass):
its radiance is then the same in every method and in the truth, so that an error over a glass object
is an error of the glass. `wineglass` and `etched` are lit, for pictures.
"""

import math
import struct
import sys
from pathlib import Path

sys.dont_write_bytecode = True

from gltf_parts import (BALL, BOX, Document, FINE_BALL, box, etching, globe, hues, normalised, png, rectangle, revolved, sand)

ALPHAS = [0.0, 0.05, 0.15, 0.35, 0.7]


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


def layers():
    """Balls under what lies over a surface: brushed metal, coats, films; glass with each; and two sheets that light comes through."""
    d = Document()
    ball = ("layered ball", lambda: globe(48, 24))
    anisotropy = lambda strength, turn: {"KHR_materials_anisotropy": {"anisotropyStrength": strength, "anisotropyRotation": turn}}
    coat = lambda roughness: {"KHR_materials_clearcoat": {"clearcoatFactor": 1.0, "clearcoatRoughnessFactor": roughness}}
    film = lambda nanometres: {"KHR_materials_iridescence": {"iridescenceFactor": 1.0, "iridescenceThicknessMaximum": nanometres}}
    clear = {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_volume": {"thicknessFactor": 2.0}}
    rows = (
        [(f"Brushed {s}{' across' if t else ''}", [0.9, 0.85, 0.8], 1.0, 0.3, anisotropy(s, t))
         for s, t in ((0.3, 0.0), (0.6, 0.0), (0.9, 0.0), (0.9, math.pi / 2))],
        [("Coat 0 on copper", [0.95, 0.64, 0.54], 1.0, 0.6, coat(0.0)), ("Coat .3 on copper", [0.95, 0.64, 0.54], 1.0, 0.6, coat(0.3)),
         ("Coat 0 on plastic", [0.6, 0.05, 0.05], 0.0, 0.6, coat(0.0)), ("Coat .5 on glass", [1.0, 1.0, 1.0], 0.0, 0.1, coat(0.5) | clear)],
        [("Film on smooth steel", [0.6, 0.58, 0.55], 1.0, 0.15, film(350.0)), ("Film on rough steel", [0.6, 0.58, 0.55], 1.0, 0.5, film(500.0)),
         ("Film on plastic", [0.02, 0.02, 0.02], 0.0, 0.2, film(420.0)), ("Film on glass", [1.0, 1.0, 1.0], 0.0, 0.1, film(420.0) | clear)])
    for y, row in enumerate(rows):
        for x, (name, colour, metallic, roughness, extensions) in enumerate(row):
            material = d.material(name, {"baseColorFactor": [*colour, 1.0], "metallicFactor": metallic, "roughnessFactor": roughness},
                                  extensions)
            d.place(name, ball, material, (1.2 * (x - 1.5), 1.2 * (1.5 - y), 0), (0.5, 0.5, 0.5))
    glass = d.material("Brushed glass", {"metallicFactor": 0.0, "roughnessFactor": 0.3}, anisotropy(0.5, 0.0) | clear)
    d.place("Brushed glass", ball, glass, (-1.8, -1.8, 0), (0.5, 0.5, 0.5))
    for x, share in ((-0.6, 0.5), (0.6, 1.0)):
        paper = d.material(f"Paper {share}", {"baseColorFactor": [0.8, 0.8, 0.75, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.8},
                           {"KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": share,
                                                                   "diffuseTransmissionColorFactor": [0.9, 0.6, 0.3]}})
        d.json["materials"][paper]["doubleSided"] = True
        d.place(f"Paper {share}", ("rectangle", rectangle), paper, (x, -1.8, 0))
    glow = d.material("Coat on a lamp", {"baseColorFactor": [0.1, 0.1, 0.1, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.5},
                      {"KHR_materials_emissive_strength": {"emissiveStrength": 4.0}} | coat(0.0))
    d.json["materials"][glow]["emissiveFactor"] = [0.5, 0.4, 0.2]
    d.place("Coat on a lamp", ball, glow, (1.8, -1.8, 0), (0.5, 0.5, 0.5))
    d.camera((0, 0, 9), (0, 0, 0), 32)
    return d


def motion():
    """Two seconds: a brushed pendulum swings (LINEAR), a glass ball bounces (CUBICSPLINE), a box jumps (STEP)."""
    d = Document()
    d.floor(d.plain("Floor", [0.7, 0.69, 0.67], 0.6), (6, 6), (0, 0, 0))
    steel = d.material("Brushed steel", {"baseColorFactor": [0.62, 0.6, 0.58, 1.0], "metallicFactor": 1.0, "roughnessFactor": 0.3},
                       {"KHR_materials_anisotropy": {"anisotropyStrength": 0.7}})
    d.place("Bob", ("layered ball", lambda: globe(48, 24)), steel, (0, -1.2, 0), (0.3, 0.3, 0.3))
    d.place("Rod", BOX, d.plain("Rod", [0.1, 0.1, 0.1], 0.5), (0, -0.5, 0), (0.03, 1.0, 0.03))
    bob, rod = d.json["scenes"][0]["nodes"][-2:]
    del d.json["scenes"][0]["nodes"][-2:]
    d.node({"name": "Pendulum", "children": [bob, rod], "translation": [-0.7, 2.0, 0]})
    pendulum = len(d.json["nodes"]) - 1
    d.place("Glass ball", BALL, d.glass("Amber", 0.1, 2.0, [0.9, 0.5, 0.12], 0.6), (0.7, 0.35, 0.3), (0.35, 0.35, 0.35))
    ball = len(d.json["nodes"]) - 1
    d.place("Box", BOX, d.plain("Red", [0.7, 0.06, 0.05], 0.5), (0.1, 0.25, -0.8), (0.5, 0.5, 0.5))
    jumper = len(d.json["nodes"]) - 1
    swing = [0.5 * math.cos(math.pi * k / 8) for k in range(17)]
    channels = (
        (pendulum, "rotation", "LINEAR", [k / 8 for k in range(17)], [(0.0, 0.0, math.sin(a / 2), math.cos(a / 2)) for a in swing]),
        # In-tangent, value, out-tangent: it meets the floor at speed and leaves it as fast.
        (ball, "translation", "CUBICSPLINE", [0.0, 1.0, 2.0],
         [v for speed in ((0, 4), (-4, 4), (-4, 0)) for v in ((0.0, float(speed[0]), 0.0), (0.7, 0.35, 0.3), (0.0, float(speed[1]), 0.0))]),
        (jumper, "translation", "STEP", [0.0, 0.5, 1.0, 1.5], [(x, 0.25, -0.8) for x in (0.1, 0.5, 0.9, 0.5)]))
    animation = {"name": "Motion", "channels": [], "samplers": []}
    for k, (node, path, interpolation, times, values) in enumerate(channels):
        data = struct.pack(f"<{len(times)}f", *times)
        d.json["accessors"].append({"bufferView": d.view(data), "componentType": 5126, "count": len(times), "type": "SCALAR",
                                    "min": [min(times)], "max": [max(times)]})
        d.json["accessors"].append({"bufferView": d.view(struct.pack(f"<{len(values) * len(values[0])}f", *[c for v in values for c in v])),
                                    "componentType": 5126, "count": len(values), "type": f"VEC{len(values[0])}"})
        animation["samplers"].append({"input": len(d.json["accessors"]) - 2, "output": len(d.json["accessors"]) - 1,
                                      "interpolation": interpolation})
        animation["channels"].append({"sampler": k, "target": {"node": node, "path": path}})
    d.json["animations"] = [animation]
    d.camera((0, 1.4, 5.4), (0, 1.0, 0), 34)
    return d


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    scenes = {"ball-grid": ball_grid(), "slabs-0.02": slabs(0.02), "slabs-0.2": slabs(0.2), "slabs-2": slabs(2.0),
              "panes": panes(), "glass-behind-glass": glass_behind_glass(), "wineglass": wineglass(), "etched": etched(),
              "contact": contact(), "odd-neighbours": odd_neighbours(), "lamp": lamp(),
              "bottle": frosted_bottle(), "window": bathroom_window(), "tumbler": etched_tumbler(), "gem": gem(),
              "brushed": brushed_metal(), "layers": layers(), "motion": motion()}
    for name, document in scenes.items():
        data = document.bytes()
        (folder / f"{name}.glb").write_bytes(data)
        print(f"{name}.glb  {len(data)} bytes")


if __name__ == "__main__":
    main()
