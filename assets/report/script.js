// The slider between the truth (left) and a method (right), and which method's picture or FLIP map it is.
"use strict";
for (const figure of document.querySelectorAll(".compare")) {
  const stack = figure.querySelector(".stack");
  const slider = figure.querySelector("input[type=range]");
  const label = stack.querySelector(".tag.right");

  const move = (percent) => {
    slider.value = percent;
    stack.style.setProperty("--at", `${slider.value}%`);
  };
  slider.addEventListener("input", () => move(slider.value));

  const follow = (event) => {
    const box = stack.getBoundingClientRect();
    move((100 * (event.clientX - box.left)) / box.width);
  };
  stack.addEventListener("pointerdown", (event) => {
    follow(event);
    stack.setPointerCapture(event.pointerId);
  });
  stack.addEventListener("pointermove", (event) => {
    if (stack.hasPointerCapture(event.pointerId)) follow(event);
  });

  const show = () => {
    const method = figure.querySelector("input[data-method]:checked").dataset.method;
    const kind = figure.querySelector("input[data-kind]:checked").dataset.kind;
    for (const image of stack.querySelectorAll(".over"))
      image.hidden = image.dataset.method !== method || image.dataset.kind !== kind;
    label.textContent = kind === "flip" ? `FLIP of ${method}` : method;
  };
  for (const input of figure.querySelectorAll("input[type=radio]")) input.addEventListener("change", show);
}
