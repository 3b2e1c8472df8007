"use strict";
const get = (id) => document.getElementById(id);
const data = JSON.parse(get("data").textContent);
const nodes = new Map(data.nodes.map((node) => [node.name, node]));
const near = new Map(data.nodes.map((node) => [node.name, []]));
data.edges.forEach((edge) => [edge.source, edge.target].forEach((name) => near.get(name).push(edge)));
const keys = new Map(data.nodes.map((node, at) => [node.name, `n${at}`]));
const drawnAs = new Map(data.edges.map((edge, at) => [edge, `e${at}`]));
const nameOf = new Map([...keys].map(([name, key]) => [key, name]));
const labelOf = (node) => (node.is_launch_file ? node.name.slice(node.package.length + 1) : node.name);
const pen = document.createElement("canvas").getContext("2d");
pen.font = "12px system-ui, sans-serif";
const widths = new Map(data.nodes.map((node) => [
  node.name, Math.ceil(pen.measureText(labelOf(node)).width) + (node.is_launch_file ? 28 : 20)]));
let chosen = null;
cytoscape.warnings(false);

const picture = cytoscape({
  container: get("graph"), style: looks(), minZoom: .02, maxZoom: 3, autoungrabify: true,
  hideEdgesOnViewport: data.edges.length > 2000, textureOnViewport: data.edges.length > 2000,
  layout: { name: "preset" },
  elements: [
    ...data.nodes.map((node) => ({ data: {
      id: keys.get(node.name), label: labelOf(node), width: widths.get(node.name),
      launch: node.is_launch_file, outside: node.is_outside } })),
    ...data.edges.map((edge) => ({
      data: { id: drawnAs.get(edge), bend: 0, source: keys.get(edge.source), target: keys.get(edge.target) },
      classes: [...edge.marks, ...(edge.kinds.join() === "launch" ? ["launch"] : [])].join(" ") })),
  ],
});

// Return the names that are at most so many edges away from one.
const reach = (start, steps, edges) => {
  const left = new Set(edges);
  const beside = (name) => near.get(name).filter((edge) => left.has(edge)).flatMap((edge) => [edge.source, edge.target]);
  let found = new Set([start]);
  for (let step = 0; step < steps; step += 1) found = new Set([...found, ...[...found].flatMap(beside)]);
  return found;
};

// Return the names and the edges that the filters leave.
const filtered = () => {
  const kinds = new Set([...document.querySelectorAll("[name=kind]:checked")].map((box) => box.value));
  const mark = get("mark").value;
  const fits = (node) => (get("launch").checked || !node.is_launch_file) && (get("outside").checked || !node.is_outside);
  let edges = data.edges.filter((edge) => edge.kinds.some((kind) => kinds.has(kind))
    && (!mark || (mark === "any" ? edge.marks.length > 0 : edge.marks.includes(mark)))
    && fits(nodes.get(edge.source)) && fits(nodes.get(edge.target)));
  const used = new Set(edges.flatMap((edge) => [edge.source, edge.target]));
  let names = new Set(data.nodes.filter((node) => fits(node)
    && (used.has(node.name) || (!mark && !node.is_outside))).map((node) => node.name));
  if (chosen && get("depth").value) {
    const kept = reach(chosen, Number(get("depth").value), edges);
    names = new Set([...names].filter((name) => kept.has(name)));
    edges = edges.filter((edge) => names.has(edge.source) && names.has(edge.target));
  }
  return { names, edges };
};

const button = (name, text) => {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = text;
  made.dataset.name = name;
  made.setAttribute("aria-current", String(name === chosen));
  return made;
};

const line = (edge, name) => {
  const item = document.createElement("li");
  const other = edge.source === name ? edge.target : edge.source;
  const said = document.createElement("div");
  said.className = "dim";
  said.textContent = `${edge.kinds.join(", ")}${edge.label ? `: ${edge.label}` : ""}`;
  edge.marks.forEach((mark) => {
    const word = document.createElement("span");
    word.className = `mark ${mark}`;
    word.textContent = ` ${mark}`;
    said.append(word);
  });
  item.append(button(other, other), said);
  return item;
};

const tell = () => {
  const box = get("details");
  box.hidden = !chosen;
  if (!chosen) return box.replaceChildren();
  const title = document.createElement("h2");
  title.textContent = chosen + (nodes.get(chosen).is_outside ? " (not here)" : "");
  const lists = [["Needs", "source"], ["Needed by", "target"]].flatMap(([heading, side]) => {
    const edges = near.get(chosen).filter((edge) => edge[side] === chosen);
    const head = document.createElement("h3");
    head.textContent = `${heading} (${edges.length})`;
    const list = document.createElement("ul");
    list.append(...edges.map((edge) => line(edge, chosen)));
    return [head, list];
  });
  return box.replaceChildren(title, ...lists);
};

