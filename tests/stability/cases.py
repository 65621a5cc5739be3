"""The hard cases on which shaders/bsdf is measured: seeded, about 24,000 rows, inputs exact float32.

    cases.py CASES.csv

Columns are those that `groundglass eval` reads, and `class`, which it ignores. A class is made for every distribution
and both lobes where it means something. Directions are drawn by choosing the incident direction and the facet and then
reflecting or refracting in double, so that each row is a configuration the renderer can meet; rounding to float32 comes
last, and what is asked for is the value at the rounded inputs.
"""
import csv
import math
import sys

import numpy

ROWS = 190  # per class, distribution and lobe
SEED = 2007
FIELDS = ["id", "lobe", "dist", "alpha", "eta", "cn", "ck", "ix", "iy", "iz", "ox", "oy", "oz", "nx", "ny", "nz", "class"]
N = numpy.array([0.0, 0.0, 1.0])


class Draw:
    """Random numbers in the shapes that the classes want. RandomState's stream is frozen by numpy's promise."""

    def __init__(self, seed):
        self.random = numpy.random.RandomState(seed)

    def uniform(self, low, high):
        return self.random.uniform(low, high)

    def decades(self, low, high):
        return 10.0 ** self.random.uniform(low, high)

    def sign(self):
        return 1.0 if self.random.randint(2) else -1.0

    def at(self, theta):
        """A direction at angle theta from +z, any azimuth."""
        phi = self.uniform(0, 2 * math.pi)
        return numpy.array([math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)])

    def grazing(self, low=-6, high=-2):
        return self.above(self.decades(low, high))

    def above(self, elevation):
        phi = self.uniform(0, 2 * math.pi)
        c, s = math.cos(elevation), math.sin(elevation)
        return numpy.array([c * math.cos(phi), c * math.sin(phi), s])

    def hemisphere(self):
        return self.at(math.acos(self.uniform(0.02, 1)))

    def near(self, v, angle):
        """A direction at `angle` from v."""
        helper = numpy.array([1.0, 0, 0]) if abs(v[0]) < 0.6 else numpy.array([0, 1.0, 0])
        a = unit(numpy.cross(v, helper))
        b = numpy.cross(v, a)
        phi = self.uniform(0, 2 * math.pi)
        return math.cos(angle) * v + math.sin(angle) * (math.cos(phi) * a + math.sin(phi) * b)

    def facet(self, alpha, low=0.0, high=1.0):
        """A facet whose slope is alpha times something in [low, high]: inside the lobe for 1, in its tail beyond."""
        return self.at(math.atan(alpha * self.uniform(low, high)))

    def rotation(self):
        q = unit(self.random.normal(size=4))
        w, x, y, z = q
        return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])

    def index(self):
        """A relative index from either side of water, glass or flint."""
        eta = self.uniform(1.1, 2.0)
        return eta if self.random.randint(2) else 1 / eta


def unit(v):
    return v / numpy.sqrt(numpy.dot(v, v))


def mirrored(i, m):
    return 2 * numpy.dot(i, m) * m - i


def refracted(i, m, eta):
    """Walter's eq. 40 with eta = eta_o / eta_i; None under total reflection."""
    c = numpy.dot(i, m)
    inside = 1 - (1 - c * c) / (eta * eta)
    if inside <= 0:
        return None
    return (c / eta - math.copysign(math.sqrt(inside), c)) * m - i / eta


def bent(lobe, i, m, eta):
    return mirrored(i, m) if lobe == "R" else refracted(i, m, eta)


class Rejected(Exception):
    """This draw is not a path over a facet: draw again."""


def path(lobe, i, m, eta):
    if numpy.dot(i, m) <= 0:
        raise Rejected
    o = bent(lobe, i, m, eta)
    if o is None or (o[2] > 0) != (lobe == "R"):
        raise Rejected
    return o


# Each class: f(draw, lobe) -> dict with alpha, eta, i, o and where they differ from the defaults n, cn, ck. ------------

def ordinary(d, lobe, alpha=None, eta=None):
    alpha = d.decades(-1.3, 0) if alpha is None else alpha
    eta = d.index() if eta is None else eta
    i, m = d.hemisphere(), d.facet(alpha, 0, 2)
    return dict(alpha=alpha, eta=eta, i=i, o=path(lobe, i, m, eta))


