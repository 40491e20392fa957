// SPDX-License-Identifier: GPL-3.0-or-later
// The directions that reach the facets of a part: the part beside the sphere of directions.

import { rampCss, rgbOfShare } from "./colours.js";
import { button, element } from "./elements.js";
import { scale, swatch } from "./legend.js";
import { colourFacets, facetMesh, View3d } from "./scene.js";

const seen = [0.9, 0.62, 0.1];
const chosen = [0.85, 0.1, 0.38];
const unseen = [0.62, 0.68, 0.76];
// Grey, unlit: directions that the machine cannot take, and those of them that reach the chosen facet.
const beyondReach = [0.4, 0.4, 0.4];
const seenBeyondReach = [0.6, 0.6, 0.6];

const css = (colour) => `rgb(${colour.map((part) => Math.round(255 * part)).join(" ")})`;

export class SphereView {
  constructor(content) {
    this.content = content;
    const { part, cells, words_per_cell: words, reachable } = content;
    this.facets = part.triangles.length / 3;
    this.cells = cells.triangles.length / 3;
    this.words = words;
    this.reachable = reachable;
    this.state = { facet: null, cell: null, cone: 0, facetsSeen: 0 };
    this.partView = new View3d("the part: click a facet for the directions that reach it", { hasScale: true });
    this.sphereView = new View3d("the sphere of directions: click a direction for the facets that it reaches");
    this.part = facetMesh(part, 0, (facet) => this.facetColour(facet));
    this.sphere = facetMesh(cells, 0, (cell) => this.cellColour(cell), (cell) => this.isReachable(cell));
    this.partView.content.add(this.part);
    this.sphereView.content.add(this.sphere);
    this.partView.onClick((event) => this.choose(this.partView.triangleAt(event, this.part), null));
    this.sphereView.onClick((event) => this.choose(null, this.sphereView.triangleAt(event, this.sphere)));
    this.readout = element("div", { class: "readout", role: "status" });
    const number = (label, most, then) => {
      const placeholder = `0 to ${most - 1}`;
      const input = element("input", { type: "number", min: 0, max: most - 1, placeholder, id: `number-of-${label}` });
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
      element("div", { class: "legend" },
        ...scale(rampCss, "facets reached, %", 0, 100),
        swatch(css(seen), "reached"), swatch(css(unseen), "not reached"),
        reachable?.includes(0) ? swatch(css(beyondReach), "beyond the rotary limits of the machine") : null));
    this.stages = [this.partView, this.sphereView];
    this.shares = Float32Array.from({ length: this.cells }, (_, cell) => this.count(cell) / this.facets);
    this.partView.fit();
    this.sphereView.fit();
    this.choose(null, null);
  }

  isReachable(cell) {
    return !this.reachable || this.reachable[cell] === 1;
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
    if (cell === this.state.cell) return chosen;
    if (this.isReachable(cell)) return colour;
    return facet !== null && this.reaches(facet, cell) ? seenBeyondReach : beyondReach;
  }

  facetColour(facet) {
    if (facet === this.state.facet) return chosen;
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
