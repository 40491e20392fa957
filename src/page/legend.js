// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of legends.

import { signedRampHalvesCss } from "./colours.js";
import { element, shown } from "./elements.js";

export function swatch(colour, text) {
  const box = element("i");
  box.style.background = colour;
  return element("span", {}, box, text);
}

function bar(css, kind) {
  const box = element("span", { class: kind });
  box.style.background = css;
  return box;
}

export const scale = (css, title, low, high) =>
  [element("span", {}, `${title}: ${shown(low, 3)}`, bar(css, "scale"), shown(high, 3))];

// The two halves of a scale of gouges and remaining stock, each with its own limit.
export function signedScale(tolerance, scallop) {
  const [gouge, stock] = signedRampHalvesCss;
  const limit = (value) => (value > 0 ? `${shown(value, 3)} mm` : "no limit");
  return element(
    "span", { class: "signed" },
    element("span", {}, `gouge, ${limit(tolerance)}`, bar(gouge, "half scale")), element("b", {}, "0"),
    element("span", {}, bar(stock, "half scale"), `${limit(scallop)}, remaining stock`));
}
