// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of the path, and what they are coloured by.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import { kindColour, rampCss, rgbOfKind, rgbOfShare } from "./colours.js";
import { element } from "./elements.js";
import { scale, swatch } from "./legend.js";

// What colours the path: a name, the value at a point, and whether the values are kinds.
export function colourings(path) {
  const found = [["move", "kind of move", (k) => path.moves[k], path.move_names]];
  found.push(["pass", "number of the pass", (k) => path.passes[k], null]);
  found.push(["piece", "number of the piece", (k) => path.pieces[k], null]);
  if (path.feeds) found.push(["feed", "feed, mm/min", (k) => path.feeds[k], null]);
  if (path.limits) found.push(["limit", "limit of the feed", (k) => path.limits[k], path.limit_names]);
  return found;
}

export class PathLines {
  // origin: of the page, mm.
  constructor(path, origin) {
    this.path = path;
    const count = path.tips.length / 3;
    const places = new Float32Array(Math.max(0, 6 * (count - 1)));
    for (let k = 1; k < count; ++k)
      for (let i = 0; i < 6; ++i) places[6 * (k - 1) + i] = path.tips[3 * (k - 1) + i] - origin[i % 3];
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(places.length), 3));
    this.node = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
  }

  // Colours each segment by its end. Returns the legend.
  colour([, title, valueOf, names]) {
    const count = this.path.tips.length / 3;
    let low = Infinity;
    let high = -Infinity;
    const seen = new Set();
    for (let k = 1; k < count; ++k) {
      const value = valueOf(k);
      if (!Number.isFinite(value)) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
      if (names) seen.add(value);
    }
    const colours = this.node.geometry.getAttribute("color");
    for (let k = 1; k < count; ++k) {
      const value = valueOf(k);
      const known = names ? rgbOfKind(value) : rgbOfShare((value - low) / (high - low || 1));
      const colour = Number.isFinite(value) ? known : [0.6, 0.6, 0.6];
      colours.setXYZ(2 * k - 2, ...colour);
      colours.setXYZ(2 * k - 1, ...colour);
    }
    colours.needsUpdate = true;
    if (names)
      return [...seen].sort((a, b) => a - b).map((kind) => swatch(kindColour(kind), names[kind]));
    return low <= high ? scale(rampCss, title, low, high) : [element("span", {}, `${title}: not known`)];
  }
}
