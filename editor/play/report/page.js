// The page as a whole: which tests are shown, keys, copying, light and dark.
{
  const tests = [...document.querySelectorAll(".test")];
  const filters = [...document.querySelectorAll("input[name=filter]")];
  const search = document.querySelector("input[type=search]");
  const fold = document.querySelector(".fold");
  const shown = () => tests.filter((test) => !test.hidden);

  const label = () => { fold.textContent = shown().some((test) => !test.open) ? "Open all" : "Close all"; };
  const apply = () => {
    const wanted = filters.find((filter) => filter.checked)?.value ?? "all";
    const words = search.value.toLowerCase().split(/\s+/);
    for (const test of tests) {
      const text = test.querySelector("summary").textContent.toLowerCase();
      const fits = wanted === "all" || test.dataset.status.split(" ").includes(wanted);
      test.hidden = !fits || !words.every((word) => text.includes(word));
    }
    document.querySelector(".nothing").hidden = shown().length > 0;
    label();
  };
  filters.forEach((filter) => filter.addEventListener("change", apply));
  search.addEventListener("input", apply);
  tests.forEach((test) => test.addEventListener("toggle", label));
  fold.addEventListener("click", () => {
    const open = shown().some((test) => !test.open);
    shown().forEach((test) => { test.open = open; });
  });
  apply();

  const go = (by) => {
    const summaries = shown().map((test) => test.querySelector("summary"));
    const now = summaries.indexOf(document.activeElement?.closest(".test")?.querySelector("summary"));
    summaries[Math.min(Math.max(now + by, 0), summaries.length - 1)]?.focus();
  };
  const choose = (value) => {
    const filter = filters.find((one) => one.value === value);
    if (filter) filter.checked = true;
    apply();
  };
  document.addEventListener("keydown", (event) => {
    if (event.target.matches("input[type=search], select") || event.ctrlKey || event.metaKey || event.altKey) return;
    const keys = {
      j: () => go(1),
      k: () => go(-1),
      "/": () => search.focus(),
      f: () => choose(filters.find((filter) => filter.checked)?.value === "failed" ? "all" : "failed"),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });

  // Older browsers, and pages from a file in some newer ones, have no clipboard.
  const copy = async (element) => {
    try {
      await navigator.clipboard.writeText(element.textContent);
      return true;
    } catch {
      getSelection().selectAllChildren(element);
      return document.execCommand("copy");
    }
  };
  for (const button of document.querySelectorAll(".copy"))
    button.addEventListener("click", async () => {
      button.textContent = (await copy(button.previousElementSibling)) ? "Copied" : "Selected";
      setTimeout(() => { button.textContent = "Copy"; }, 1500);
    });

  const theme = document.querySelector(".theme"), themes = ["system", "light", "dark"];
  theme.addEventListener("click", () => {
    const now = themes[(themes.indexOf(document.documentElement.dataset.theme ?? "system") + 1) % themes.length];
    document.documentElement.dataset.theme = now;
    theme.textContent = "Theme: " + now;
  });

  // index.html#test-3 opens that test.
  if (/^#test-\d+$/.test(location.hash)) {
    const test = document.getElementById(location.hash.slice(1));
    if (test) test.open = true;
  }
}