def random_pair(d, lobe):
    """Two directions that know nothing of a facet; in transmission most pairs are none, which then must be exactly 0."""
    o = d.hemisphere()
    return dict(alpha=d.decades(-1.3, 0), eta=d.index(), i=d.hemisphere(), o=o if lobe == "R" else -o)


def grazing_in(d, lobe):
    alpha, eta, i = d.decades(-1.3, 0), d.index(), d.grazing()
    return dict(alpha=alpha, eta=eta, i=i, o=path(lobe, i, d.facet(alpha, 0, 2), eta))


def reversed_path(case, lobe):
    eta = case["eta"] if lobe == "R" else 1 / case["eta"]
    i, o = case["i"], case["o"]
    if lobe == "T":
        flip = numpy.array([1, 1, -1])
        i, o = i * flip, o * flip
    return dict(case, eta=eta, i=o, o=i)


def grazing_out(d, lobe):
    return reversed_path(grazing_in(d, lobe), lobe)


def grazing_both(d, lobe):
    i, o = d.grazing(), d.grazing()
    eta = d.index()
    if lobe == "T":
        # Across the interface nearly unbent, so that a facet of the two exists: the index goes to 1 with the angles.
        eta = 1 + d.sign() * d.decades(-6, -2)
        o = -d.near(i, d.decades(-6, -2))
    return dict(alpha=d.decades(-1.3, 0), eta=eta, i=i, o=o)


def small_alpha_peak(d, lobe):
    return ordinary_facet(d, lobe, d.decades(-4, -2), 0, 2)


def small_alpha_off(d, lobe):
    return ordinary_facet(d, lobe, d.decades(-4, -2), 3, 8)


def ordinary_facet(d, lobe, alpha, low, high):
    eta, i = d.index(), d.hemisphere()
    return dict(alpha=alpha, eta=eta, i=i, o=path(lobe, i, d.facet(alpha, low, high), eta))


def alpha_one(d, lobe):
    return ordinary(d, lobe, alpha=1.0)


def near_normal(d, lobe):
    i, m = d.at(d.decades(-6, -2)), d.at(d.decades(-6, -2))
    eta = d.index()
    return dict(alpha=d.decades(-3, 0), eta=eta, i=i, o=path(lobe, i, m, eta))


def retro(d, lobe):
    i = d.hemisphere()
    o = d.near(i, d.decades(-7, -2)) if d.uniform(0, 1) < 0.9 else i
    return dict(alpha=d.decades(-1, 0), eta=d.index(), i=i, o=o)


def forward_grazing(d, lobe):
    i = d.grazing(-6, -1)
    alpha = d.decades(-3, 0)
    m = d.at(math.atan(alpha * d.uniform(0, 1)) * d.decades(-4, 0))
    eta = d.index() if lobe == "R" else 1 + d.sign() * d.decades(-6, -1)
    return dict(alpha=alpha, eta=eta, i=i, o=path(lobe, i, m, eta))


def eta_near_one(d, lobe):
    return ordinary(d, lobe, eta=1 + d.sign() * d.decades(-6, -1))


def eta_one(d, lobe):
    if lobe == "R":
        return ordinary(d, lobe, eta=1.0)
    i = d.hemisphere()
    o = -i if d.uniform(0, 1) < 0.5 else -d.near(i, d.decades(-7, -1))
    return dict(alpha=d.decades(-3, 0), eta=1.0, i=i, o=o)


def straight_through(d, lobe):
    """i + eta o goes to 0: both the index and the deviation do."""
    eta = 1 + d.sign() * d.decades(-6, -2)
    i, alpha = d.hemisphere(), d.decades(-2, 0)
    return dict(alpha=alpha, eta=eta, i=i, o=path(lobe, i, d.facet(alpha, 0, 2), eta))


def critical(d, lobe, offset):
    """From the dense side, the angle to the facet `offset` radians inside the critical one (beyond it if negative)."""
    eta = 1 / d.uniform(1.1, 2.4)
    alpha = d.decades(-2, 0)
    m = d.facet(alpha, 0, 1)
    i = d.near(m, math.asin(eta) - offset)
    if i[2] <= 0:
        raise Rejected
    return dict(alpha=alpha, eta=eta, i=i, o=path(lobe, i, m, eta))


def critical_at(d, lobe):
    return critical(d, lobe, d.decades(-7, -4) * (d.sign() if lobe == "R" else 1))


