"use strict";
// Layout: each connected part by dagre, over the edges that no longer way tells already; then the parts side by side.
const DAGRE_UP_TO = 300; // nodes; beyond, it would take seconds for a strip of a hundred screens
const ROW = 36;

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

// Return for each id how many edges the longest way from it has; an edge back to where a way came from counts nothing.
const ranks = (ids, from) => {
  const found = new Map();
  ids.forEach((start) => {
    const open = [start];
    while (open.length) {
      const id = open[open.length - 1];
      if (!found.has(id)) {
        found.set(id, -1);
        open.push(...[...from.get(id)].filter((each) => !found.has(each)));
      } else {
        open.pop();
        if (found.get(id) < 0) found.set(id, 1 + Math.max(-1, ...[...from.get(id)].map((each) => found.get(each))));
      }
    }
  });
  return found;
};

// Return { places, width, height } of a large part: a block of columns for each rank, near to what it needs.
const arrangeLarge = (ids, edges, widthOf) => {
  const from = edgesFrom(ids, edges);
  const rankOf = ranks(ids, from);
  const levels = [];
  ids.forEach((id) => (levels[rankOf.get(id)] ||= []).push(id));
  const rows = Math.ceil(Math.sqrt((ids.length * Math.max(...ids.map(widthOf))) / ROW / 1.5));
  const found = new Map();
  const heightOf = (id) => {
    const below = [...from.get(id)].filter((each) => found.has(each)).map((each) => found.get(each).y);
    return below.length ? below.reduce((sum, y) => sum + y, 0) / below.length : Infinity;
  };
  let right = 0;
  levels.forEach((level) => {
    const order = new Map(level.map((id) => [id, heightOf(id)]));
    level.sort((one, other) => order.get(one) - order.get(other) || 0);
    const columns = Math.ceil(level.length / rows);
    const wide = Math.max(...level.map(widthOf)) + 24;
    level.forEach((id, at) => found.set(id, {
      x: right - wide * (at % columns) - wide / 2, y: ROW * (Math.floor(at / columns) + .5) + ROW * (rows - Math.ceil(level.length / columns)) / 2 }));
    right -= wide * columns + 60;
  });
  return { places: ids.map((id) => [id, { x: found.get(id).x - right, y: found.get(id).y }]), width: -right, height: ROW * rows };
};

// Return { places, width, height } of one part.
const arrangePart = (ids, edges, widthOf) => {
  if (ids.length > DAGRE_UP_TO) return arrangeLarge(ids, edges, widthOf);
  const graph = new dagre.graphlib.Graph();
  graph.setGraph({ rankdir: "LR", ranker: "longest-path", nodesep: 10, ranksep: 45 });
  graph.setDefaultEdgeLabel(() => ({}));
  ids.forEach((id) => graph.setNode(id, { width: widthOf(id), height: 26 }));
  edges.forEach(([source, target]) => graph.setEdge(source, target));
  dagre.layout(graph);
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
