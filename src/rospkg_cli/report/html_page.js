"use strict";
const get = (id) => document.getElementById(id);
const found = [...document.querySelectorAll("article")];
const texts = found.map((each) => each.textContent.toLowerCase());
const show = () => {
  const words = get("search").value.toLowerCase().split(/\s+/).filter(Boolean);
  const chosen = { package: get("package").value, rule: get("rule").value, level: get("level").value };
  let count = 0;
  found.forEach((each, at) => {
    const fits = Object.entries(chosen).every(([key, value]) => !value || each.dataset[key] === value);
    each.hidden = !(fits && words.every((word) => texts[at].includes(word)));
    count += each.hidden ? 0 : 1;
  });
  get("count").textContent = `${count} of ${found.length} shown`;
};
get("filters").hidden = false;
get("filters").addEventListener("input", show);
get("filters").addEventListener("reset", () => setTimeout(show));
get("filters").addEventListener("submit", (event) => event.preventDefault());
get("theme").addEventListener("click", () => {
  const root = document.documentElement;
  const isDark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = isDark ? "light" : "dark";
});
show();
