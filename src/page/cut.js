// SPDX-License-Identifier: GPL-3.0-or-later
// The part, the path and its proof: a 3D view with the tool on a slider, and plots along the path.

import {
  BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, Points,
  PointsMaterial, SphereGeometry, Vector3,
} from "three";
import { kindColour, rampCss, rgbOfKind, rgbOfShare, rgbOfSigned, signedRampCss } from "./colours.js";
import { button, choice, element, shown } from "./elements.js";
import { Plot } from "./plots.js";
import { facetMesh, View3d } from "./scene.js";
import { cutterMesh, place } from "./tool.js";

const partColour = 0x9fb0c8;
const wholePathSeconds = 20; // at speed 1

const axisOf = { a: new Vector3(1, 0, 0), b: new Vector3(0, 1, 0), c: new Vector3(0, 0, 1) };

// What colours the path: a name, the value at a point, and whether the values are kinds.
function colourings(path) {
  const found = [["move", "kind of move", (k) => path.moves[k], path.move_names]];
  found.push(["pass", "number of the pass", (k) => path.passes[k], null]);
  found.push(["piece", "number of the piece", (k) => path.pieces[k], null]);
  if (path.feeds) found.push(["feed", "feed, mm/min", (k) => path.feeds[k], null]);
  if (path.limits) found.push(["limit", "limit of the feed", (k) => path.limits[k], path.limit_names]);
  return found;
}

class PathLines {
  constructor(path) {
    this.path = path;
    const count = path.tips.length / 3;
    const places = new Float32Array(Math.max(0, 6 * (count - 1)));
    for (let k = 1; k < count; ++k) places.set(path.tips.subarray(3 * k - 3, 3 * k + 3), 6 * (k - 1));
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(places.length), 3));
    this.node = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
  }

  // Colours each segment by its end. Returns the legend.
  colour([, title, valueOf, names]) {
    const count = this.path.tips.length / 3;
    let low = Infinity;
    let high = -Infinity;
    const seen = new Set();
    for (let k = 1; k < count; ++k) {
      const value = valueOf(k);
      if (!Number.isFinite(value)) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
      if (names) seen.add(value);
    }
    const colours = this.node.geometry.getAttribute("color");
    for (let k = 1; k < count; ++k) {
      const value = valueOf(k);
      const known = names ? rgbOfKind(value) : rgbOfShare((value - low) / (high - low || 1));
      const colour = Number.isFinite(value) ? known : [0.6, 0.6, 0.6];
      colours.setXYZ(2 * k - 2, ...colour);
      colours.setXYZ(2 * k - 1, ...colour);
    }
    colours.needsUpdate = true;
    if (names)
      return [...seen].sort((a, b) => a - b).map((kind) => swatch(kindColour(kind), names[kind]));
    return low <= high ? scale(rampCss, title, low, high) : [element("span", {}, `${title}: not known`)];
  }
}

function swatch(colour, text) {
  const box = element("i");
  box.style.background = colour;
  return element("span", {}, box, text);
}

function scale(css, title, low, high) {
  const box = element("div", { class: "scale" });
  box.style.background = css;
  return [element("span", {}, `${title}: ${shown(low, 3)}`, box, shown(high, 3))];
}

