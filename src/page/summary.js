// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the summaries, what the page was made from, and the works to cite.

import { element } from "./elements.js";

export class SummaryView {
  constructor({ summaries, provenance, citations, pictures }) {
    const table = (rows) => element("table", {}, ...rows.map(([key, value]) =>
      element("tr", {}, element("th", { scope: "row" }, ...breakable(key)), element("td", {}, value))));
    this.node = element("section", { class: "view" });
    for (const { title, rows, is_folded: isFolded } of summaries) {
      if (rows.length === 0) continue;
      if (isFolded) this.node.append(element("details", {}, element("summary", {}, title), table(rows)));
      else this.node.append(element("h2", {}, title), table(rows));
    }
    this.node.append(element("h2", {}, "Made from"), table(provenance));
    const works = citations.map((work) => element("li", {}, work));
    if (works.length > 0) this.node.append(element("h2", {}, "Please cite"), element("ul", {}, ...works));
    if (pictures.length > 0) this.node.append(element("h2", {}, "Pictures"), ...pictures.map(pictureOf));
  }
}

// A key, which may wrap behind "_" and "." only.
const breakable = (key) => key.split(/(?<=[_.])/).flatMap((word, k) => (k > 0 ? [element("wbr"), word] : [word]));

export function pictureOf({ name, svg }) {
  const src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  const image = element("img", { src, alt: name, class: "plot" });
  return element("figure", {}, image, element("figcaption", { class: "note" }, name));
}
