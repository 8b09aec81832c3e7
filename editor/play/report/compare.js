// Golden against actual picture: how they are shown, and where the line is that parts them.
for (const compare of document.querySelectorAll(".compare")) {
  const buttons = compare.querySelectorAll("button[data-mode]");
  for (const button of buttons)
    button.addEventListener("click", () => {
      compare.dataset.mode = button.dataset.mode;
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
    });
  const wipe = compare.querySelector(".wipe");
  const move = () => wipe.parentElement.style.setProperty("--at", wipe.value + "%");
  wipe.addEventListener("input", move);
  move(); // browsers remember values when a page is loaded again
  const brighten = compare.querySelector(".brighten");
  const shine = () => compare.classList.toggle("bright", brighten.checked);
  brighten.addEventListener("change", shine);
  shine();
}
