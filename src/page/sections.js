// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of the offset by drive planes, before and after trimming, with the plane on a slider.

import { button, choice, decimalsFor, element, fixed, onWidth, svgElement } from "./elements.js";

const usualWidth = 900; // pixels, until the picture has a place
const margin = { left: 112, right: 18, top: 20, bottom: 34 }; // pixels, of the frame
const lineHeight = 17; // pixels

// The box of all curves, [s, z] of its corners.
function extentOf(curves) {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const curve of curves)
    for (let k = 0; k < curve.length; ++k) {
      low[k % 2] = Math.min(low[k % 2], curve[k]);
      high[k % 2] = Math.max(high[k % 2], curve[k]);
    }
  return { low, high };
}

function lengthOf(curves) {
  let length = 0;
  for (const curve of curves)
    for (let k = 2; k < curve.length; k += 2) length += Math.hypot(curve[k] - curve[k - 2], curve[k + 1] - curve[k - 1]);
  return length;
}

const countOf = (curves) => `${curves.length} ${curves.length === 1 ? "curve" : "curves"}`;

export class SectionsView {
  constructor({ planes, methods }) {
    this.planes = planes;
    this.width = usualWidth;
    this.state = { plane: 0, method: 0 }; // indices; the number of a plane may differ
    this.picture = svgElement("svg", { class: "plot", role: "img" });
    const last = planes.length - 1;
    const range = { type: "range", min: 0, max: last, value: 0, id: "plane", "aria-label": "drive plane" };
    this.slider = element("input", range);
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    this.readout = element("div", { class: "readout" });
    const step = (by) => () => this.show(Math.min(Math.max(this.state.plane + by, 0), last));
    const words = "Dashed: the section of the offset. Solid: what trimming leaves. s runs along the feed.";
    const names = methods.map((name, k) => [k, name]);
    const method = methods.length > 1
      ? choice("trimmed by method", names, (k) => this.show(this.state.plane, Number(k))) : null;
    if (method) method.select.id = "method";
    this.node = element(
      "section", { class: "view" }, this.picture,
      element("div", { class: "bar" }, button("previous plane", step(-1)), this.slider, button("next plane", step(1)),
        method?.node ?? null),
      this.readout, element("p", { class: "note" }, words));
    this.show(this.mostTrimmed());
    onWidth(this.picture, (width) => {
      this.width = width;
      this.draw();
    });
  }

  // The plane in which trimming removes most length.
  mostTrimmed() {
    const removed = this.planes.map(({ before, after }) => lengthOf(before) - lengthOf(after[0]));
    return removed.indexOf(Math.max(...removed));
  }

  // The curves of a plane before trimming, and after it by the chosen method.
  curves() {
    const { before, after } = this.planes[this.state.plane];
    return { before, after: after[this.state.method] };
  }

  show(plane, method = this.state.method) {
    Object.assign(this.state, { plane, method });
    this.slider.value = plane;
    const { number, position_mm: position } = this.planes[plane];
    const { before, after } = this.curves();
    const across = () => `, ${fixed(position, decimalsFor(10 * Math.abs(position)))} mm across the feed`;
    const place = position === undefined ? "" : across();
    const words = `plane ${number} (${plane + 1} of ${this.planes.length})${place}: ` +
      `${countOf(before)} before, ${countOf(after)} after trimming`;
    this.readout.textContent = words;
    this.picture.setAttribute("aria-label", words);
    this.draw();
  }

  // Draws for the width of the picture in pixels, so that texts keep their size.
  draw() {
    const { before, after } = this.curves();
    const width = this.width;
    const height = Math.round(Math.min(520, Math.max(300, 0.58 * width)));
    const label = (x, y, words, anchor) => svgElement("text", { x, y, "text-anchor": anchor }, words);
    this.picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    if (before.length + after.length === 0) {
      this.picture.replaceChildren(label(width / 2, height / 2, "no curve in this plane", "middle"));
      return;
    }
    const { low: [s0, z0], high: [s1, z1] } = extentOf([...before, ...after]);
    const room = [width - margin.left - margin.right, height - margin.top - margin.bottom];
    const scale = Math.min(room[0] / (s1 - s0 || 1), room[1] / (z1 - z0 || 1));
    const left = margin.left + (room[0] - scale * (s1 - s0)) / 2;
    const base = margin.top + (room[1] + scale * (z1 - z0)) / 2;
    const [right, top] = [left + scale * (s1 - s0), base - scale * (z1 - z0)];
    const text = (curve) => {
      let path = "";
      for (let k = 0; k < curve.length; k += 2) {
        const [x, y] = [left + scale * (curve[k] - s0), base - scale * (curve[k + 1] - z0)];
        path += `${k ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`;
      }
      return path;
    };
    const draw = (list, kind) => list.map((curve) => svgElement("path", { class: `curve ${kind}`, d: text(curve) }));
    const mm = (value) => `${fixed(value, decimalsFor(Math.hypot(s1 - s0, z1 - z0)))} mm`;
    const isNarrow = right - left < 2 * margin.left; // the second label of s stands below the first
    this.picture.replaceChildren(
      svgElement("path", { class: "axis", d: `M${left} ${top}V${base}H${right}` }),
      ...draw(before, "before"), ...draw(after, "after"),
      label(left - 8, Math.min(top + 5, base + 5 - lineHeight), `z ${mm(z1)}`, "end"),
      label(left - 8, base + 5, `z ${mm(z0)}`, "end"),
      label(left, base + lineHeight, `s ${mm(s0)}`, "start"),
      label(isNarrow ? left : right, base + (isNarrow ? 2 : 1) * lineHeight, `s ${mm(s1)}`, isNarrow ? "start" : "end"));
  }
}
