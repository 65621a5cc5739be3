"""Compares values of the BSDF with the truth, class by class: the stability table, and its limits as a check.

    table.py CASES.csv TRUTH.csv NAME=VALUES.csv... [--value f] [--split] [--check NAME=float|double[,everywhere]]...

Relative errors; `noise` is what half an ulp of input noise does to the truth itself; `bad` counts NaN or Inf / negative
values / values that are not exactly 0 where the configuration is impossible. With --check, every value of the
named file is held to the limits below and the exit status is 1 if one breaks.
"""
import argparse
import csv
import sys

import numpy

VALUES = ["D", "G", "G2", "F", "omF", "f", "f_cos", "f_G2", "pdf_D", "pdf_vndf"]

# The limits, for float32. MEDIAN and P99 are a few roundings of 6e-8 each and hold where the inputs are well
# conditioned; NOISE is how much more than half an ulp of input noise an evaluation may add where they are not.
MEDIAN, P99, NOISE = 3e-7, 2e-6, 4.0
# What the compensated half-vector holds in every row, ill-conditioned or not. What is left is the argument of Beckmann's
# and Phong's exponential: up to 70 (beyond it D is under FLOOR), rounded three times at 6e-8.
EVERYWHERE = 1.4e-5
# In double the same text rounds at 2^-53 instead of 2^-24.
SCALE = {"float": 1.0, "double": 2.0**-29}
# Below the smallest normal float32 a device may return anything from 0 to that number; products on the way to a value
# (an exponential times a Jacobian) leave the range up to eight decades earlier.
FLOOR = {"float": 1e-30, "double": 1e-300}


def read(path, columns):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    return rows, {c: numpy.array([float(row[c]) for row in rows]) for c in columns}


class Compared:
    """One value of one file against the truth, row by row."""

    def __init__(self, got, truth, noise, precision):
        floor, scale = FLOOR[precision], SCALE[precision]
        self.not_finite = ~numpy.isfinite(got)
        self.negative = got < 0
        got = numpy.where(numpy.isfinite(got), got, 0)
        difference = numpy.abs(got - truth)
        size = numpy.maximum(numpy.abs(truth), floor)
        tiny = (truth < floor) & (got <= floor)
        self.error = numpy.where(tiny, 0, difference / size)
        self.noise = numpy.where(tiny, 0, noise * scale / size)
        # Exactly 0 is asked for where the configuration is impossible and stays so under the noise.
        self.not_zero = (truth == 0) & (noise == 0) & (got != 0)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            self.share = numpy.where(self.error == 0, 0, self.error / numpy.maximum(P99 * scale, NOISE * self.noise))
        self.scale = scale

    def broken(self, rows, everywhere):
        """What is wrong with these rows, in words."""
        said = []
        for count, what in ((self.not_finite, "NaN or Inf"), (self.negative, "negative"),
                            (self.not_zero, "not exactly 0")):
            if count[rows].any():
                said.append(f"{count[rows].sum()} {what}")
        error, noise = self.error[rows], self.noise[rows]
        median, allowed = numpy.median(error), max(MEDIAN * self.scale, NOISE * numpy.median(noise))
        if median > allowed:
            said.append(f"median {median:.1e} > {allowed:.1e}")
        p99, allowed = percentile(error), max(P99 * self.scale, NOISE * percentile(noise))
        if p99 > allowed:
            said.append(f"p99 {p99:.1e} > {allowed:.1e}")
        if everywhere and error.max() > EVERYWHERE * self.scale:
            said.append(f"largest {error.max():.1e} > {EVERYWHERE * self.scale:.1e}")
        return said


def percentile(values, share=0.99):
    return numpy.sort(values)[int(numpy.ceil(share * len(values))) - 1]


def number(x):
    if x > 1e6:
        return "> 1e6"
    return "0" if x == 0 else f"{x:.1e}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e")


def counts(compared, rows):
    """NaN or Inf / negative / something where exactly 0 is right."""
    each = [int(c[rows].sum()) for c in (compared.not_finite, compared.negative, compared.not_zero)]
    return " / ".join(map(str, each)) if any(each) else "0"


def table(groups, compared, names):
    head = ["class", "rows", "noise p99"]
    for name in names:
        head += [f"{name} median", "p99", "max", "bad"]
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for key, rows in groups.items():
        first = compared[names[0]]
        cells = [key, str(len(rows)), number(percentile(first.noise[rows] / first.scale))]
        for name in names:
            c = compared[name]
            error = c.error[rows]
            cells += [number(numpy.median(error)), number(percentile(error)), number(error.max()), counts(c, rows)]
        print("| " + " | ".join(cells) + " |")


def grouped(rows, key):
    groups = {}
    for number_, row in enumerate(rows):
        groups.setdefault(key(row), []).append(number_)
    return {k: numpy.array(v) for k, v in groups.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("cases")
    parser.add_argument("truth")
    parser.add_argument("values", nargs="+", help="NAME=FILE")
    parser.add_argument("--value", default="f", choices=VALUES, help="which column the table is about")
    parser.add_argument("--split", action="store_true", help="a line for each lobe and distribution")
    parser.add_argument("--check", action="append", default=[], help="NAME=float or NAME=double, then maybe ,everywhere")
    parser.add_argument("--expect-broken", metavar="NAME", help="succeed only if this float file breaks limits")
    arguments = parser.parse_args()

    cases, _ = read(arguments.cases, [])
    truth_rows, truth = read(arguments.truth, VALUES + [v + "_noise" for v in VALUES])
    checks = dict(c.split("=", 1) for c in arguments.check)
    if arguments.expect_broken:
        checks[arguments.expect_broken] = "float"
    files = {}
    for item in arguments.values:
        name, path = item.split("=", 1)
        rows, files[name] = read(path, VALUES)
        for a, b, c in zip(cases, truth_rows, rows, strict=True):
            if not a["id"] == b["id"] == c["id"]:
                sys.exit(f"{path}: row {c['id']} stands where {a['id']} is expected")

    def compare(name, value):
        precision = checks.get(name, "double" if name == "cpu" else "float").split(",")[0]
        return Compared(files[name][value], truth[value], truth[value + "_noise"], precision)

    by_class = grouped(cases, lambda r: r["class"])
    by_class["all"] = numpy.arange(len(cases))
    by_all = grouped(cases, lambda r: f"{r['class']} {r['lobe']} {r['dist']}")
    table(by_all if arguments.split else by_class, {n: compare(n, arguments.value) for n in files}, list(files))

    failures = 0
    for name in checks:
        for value in VALUES:
            compared = compare(name, value)
            for key, rows in by_all.items():
                for words in compared.broken(rows, checks[name].endswith(",everywhere")):
                    failures += 1
                    if arguments.expect_broken:
                        continue
                    worst = rows[numpy.argmax(compared.share[rows])]
                    print(f"{name}: {value} in {key}: {words} (worst id {cases[worst]['id']})")
    if checks:
        print(f"{failures} limits broken" if failures else f"All limits hold for {', '.join(checks)}.")
    sys.exit(1 if (failures > 0) != bool(arguments.expect_broken) else 0)


if __name__ == "__main__":
    main()
