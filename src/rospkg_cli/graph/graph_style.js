"use strict";
// How nodes and edges look: the colors are those of the page's style.
const color = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const looks = () => [
  { selector: "node", style: {
    label: "data(label)", shape: "round-rectangle", width: "data(width)", height: 26, "text-valign": "center",
    "font-size": 12, "font-family": "system-ui, sans-serif", color: color("fg"), "background-color": color("box"),
    "border-width": 1, "border-color": color("dim"), "min-zoomed-font-size": 5 } },
  { selector: "node[?launch]", style: { shape: "cut-rectangle", "background-color": color("bg"), "border-color": color("launch"), "font-size": 11 } },
  { selector: "node[?outside]", style: { "border-style": "dashed", color: color("dim") } },
  { selector: "edge", style: {
    width: 1, "curve-style": "bezier", "line-color": color("edge"), "target-arrow-color": color("edge"),
    "target-arrow-shape": "triangle", "arrow-scale": .8 } },
  { selector: "edge.curved", style: { "curve-style": "unbundled-bezier", "control-point-distances": "data(bend)", "control-point-weights": .5 } },
  ...["launch", "unused", "undeclared", "cycle"].map((mark) => ({ selector: `edge.${mark}`, style: {
    "line-color": color(mark), "target-arrow-color": color(mark), width: mark === "launch" ? 1 : 2,
    "line-style": { unused: "dotted", undeclared: "dashed" }[mark] || "solid" } })),
  { selector: ".far", style: { opacity: .25 } },
  { selector: "node.found", style: { "border-width": 3, "border-color": color("link") } },
  { selector: "node.chosen", style: { "border-width": 3, "border-color": color("link"), "background-color": color("picked") } },
  { selector: ".off", style: { display: "none" } },
];
