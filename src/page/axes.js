// SPDX-License-Identifier: GPL-3.0-or-later
// The axis cross and the scale bar over a 3D view.

import { Vector3 } from "three";
import { svgElement } from "./elements.js";

const arm = 30; // pixels
const longestBar = 110; // pixels
const directions = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

// The greatest of 1, 2 and 5 times a power of ten up to `most`.
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1) * power;
}

export class Axes {
  constructor({ hasScale = false } = {}) {
    this.lines = directions.map((_, k) => svgElement("line", { class: `axis-${k}`, x1: 0, y1: 0 }));
    this.labels = ["x", "y", "z"].map((name) => svgElement("text", { "text-anchor": "middle" }, name));
    this.cross = svgElement("g", {}, ...this.lines, ...this.labels);
    this.bar = svgElement("path", { class: "bar-line" });
    this.length = svgElement("text", { "text-anchor": "end" });
    this.hasScale = hasScale;
    this.node = svgElement("svg", { class: "axes", "aria-hidden": "true" }, this.cross, this.bar, this.length);
  }

  name(names) {
    names.forEach((name, k) => (this.labels[k].textContent = name));
  }

  // For an orthographic camera and a view of this many pixels.
  draw(camera, width, height) {
    const seenFrom = camera.quaternion.clone().invert();
    this.cross.setAttribute("transform", `translate(${arm + 22} ${height - arm - 22})`);
    directions.forEach((direction, k) => {
      const { x, y } = direction.clone().applyQuaternion(seenFrom);
      this.lines[k].setAttribute("x2", (arm * x).toFixed(1));
      this.lines[k].setAttribute("y2", (-arm * y).toFixed(1));
      this.labels[k].setAttribute("x", ((arm + 11) * x).toFixed(1));
      this.labels[k].setAttribute("y", (-(arm + 11) * y + 5).toFixed(1));
    });
    if (!this.hasScale) return;
    const pixelsPerMm = (width * camera.zoom) / (camera.right - camera.left);
    const mm = roundLength(longestBar / pixelsPerMm);
    const pixels = mm * pixelsPerMm;
    this.bar.setAttribute("d", `M${width - 16 - pixels} ${height - 24}v6h${pixels}v-6`);
    this.length.setAttribute("x", width - 16);
    this.length.setAttribute("y", height - 30);
    this.length.textContent = `${Number(mm.toPrecision(1))} mm`;
  }
}
