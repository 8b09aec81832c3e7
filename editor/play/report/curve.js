// A cursor on curves that tells their values, moved by the pointer or with the arrow keys. Where the same expectation has
// a film, they go together: the cursor rests at the film's frame, and the film shows the cursor's.
for (const curve of document.querySelectorAll(".curve")) {
  const plot = curve.querySelector(".plot"), output = curve.querySelector("output");
  const cursor = curve.querySelector(".cursor"), point = curve.querySelector(".point");
  const values = curve.dataset.values.split(" ").map(Number); // "x" is no number
  const first = Number(curve.dataset.first), low = Number(curve.dataset.low), high = Number(curve.dataset.high);
  const group = curve.closest(".inside");
  let index = -1, rest = -1;

  const show = (to) => {
    index = to;
    const value = values[index];
    cursor.hidden = index < 0;
    point.hidden = !Number.isFinite(value);
    output.value = "";
    if (index < 0) return;
    const left = values.length > 1 ? (100 * index) / (values.length - 1) : 50;
    const top = Math.min(Math.max((100 * (high - value)) / (high - low), 0), 100);
    cursor.style.left = point.style.left = left + "%";
    point.style.top = top + "%";
    const text = Number.isFinite(value) ? `${Number(value.toPrecision(5))} ${curve.dataset.unit}` : "no number";
    output.value = `frame ${first + index}: ${text.trim()}`;
  };

  const point_at = (to) => {
    show(Math.min(Math.max(to, 0), values.length - 1));
    group?.dispatchEvent(new CustomEvent("seek", { detail: first + index }));
  };

  plot.addEventListener("pointermove", (event) => {
    const box = plot.getBoundingClientRect();
    point_at(Math.round(((event.clientX - box.left) / box.width) * (values.length - 1)));
  });
  plot.addEventListener("pointerleave", () => show(rest));
  plot.addEventListener("blur", () => show(rest));
  group?.addEventListener("frame", (event) => {
    rest = event.detail - first;
    if (rest < 0 || rest >= values.length) rest = -1;
    show(rest);
  });
  plot.addEventListener("keydown", (event) => {
    const to = { ArrowLeft: index - 1, ArrowRight: index + 1, Home: 0, End: values.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    point_at(to);
  });
}
