// Two pictures of a scene, left and right of a line: any two, zoomed without blur, with the values under the pointer.
"use strict";
for (const figure of document.querySelectorAll(".compare")) {
  const canvas = figure.querySelector("canvas"), context = canvas.getContext("2d");
  const slider = figure.querySelector("input[type=range]"), output = figure.querySelector("output");
  const sources = new Map([...figure.querySelectorAll(".source")].map((image) => [image.dataset.name, image]));
  const chosen = (side) => sources.get(figure.querySelector(`[data-side=${side}]`).value);
  const { width, height } = sources.get("truth");
  let scale = 1, x = 0, y = 0; // screen pixels for a picture's one, and the picture's point at the top left

  const draw = () => {
    const at = (canvas.width * slider.value) / 100;
    context.imageSmoothingEnabled = false;
    context.setTransform(scale, 0, 0, scale, -x * scale, -y * scale);
    context.drawImage(chosen("left"), 0, 0);
    context.save();
    context.beginPath();
    context.rect(x + at / scale, y, canvas.width / scale, canvas.height / scale);
    context.clip();
    context.drawImage(chosen("right"), 0, 0);
    context.restore();
    context.resetTransform();
    context.fillStyle = "#000";
    context.fillRect(at - 2, 0, 4, canvas.height);
    context.fillStyle = "#fff";
    context.fillRect(at - 1, 0, 2, canvas.height);
  };
  const whole = () => {
    canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
    canvas.height = Math.round((canvas.width * height) / width);
    scale = canvas.width / width;
    x = y = 0;
    draw();
  };
  // The pointer in screen pixels of the canvas.
  const pointer = (event) => {
    const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
    return { px: (event.clientX - box.left) * ratio, py: (event.clientY - box.top) * ratio };
  };
  const keep = () => {
    x = Math.min(Math.max(x, 0), width - canvas.width / scale);
    y = Math.min(Math.max(y, 0), height - canvas.height / scale);
  };

  const values = new Map(); // the pictures' bytes, once asked for
  const pixel = (image, i, j) => {
    if (!values.has(image)) {
      const copy = new OffscreenCanvas(width, height).getContext("2d");
      copy.drawImage(image, 0, 0);
      values.set(image, copy.getImageData(0, 0, width, height).data);
    }
    return [...values.get(image).slice(4 * (j * width + i), 4 * (j * width + i) + 3)].join(" ");
  };
  const tell = ({ px, py }) => {
    const i = Math.floor(x + px / scale), j = Math.floor(y + py / scale);
    if (i < 0 || j < 0 || i >= width || j >= height) return;
    const [a, b] = [chosen("left"), chosen("right")];
    output.textContent =
      `(${i}, ${j})  ${a.dataset.name}: ${pixel(a, i, j)}  ${b.dataset.name}: ${pixel(b, i, j)}  (sRGB, 0 to 255)`;
  };

  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const { px, py } = pointer(event), least = canvas.width / width;
    const next = Math.min(Math.max(scale * Math.pow(2, -event.deltaY / 250), least), 64 * least);
    x += px / scale - px / next;
    y += py / scale - py / next;
    scale = next;
    keep();
    draw();
  }, { passive: false });
  let last = null;
  canvas.addEventListener("pointerdown", (event) => {
    last = pointer(event);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointerup", () => (last = null));
  canvas.addEventListener("pointermove", (event) => {
    const now = pointer(event);
    if (last) {
      x -= (now.px - last.px) / scale;
      y -= (now.py - last.py) / scale;
      last = now;
      keep();
      draw();
    }
    tell(now);
  });
  canvas.addEventListener("dblclick", whole);
  slider.addEventListener("input", draw);
  for (const select of figure.querySelectorAll("select")) select.addEventListener("change", draw);
  new ResizeObserver(whole).observe(canvas);
  Promise.all([...sources.values()].map((image) => image.decode())).then(whole);
}
