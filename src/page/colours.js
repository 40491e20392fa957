// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of values and of kinds. Those of kinds differ for people with any colour vision.

const kindColours = ["#1f77b4", "#d95f02", "#7570b3", "#e7298a", "#66a61e", "#e6ab02", "#a6761d", "#666666"];
// Dark blue to yellow, even in lightness.
const ramp = [[0.27, 0.0, 0.33], [0.23, 0.32, 0.55], [0.13, 0.57, 0.55], [0.37, 0.79, 0.38], [0.99, 0.91, 0.14]];
// Red for a gouge, white for none, blue for remaining stock.
const signedRamp = [[0.70, 0.09, 0.17], [0.96, 0.65, 0.51], [0.93, 0.93, 0.90], [0.45, 0.68, 0.82], [0.13, 0.40, 0.67]];

function between(stops, share) {
  const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const k = Math.min(Math.floor(place), stops.length - 2);
  return stops[k].map((low, c) => low + (place - k) * (stops[k + 1][c] - low));
}

export const kindColour = (k) => kindColours[k % kindColours.length];

export function rgbOfKind(k) {
  const colour = kindColour(k);
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255);
}

export const rgbOfShare = (share) => between(ramp, share);
// -1: the limit of gouges, 0: nothing left, 1: the limit of remaining stock.
export const rgbOfSigned = (value) => between(signedRamp, (value + 1) / 2);

function css(stops) {
  return `linear-gradient(to right, ${stops
    .map((stop) => `rgb(${stop.map((part) => Math.round(255 * part)).join(" ")})`)
    .join(", ")})`;
}
export const rampCss = css(ramp);
export const signedRampHalvesCss = [css(signedRamp.slice(0, 3)), css(signedRamp.slice(2))];
