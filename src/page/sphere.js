// SPDX-License-Identifier: GPL-3.0-or-later
// The directions that reach the facets of a part: the part beside the sphere of directions.

import { rampCss, rgbOfShare } from "./colours.js";
import { button, element } from "./elements.js";
import { colourFacets, facetMesh, View3d } from "./scene.js";

const seen = [0.9, 0.62, 0.1];
const unseen = [0.62, 0.68, 0.76];
const beyondReach = 0.45; // brightness of directions that the machine cannot take

export class SphereView {
  constructor(content) {
    this.content = content;
    const { part, cells, words_per_cell: words, reachable } = content;
    this.facets = part.triangles.length / 3;
    this.cells = cells.triangles.length / 3;
    this.words = words;
    this.reachable = reachable;
    this.state = { facet: null, cell: null, cone: 0, facetsSeen: 0 };
    this.partView = new View3d("the part: click a facet for the directions that reach it");
    this.sphereView = new View3d("the sphere of directions: click a direction for the facets that it reaches");
    this.part = facetMesh(part, 0, (facet) => this.facetColour(facet));
    this.sphere = facetMesh(cells, 0, (cell) => this.cellColour(cell));
    this.partView.content.add(this.part);
    this.sphereView.content.add(this.sphere);
    this.partView.onClick((event) => this.choose(this.partView.triangleAt(event, this.part), null));
    this.sphereView.onClick((event) => this.choose(null, this.sphereView.triangleAt(event, this.sphere)));
    this.readout = element("div", { class: "readout", role: "status" });
    const box = element("div", { class: "scale" });
    box.style.background = rampCss;
    const number = (label, most, then) => {
      const input = element("input", { type: "number", min: 0, max: most - 1, placeholder: `0 to ${most - 1}`, id: `number-of-${label}` });
      input.addEventListener("change", () => then(Math.min(Math.max(Math.round(Number(input.value)), 0), most - 1)));
      return element("label", {}, label, input);
    };
    const stages = element("div", { class: "pair" }, this.partView.node, this.sphereView.node);
    this.node = element(
      "section", { class: "view" }, stages,
      element("div", { class: "bar" },
        number("facet", this.facets, (facet) => this.choose(facet, null)),
        number("direction", this.cells, (cell) => this.choose(null, cell)),
        button("all", () => this.choose(null, null))),
      this.readout,
      element("div", { class: "legend" }, element("span", {}, "sphere: facets reached, 0 %", box, "100 %"),
        element("span", {}, reachable?.includes(0) ? "dark: beyond the rotary limits of the machine" : "")));
    this.shares = Float32Array.from({ length: this.cells }, (_, cell) => this.count(cell) / this.facets);
    this.partView.fit();
    this.sphereView.fit();
    this.choose(null, null);
  }

  reaches(facet, cell) {
    return (this.content.bits[cell * this.words + (facet >> 5)] >>> (facet & 31)) & 1;
  }

  count(cell) {
    let count = 0;
    for (let facet = 0; facet < this.facets; ++facet) count += this.reaches(facet, cell);
    return count;
  }

  cellColour(cell) {
    const { facet } = this.state;
    const colour = facet !== null ? (this.reaches(facet, cell) ? seen : unseen) : rgbOfShare(this.shares?.[cell] ?? 0);
    const light = this.reachable && !this.reachable[cell] ? beyondReach : 1;
    return cell === this.state.cell ? [0.85, 0.1, 0.38] : colour.map((part) => light * part);
  }

  facetColour(facet) {
    if (facet === this.state.facet) return [0.85, 0.1, 0.38];
    return this.state.cell !== null && this.reaches(facet, this.state.cell) ? seen : unseen;
  }

  choose(facet, cell) {
    Object.assign(this.state, { facet, cell, cone: 0, facetsSeen: 0 });
    if (facet !== null) {
      for (let k = 0; k < this.cells; ++k) this.state.cone += this.reaches(facet, k);
      this.readout.textContent = `facet ${facet}: ${this.state.cone} of ${this.cells} directions reach it`;
    } else if (cell !== null) {
      this.state.facetsSeen = this.count(cell);
      this.readout.textContent = `direction ${cell}: reaches ${this.state.facetsSeen} of ${this.facets} facets`;
    } else {
      this.readout.textContent = "Click a facet or a direction.";
    }
    colourFacets(this.part, (k) => this.facetColour(k));
    colourFacets(this.sphere, (k) => this.cellColour(k));
    this.partView.draw();
    this.sphereView.draw();
  }
}
