#!/usr/bin/env python3
"""Opens a report in headless Chromium and uses it as a reader would.

    tests/report/browser.py REPORT.html [--screenshots DIR]

At the widths of a phone (375 px) and of a desktop (1280 px): every picture loads, every one can be put left or right of
the line, the wheel zooms, values under the pointer are told, nothing is wider than the window, and no two texts of a plot
cover each other. Needs Debian's chromium package; run by hand, after a change to assets/report, app/report/page.cpp or
app/report/plot.cpp.
"""

import argparse
import base64
import fcntl
import json
import os
import pathlib
import subprocess
import sys
import tempfile

CHECK = """
(async () => {
  const wrong = [], need = (ok, what) => { if (!ok) wrong.push(what); };
  const images = [...document.images];
  await Promise.all(images.map((image) => image.decode().catch(() => need(false, "does not load: " + image.alt))));
  for (const image of images) need(image.naturalWidth > 1, "is empty: " + image.alt);
  const frame = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  for (const figure of document.querySelectorAll(".compare")) {
    const canvas = figure.querySelector("canvas"), slider = figure.querySelector("input[type=range]");
    const [left, right] = ["left", "right"].map((side) => figure.querySelector(`[data-side=${side}]`));
    const drawn = () => canvas.toDataURL(), output = figure.querySelector("output");
    await frame();
    const names = [...right.options].map((option) => option.value);
    need(names.length >= 3 && names.includes("truth"), "has too little to choose from: " + names);
    need(names.length === figure.querySelectorAll(".source").length, "a picture cannot be chosen");
    const pictures = new Set();
    slider.value = 0; // the right one alone
    for (const name of names) {
      right.value = name;
      right.dispatchEvent(new Event("change"));
      pictures.add(drawn());
    }
    need(pictures.size === names.length, `${names.length} pictures look like ${pictures.size}`);
    slider.value = 100;
    slider.dispatchEvent(new Event("input"));
    need(left.value === "truth", "does not begin with the truth");
    const whole = drawn(), box = canvas.getBoundingClientRect();
    const at = { clientX: box.left + 0.5 * box.width, clientY: box.top + 0.5 * box.height, bubbles: true, cancelable: true };
    canvas.dispatchEvent(new WheelEvent("wheel", { ...at, deltaY: -500 }));
    need(drawn() !== whole, "the wheel does not zoom");
    canvas.dispatchEvent(new PointerEvent("pointermove", at));
    need(/\\(\\d+, \\d+\\)  truth: \\d+ \\d+ \\d+  /.test(output.textContent), "tells no values: " + output.textContent);
    canvas.dispatchEvent(new MouseEvent("dblclick", at));
    need(drawn() === whole, "a double click does not show the whole picture");
  }
  need(document.querySelectorAll(".compare").length > 0, "no pictures to compare");
  need(document.documentElement.scrollWidth <= innerWidth,
       `is ${document.documentElement.scrollWidth} px wide in a window of ${innerWidth}`);
  for (const element of document.querySelectorAll("body *:not(.scroll *):not(pre *):not(svg *)"))
    need(element.getBoundingClientRect().right <= innerWidth + 0.5, `${element.tagName}.${element.className} sticks out`);
  for (const plot of document.querySelectorAll("svg")) {
    const frame = plot.getBoundingClientRect();
    const texts = [...plot.querySelectorAll("text")].map((t) => [t.textContent, t.getBoundingClientRect()]);
    texts.forEach(([a, p], i) => {
      need(p.left >= frame.left && p.right <= frame.right && p.top >= frame.top && p.bottom <= frame.bottom,
           `"${a}" sticks out of its plot`);
      // A box holds the font's whole height, of which letters leave a fifth empty above and below.
      for (const [b, q] of texts.slice(i + 1)) {
        const spare = 0.2 * (p.height + q.height);
        need(p.right <= q.left || q.right <= p.left || p.bottom - spare <= q.top || q.bottom - spare <= p.top,
             `"${a}" covers "${b}" in a plot`);
      }
    });
  }
  return { width: innerWidth, height: document.documentElement.scrollHeight, images: images.length,
           figures: document.querySelectorAll(".compare").length, wrong };
})()
"""


class Chromium:
    """A page of a browser of its own, driven by the DevTools protocol over a pipe (its descriptors 3 and 4)."""

    def __init__(self, profile):
        to_browser, self.commands = os.pipe()
        self.answers, from_browser = os.pipe()
        # Out of the way of 3 and 4 before they become those.
        ours = [fcntl.fcntl(fd, fcntl.F_DUPFD, 10) for fd in (to_browser, from_browser)]
        self.process = subprocess.Popen(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run", "--disable-sync",
             "--disable-background-networking", "--disable-component-update", "--disable-quic", "--remote-debugging-pipe",
             f"--user-data-dir={profile}"],
            preexec_fn=lambda: (os.dup2(ours[0], 3), os.dup2(ours[1], 4)), close_fds=False, stderr=subprocess.DEVNULL)
        for fd in (to_browser, from_browser, *ours):
            os.close(fd)
        self.buffer, self.count, self.session = b"", 0, None
        page = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        self.call("Page.enable")

    def message(self):
        while b"\0" not in self.buffer:
            read = os.read(self.answers, 1 << 20)
            if not read:
                sys.exit("Chromium ended")
            self.buffer += read
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.count += 1
        command = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            command["sessionId"] = self.session
        os.write(self.commands, json.dumps(command).encode() + b"\0")
        while (answer := self.message()).get("id") != self.count:
            pass
        if "error" in answer:
            sys.exit(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def open(self, address, width):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        self.call("Page.navigate", url=address)
        while self.message().get("method") != "Page.loadEventFired":
            pass

    def evaluate(self, script):
        result = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            sys.exit(result["exceptionDetails"]["exception"]["description"])
        return result["result"]["value"]

    def picture(self, width, top, height):
        clip = {"x": 0, "y": top, "width": width, "height": height, "scale": 1}
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip)["data"]
        return base64.b64decode(data)

    def close(self):
        self.call("Browser.close")
        self.process.wait()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path, help="the whole page at both widths, in pieces of 2000 px")
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        browser = Chromium(folder)
        for width in (375, 1280):
            browser.open(options.report.resolve().as_uri(), width)
            result = browser.evaluate(CHECK)
            print(f"{width} px: {result['figures']} comparisons, {result['images']} pictures, {len(result['wrong'])} complaints")
            for complaint in result["wrong"]:
                print("  " + complaint)
            failed = failed or bool(result["wrong"]) or result["width"] != width
            if options.screenshots:
                options.screenshots.mkdir(parents=True, exist_ok=True)
                for top in range(0, result["height"], 2000):
                    picture = browser.picture(width, top, min(2000, result["height"] - top))
                    (options.screenshots / f"report-{width}-{top // 2000}.png").write_bytes(picture)
        browser.close()
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
