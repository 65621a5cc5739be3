#!/usr/bin/env python3
"""Every snippet in every target, by a compiler of that target; prints the table.

    tests/snippet/matrix.py GROUNDGLASS [--write] [NAME...]

glsl, vulkan, essl, hlsl: glslang (Debian's glslang-tools; HLSL by its HLSL front end). cpp: g++ with GLM, float and double. wgsl: naga, if
it is there; without it, only that the text is made of the snippets as they are (shaders/wgsl/make --check). msl: none can be had, Metal's
compiler is Apple's alone: that SPIRV-Cross makes it is all that is shown. --write keeps the table in shaders/compiled.txt, which `groundglass snippet
--list` prints; without it, what that file says otherwise of a snippet fails.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent
KEPT = ROOT / "shaders/compiled.txt"
CPP = ("g++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function")
TARGETS = ("glsl", "vulkan", "essl", "hlsl", "msl", "wgsl", "cpp")


def run(words, text=None):
    done = subprocess.run(words, input=text, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def compiler(target, folder, naga):
    """Name, what goes before and after the text, the file's suffix, and the command that compiles it."""
    fragment = "\nvoid main() { pixel = vec4(0.0); }\n"
    glsl = "#version 450\nlayout(location = 0) out vec4 pixel;\n"
    return {
        "glsl": ("glslang -G", glsl, fragment, "frag", ["glslangValidator", "-G", "-o", os.devnull]),
        "vulkan": ("glslang -V", glsl, fragment, "frag", ["glslangValidator", "-V", "-o", os.devnull]),
        "essl": ("glslang", "#version 300 es\n", "\nout vec4 pixel;" + fragment, "frag", ["glslangValidator"]),
        "hlsl": ("glslang -D", "", "\nfloat4 shade() : SV_Target { return 0.0; }\n", "frag", ["glslangValidator", "-D", "-V", "-e", "shade", "-o", os.devnull]),
        "msl": ("none", "", "", "metal", None),
        "wgsl": (f"naga {naga}" if naga else "none (no naga)", "", "", "wgsl", ["naga"] if naga else None),
        "cpp": ("g++ -std=c++20", "", "", "cpp", [*CPP, "-fsyntax-only", "-include", f"{folder}/ahead.h"]),
    }[target]


def main():
    program, chosen, write = sys.argv[1], [word for word in sys.argv[2:] if word != "--write"], "--write" in sys.argv
    kept = dict(line.split(None, 1) for line in KEPT.read_text().splitlines()) if KEPT.exists() else {}
    lines = []

    def say(line):
        print(line, flush=True)
        lines.append(line.rstrip())

    naga = run(["naga", "--version"])[1].strip() if shutil.which("naga") else ""
    if run([sys.executable, ROOT / "shaders/wgsl/make", program, "--check"])[0]:
        sys.exit("shaders/wgsl/snippets.wgsl is out of date: run shaders/wgsl/make " + program)
    files = sorted(path for folder in ("bsdf", "color", "environment", "neighbours", "refraction") for path in (ROOT / "shaders" / folder).glob("*.glsl"))
    failed, counts = [], {target: 0 for target in TARGETS}
    with tempfile.TemporaryDirectory() as folder:
        table = {target: compiler(target, folder, naga) for target in TARGETS}
        say("compilers: " + ", ".join(f"{target} {table[target][0]}" for target in TARGETS))
        say(f"{'snippet':<34}" + "".join(f"{target:<8}" for target in TARGETS))
        # GLM and the standard headers once for all: what each text includes itself finds them read.
        (pathlib.Path(folder) / "ahead.h").write_text("#include <cmath>\n#include <type_traits>\n#include <glm/glm.hpp>\n")
        run([*CPP, "-x", "c++-header", f"{folder}/ahead.h"])

        def compiled(file, target):
            """What the table says of it, and what went wrong."""
            name = f"{file.parent.name}/{file.stem}"
            code, text = run([program, "snippet", name, "--target", target])
            _, before, after, suffix, command = table[target]
            if code == 4 and file.stem.endswith("_fetch") and target in ("wgsl", "cpp"):
                return "-", ""
            path, log = pathlib.Path(folder) / f"{file.parent.name}-{file.stem}-{target}.{suffix}", text
            # What an engine supplies: a body that returns zero.
            supplied = "".join(f"{header} {{ return {kind}(); }}\n" for header, kind in re.findall(r"^// Yours to supply: (fn .* -> (.*))$", text, re.M))
            path.write_text(before + text.replace("#pragma once", "") + supplied + after)
            if code == 0 and command:
                code, log = run([*command, path])
            return ("FAILED", f"{name} {target}:\n{log}") if code else ("ok" if command else "made", "")

        files = [file for file in files if not chosen or file.stem in chosen]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(lambda job: compiled(*job), [(file, target) for file in files for target in TARGETS]))
        for k, file in enumerate(files):
            name, cells = f"{file.parent.name}/{file.stem}", results[k * len(TARGETS) : (k + 1) * len(TARGETS)]
            for target, (word, log) in zip(TARGETS, cells):
                counts[target] += word in ("ok", "made")
                failed += [log] if log else []
            row = "".join(f"{word:<8}" for word, _ in cells)
            say(f"{name:<34}{row}")
            if not write and name in kept and kept[name].split() != row.split() and naga:
                failed.append(f"{name}: shaders/compiled.txt says {kept[name]}: write it again with --write")
    print(f"{'compile':<34}" + "".join(f"{counts[target]:<8}" for target in TARGETS))
    if failed:
        sys.exit("\n".join(failed))
    if write and not chosen:
        KEPT.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
