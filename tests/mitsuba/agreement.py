"""Compares groundglass with Mitsuba 3, which shares no text with it: f, pdf and both transport modes.

    agreement.py GROUNDGLASS [--count N]

Run on demand, with a Python that has `mitsuba` and `numpy` from PyPI. For each of roughdielectric (reflection,
transmission) and roughconductor, with GGX and Beckmann, N random configurations are put to both programs: either side
of the interface, alpha 0.05 to 1, index 1.1 to 2.4 or metal n 0.1 to 4, k 0 to 8. Printed are relative differences
against `groundglass eval --backend cpu`; what is left is Mitsuba's float32 arithmetic.

How the conventions map. Mitsuba's wi is the known direction (Walter's i), wo the other (o); eval() is f |cos(wo)|; its
eta is n_transmitted / n_incident seen from wi, as ours. TransportMode.Importance is Walter's f_t, power that scatters from
i to o: our f_cos. TransportMode.Radiance carries the other way and has the factor 1 / eta² for the widening of the lobe:
our f_cos / eta², which shaders/bsdf/transmission.glsl calls transmissionF. Reflection is the same in both modes. pdf() is
of wo, times the probability F (or 1 - F) of choosing the lobe: our pdf_vndf F, pdf_vndf (1 - F); GGX only.
"""
import argparse
import csv
import math
import os
import subprocess
import sys
import tempfile

import mitsuba
import numpy

mitsuba.set_variant("scalar_rgb")

FIELDS = ["id", "lobe", "dist", "alpha", "eta", "cn", "ck", "ix", "iy", "iz", "ox", "oy", "oz", "nx", "ny", "nz"]
# Mitsuba evaluates in float32, mostly from vectors in the local frame: a few roundings of 6e-8, more in the tails of the
# narrowest lobes. A wrong factor, exponent or convention shows at 1e-2.
MEDIAN_LIMIT, P99_LIMIT = 1e-6, 2e-5


def facet(random, dist, alpha):
    u = random.uniform(1e-4, 0.999)
    slope = alpha * math.sqrt(u / (1 - u) if dist == "ggx" else -math.log(1 - u))
    phi = random.uniform(0, 2 * math.pi)
    m = numpy.array([slope * math.cos(phi), slope * math.sin(phi), 1.0])
    return m / numpy.sqrt(m @ m)


def configurations(random, lobe, dist, metal, count):
    """Random paths over one facet, incident within 85 degrees of the normal."""
    made = []
    while len(made) < count:
        alpha = 10 ** random.uniform(math.log10(0.05), 0)
        inside = not metal and random.randint(2) == 1
        ior = random.uniform(1.1, 2.4)
        eta = 1 / ior if inside else ior
        cosine, phi = random.uniform(math.cos(math.radians(85)), 1), random.uniform(0, 2 * math.pi)
        sine = math.sqrt(1 - cosine * cosine)
        i = numpy.array([sine * math.cos(phi), sine * math.sin(phi), cosine])
        m = facet(random, dist, alpha)
        c = i @ m
        if c <= 0.02:
            continue
        if lobe == "R":
            o = 2 * c * m - i
        else:
            radicand = eta * eta - 1 + c * c
            if radicand <= 1e-3:
                continue
            o = ((c - math.sqrt(radicand)) * m - i) / eta
        if abs(o[2]) < 0.05 or (o[2] > 0) != (lobe == "R"):
            continue
        flip = numpy.array([1, 1, -1.0 if inside else 1.0])
        i, o = numpy.float32(i * flip), numpy.float32(o * flip)
        made.append(dict(alpha=float(numpy.float32(alpha)), ior=float(numpy.float32(ior)), inside=inside,
                         n=float(numpy.float32(random.uniform(0.1, 4))), k=float(numpy.float32(random.uniform(0, 8))),
                         i=i, o=o))
    return made


