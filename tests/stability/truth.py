"""Values of Walter's microfacet BSDF to 77 digits, straight from the definitions.

Walter, Marschner, Li, Torrance: "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007. Every line below
is an equation of that paper as it stands (its number beside it), with no rearrangement for numerical stability: at 256
bits none is needed. Nothing here is shared with shaders/bsdf, on purpose: this is what shaders/bsdf is measured by.

    truth.py CASES.csv TRUTH.csv [--noise N]

Columns out are those of `groundglass eval`, and for each of them `<column>_noise`: the largest change of the value when
every non-zero input moves by half a unit in its last float32 place, up or down, over N seeded choices of signs.
"""
import argparse
import csv
import multiprocessing
import random

import gmpy2
import numpy
from gmpy2 import exp, mpfr, sqrt

VALUES = ["D", "G", "G2", "F", "omF", "f", "f_cos", "f_G2", "pdf_D", "pdf_vndf"]
INPUTS = ["alpha", "eta", "cn", "ck", "ix", "iy", "iz", "ox", "oy", "oz", "nx", "ny", "nz"]
BITS = 256
ZERO = [0] * len(VALUES)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def normalised(v):
    length = sqrt(dot(v, v))
    return [x / length for x in v]


def tan2(cosine):
    return (1 - cosine * cosine) / (cosine * cosine)


def distribution(dist, alpha, cos_m):
    """D(m), eqs. 25 (Beckmann), 30 (Phong), 33 (GGX)."""
    pi = gmpy2.const_pi()
    if dist == "ggx":
        return alpha**2 / (pi * cos_m**4 * (alpha**2 + tan2(cos_m)) ** 2)
    if dist == "beckmann":
        return exp(-tan2(cos_m) / alpha**2) / (pi * alpha**2 * cos_m**4)
    return (alpha + 2) / (2 * pi) * cos_m**alpha


def masking(dist, alpha, cos_v):
    """G1 of a direction whose facet is not seen from behind, eqs. 27 (Beckmann and Phong, rational) and 34 (GGX)."""
    tangent = sqrt(tan2(cos_v))
    if dist == "ggx":
        return 2 / (1 + sqrt(1 + alpha**2 * tangent**2))
    if tangent == 0:
        return mpfr(1)
    a = 1 / (alpha * tangent) if dist == "beckmann" else sqrt(alpha / 2 + 1) / tangent
    if a >= mpfr("1.6"):
        return mpfr(1)
    return (mpfr("3.535") * a + mpfr("2.181") * a**2) / (1 + mpfr("2.276") * a + mpfr("2.577") * a**2)


def dielectric(eta, c):
    """F, eq. 22."""
    radicand = eta**2 - 1 + c**2
    if radicand < 0:
        return mpfr(1)
    g = sqrt(radicand)
    return (g - c) ** 2 / (g + c) ** 2 * (1 + (c * (g + c) - 1) ** 2 / (c * (g - c) + 1) ** 2) / 2


def conductor(index, c):
    """F of a complex index n + ik: Fresnel's two amplitudes with Snell's law for the complex cosine."""
    inside = sqrt(1 - (1 - c**2) / index**2)
    s = (c - index * inside) / (c + index * inside)
    p = (index * c - inside) / (index * c + inside)
    return (gmpy2.norm(s) + gmpy2.norm(p)) / 2


def evaluate(lobe, dist, alpha, eta, cn, ck, i, o, n):
    """All values of one row; exactly 0 where i, o cannot be the two ends of a path over a facet."""
    i, o, n = normalised(i), normalised(o), normalised(n)
    i_n, o_n = dot(i, n), dot(o, n)
    if lobe == "R":
        if i_n * o_n <= 0:
            return ZERO
        h = [a + b for a, b in zip(i, o)]  # eq. 13
    else:
        if i_n * o_n >= 0 or eta == 0:
            return ZERO
        h = [a + eta * b for a, b in zip(i, o)]  # eq. 16
    if dot(h, h) == 0:
        return ZERO
    m = normalised(h)
    if dot(m, n) < 0:
        m = [-x for x in m]
    m_n = dot(m, n)
    # G1's chi+, eq. 23. Walter's m is on n's side, i and o on either: a facet is seen from the side that n is seen from.
    i_m, o_m = dot(i, m), dot(o, m)
    if m_n == 0 or i_m * i_n <= 0 or o_m * o_n <= 0:
        return ZERO

    d = distribution(dist, alpha, m_n)
    gi, go = masking(dist, alpha, abs(i_n)), masking(dist, alpha, abs(o_n))
    g = gi * go
    g2 = 1 / (1 + (1 / gi - 1) + (1 / go - 1)) if dist == "ggx" else mpfr(0)
    fresnel = conductor(gmpy2.mpc(cn, ck), abs(i_m)) if eta == 0 else dielectric(eta, abs(i_m))
    if lobe == "R":
        share, jacobian = fresnel, 1 / (4 * abs(o_m))  # eq. 14
    else:
        share, jacobian = 1 - fresnel, eta**2 * abs(o_m) / (i_m + eta * o_m) ** 2  # eq. 17
    # f_s = |i·m| / (|i·n| |o·n|) rho D G dω_m/dω_o: eqs. 20 and 21 are this with the two Jacobians.
    common = abs(i_m) / abs(i_n * o_n) * share * d * jacobian
    visible = gi * abs(i_m) * d / abs(i_n) * jacobian if dist == "ggx" else mpfr(0)
    f = common * g
    return [d, g, g2, fresnel, 1 - fresnel, f, f * abs(o_n), common * g2, d * m_n * jacobian, visible]


def half_ulps(numbers):
    """Half a unit in the last float32 place of each, 0 for 0."""
    return [float(numpy.spacing(numpy.float32(abs(x)))) / 2 if x != 0 else 0.0 for x in numbers]


def evaluate_inputs(row, numbers):
    x = [mpfr(v) for v in numbers]
    return evaluate(row["lobe"], row["dist"], x[0], x[1], x[2], x[3], x[4:7], x[7:10], x[10:13])


def solve(job):
    row, noise = job
    gmpy2.get_context().precision = BITS
    numbers = [float(numpy.float32(row[name])) for name in INPUTS]
    values = evaluate_inputs(row, numbers)
    steps = half_ulps(numbers)
    if numbers[1] == 1:
        steps[1] = 0.0  # index 1 is a case of its own, not a rounded measurement
    signs = random.Random(row["id"])
    spread = [mpfr(0)] * len(VALUES)
    for _ in range(noise):
        moved = [x + signs.choice((-1, 1)) * step for x, step in zip(numbers, steps)]
        spread = [max(s, abs(a - b)) for s, a, b in zip(spread, evaluate_inputs(row, moved), values)]
    return [row["id"]] + [f"{v:.25g}" for v in values] + [f"{v:.6g}" for v in spread]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("cases")
    parser.add_argument("truth")
    parser.add_argument("--noise", type=int, default=8, help="seeded perturbations per row")
    arguments = parser.parse_args()
    with open(arguments.cases, newline="") as file:
        jobs = [(row, arguments.noise) for row in csv.DictReader(file)]
    with multiprocessing.Pool() as pool, open(arguments.truth, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["id"] + VALUES + [v + "_noise" for v in VALUES])
        out.writerows(pool.imap(solve, jobs, chunksize=256))


if __name__ == "__main__":
    main()