// Values from -1 (limit of gouges) to 1 (limit of remaining stock).
function deviationPoints({ points, left_mm: left, tolerance_mm: tolerance, scallop_mm: scallop }) {
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

function marks(places, radius) {
  const group = new Group();
  for (const { point_mm: point } of places) {
    const ball = new Mesh(new SphereGeometry(radius, 16, 12), new MeshBasicMaterial({ color: 0xd81b60 }));
    ball.position.set(...point);
    group.add(ball);
  }
  return group;
}

// The turns of the part and of the tool on a machine, from the positions of its rotary axes.
function machineTurns(machine, degrees) {
  const part = new Matrix4();
  const tool = new Matrix4();
  machine.rotary.forEach(({ letter, side }, number) => {
    const turn = new Matrix4().makeRotationAxis(axisOf[letter], (degrees[number] * Math.PI) / 180);
    if (side === "table") part.premultiply(turn);
    else tool.multiply(turn);
  });
  return { part, tool };
}

export class CutView {
  constructor(content) {
    this.content = content;
    this.state = { point: 0, tip_mm: null, colour: null, isPlaying: false };
    this.node = element("section", { class: "view" });
    this.parts = {};
    this.view = new View3d(this.description());
    this.world = new Group(); // all that is fixed to the part
    this.view.content.add(this.world);
    const bar = element("div", { class: "bar" });
    this.legend = element("div", { class: "legend" });
    this.readout = element("div", { class: "readout", "aria-live": "off" });
    this.plots = [];
    this.node.append(this.view.node, bar);
    if (content.part) this.add("part", "part", facetMesh(content.part, partColour), bar);
    if (content.path) this.addPath(bar);
    if (content.deviation) this.addDeviation(bar);
    bar.append(button("whole view", () => this.view.fit()));
    this.node.append(this.legend, this.readout, ...this.notes());
    this.node.append(...this.plots.map((plot) => plot.node));
    this.view.fit();
    this.show(0);
  }

  description() {
    const { part, path, deviation } = this.content;
    const shownThings = [part && "the part", path && "the tool path", deviation && "the remaining stock"].filter(Boolean);
    return `3D view of ${shownThings.join(", ") || "nothing"}. Drag or use arrow keys with Shift to turn, the wheel to zoom.`;
  }

  notes() {
    const notes = ["part", "path", "deviation"].map((key) => this.content[key]?.note).filter(Boolean);
    return notes.map((note) => element("p", { class: "note" }, note));
  }

  // Adds an object with a box that shows or hides it.
  add(name, label, object, bar, isShown = true) {
    this.world.add(object);
    this.parts[name] = object;
    object.visible = isShown;
    const box = element("input", { type: "checkbox", checked: isShown, id: `show-${name}` });
    box.addEventListener("change", () => {
      object.visible = box.checked;
      this.view.draw();
    });
    bar.append(element("label", {}, box, label));
  }

  addPath(bar) {
    const { path } = this.content;
    this.lines = new PathLines(path);
    this.add("path", "path", this.lines.node, bar);
    const ways = colourings(path);
    const { node, select } = choice("path by", ways.map(([name]) => [name, name]), (name) => this.colour(name));
    select.id = "colour";
    bar.append(node);
    this.ways = new Map(ways.map((way) => [way[0], way]));
    this.colour(ways[0][0]);
    if (path.cutter) {
      this.cutter = cutterMesh(path.cutter);
      this.view.content.add(this.cutter);
    }
    if (this.content.machine && path.positions) {
      const box = element("input", { type: "checkbox", id: "on-machine" });
      box.addEventListener("change", () => {
        this.show(this.state.point);
        this.view.fit();
      });
      this.onMachine = box;
      bar.append(element("label", {}, box, `on the machine ${this.content.machine.word}`));
    }
    this.addSlider();
    this.addPlots();
  }

  addSlider() {
    const count = this.content.path.tips.length / 3;
    this.slider = element("input", { type: "range", min: 0, max: count - 1, value: 0, step: 1, id: "point", "aria-label": "point of the path" });
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    this.player = button("play", () => this.play(!this.state.isPlaying), { id: "play" });
    const speed = choice("speed", [[0.25, "1/4"], [1, "1"], [4, "4"], [16, "16"]], () => {});
    speed.select.value = "1";
    speed.select.id = "speed";
    this.speed = speed.select;
    this.node.append(element("div", { class: "bar" }, this.player, this.slider, speed.node));
  }

  addPlots() {
    const { plots, path } = this.content;
    if (plots) for (const { name, values } of plots.series) this.plots.push(new Plot(name, values, plots.along_mm, "way of the tip, mm"));
    else if (path.feeds && path.feeds.some(Number.isFinite))
      this.plots.push(new Plot("feed, mm/min", path.feeds, path.way_mm, "way of the tip, mm"));
  }

  addDeviation(bar) {
    const { deviation } = this.content;
    this.add("deviation", "remaining stock", deviationPoints(deviation), bar);
    this.add("places", "worst places", marks(deviation.worst, deviation.mark_mm), bar);
    const [legend] = scale(signedRampCss, "gouge, mm", -deviation.tolerance_mm, deviation.scallop_mm);
    legend.append(" remaining, mm");
    this.node.append(element("div", { class: "legend" }, legend, ...deviation.worst.map(({ text }) => swatch("#d81b60", text))));
  }

  colour(name) {
    this.state.colour = name;
    this.legend.replaceChildren(...this.lines.colour(this.ways.get(name)));
    this.view.draw();
  }

  // Moves the tool to a point of the path that is drawn.
  show(point) {
    const { path, machine } = this.content;
    if (!path) return;
    const at = (array, width) => (array ? Array.from(array.subarray(width * point, width * point + width)) : null);
    const drawn = at(path.tips, 3); // relative to the origin of the page
    const tip = drawn.map((x, c) => x + this.content.origin_mm[c]);
    const axis = at(path.axes, 3) ?? path.axis;
    Object.assign(this.state, { point, tip_mm: tip, axis });
    this.slider.value = point;
    const isOnMachine = Boolean(this.onMachine?.checked);
    this.world.matrixAutoUpdate = false;
    this.world.matrix.identity();
    if (this.cutter) place(this.cutter, drawn, axis);
    if (isOnMachine) {
      const positions = at(path.positions, 5);
      this.state.positions = positions;
      const { part } = machineTurns(machine, positions.slice(3));
      this.world.matrix.copy(part.multiply(new Matrix4().fromArray(machine.part_to_machine)));
      const turned = (vector, w) => new Vector3(...vector).applyMatrix4(w ? this.world.matrix : new Matrix4().extractRotation(this.world.matrix));
      if (this.cutter) place(this.cutter, turned(drawn, true).toArray(), turned(axis, false).normalize().toArray());
    }
    this.world.matrixWorldNeedsUpdate = true;
    this.readout.textContent = this.words(point, tip, axis, isOnMachine);
    for (const plot of this.plots) plot.point(path.way_mm[point]);
    this.view.draw();
  }

  words(point, tip, axis, isOnMachine) {
    const { path } = this.content;
    const parts = [`point ${path.numbers[point]}`, path.move_names[path.moves[point]], `pass ${path.passes[point]}`];
    parts.push(`tip ${tip.map((x) => x.toFixed(3)).join(", ")} mm`);
    if (path.axes) parts.push(`axis ${axis.map((x) => x.toFixed(3)).join(", ")}`);
    if (path.feeds && Number.isFinite(path.feeds[point])) parts.push(`${shown(path.feeds[point])} mm/min`);
    if (path.limits) parts.push(`limit: ${path.limit_names[path.limits[point]] || "none"}`);
    if (isOnMachine) {
      const [x, y, z, r1, r2] = this.state.positions;
      parts.push(`X ${x.toFixed(3)} Y ${y.toFixed(3)} Z ${z.toFixed(3)} mm, rotary axes ${r1.toFixed(3)}, ${r2.toFixed(3)} deg`);
    }
    return parts.join(" · ");
  }

  play(isPlaying) {
    this.state.isPlaying = isPlaying;
    this.player.textContent = isPlaying ? "pause" : "play";
    if (!isPlaying) return;
    const { way_mm: way } = this.content.path;
    const last = way.length - 1;
    if (this.state.point >= last) this.show(0);
    let at = way[this.state.point];
    let before = performance.now();
    const step = (now) => {
      if (!this.state.isPlaying) return;
      at += ((now - before) / 1000) * (way[last] / wholePathSeconds) * Number(this.speed.value);
      before = now;
      let point = this.state.point;
      while (point < last && way[point + 1] <= at) ++point;
      if (point !== this.state.point) this.show(point);
      if (point >= last) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}
