"""Scenes by name: a list of (mesh, material), a camera, an environment."""
from .materials import brushed_gold, diffuse, glass, gold
from .meshes import ball, box, checkers, globe, half, suzanne, turned
from .places import ENVIRONMENTS


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
    # Bodies of two materials, and a solid whose wall is its container's.
    outer = ball([0, 0, 0], 0.9, rings)
    two = [(half(outer, True), glass(0.0)), (half(outer, False), glass(0.2) | {"joins": True})]
    shell = glass(0.0)
    inner = ball([0, 0, 0], 0.7, rings)
    liquid = [
        (outer, shell),
        (turned(inner), shell | {"joins": True, "bsdf": None}),
        (inner, glass(0.0, ior=1.33, outside=1.5)),
    ]
    close = {"eye": [0, 0, 7], "target": [0, 0, 0], "fovy": 25}
    face = {"eye": [1.0, 0.6, 4.2], "target": [0, 0, 0], "fovy": 38}
    sky = next(e for e in ENVIRONMENTS if "royal" in e.name)
    result = {
        "ball grid GGX": (grid, camera, sky),
        "ball grid Beckmann": (beckmann, camera, sky),
        "slabs over checkers": (board + slabs, aslant, sky),
        "absorbing glass": (absorbing, close, sky),
        "one body of two materials": (two, close, sky),
        "liquid in glass": (liquid, close, sky),
    }
    brushed = [
        (globe([2.0 * (i % 2) - 1.0, 1.0 - 2.0 * (i // 2), 0], 0.9, rings), brushed_gold(across, strength))
        for i, (across, strength) in enumerate(((0.05, 0.4), (0.05, 0.7), (0.2, 0.5), (0.2, 0.8)))
    ]
    result["gold brushed"] = (brushed, {"eye": [0, 0, 9], "target": [0, 0, 0], "fovy": 28}, sky)
    for i, environment in enumerate(ENVIRONMENTS):
        distribution = ("ggx", "beckmann")[i % 2]
        name = f"gold {distribution} {environment.stem.replace('_1k', '')}"
        result[name] = ([(suzanne(), gold(0.2, distribution))], face, environment)
    return result