def ours(program, lobe, dist, metal, cases):
    with tempfile.TemporaryDirectory() as folder:
        queries, values = os.path.join(folder, "queries.csv"), os.path.join(folder, "values.csv")
        with open(queries, "w", newline="") as file:
            out = csv.writer(file)
            out.writerow(FIELDS)
            for number, case in enumerate(cases):
                eta = 0 if metal else (1 / case["ior"] if case["inside"] else case["ior"])
                numbers = [case["alpha"], eta, case["n"], case["k"], *case["i"], *case["o"], 0, 0, 1]
                out.writerow([number, lobe, dist] + [f"{x:.9g}" for x in numbers])
        subprocess.run([program, "eval", "--backend", "cpu", "--in", queries, "--output", values], check=True)
        with open(values, newline="") as file:
            return [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]


def theirs(lobe, dist, metal, case):
    common = {"distribution": dist, "alpha": case["alpha"]}
    if metal:
        bsdf = mitsuba.load_dict({"type": "roughconductor", "eta": case["n"], "k": case["k"], **common})
    else:
        bsdf = mitsuba.load_dict({"type": "roughdielectric", "int_ior": case["ior"], "ext_ior": 1.0, **common})
    hit = mitsuba.SurfaceInteraction3f()
    hit.wi = mitsuba.Vector3f(*[float(x) for x in case["i"]])
    o = mitsuba.Vector3f(*[float(x) for x in case["o"]])
    context = lambda mode: mitsuba.BSDFContext(mode)
    importance = bsdf.eval(context(mitsuba.TransportMode.Importance), hit, o)[0]
    radiance = bsdf.eval(context(mitsuba.TransportMode.Radiance), hit, o)[0]
    return importance, radiance, bsdf.pdf(context(mitsuba.TransportMode.Radiance), hit, o)


def statistics(ours_, theirs_):
    a, b = numpy.array(ours_), numpy.array(theirs_)
    error = numpy.abs(a - b) / numpy.maximum(numpy.abs(a), 1e-30)
    return numpy.median(error), numpy.sort(error)[int(0.99 * len(error))], error.max()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("groundglass")
    parser.add_argument("--count", type=int, default=2000)
    arguments = parser.parse_args()
    random = numpy.random.RandomState(2007)
    print(f"Mitsuba {mitsuba.__version__} ({mitsuba.variant()}), {arguments.count} random configurations a line; "
          "relative differences from groundglass\n")
    print("| plugin | lobe | distribution | quantity | median | p99 | max |\n|---|---|---|---|---|---|---|")
    good = True
    for metal, lobe in ((False, "R"), (False, "T"), (True, "R")):
        for dist in ("ggx", "beckmann"):
            cases = configurations(random, lobe, dist, metal, arguments.count)
            mine = ours(arguments.groundglass, lobe, dist, metal, cases)
            other = [theirs(lobe, dist, metal, case) for case in cases]
            f = [v["f_cos"] for v in mine]
            lines = [("f cos, importance", f, [t[0] for t in other])]
            eta = [1.0 if metal or lobe == "R" else (1 / c["ior"] if c["inside"] else c["ior"]) for c in cases]
            lines.append(("f cos, radiance", [x / (e * e) for x, e in zip(f, eta)], [t[1] for t in other]))
            if dist == "ggx":
                share = [1.0 if metal else v["F" if lobe == "R" else "omF"] for v in mine]
                lines.append(("pdf of visible normals", [v["pdf_vndf"] * s for v, s in zip(mine, share)],
                              [t[2] for t in other]))
            for name, a, b in lines:
                median, p99, largest = statistics(a, b)
                good = good and median < MEDIAN_LIMIT and p99 < P99_LIMIT
                plugin = "roughconductor" if metal else "roughdielectric"
                print(f"| {plugin} | {'reflection' if lobe == 'R' else 'transmission'} | {dist} | {name} | {median:.1e} "
                      f"| {p99:.1e} | {largest:.1e} |")
    print("\nThey agree." if good else "\nThey DISAGREE.")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
