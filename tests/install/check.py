#!/usr/bin/env python3
"""Installs into a folder that did not exist, draws from / with nothing set, and builds a program that finds the package.

    tests/install/check.py BUILD
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
# Neither a home of the caller's nor the source's may stand in for what is installed.
PLAIN = {name: value for name, value in os.environ.items() if not name.startswith("GROUNDGLASS")}


def run(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, env=PLAIN, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        prefix = pathlib.Path(scratch) / "prefix"
        run("cmake", "--install", build, "--prefix", prefix)
        program, data = prefix / "bin/groundglass", prefix / "share/groundglass"
        # It reads its own files: a mark in the installed shader is printed.
        with open(data / "shaders/bsdf/ggx.glsl", "a") as shader:
            shader.write("// the installed one\n")
        if "the installed one" not in run(program, "snippet", "ggx", cwd="/"):
            sys.exit("the installed program reads shaders from somewhere else")
        picture = pathlib.Path(scratch) / "picture.png"
        run(program, "capture", data / "assets/scenes/slabs-0.2.glb", "--size", "48x48", "-o", picture, cwd="/")
        if picture.stat().st_size < 500:
            sys.exit("capture drew nothing")
        run(program, "kit", "--target", "three", "-o", pathlib.Path(scratch) / "kit", cwd="/")
        run("cmake", "-G", "Ninja", "-S", HERE / "consumer", "-B", pathlib.Path(scratch) / "consumer", f"-DCMAKE_PREFIX_PATH={prefix}")
        run("cmake", "--build", pathlib.Path(scratch) / "consumer")
        run(pathlib.Path(scratch) / "consumer/consumer", cwd="/")
    print("installed, drawn from /, found by find_package")


if __name__ == "__main__":
    main()
