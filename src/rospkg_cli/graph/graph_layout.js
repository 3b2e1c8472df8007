"use strict";
// Layout: each connected part by dagre, over the edges that no longer way tells already; then the parts side by side.
const ORDERED_UP_TO = 600; // edges; beyond, finding the order with fewest crossings would take seconds

// Return for each id the set of ids that its edges lead to.
const edgesFrom = (ids, edges) => {
  const from = new Map(ids.map((id) => [id, new Set()]));
  edges.forEach(([source, target]) => source !== target && from.get(source).add(target));
  return from;
};

// Return the edges without those whose target is reached over another neighbour.
const reduced = (from) => [...from].flatMap(([source, targets]) => {
  const longer = new Set();
  const open = [...targets].flatMap((each) => [...from.get(each)]);
  while (open.length) {
    const next = open.pop();
    if (next === source || longer.has(next)) continue;
    longer.add(next);
    open.push(...from.get(next));
  }
  return [...targets].filter((each) => !longer.has(each)).map((each) => [source, each]);
});

// Return the connected parts: arrays of ids.
const parts = (from) => {
  const beside = new Map([...from.keys()].map((id) => [id, []]));
  from.forEach((targets, source) => targets.forEach((target) => {
    beside.get(source).push(target);
    beside.get(target).push(source);
  }));
  const seen = new Set();
  return [...from.keys()].filter((id) => !seen.has(id)).map((id) => {
    if (seen.has(id)) return [];
    const part = [id];
    seen.add(id);
    for (const each of part) beside.get(each).forEach((other) => seen.has(other) || (seen.add(other), part.push(other)));
    return part;
  }).filter((part) => part.length);
};

// Return { places, width, height } of one part.
const arrangePart = (ids, edges, widthOf) => {
  const graph = new dagre.graphlib.Graph();
  graph.setGraph({ rankdir: "LR", ranker: "longest-path", nodesep: 10, ranksep: 45 });
  graph.setDefaultEdgeLabel(() => ({}));
  ids.forEach((id) => graph.setNode(id, { width: widthOf(id), height: 26 }));
  edges.forEach(([source, target]) => graph.setEdge(source, target));
  dagre.layout(graph, { disableOptimalOrderHeuristic: edges.length > ORDERED_UP_TO });
  const { width, height } = graph.graph();
  return { places: ids.map((id) => [id, graph.node(id)]), width, height };
};

// Return the place { x, y } of each id, and for an id those that its edges lead to directly, over no other.
const arrange = (ids, edges, widthOf) => {
  const from = edgesFrom(ids, edges);
  const partOf = new Map();
  const all = parts(from);
  all.forEach((part, at) => part.forEach((id) => partOf.set(id, at)));
  const inside = all.map(() => []);
  const direct = reduced(from);
  direct.forEach((edge) => inside[partOf.get(edge[0])].push(edge));
  const blocks = all.map((part, at) => arrangePart(part, inside[at], widthOf));
  blocks.sort((one, other) => other.width - one.width || other.height - one.height);
  const area = blocks.reduce((sum, each) => sum + (each.width + 40) * (each.height + 14), 0);
  const limit = Math.max(Math.sqrt(area / 1.8), ...blocks.map((each) => each.height));
  const found = new Map();
  let x = 0, y = 0, widest = 0;
  blocks.forEach((block) => {
    if (y && y + block.height > limit) [x, y, widest] = [x + widest + 40, 0, 0];
    block.places.forEach(([id, place]) => found.set(id, { x: x + place.x, y: y + place.y }));
    y += block.height + 14;
    widest = Math.max(widest, block.width);
  });
  return { places: found, direct: edgesFrom(ids, direct) };
};
