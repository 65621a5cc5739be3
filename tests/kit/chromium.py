#!/usr/bin/env python3
"""Draws the three.js kit in headless Chromium beside stock three.js, and scores both against the path-traced references.

    tests/kit/chromium.py BUILD [--scene NAME...] [--keep DIR]

Needs Debian's chromium and npm, which fetches three.js at the kit's own version. relMSE over pixels that glass covers wholly, in
linear radiance; frame times are the least of interleaved frames, on Chromium's software WebGL. Fails if the kit's error is not below
stock's by the factor of each scene, or a shader complains.
"""

import argparse
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import urllib.parse

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent
ENVIRONMENT = ROOT / "assets/environments/royal_esplanade_1k.hdr"
# Scene, reference, and by how much less error the kit must have.
SCENES = {"slabs-0.2": ("slabs-0.2.glb", 4.0), "ball-grid": ("ball-grid.glb", 2.0)}
SIZE = 160


def handler(folder, results, done):
    class Handler(http.server.SimpleHTTPRequestHandler):
        def __init__(self, *arguments):
            super().__init__(*arguments, directory=str(folder))

        def translate_path(self, path):
            name = urllib.parse.urlparse(path).path
            if name == "/environment.hdr":
                return str(ENVIRONMENT)
            if name.startswith("/scenes/"):
                return str(ROOT / "assets" / name[1:])
            if name == "/test.html":
                return str(HERE / "page.html")
            return super().translate_path(path)

        def do_POST(self):
            results[self.path.rsplit("/", 1)[1]] = self.rfile.read(int(self.headers["Content-Length"]))
            self.send_response(204)
            self.end_headers()
            if self.path.endswith("/done"):
                done.set()

        def log_message(self, *_):
            pass

    return Handler


def draw(folder, scene, samples, frames):
    results, done = {}, threading.Event()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler(folder, results, done))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/test.html?scene={scene}&size={SIZE}&samples={samples}&frames={frames}"
    with tempfile.TemporaryDirectory() as profile:
        browser = subprocess.Popen(
            ["chromium", "--headless", "--no-sandbox", "--no-first-run", "--disable-sync", "--disable-background-networking",
             "--disable-component-update", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
             f"--user-data-dir={profile}", address], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        finished = done.wait(timeout=540)
        browser.terminate()
        browser.wait()
    server.shutdown()
    if not finished:
        sys.exit(f"{scene}: the page did not finish")
    answer = json.loads(results["done"])
    if "failed" in answer:
        sys.exit(f"{scene}: {answer['failed']}\n" + "\n".join(answer["complaints"]))
    return results, answer


def score(build, folder, picture, mask, reference):
    for name, data in (("picture", picture), ("mask", mask)):
        (folder / f"{name}.rgba").write_bytes(data)
    words = [build / "tests/kit/kit_score", str(SIZE), folder / "picture.rgba", folder / "mask.rgba", reference, folder / "picture.png"]
    return json.loads(subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--scene", nargs="*", default=list(SCENES))
    parser.add_argument("--samples", type=int, default=4, help="along each axis of a pixel")
    parser.add_argument("--frames", type=int, default=9)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the pictures")
    parser.add_argument("--objects", action="store_true", help="errors of each object")
    options = parser.parse_args()
    failed = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        subprocess.run([options.build / "groundglass", "kit", "--target", "three", "-o", folder], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund"], cwd=folder, check=True)
        print(f"{'scene':<14}{'':<8}{'relMSE':>10}{'bias':>10}{'ms':>9}")
        for name in options.scene:
            file, factor = SCENES[name]
            results, answer = draw(folder, file, options.samples, options.frames)
            scores = {}
            for kind in ("stock", "ours"):
                scores[kind] = score(options.build, folder, results[kind], results["mask"], ROOT / f"assets/references/{name}.exr")
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(folder / "picture.png", options.keep / f"{name}-{kind}.png")
                print(f"{name:<14}{kind:<8}{scores[kind]['all']['relMSE']:>10.4f}{scores[kind]['all']['bias']:>10.4f}{min(answer['ms'][kind]):>9.1f}")
            if options.objects:
                for one in scores["ours"]:
                    print(f"  {one:<20}" + "".join(f"{kind}: relMSE {scores[kind][one]['relMSE']:.4f} bias {scores[kind][one]['bias']:+.4f}  " for kind in scores)
                          + f"mean {scores['ours'][one]['mean']:.4f}")
            gain = scores["stock"]["all"]["relMSE"] / scores["ours"]["all"]["relMSE"]
            slower = min(answer["ms"]["ours"]) / min(answer["ms"]["stock"])
            print(f"{name:<14}{gain:.2f} times less error at {slower:.2f} times the frame time; three.js {answer['three']}, {answer['device']}")
            if gain < factor:
                failed.append(f"{name}: {gain:.2f} times less error, not {factor}")
            if answer["complaints"]:
                print("\n".join(answer["complaints"][:5])[:3000])
    sys.exit("\n".join(failed) if failed else 0)


if __name__ == "__main__":
    main()
