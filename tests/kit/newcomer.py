#!/usr/bin/env python3
"""Goes the way that each kit's README describes, from nothing to a picture, and prints how long each step took.

    tests/kit/newcomer.py BUILD [--target NAME...] [--keep DIR]

three and webgl2: a server of files and a screenshot of the page in headless Chromium on its software device; three.js comes from npm.
opengl and vulkan: CMake, Debian's packages, one frame offscreen. Fails if a step fails or leaves no picture.
"""

import argparse
import functools
import http.server
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time

TARGETS = ("three", "webgl2", "opengl", "vulkan")


# The page in a frame, and a picture that is not there until the page says how many milliseconds a frame takes: so long the screenshot waits.
FRAME = b"""<!doctype html><body style="margin:0"><iframe src="/index.html" style="border:0;width:640px;height:480px"></iframe><img src="/shown" hidden>
<script>
const look = setInterval(() => {
  const text = document.querySelector('iframe').contentDocument?.body?.innerText ?? '';
  if (/[1-9][0-9.]* ms/.test(text)) { clearInterval(look); fetch('/drawn'); }
}, 50);
</script>"""


class Handler(http.server.SimpleHTTPRequestHandler):
    def do_GET(self):
        if self.path == "/frame.html":
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(FRAME)
        elif self.path in ("/shown", "/drawn"):
            self.server.drawn.set() if self.path == "/drawn" else self.server.drawn.wait(120)
            self.send_response(204)
            self.end_headers()
        else:
            super().do_GET()

    def log_message(self, *_):
        pass


def screenshot(folder, profile):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=str(folder)))
    server.drawn = threading.Event()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    run(folder, "chromium", "--headless", "--no-sandbox", "--no-first-run", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
        "--ignore-gpu-blocklist", "--hide-scrollbars", "--window-size=640,480", f"--user-data-dir={profile}",
        "--screenshot=picture.png", f"http://127.0.0.1:{server.server_port}/frame.html")
    server.shutdown()
    if not server.drawn.is_set():
        sys.exit("the page drew nothing")


def run(folder, *words):
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}\n{done.stdout}{done.stderr}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--target", nargs="*", default=TARGETS)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the pictures")
    options = parser.parse_args()
    program = options.build.resolve() / "groundglass"
    for target in options.target:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch: # the browser's children may outlive it
            folder, profile = pathlib.Path(scratch) / "DIR", pathlib.Path(scratch) / "profile"
            steps = [("groundglass kit", lambda: run(scratch, program, "kit", "--target", target, "-o", folder))]
            if target == "three":
                steps.append(("npm install", lambda: run(folder, "npm", "install", "--silent", "--no-audit", "--no-fund")))
            if target in ("three", "webgl2"):
                picture = folder / "picture.png"
                steps.append(("page", lambda: screenshot(folder, profile)))
            else:
                picture = folder / "picture.png"
                steps += [("cmake", lambda: run(folder, "cmake", "-G", "Ninja", "-B", "build")), ("build", lambda: run(folder, "cmake", "--build", "build")),
                          ("picture", lambda: run(folder, "build/rough_glass"))]
            line, whole = [], time.monotonic()
            for name, step in steps:
                start = time.monotonic()
                step()
                line.append(f"{name} {time.monotonic() - start:.1f} s")
            if not picture.exists() or os.path.getsize(picture) < 10000:
                sys.exit(f"{target}: no picture")
            print(f"{target}: {', '.join(line)}; in all {time.monotonic() - whole:.1f} s", flush=True)
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(picture, options.keep / f"{target}{picture.suffix}")


if __name__ == "__main__":
    main()
