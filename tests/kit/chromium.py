#!/usr/bin/env python3
"""Draws the kits for three.js and WebGL2 in headless Chromium beside stock three.js, and scores all against path-traced references.

    tests/kit/chromium.py BUILD [--scene NAME...] [--keep DIR]

Needs Debian's chromium and npm, which fetches three.js at the kit's own version. relMSE over pixels that glass covers wholly, in
linear radiance; frame times are the least of interleaved frames, on Chromium's software WebGL. "trimmed": 1 %-trimmed, which a glint of a
lamp in the reference's pixels, noise as large as all the rest, does not decide; "to capture": relMSE against the same frame by
`groundglass capture`. Fails if a kit's trimmed error is not below stock's by a factor of 4 on each scene, with the tier that the
instructions name for it. The references beside this file are `groundglass truth SCENE --size 160x160 --half`: wineglass.exr with --spp 2560 --seed 3,
transmission-roughness.exr with --spp 256 and the camera below; the balls' is that of
assets/references.
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
# Scene, its camera where it has none of its own, and the tier that the kits' instructions name for it, which must have a quarter of stock's
# trimmed relMSE: 'pairs' for a hollow body.
FACTOR = 4.0
SCENES = {
    "slabs-0.2": ("slabs-0.2.glb", {}, ""),
    "ball-grid": ("ball-grid.glb", {}, ""),
    "wineglass": ("wineglass.glb", {}, ", pairs"),
    "transmission-roughness": ("TransmissionRoughnessTest.glb", {"eye": "0,0.1,2.6", "target": "0,0,0", "fovy": 28}, ""),
}
KINDS = ("stock", "three", "three, convex", "three, pairs", "webgl2", "webgl2, convex", "webgl2, pairs")
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
            results[urllib.parse.unquote(self.path.rsplit("/", 1)[1])] = self.rfile.read(int(self.headers["Content-Length"]))
            self.send_response(204)
            self.end_headers()
            if self.path.endswith("/done"):
                done.set()

        def log_message(self, *_):
            pass

    return Handler


def draw(folder, scene, camera, samples, frames):
    results, done = {}, threading.Event()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler(folder, results, done))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    asked = urllib.parse.urlencode({"scene": scene, "size": SIZE, "samples": samples, "frames": frames, **camera})
    address = f"http://127.0.0.1:{server.server_port}/test.html?{asked}"
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile: # its children may outlive the browser
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
    """picture: bytes as the page sent them, or the path of an .exr."""
    if isinstance(picture, bytes):
        (folder / "picture.rgba").write_bytes(picture)
        picture = folder / "picture.rgba"
    (folder / "mask.rgba").write_bytes(mask)
    words = [build / "tests/kit/kit_score", SIZE, picture, folder / "mask.rgba", reference, folder / "picture.png"]
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
        for target, into in (("three", folder), ("webgl2", folder / "webgl2")):
            subprocess.run([options.build / "groundglass", "kit", "--target", target, "-o", into], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund"], cwd=folder, check=True)
        print(f"{'scene':<24}{'':<16}{'relMSE':>10}{'trimmed':>10}{'bias':>10}{'ms':>9}{'/ stock':>9}{'to capture':>12}")
        for name in options.scene:
            file, camera, tier = SCENES[name]
            results, answer = draw(folder, file, camera, options.samples, options.frames)
            capture, errors = folder / "capture.exr", {}
            reference = next(at for at in (HERE / f"{name}.exr", ROOT / f"assets/references/{name}.exr") if at.exists())
            view = [word for key, value in camera.items() for word in (f"--{key}", str(value))]
            subprocess.run([options.build / "groundglass", "capture", ROOT / "assets/scenes" / file, *view, "--env", ENVIRONMENT, "--size", f"{SIZE}x{SIZE}",
                            "--samples", str(options.samples**2), "-o", capture], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            stock_ms = min(answer["ms"]["stock"])
            for kind in (*KINDS, "capture"):
                picture = capture if kind == "capture" else results[kind]
                errors[kind] = score(options.build, folder, picture, results["mask"], reference)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(folder / "picture.png", options.keep / f"{name}-{kind.replace(', ', '-')}.png")
                line = f"{name:<24}{kind:<16}{errors[kind]['all']['relMSE']:>10.4f}{errors[kind]['all']['trimmed']:>10.4f}{errors[kind]['all']['bias']:>10.4f}"
                if kind != "capture":
                    apart, ms = score(options.build, folder, picture, results["mask"], capture)["all"]["relMSE"], min(answer["ms"][kind])
                    line += f"{ms:>9.1f}{ms / stock_ms:>9.2f}{apart:>12.4f}"
                print(line)
                if options.objects:
                    for one, error in errors[kind].items():
                        print(f"  {one:<22}relMSE {error['relMSE']:.4f} bias {error['bias']:+.4f} mean {error['mean']:.4f}")
            print(f"{name:<24}three.js {answer['three']}, {answer['device']}")
            for kind in ("three", "webgl2"):
                gain = {how: errors["stock"]["all"][how] / errors[kind + tier]["all"][how] for how in ("relMSE", "trimmed")}
                print(f"{name:<24}{kind + tier}: stock has {gain['trimmed']:.1f} times the trimmed error ({gain['relMSE']:.1f} times the whole), "
                      f"{kind} {min(answer['ms'][kind + tier]) / stock_ms:.2f} times stock's time")
                if gain["trimmed"] < FACTOR:
                    failed.append(f"{name}, {kind}{tier}: {gain['trimmed']:.2f} times less error than stock, not {FACTOR}")
            if answer["complaints"]:
                print("\n".join(answer["complaints"][:5])[:3000])
    sys.exit("\n".join(failed) if failed else 0)


if __name__ == "__main__":
    main()
