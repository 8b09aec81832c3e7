// Frames that are played, stepped through, and laid over one another.
for (const film of document.querySelectorAll(".film")) {
  const frames = [...film.querySelector(".stage").children];
  const find = (name) => film.querySelector("." + name);
  const [play, seek, speed, layer, stage] = ["play", "seek", "speed", "layer", "stage"].map(find);
  const first = Number(film.dataset.first);
  let timer = 0;

  const show = (index) => {
    const now = (index + frames.length) % frames.length;
    frames.forEach((frame, i) => {
      frame.classList.toggle("shown", i === now);
      frame.classList.toggle("before", layer.value !== "frame" && i === now - 1);
    });
    seek.value = now;
    film.querySelector("output").value = `frame ${first + now}`;
    film.dispatchEvent(new CustomEvent("frame", { bubbles: true, detail: first + now }));
  };
  const run = (running) => {
    clearInterval(timer);
    timer = running ? setInterval(() => show(Number(seek.value) + 1), 1000 / Number(speed.value)) : 0;
    play.textContent = running ? "Pause" : "Play";
    play.setAttribute("aria-pressed", String(running));
  };
  const step = (by) => {
    run(false);
    show(Number(seek.value) + by);
  };

  play.addEventListener("click", () => run(timer === 0));
  stage.addEventListener("click", () => run(timer === 0));
  find("back").addEventListener("click", () => step(-1));
  find("next").addEventListener("click", () => step(1));
  seek.addEventListener("input", () => step(0));
  speed.addEventListener("change", () => run(timer !== 0));
  layer.addEventListener("change", () => {
    film.dataset.layer = layer.value;
    show(Number(seek.value));
  });
  stage.addEventListener("keydown", (event) => {
    const keys = { ArrowLeft: () => step(-1), ArrowRight: () => step(1), " ": () => run(timer === 0) };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  film.closest(".inside").addEventListener("seek", (event) => {
    if (event.detail < first || event.detail >= first + frames.length) return;
    run(false);
    show(event.detail - first);
  });
  film.dataset.layer = layer.value;
  show(Number(seek.value));
}
