// SPDX-License-Identifier: GPL-3.0-or-later
// The remaining stock on the part, and its worst places.

import {
  BufferAttribute, BufferGeometry, Group, Mesh, MeshBasicMaterial, Points, PointsMaterial, SphereGeometry,
} from "three";
import { rgbOfSigned } from "./colours.js";

// Values from -1 (limit of gouges) to 1 (limit of remaining stock).
export function deviationPoints({ points, left_mm: left, tolerance_mm: tolerance, scallop_mm: scallop }) {
  const colours = new Float32Array(points.length);
  for (let k = 0; k < left.length; ++k) {
    const value = left[k];
    const limit = value < 0 ? tolerance : scallop;
    colours.set(rgbOfSigned(limit > 0 ? value / limit : Math.sign(value)), 3 * k);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setAttribute("color", new BufferAttribute(colours, 3));
  return new Points(geometry, new PointsMaterial({ vertexColors: true, size: 3, sizeAttenuation: false }));
}

// A place of the deepest gouge and one of most remaining stock differ in colour.
export const placeColour = { gouge: "#d81b60", stock: "#00796b" };

export function marks(places, radius) {
  const group = new Group();
  for (const { point_mm: point, kind } of places) {
    const ball = new Mesh(new SphereGeometry(radius, 16, 12), new MeshBasicMaterial({ color: placeColour[kind] }));
    ball.position.set(...point);
    group.add(ball);
  }
  return group;
}