const light = ({ names }) => {
  const words = get("search").value.toLowerCase().split(/\s+/).filter(Boolean);
  const found = [...names].filter((name) => words.every((word) => name.toLowerCase().includes(word)));
  const hits = new Set(words.length ? found : []);
  picture.batch(() => {
    picture.elements().removeClass("far found chosen");
    const self = chosen ? picture.getElementById(keys.get(chosen)) : picture.collection();
    if (chosen) picture.elements().difference(self.closedNeighborhood()).addClass("far");
    else if (hits.size) picture.elements().addClass("far");
    hits.forEach((name) => picture.getElementById(keys.get(name)).addClass("found").removeClass("far"));
    self.addClass("chosen");
  });
  get("names").replaceChildren(...found.map((name) => {
    const item = document.createElement("li");
    item.append(button(name, name));
    return item;
  }));
  return found;
};

// Put the nodes in their places; an edge that others lead around is bent, since it would be hidden by them.
const draw = ({ places, direct }, edges) => picture.batch(() => {
  places.forEach((place, name) => picture.getElementById(keys.get(name)).position(place));
  edges.forEach((edge) => {
    const [from, to] = [places.get(edge.source), places.get(edge.target)];
    const isBent = edges.length < 400 && from !== to && !direct.get(edge.source).has(edge.target);
    const drawn = picture.getElementById(drawnAs.get(edge)).toggleClass("curved", isBent);
    if (isBent) drawn.data("bend", 12 + Math.hypot(from.x - to.x, from.y - to.y) / 8);
  });
});

const known = new Map(); // layouts, by what they show
let placed = new Set(); // the names that the layout on the screen has
let shown = null;

// Lay out what is shown, unless most of what has its place remains: then nothing moves.
const place = ({ names, edges }) => {
  if (names.size * 3 > placed.size && [...names].every((name) => placed.has(name))) return;
  const key = `${[...names].join()}|${edges.length}`;
  if (!known.has(key)) {
    known.set(key, arrange([...names], edges.map((edge) => [edge.source, edge.target]), (name) => widths.get(name)));
  }
  draw(known.get(key), edges);
  placed = names;
  picture.fit(picture.elements(":visible"), 20);
};

const count = () => {
  const found = light(shown).length || "nothing";
  const packages = [...shown.names].filter((name) => !nodes.get(name).is_launch_file).length;
  get("count").textContent = `${packages} packages, ${shown.edges.length} edges shown, ${found} found`;
};

const show = () => {
  const before = shown;
  shown = filtered();
  const kept = new Set(shown.edges);
  picture.batch(() => {
    data.nodes.forEach(({ name }) => {
      if (!before || before.names.has(name) !== shown.names.has(name)) {
        picture.getElementById(keys.get(name)).toggleClass("off", !shown.names.has(name));
      }
    });
    const was = before ? new Set(before.edges) : null;
    drawnAs.forEach((id, edge) => {
      if (!was || was.has(edge) !== kept.has(edge)) picture.getElementById(id).toggleClass("off", !kept.has(edge));
    });
  });
  place(shown);
  count();
  tell();
};

const choose = (name) => {
  chosen = name === chosen ? null : name;
  if (get("depth").value) return show();
  count();
  return tell();
};

// Show the chosen one with its neighbours, no larger than they are read.
const look = () => {
  const node = chosen ? picture.getElementById(keys.get(chosen)) : picture.collection();
  if (node.empty() || !node.visible()) return;
  picture.fit(node.closedNeighborhood(":visible"), 40);
  if (picture.zoom() > 1.1) picture.zoom(1.1);
  picture.center(node.closedNeighborhood(":visible"));
};

picture.on("tap", "node", (event) => choose(nameOf.get(event.target.id())));
picture.on("tap", (event) => { if (event.target === picture && chosen) choose(chosen); });
document.querySelector("aside").addEventListener("click", (event) => {
  if (event.target.dataset.name === undefined) return;
  choose(event.target.dataset.name);
  look();
});
get("search").addEventListener("input", (event) => { event.stopPropagation(); count(); });
get("filters").addEventListener("input", show);
get("filters").addEventListener("reset", () => setTimeout(() => { chosen = null; show(); }));
get("filters").addEventListener("submit", (event) => event.preventDefault());
get("fit").addEventListener("click", () => picture.fit(picture.elements(":visible"), 20));
let width = picture.width();
picture.on("resize", () => { // a window made narrow, a tablet turned
  if (picture.width() === width) return;
  width = picture.width();
  picture.fit(picture.elements(":visible"), 20);
});
get("theme").addEventListener("click", () => {
  const root = document.documentElement;
  const isDark = root.dataset.theme ? root.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  root.dataset.theme = isDark ? "light" : "dark";
  picture.style(looks());
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => picture.style(looks()));
show();
