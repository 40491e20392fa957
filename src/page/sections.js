// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of the offset by drive planes, before and after trimming, with the plane on a slider.

import { button, element, svgElement } from "./elements.js";

const width = 900;
const height = 520;
const margin = 40;

export class SectionsView {
  constructor({ before, after, positions_mm: positions, note }) {
    this.before = before;
    this.after = after;
    this.positions = positions;
    this.state = { plane: 0 };
    this.picture = svgElement("svg", { class: "plot", viewBox: `0 0 ${width} ${height}`, role: "img" });
    this.slider = element("input", { type: "range", min: 0, max: before.length - 1, value: 0, id: "plane", "aria-label": "drive plane" });
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    this.readout = element("div", { class: "readout" });
    const step = (by) => () => this.show(Math.min(Math.max(this.state.plane + by, 0), before.length - 1));
    this.node = element(
      "section", { class: "view" }, this.picture,
      element("div", { class: "bar" }, button("previous plane", step(-1)), this.slider, button("next plane", step(1))),
      this.readout,
      element("p", { class: "note" }, "Dashed: the section of the offset. Solid: what trimming leaves. s runs along the feed."));
    if (note) this.node.append(element("p", { class: "note" }, note));
    this.show(0);
  }

  show(plane) {
    this.state.plane = plane;
    this.slider.value = plane;
    const curves = [...this.before[plane], ...this.after[plane]];
    let [s0, z0, s1, z1] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const curve of curves)
      for (let k = 0; k < curve.length; k += 2) {
        s0 = Math.min(s0, curve[k]);
        s1 = Math.max(s1, curve[k]);
        z0 = Math.min(z0, curve[k + 1]);
        z1 = Math.max(z1, curve[k + 1]);
      }
    const scale = Math.min((width - 2 * margin) / (s1 - s0 || 1), (height - 2 * margin) / (z1 - z0 || 1));
    const left = (width - scale * (s1 - s0)) / 2;
    const low = (height + scale * (z1 - z0)) / 2;
    const text = (curve) => {
      let path = "";
      for (let k = 0; k < curve.length; k += 2)
        path += `${k ? "L" : "M"}${(left + scale * (curve[k] - s0)).toFixed(2)} ${(low - scale * (curve[k + 1] - z0)).toFixed(2)}`;
      return path;
    };
    const draw = (list, kind) => list.map((curve) => svgElement("path", { class: `curve ${kind}`, d: text(curve) }));
    const label = (x, y, words, anchor) => svgElement("text", { x, y, "text-anchor": anchor }, words);
    this.picture.replaceChildren(
      ...draw(this.before[plane], "before"), ...draw(this.after[plane], "after"),
      ...(curves.length === 0 ? [label(width / 2, height / 2, "no curve in this plane", "middle")] : [
        label(margin, height - 10, `s ${s0.toFixed(2)} mm`, "start"),
        label(width - margin, height - 10, `s ${s1.toFixed(2)} mm`, "end"),
        label(margin, 20, `z ${z1.toFixed(2)} mm`, "start"),
        label(margin, height - 28, `z ${z0.toFixed(2)} mm`, "start")]));
    const place = this.positions ? ` at ${this.positions[plane].toFixed(3)} mm across the feed` : "";
    const count = (curves) => `${curves.length} ${curves.length === 1 ? "curve" : "curves"}`;
    const words = `plane ${plane} of ${this.before.length}${place}: ${count(this.before[plane])} before, ${count(this.after[plane])} after trimming`;
    this.readout.textContent = words;
    this.picture.setAttribute("aria-label", words);
  }
}
