#!/usr/bin/python3
"""The proof of numerical stability: everything from the cases to the tables, in one command.

    proof.py BUILD                 the stability table of f and the cost table
    proof.py BUILD --value D       the same of another value
    proof.py BUILD --split         a line for each lobe and distribution
    proof.py BUILD --backend vulkan
    proof.py BUILD --only STEP     what ctest runs, one property a time: prepare, cpu, stable, compensated, textbook

BUILD is a build directory. Files are kept in BUILD/test-output/stability.
"""
import argparse
import csv
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


class Proof:
    def __init__(self, build, backend):
        self.backend = backend
        self.program = os.path.join(build, "groundglass")
        self.variants = os.path.join(build, "tests", "stability", "stability_variants")
        self.folder = os.path.join(build, "test-output", "stability")
        os.makedirs(self.folder, exist_ok=True)

    def file(self, name):
        return os.path.join(self.folder, name + ".csv")

    def run(self, *words):
        return subprocess.run(words, check=False).returncode

    def must(self, *words):
        status = self.run(*words)
        if status != 0:
            sys.exit(f"{words[0]} failed with {status}")

    def python(self, script, *words):
        return (sys.executable, os.path.join(HERE, script), *words)

    def prepare(self):
        self.must(*self.python("cases.py", self.file("cases")))
        self.must(*self.python("truth.py", self.file("cases"), self.file("truth")))

    def values(self, name):
        cases, out = self.file("cases"), self.file(name if name == "cpu" else f"{name}-{self.backend}")
        if name == "cpu":
            self.must(self.program, "eval", "--backend", "cpu", "--in", cases, "--output", out)
        elif name == "textbook":
            self.must(self.variants, self.backend, "values", name, cases, out)
        else:
            self.must(self.program, "eval", "--backend", self.backend, "--form", name, "--in", cases, "--output", out)
        return f"{name}={out}"

    def table(self, names, *words):
        files = [self.values(name) for name in names]
        return self.run(*self.python("table.py", self.file("cases"), self.file("truth"), *files, *words))

    def cost(self):
        """On ordinary rows: on the hardest ones a branch that is not taken would pass for speed."""
        with open(self.file("cases"), newline="") as file, open(self.file("ordinary"), "w", newline="") as ordinary:
            rows = csv.DictReader(file)
            out = csv.DictWriter(ordinary, rows.fieldnames)
            out.writeheader()
            out.writerows(row for row in rows if row["class"] in ("ordinary", "tilted", "eta_2_4"))
        return self.run(self.variants, self.backend, "cost", self.file("ordinary"))

    def check(self, name):
        if name == "textbook":
            # The other way round: if the usual formulas passed, the cases would not be hard or the limits not be limits.
            return self.table([name], "--expect-broken", name)
        limits = {"cpu": "cpu=double", "stable": "stable=float", "compensated": "compensated=float,everywhere"}
        return self.table([name], "--check", limits[name])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--value", default="f")
    parser.add_argument("--backend", default="opengl", choices=["opengl", "vulkan"])
    parser.add_argument("--split", action="store_true")
    parser.add_argument("--only", choices=["prepare", "cpu", "stable", "compensated", "textbook"])
    arguments = parser.parse_args()
    proof = Proof(arguments.build, arguments.backend)
    if arguments.only == "prepare":
        proof.prepare()
    elif arguments.only:
        sys.exit(proof.check(arguments.only))
    else:
        proof.prepare()
        more = ["--value", arguments.value] + (["--split"] if arguments.split else [])
        proof.table(["cpu", "textbook", "stable", "compensated"], *more)
        print()
        sys.stdout.flush()
        sys.exit(proof.cost())


if __name__ == "__main__":
    main()
