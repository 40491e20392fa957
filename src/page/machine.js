// SPDX-License-Identifier: GPL-3.0-or-later
// The part and the tool as they stand on a machine.

import { Matrix4, Vector3 } from "three";

const axisOf = { a: new Vector3(1, 0, 0), b: new Vector3(0, 1, 0), c: new Vector3(0, 0, 1) };

// The turn about a line through a point along an axis of the machine.
function turnAbout(letter, degrees, [x, y, z]) {
  const turn = new Matrix4().makeRotationAxis(axisOf[letter], (degrees * Math.PI) / 180);
  return new Matrix4().makeTranslation(x, y, z).multiply(turn).multiply(new Matrix4().makeTranslation(-x, -y, -z));
}

// Matrices that lead from the page's part, and from a tool with its tip at the origin along +z, to the machine.
// positions: X, Y, Z in mm and the rotary axes, from the part to the tool, in degrees.
export function machinePoses({ rotary, part_to_machine: clamped }, positions) {
  const part = new Matrix4().fromArray(clamped);
  const tool = new Matrix4().makeTranslation(...positions.slice(0, 3));
  rotary.forEach(({ letter, side, point_mm: point }, number) => {
    const turn = turnAbout(letter, positions[3 + number], point);
    if (side === "table") part.premultiply(turn);
    else tool.multiply(turn);
  });
  return { part, tool };
}
