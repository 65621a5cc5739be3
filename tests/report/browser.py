#!/usr/bin/env python3
"""Opens a report in headless Chromium and uses it as a reader would.

    tests/report/browser.py REPORT.html [--screenshots DIR]

At the widths of a phone (375 px) and of a desktop (1280 px): every picture loads, the slider and the pointer move the
line, every method and its FLIP map can be shown, alone, and nothing is wider than the window. Needs Debian's chromium
package; run by hand, after a change to assets/report or app/report/page.cpp.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

CHECK = """
<script>
addEventListener("load", async () => {
  const wrong = [], need = (ok, what) => { if (!ok) wrong.push(what); };
  const images = [...document.images];
  await Promise.all(images.map((image) => image.decode().catch(() => need(false, "does not load: " + image.alt))));
  for (const image of images) need(image.naturalWidth > 1, "is empty: " + image.alt);
  const edge = (element) => getComputedStyle(element).clipPath.match(/([0-9.]+)%\\)$/)?.[1];
  for (const figure of document.querySelectorAll(".compare")) {
    const stack = figure.querySelector(".stack"), slider = figure.querySelector("input[type=range]");
    const shown = () => [...stack.querySelectorAll(".over")].filter((image) => image.checkVisibility());
    for (const at of [0, 20, 100, 50]) {
      slider.value = at;
      slider.dispatchEvent(new Event("input"));
      need(Math.abs(edge(shown()[0]) - at) < 0.2, `the slider at ${at} leaves the line at ${edge(shown()[0])}`);
    }
    const box = stack.getBoundingClientRect();
    try { // a made-up pointer moves the line, but cannot be captured
      stack.dispatchEvent(new PointerEvent("pointerdown", { clientX: box.left + 0.75 * box.width, pointerId: 1 }));
    } catch {}
    need(Math.abs(slider.value - 75) < 0.5, `the pointer at 75 leaves the slider at ${slider.value}`);
    need(Math.abs(stack.querySelector("img").getBoundingClientRect().width - box.width) < 1, "a picture is not as wide as its box");
    for (const method of figure.querySelectorAll("[data-method][type=radio]"))
      for (const kind of figure.querySelectorAll("[data-kind][type=radio]")) {
        method.click();
        kind.click();
        const now = shown();
        need(now.length === 1 && now[0].dataset.method === method.dataset.method && now[0].dataset.kind === kind.dataset.kind,
             `${method.dataset.method}, ${kind.dataset.kind}: ${now.length} pictures shown`);
      }
    need(figure.querySelectorAll("[data-method][type=radio]").length > 0, "no methods to choose from");
  }
  need(document.querySelectorAll(".compare").length > 0, "no pictures to compare");
  need(document.documentElement.scrollWidth <= innerWidth,
       `is ${document.documentElement.scrollWidth} px wide in a window of ${innerWidth}`);
  for (const element of document.querySelectorAll("body *:not(.scroll *):not(pre *):not(svg *)"))
    need(element.getBoundingClientRect().right <= innerWidth + 0.5, `${element.tagName}.${element.className} sticks out`);
  const result = { width: innerWidth, images: images.length, figures: document.querySelectorAll(".compare").length, wrong };
  document.documentElement.innerHTML = "<body><pre id=result></pre></body>";
  document.getElementById("result").textContent = JSON.stringify(result);
});
</script>
"""


def chromium(width, height, *arguments):
    command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--window-size={width},{height}",
               "--virtual-time-budget=600000", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=180, check=True).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path)
    options = parser.parse_args()
    page = options.report.read_text()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        checked = pathlib.Path(folder) / "checked.html"
        checked.write_text(page.replace("</body>", CHECK + "</body>"))
        for width in (375, 1280):
            # A window has a least width of its own; a frame inside it has none.
            frame = pathlib.Path(folder) / f"frame-{width}.html"
            frame.write_text(f'<body style="margin:0"><iframe src="checked.html" style="border:0;width:{width}px;height:900px">'
                             "</iframe><script>setInterval(() => { const d = document.querySelector('iframe').contentDocument;"
                             "const r = d && d.getElementById('result'); if (r) document.body.textContent = r.textContent; }, 1000)</script>")
            dom = chromium(1400, 900, "--allow-file-access-from-files", "--dump-dom", frame.as_uri())
            found = re.search(r"<body[^>]*>(\{.*\})", dom, re.S)
            if not found:
                sys.exit(f"{width} px: the page did not finish")
            text = found[1].split("</body>")[0].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
            result = json.loads(text)
            print(f"{width} px: {result['figures']} comparisons, {result['images']} pictures, {len(result['wrong'])} complaints")
            for complaint in result["wrong"]:
                print("  " + complaint)
            failed = failed or bool(result["wrong"]) or result["width"] != width
            if options.screenshots:
                options.screenshots.mkdir(parents=True, exist_ok=True)
                shown = pathlib.Path(folder) / f"shown-{width}.html"
                shown.write_text(f'<body style="margin:0"><iframe src="{options.report.resolve().as_uri()}" '
                                 f'style="border:0;width:{width}px;height:2400px"></iframe>')
                chromium(width if width > 500 else 500, 2400, "--allow-file-access-from-files",
                         f"--screenshot={options.screenshots / f'report-{width}.png'}", shown.as_uri())
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
