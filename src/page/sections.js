// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of the offset by drive planes, before and after trimming, with the plane on a slider.

import { button, decimalsFor, element, fixed, onWidth, svgElement } from "./elements.js";

const usualWidth = 900; // pixels, until the picture has a place
const margin = { side: 16, top: 34, bottom: 52 };

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

const countOf = (curves) => `${curves.length} ${curves.length === 1 ? "curve" : "curves"}`;

export class SectionsView {
  constructor({ planes }) {
    this.planes = planes;
    this.width = usualWidth;
    this.state = { plane: 0 }; // index of a plane; its number may differ
    this.picture = svgElement("svg", { class: "plot", role: "img" });
    const last = planes.length - 1;
    const range = { type: "range", min: 0, max: last, value: 0, id: "plane", "aria-label": "drive plane" };
    this.slider = element("input", range);
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    this.readout = element("div", { class: "readout" });
    const step = (by) => () => this.show(Math.min(Math.max(this.state.plane + by, 0), last));
    const words = "Dashed: the section of the offset. Solid: what trimming leaves. s runs along the feed.";
    this.node = element(
      "section", { class: "view" }, this.picture,
      element("div", { class: "bar" }, button("previous plane", step(-1)), this.slider, button("next plane", step(1))),
      this.readout, element("p", { class: "note" }, words));
    this.show(0);
    onWidth(this.picture, (width) => {
      this.width = width;
      this.draw();
    });
  }

  show(plane) {
    this.state.plane = plane;
    this.slider.value = plane;
    const { number, position_mm: position, before, after } = this.planes[plane];
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
    const { before, after } = this.planes[this.state.plane];
    const width = this.width;
    const height = Math.round(Math.min(520, Math.max(300, 0.58 * width)));
    const label = (x, y, words, anchor) => svgElement("text", { x, y, "text-anchor": anchor }, words);
    this.picture.setAttribute("viewBox", `0 0 ${width} ${height}`);
    if (before.length + after.length === 0) {
      this.picture.replaceChildren(label(width / 2, height / 2, "no curve in this plane", "middle"));
      return;
    }
    const { low: [s0, z0], high: [s1, z1] } = extentOf([...before, ...after]);
    const room = [width - 2 * margin.side, height - margin.top - margin.bottom];
    const scale = Math.min(room[0] / (s1 - s0 || 1), room[1] / (z1 - z0 || 1));
    const left = (width - scale * (s1 - s0)) / 2;
    const base = margin.top + (room[1] + scale * (z1 - z0)) / 2;
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
    this.picture.replaceChildren(
      ...draw(before, "before"), ...draw(after, "after"),
      label(margin.side, 22, `z ${mm(z1)}`, "start"),
      label(margin.side, height - 30, `z ${mm(z0)}`, "start"),
      label(margin.side, height - 10, `s ${mm(s0)}`, "start"),
      label(width - margin.side, height - 10, `s ${mm(s1)}`, "end"));
  }
}