def critical_inside(d, lobe):
    return critical(d, lobe, d.decades(-4, -1))


def critical_beyond(d, lobe):
    return critical(d, lobe, -d.uniform(0.001, 0.3))


def facet_horizon(d, lobe):
    """cos of the facet from 1e-6 to 1e-2: only a sideways step between grazing directions, or across, gets there."""
    m = d.grazing()
    eta = d.index() if lobe == "R" else 1 / d.uniform(1.05, 1.6)
    if lobe == "R":
        i = d.above(abs(m[2]) * d.uniform(0.1, 1.9))
        return dict(alpha=d.decades(-1, 0), eta=eta, i=i, o=path(lobe, i, m, eta))
    i = d.hemisphere()
    return dict(alpha=d.decades(-1, 0), eta=eta, i=i, o=path(lobe, i, m, eta))


def eta_2_4(d, lobe):
    return ordinary(d, lobe, eta=2.4 if d.uniform(0, 1) < 0.5 else 1 / 2.4)


def eta_4(d, lobe):
    return ordinary(d, lobe, eta=4.0 if d.uniform(0, 1) < 0.5 else 0.25)


def metal(d, lobe):
    alpha = d.decades(-3, 0)
    grazing = d.uniform(0, 1) < 0.3
    i = d.grazing() if grazing else d.hemisphere()
    o = path(lobe, i, d.facet(alpha, 0, 2), 1.0)
    return dict(alpha=alpha, eta=0.0, cn=d.decades(-1.3, 0.7), ck=d.uniform(0, 10), i=i, o=o)


def huge_d(d, lobe):
    return ordinary_facet(d, lobe, d.decades(-6, -4), 0, 0.5)


def rotated(d, case, **more):
    turn = d.rotation()
    return dict(case, i=turn @ case["i"], o=turn @ case["o"], n=turn @ N, **more)


def tilted(d, lobe):
    return rotated(d, ordinary(d, lobe))


def tilted_grazing(d, lobe):
    return rotated(d, (grazing_in if d.sign() > 0 else grazing_out)(d, lobe))


def tilted_small_alpha(d, lobe):
    return rotated(d, small_alpha_peak(d, lobe))


def from_below(d, lobe):
    """n points away from i: the same interface, named by its other normal."""
    case = rotated(d, ordinary(d, lobe))
    return dict(case, n=-case["n"])


def wrong_side(d, lobe):
    """i and o where the lobe cannot be: exactly 0."""
    i, o = d.hemisphere(), d.hemisphere()
    case = dict(alpha=d.decades(-3, 0), eta=d.index(), i=i, o=-o if lobe == "R" else o)
    return rotated(d, case) if d.sign() > 0 else case


BOTH = [ordinary, random_pair, grazing_in, grazing_out, grazing_both, small_alpha_peak, small_alpha_off, alpha_one,
        near_normal, forward_grazing, eta_near_one, eta_one, critical_at, critical_inside, facet_horizon, eta_2_4, eta_4,
        huge_d, tilted, tilted_grazing, tilted_small_alpha, from_below, wrong_side]
REFLECTION = BOTH + [retro, critical_beyond, metal]
TRANSMISSION = BOTH + [straight_through]


def phong_exponent(alpha):
    """The exponent whose lobe is as wide as Beckmann's of slope width alpha (Walter, section 5.2)."""
    return 2 / (alpha * alpha) - 2


def float32(x):
    return float(numpy.float32(x))


def rows():
    number = 0
    for lobe, classes in (("R", REFLECTION), ("T", TRANSMISSION)):
        for dist in ("ggx", "beckmann", "phong"):
            for make in classes:
                draw = Draw(SEED + number)
                made = 0
                while made < ROWS:
                    try:
                        case = make(draw, lobe)
                    except Rejected:
                        continue
                    alpha = phong_exponent(case["alpha"]) if dist == "phong" else case["alpha"]
                    n = case.get("n", N)
                    numbers = [alpha, case["eta"], case.get("cn", 0), case.get("ck", 0), *case["i"], *case["o"], *n]
                    text = [f"{float32(x):.9g}" for x in numbers]
                    yield [number, lobe, dist, *text, make.__name__]
                    number += 1
                    made += 1


def main():
    with open(sys.argv[1], "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(FIELDS)
        out.writerows(rows())


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
