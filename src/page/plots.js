// SPDX-License-Identifier: GPL-3.0-or-later
// Plots of quantities along the path, with a cursor.

import { onWidth, shown, svgElement } from "./elements.js";

const usualWidth = 900; // pixels, until the plot has a place
const height = 170;
const box = { left: 76, right: 16, top: 26, bottom: 34 };

function extent(values) {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values)
    if (Number.isFinite(value)) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  return low <= high ? [low, high] : [0, 1];
}

// The curve through the values, broken where one is not known.
function curve(xs, ys, toX, toY) {
  let text = "";
  let isDown = false;
  for (let k = 0; k < ys.length; ++k) {
    const isKnown = Number.isFinite(ys[k]) && Number.isFinite(xs[k]);
    if (isKnown) text += `${isDown ? "L" : "M"}${toX(xs[k]).toFixed(1)} ${toY(ys[k]).toFixed(1)}`;
    isDown = isKnown;
  }
  return text;
}

// A plot of `values` over `along`, both arrays; `name` and `alongName` carry their units.
export class Plot {
  constructor(name, values, along, alongName) {
    Object.assign(this, { name, values, along, alongName, at: null });
    const [low, high] = extent(values);
    const words = `${name}: ${shown(low)} to ${shown(high)}`;
    this.node = svgElement("svg", { class: "plot", role: "img", "aria-label": words });
    this.draw(usualWidth);
    onWidth(this.node, (width) => this.draw(width));
  }

  // Draws for a width in pixels, so that texts keep their size.
  draw(width) {
    const [low, high] = extent(this.values);
    const [first, last] = extent(this.along);
    const bottom = low >= 0 && low < 0.5 * high ? 0 : low;
    const rise = high - bottom || 1;
    this.toX = (x) => box.left + ((x - first) / (last - first || 1)) * (width - box.left - box.right);
    const toY = (y) => height - box.bottom - ((y - bottom) / rise) * (height - box.top - box.bottom);
    const label = (x, y, text, anchor) => svgElement("text", { x, y, "text-anchor": anchor }, text);
    this.cursor = svgElement("line", { class: "cursor", y1: box.top, y2: height - box.bottom, x1: -9, x2: -9 });
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.node.replaceChildren(
      svgElement("path", { class: "axis", d: `M${box.left} ${box.top}V${height - box.bottom}H${width - box.right}` }),
      label(box.left, 17, this.name, "start"),
      label(box.left - 6, toY(bottom) + 4, shown(bottom, 3), "end"),
      label(box.left - 6, toY(bottom + rise) + 4, shown(bottom + rise, 3), "end"),
      label(box.left, height - 12, shown(first, 3), "start"),
      label(width - box.right, height - 12, shown(last, 3), "end"),
      label((box.left + width - box.right) / 2, height - 12, this.alongName, "middle"),
      svgElement("path", { class: "curve", d: curve(this.along, this.values, this.toX, toY) }),
      this.cursor);
    if (this.at !== null) this.point(this.at);
  }

  // Moves the cursor to a value of the axis along the path.
  point(at) {
    this.at = at;
    const x = this.toX(at).toFixed(1);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
  }
}
