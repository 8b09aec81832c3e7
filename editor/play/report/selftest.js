// index.html#selftest: uses the page as a person would and writes what came of it at its end, for the tests in the tree.
if (location.hash === "#selftest") (async () => {
  const faults = [];
  const expect = (truth, what) => truth || faults.push(what);
  const one = (selector) => document.querySelector(selector);
  const wait = (ms) => new Promise((done) => setTimeout(done, ms));
  const key = (target, name) => target.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
  const seen = (element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true });

  const comparing = () => {
    const wipe = one(".wipe"), actual = one(".pair .actual");
    wipe.value = 20;
    wipe.dispatchEvent(new Event("input"));
    expect(getComputedStyle(actual).clipPath.replace(/ /g, "").includes("20%"), "the slider does not wipe");
    one(".compare").scrollIntoView({ block: "center" });
    const edge = one(".edge").getBoundingClientRect(), stage = wipe.parentElement.getBoundingClientRect();
    expect(Math.abs(edge.left + 1 - stage.left - 0.2 * stage.width) < 2, "the line is not where the wipe is");
    const middle = document.elementFromPoint(stage.left + stage.width / 2, stage.top + stage.height / 2);
    expect(middle === wipe, "the pictures can't be dragged on");
    one("button[data-mode=beside]").click();
    expect(getComputedStyle(actual).clipPath === "none" && !seen(wipe), "side by side is still wiped");
    const golden = one(".pair .golden").getBoundingClientRect();
    expect(actual.getBoundingClientRect().left >= golden.right, "side by side is one on the other");
    one("button[data-mode=blink]").click();
    expect(getComputedStyle(actual).animationName === "blink", "nothing blinks");
    one("button[data-mode=wipe]").click();
    one(".brighten").click();
    expect(getComputedStyle(one(".difference img")).filter !== "none", "the difference is not brightened");
    one(".brighten").click();
  };

  const playing = async () => {
    const film = one(".film"), frames = [...film.querySelector(".stage").children];
    const now = () => frames.findIndex((frame) => frame.classList.contains("shown"));
    expect(frames.filter(seen).length === 1, "not one frame is seen");
    const start = now();
    expect(film.querySelector("output").value.length > 0, "the frame is not named");
    film.querySelector(".next").click();
    expect(now() === start + 1 && seen(frames[start + 1]) && !seen(frames[start]), "no step forward");
    key(film.querySelector(".stage"), "ArrowLeft");
    expect(now() === start, "no step back by key");
    film.querySelector(".seek").value = 0;
    film.querySelector(".back").click();
    expect(now() === frames.length - 1, "no step round the end");
    film.querySelector(".layer").value = "onion";
    film.querySelector(".layer").dispatchEvent(new Event("change"));
    expect(frames.filter(seen).length === 2, "no frame shines through");
    film.querySelector(".layer").value = "frame";
    film.querySelector(".layer").dispatchEvent(new Event("change"));
    film.querySelector(".speed").value = "60";
    const before = now();
    film.querySelector(".play").click();
    await wait(60);
    film.querySelector(".play").click();
    const after = now();
    expect(after !== before, "the film does not play");
    await wait(60);
    expect(now() === after, "the film does not pause");
    film.querySelector(".seek").value = 0;
    film.querySelector(".seek").dispatchEvent(new Event("input"));
    expect(now() === 0 && film.querySelector("output").value !== "", "no frame is sought");
  };

  const reading = () => {
    const curve = one(".curve"), plot = curve.querySelector(".plot"), box = plot.getBoundingClientRect();
    plot.dispatchEvent(new PointerEvent("pointermove", { clientX: box.right, clientY: box.top }));
    const values = curve.dataset.values.split(" ");
    const last = Number(curve.dataset.first) + values.length - 1;
    expect(curve.querySelector("output").value.startsWith(`frame ${last}: `), "the cursor does not tell the value");
    key(plot, "Home");
    expect(curve.querySelector("output").value.includes(Number(values[0])), "no cursor by key");
    plot.dispatchEvent(new PointerEvent("pointerleave"));
    expect(curve.querySelector("output").value === "", "the cursor stays");
    const film = one(".film"), beside = film.closest(".inside").querySelector(".curve");
    key(beside.querySelector(".plot"), "End");
    expect(film.querySelector("output").value === beside.querySelector("output").value.split(":")[0],
      "film and curve are not at one frame");
  };

  const filtering = () => {
    const shown = (selector) => [...document.querySelectorAll(selector)].filter((test) => !test.hidden).length;
    const all = shown(".test"), failed = shown(".test.failed");
    one("input[value=failed]").click();
    expect(shown(".test") === failed && failed > 0 && failed < all, "failed tests are not filtered");
    one("input[value=passed]").click();
    expect(shown(".test") === all - failed && shown(".test.failed") === 0, "passed tests are not filtered");
    one("input[value=all]").click();
    const search = one("input[type=search]");
    search.value = "no such test";
    search.dispatchEvent(new Event("input"));
    expect(shown(".test") === 0 && !one(".nothing").hidden, "what is not there is found");
    search.value = "";
    search.dispatchEvent(new Event("input"));
    expect(shown(".test") === all && one(".nothing").hidden, "not all come back");
    key(document.body, "j");
    expect(document.activeElement === one(".test > summary"), "no way by key");
    document.activeElement.blur();
  };

  const page = () => {
    const failed = [...document.querySelectorAll(".test.failed")], passed = [...document.querySelectorAll(".test.passed")];
    expect(failed.every((test) => test.open) && passed.every((test) => !test.open), "the wrong tests are open");
    expect(document.documentElement.scrollWidth <= innerWidth, "the page is wider than the window");
    const pictures = [...document.images].filter((image) => image.naturalWidth === 0);
    expect(pictures.length === 0, `${pictures.length} pictures are broken`);
    expect(document.querySelectorAll("[src]:not([src^='data:']), link[href^='http']").length === 0, "it asks for more");
  };

  addEventListener("error", (event) => faults.push(event.message));
  try {
    if (document.readyState !== "complete") await new Promise((done) => addEventListener("load", done));
    page();
    comparing();
    await playing();
    reading();
    filtering();
  } catch (error) {
    faults.push(String(error));
  }
  const result = document.body.appendChild(document.createElement("pre"));
  result.id = "selftest-result";
  result.textContent = faults.length === 0 ? "SELFTEST PASS" : "SELFTEST FAIL: " + faults.join("; ");
})();
