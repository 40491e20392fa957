// SPDX-License-Identifier: GPL-3.0-or-later
// The part, the path and the result of the simulation: a 3D view with the tool on a slider, and plots along the path.

import { Group, Vector3 } from "three";
import { deviationPoints, marks, placeColour } from "./deviation.js";
import { button, choice, decimalsFor, element, fixed, shown } from "./elements.js";
import { signedScale, swatch } from "./legend.js";
import { colourings, PathLines } from "./lines.js";
import { machinePoses } from "./machine.js";
import { Plot } from "./plots.js";
import { facetMesh, View3d } from "./scene.js";
import { cutterMesh, extentOfCutter, place } from "./tool.js";

const partColour = 0x9fb0c8;
const wholePathSeconds = 20; // at speed 1
const mostToolsFitted = 2000;

export class CutView {
  constructor(content) {
    this.content = content;
    this.state = { point: 0, tip_mm: null, colour: null, isPlaying: false };
    this.node = element("section", { class: "view" });
    this.parts = {};
    this.view = new View3d(this.description(), { hasScale: true });
    this.decimals = decimalsFor(content.size_mm);
    this.stages = [this.view];
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
    bar.append(button("fit view", () => this.fit()));
    this.node.append(this.legend, this.readout, ...this.notes());
    this.node.append(...this.plots.map((plot) => plot.node));
    this.show(0);
    this.fit();
  }

  // Shows everything, with the tool at points all along the path. On a machine the tool is where it is now.
  fit() {
    const { path, origin_mm: origin } = this.content;
    const points = [];
    if (this.cutter && !this.onMachine?.checked) {
      const { radius, height } = extentOfCutter(path.cutter);
      const step = 3 * Math.ceil(path.tips.length / 3 / mostToolsFitted);
      for (let k = 0; k < path.tips.length; k += step)
        for (const along of [0, height])
          for (const side of [-radius, radius]) {
            const at = [0, 1, 2].map((c) => path.tips[k + c] - origin[c] + along * (path.axes?.[k + c] ?? path.axis[c]));
            points.push(new Vector3(at[0] + side, at[1], at[2]), new Vector3(at[0], at[1] + side, at[2]));
          }
    }
    this.view.fit(points);
  }

  description() {
    const { part, path, deviation } = this.content;
    const things = [part && "the part", path && "the tool path", deviation && "the remaining stock"].filter(Boolean);
    return `3D view of ${things.join(", ")}. Drag or use arrow keys with Shift to turn, the wheel to zoom.`;
  }

  notes() {
    const notes = ["part", "path", "deviation", "plots"].map((key) => this.content[key]?.note).filter(Boolean);
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
    this.lines = new PathLines(path, this.content.origin_mm);
    this.add("path", "path", this.lines.node, bar);
    const ways = colourings(path);
    const names = ways.map(([name]) => [name, name]);
    const { node, select } = choice("path by", names, (name) => this.colour(name));
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
        this.fit();
      });
      this.onMachine = box;
      bar.append(element("label", {}, box, `as mounted on ${this.content.machine.word}`));
    }
    this.addSlider();
    this.addPlots();
  }

  addSlider() {
    const count = this.content.path.tips.length / 3;
    this.slider = element("input", {
      type: "range", min: 0, max: count - 1, value: 0, step: 1, id: "point", "aria-label": "point of the path",
    });
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
    const along = "path length, mm";
    if (plots) this.plots = plots.series.map(({ name, values }) => new Plot(name, values, plots.along_mm, along));
    else if (path.feeds) this.plots = [new Plot("feed, mm/min", path.feeds, path.length_mm, along)];
  }

  addDeviation(bar) {
    const { deviation } = this.content;
    this.add("deviation", "remaining stock", deviationPoints(deviation), bar);
    this.add("places", "worst places", marks(deviation.worst, deviation.mark_mm), bar);
    const places = deviation.worst.map(({ kind, text }) => swatch(placeColour[kind], text));
    const limits = signedScale(deviation.tolerance_mm, deviation.scallop_mm);
    this.node.append(element("div", { class: "legend" }, limits, ...places));
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
    const tip = at(path.tips, 3);
    const drawn = tip.map((x, c) => x - this.content.origin_mm[c]); // relative to the origin of the page
    const axis = at(path.axes, 3) ?? path.axis;
    const isOnMachine = Boolean(this.onMachine?.checked);
    Object.assign(this.state, { point, tip_mm: tip, axis, positions: at(path.positions, 5) });
    this.slider.value = point;
    this.world.matrixAutoUpdate = false;
    this.view.axes.name(isOnMachine ? ["X", "Y", "Z"] : ["x", "y", "z"]);
    if (isOnMachine) {
      const { part, tool } = machinePoses(machine, this.state.positions);
      this.world.matrix.copy(part);
      this.cutter?.position.setFromMatrixPosition(tool);
      this.cutter?.quaternion.setFromRotationMatrix(tool);
    } else {
      this.world.matrix.identity();
      if (this.cutter) place(this.cutter, drawn, axis);
    }
    this.world.matrixWorldNeedsUpdate = true;
    this.readout.textContent = this.words(isOnMachine);
    for (const plot of this.plots) plot.point(path.length_mm[point]);
    this.view.draw();
  }

  words(isOnMachine) {
    const { path, machine } = this.content;
    const { point, tip_mm: tip, axis, positions } = this.state;
    const lengths = (values) => values.map((x) => fixed(x, this.decimals));
    const parts = [`point ${path.numbers[point]}`, path.move_names[path.moves[point]], `pass ${path.passes[point]}`];
    parts.push(`tip ${lengths(tip).join(", ")} mm`);
    if (path.axes) parts.push(`axis ${axis.map((x) => fixed(x, 3)).join(", ")}`);
    if (path.feeds && Number.isFinite(path.feeds[point])) parts.push(`${shown(path.feeds[point])} mm/min`);
    if (path.limits) parts.push(`limit: ${path.limit_names[path.limits[point]] || "none"}`);
    if (isOnMachine) {
      const [x, y, z] = lengths(positions.slice(0, 3));
      const turns = machine.rotary.map(({ letter }, k) => `${letter.toUpperCase()} ${fixed(positions[3 + k], 3)}°`);
      parts.push([`X ${x} Y ${y} Z ${z} mm`, ...turns].join(" "));
    }
    return parts.join(" · ");
  }

  play(isPlaying) {
    this.state.isPlaying = isPlaying;
    this.player.textContent = isPlaying ? "pause" : "play";
    if (!isPlaying) return;
    const { length_mm: length } = this.content.path;
    const last = length.length - 1;
    if (this.state.point >= last) this.show(0);
    let at = length[this.state.point];
    let before = performance.now();
    const step = (now) => {
      if (!this.state.isPlaying) return;
      at += ((now - before) / 1000) * (length[last] / wholePathSeconds) * Number(this.speed.value);
      before = now;
      let point = this.state.point;
      while (point < last && length[point + 1] <= at) ++point;
      if (point !== this.state.point) this.show(point);
      if (point >= last) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}
