// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of the page. Texts become text nodes, never markup.

const svgSpace = "http://www.w3.org/2000/svg";

function filled(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes))
    if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) node.setAttribute(name, value);
  node.append(...children.filter((child) => child !== null));
  return node;
}

export const element = (name, attributes = {}, ...children) =>
  filled(document.createElement(name), attributes, children);

export const svgElement = (name, attributes = {}, ...children) =>
  filled(document.createElementNS(svgSpace, name), attributes, children);

// A choice of words, [value, text] each.
export function choice(label, options, onChange) {
  const select = element("select", {}, ...options.map(([value, text]) => element("option", { value }, text)));
  select.addEventListener("change", () => onChange(select.value));
  return { node: element("label", {}, label, select), select };
}

export function button(text, onClick, attributes = {}) {
  const node = element("button", { type: "button", ...attributes }, text);
  node.addEventListener("click", onClick);
  return node;
}

const measured = []; // functions that look at the width of an element

// Calls `then` with the width of an element in pixels when it is placed or its width changes.
export function onWidth(node, then) {
  let last = 0;
  const measure = () => {
    const width = Math.round(node.getBoundingClientRect().width);
    if (width === 0 || width === last) return;
    last = width;
    then(width);
  };
  measured.push(measure);
  new ResizeObserver(measure).observe(node);
}

// Does so at once, before a page is printed.
export const measureAll = () => measured.forEach((measure) => measure());

// A number with a fixed number of digits after the point, never "-0.000".
export function fixed(value, decimals) {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace("-", "") : text;
}

// Digits after the point for lengths in a part of this extent, mm: a micrometre, or less in a small part.
export const decimalsFor = (extent) =>
  extent > 0 ? Math.min(Math.max(5 - Math.floor(Math.log10(extent)), 3), 12) : 3;

// A number as people read it.
export function shown(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "not known";
  if (value !== 0 && (Math.abs(value) >= 1e6 || Math.abs(value) < 1e-4)) return value.toExponential(digits - 1);
  return String(Number(value.toPrecision(digits)));
}
