// SPDX-License-Identifier: GPL-3.0-or-later
// The page: one tab for each view that its content allows. `window.endmill` is the state, for tests.

import { readContent } from "./content.js";
import { CutView } from "./cut.js";
import { button, element, measureAll } from "./elements.js";
import { hasWebGL } from "./scene.js";
import { SectionsView } from "./sections.js";
import { SphereView } from "./sphere.js";
import { pictureOf, SummaryView } from "./summary.js";

// Pictures in place of a 3D view where the browser has no WebGL.
class Pictures {
  constructor(pictures) {
    const words = pictures.length > 0
      ? "This browser has no WebGL; these pictures replace the 3D view."
      : "This browser has no WebGL, and the results have no pictures that could replace the 3D view.";
    const note = element("p", { class: "note" }, words);
    this.node = element("section", { class: "view" }, note, ...pictures.map(pictureOf));
  }
}

function viewsOf(content) {
  const views = [];
  const is3d = hasWebGL();
  const title = content.path ? "part and path" : "part";
  if (content.path || content.deviation || (content.part && !content.sphere))
    views.push(["cut", title, () => (is3d ? new CutView(content) : new Pictures(content.pictures))]);
  if (content.sections) views.push(["sections", "sections", () => new SectionsView(content.sections)]);
  if (content.sphere)
    views.push(["sphere", "directions", () => (is3d ? new SphereView(content.sphere) : new Pictures(content.pictures))]);
  views.push(["summary", "summary", () => new SummaryView(content)]);
  return views;
}

function start() {
  const content = readContent();
  const tabs = document.getElementById("tabs");
  const stage = document.getElementById("views");
  const views = viewsOf(content);
  const made = new Map();
  const state = { tab: null, views: {}, isReady: false };
  window.endmill = state;

  const choose = (chosen) => {
    const [name, , make] = views.find(([known]) => known === chosen);
    state.tab = name;
    for (const tab of tabs.children) {
      const isChosen = tab.dataset.view === name;
      tab.setAttribute("aria-selected", isChosen);
      tab.tabIndex = isChosen ? 0 : -1;
    }
    for (const [other, view] of made) view.node.hidden = other !== name;
    if (!made.has(name)) add(name, make());
  };

  const add = (name, view) => {
    view.node.setAttribute("role", "tabpanel");
    view.node.setAttribute("aria-labelledby", `tab-${name}`);
    made.set(name, view);
    state.views[name] = view;
    stage.append(view.node);
  };

  for (const [name, title] of views)
    tabs.append(button(title, () => choose(name), { role: "tab", id: `tab-${name}`, "data-view": name }));
  tabs.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const next = (views.findIndex(([name]) => name === state.tab) + step + views.length) % views.length;
    choose(views[next][0]);
    tabs.children[next].focus();
  });
  // In print all tabs follow each other, in light colours and with the width of a sheet.
  const drawAll = () => {
    measureAll();
    for (const view of made.values()) for (const stage of view.stages ?? []) stage.redraw();
  };
  window.addEventListener("beforeprint", () => {
    const shownTab = state.tab;
    for (const [name] of views) if (!made.has(name)) choose(name);
    choose(shownTab);
    document.documentElement.classList.add("printing");
    for (const view of made.values()) view.node.hidden = false;
    drawAll();
    for (const view of made.values()) for (const stage of view.stages ?? []) stage.keepPicture();
  });
  window.addEventListener("afterprint", () => {
    document.documentElement.classList.remove("printing");
    choose(state.tab);
    drawAll();
  });
  choose(views[0][0]);
  state.isReady = true;
}

start();
