// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a cutter, with its tip at the origin and its axis along +z.

import { LatheGeometry, Mesh, MeshLambertMaterial, Quaternion, Vector2, Vector3 } from "three";

const cornerSteps = 12;

// How much of a cutter is drawn, mm.
export const extentOfCutter = ({ radius_mm: radius }) => ({ radius, height: 4 * radius });

export function cutterMesh({ radius_mm: radius, corner_radius_mm: corner }) {
  const profile = [new Vector2(0, 0)];
  if (radius > corner) profile.push(new Vector2(radius - corner, 0));
  for (let k = corner > 0 ? 1 : cornerSteps; k <= cornerSteps; ++k) {
    const angle = ((Math.PI / 2) * k) / cornerSteps;
    profile.push(new Vector2(radius - corner + corner * Math.sin(angle), corner * (1 - Math.cos(angle))));
  }
  const { height } = extentOfCutter({ radius_mm: radius });
  profile.push(new Vector2(radius, height), new Vector2(0, height));
  const geometry = new LatheGeometry(profile, 40);
  geometry.rotateX(Math.PI / 2); // from +y to +z
  const material = new MeshLambertMaterial({ color: 0xd9a441, transparent: true, opacity: 0.75 });
  const mesh = new Mesh(geometry, material);
  mesh.name = "cutter";
  return mesh;
}

const up = new Vector3(0, 0, 1);

// Places the cutter with its tip at a point and along an axis, both arrays of three.
export function place(mesh, tip, axis) {
  mesh.position.set(...tip);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(up, new Vector3(...axis)));
}
