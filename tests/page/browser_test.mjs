// SPDX-License-Identifier: GPL-3.0-or-later
// The page in a real browser: ENDMILL is the program, CHROMIUM the browser.
//
// UPDATE_PICTURES=1 writes the kept pictures anew.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";

const { chromium } = createRequire(join(process.env.NODE_PATH, "x"))("playwright-core");
const root = fileURLToPath(new URL("../..", import.meta.url));
const kept = fileURLToPath(new URL("pictures/", import.meta.url));
const datasets = join(root, "datasets");
const flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];

let folder;
let browser;

// Exit code 1 is the answer no, such as of a part that the machine cannot reach everywhere.
function endmill(...words) {
  const { status, stderr } = spawnSync(process.env.ENDMILL, words, { cwd: folder, encoding: "utf8" });
  assert.ok(status === 0 || status === 1, stderr);
}

// Columns of a CSV file of numbers and words.
function table(file) {
  const [head, ...lines] = readFileSync(join(folder, file), "utf8").trim().split("\n").map((line) => line.split(","));
  return lines.map((cells) => Object.fromEntries(head.map((name, k) => [name, cells[k]])));
}

// Waits until a function of the page returns true. The security policy of the page forbids to do so in the page.
async function until(page, condition) {
  const start = Date.now();
  while (!(await page.evaluate(condition))) {
    assert.ok(Date.now() - start < 60000, `never: ${condition}`);
    await page.waitForTimeout(50);
  }
}

// Opens a page of the folder. Requests and messages of the console are faults.
async function open(name, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.faults = [];
  page.on("console", (message) => page.faults.push(message.text()));
  page.on("pageerror", (error) => page.faults.push(error.message));
  page.on("dialog", (dialog) => page.faults.push(`dialog ${dialog.message()}`));
  page.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) page.faults.push(`request ${request.url()}`);
  });
  await page.goto(`file://${join(folder, name)}`);
  await until(page, () => window.endmill?.isReady);
  return page;
}

// Programs of a path with turning axes, for a table and for a head whose axes do not meet.
function fiveAxes() {
  const bump = join(datasets, "surfaces/gaussian-bump.json");
  const options = ["--axis-mode", "lead", "--cutter", "ball:10", "--direction", "u", "--scallop", "1"];
  endmill("plan", bump, ...options, "--inner-tolerance", "0.2", "-o", "bump");
  for (const [name, of, changes, clamp] of [
    ["table", "ca-table-table", { axis_offset_mm: [0, 7, 11], table_offset_mm: [13, -4, -60] }, "5,6,7"],
    ["head", "cb-head-head", { axis_offset_mm: [30, 5, 12] }, "3,-2,400"],
    ["both", "ca-table-head", {}, "1,2,50"],
  ]) {
    const machine = JSON.parse(readFileSync(join(datasets, `machines/${of}.json`), "utf8"));
    writeFileSync(join(folder, `${name}.json`), JSON.stringify({ ...machine, ...changes, limits: {} }));
    const post = ["--machine", `${name}.json`, "--clamp", clamp, "--feed", "800", "--spindle-rpm", "6000"];
    endmill("post", "bump/toolpath.csv", ...post, "-o", name);
    endmill("view", name, "-o", `${name}.html`);
  }
}

const cut = (page, read) => page.evaluate(`(${read})(window.endmill.views.cut)`);

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "endmill-page-"));
  endmill("plan", join(datasets, "surfaces/saddle.json"), "--cutter", "ball:15", "--scallop", "0.5", "--strategy", "iso-u", "-o", "saddle");
  endmill("verify", "saddle/toolpath.csv", "--resolution", "1", "-o", "checked", "--html");
  endmill("view", "saddle", "checked", "-o", "saddle.html");
  endmill("trim", join(datasets, "surfaces/valley.json"), "--cutter", "ball:20", "--planes", "5", "-o", "trimmed");
  endmill("view", "trimmed", "-o", "trimmed.html");
  endmill("trim", join(datasets, "surfaces/valley.json"), "--cutter", "ball:20", "--planes", "5", "--method", "all", "-o", "methods", "--html");
  endmill("plan", join(datasets, "surfaces/saddle.json"), "--cutter", "ball:15", "--scallop", "0.5", "--direction", "both", "-o", "both-ways", "--html");
  const limited = ["--machine", join(datasets, "machines/ca-table-table.json"), "--sphere", "hex:4"];
  endmill("setup", join(datasets, "meshes/teapot-288.off"), ...limited, "-o", "limited", "--html");
  endmill("setup", join(datasets, "meshes/teapot-288.off"), "--machine", "W/caxyBz/T", "--sphere", "hex:4", "-o", "setup", "--html");
  fiveAxes();
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

describe("part and path", () => {
  test("the slider moves the tool to the points of the path", async () => {
    const page = await open("saddle.html");
    const rows = table("saddle/toolpath.csv");
    for (const share of [0, 0.3, 0.77, 1]) {
      const point = Math.round(share * (rows.length - 1));
      await page.locator("#point").evaluate((slider, value) => {
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
      }, point);
      const state = await cut(page, (view) => ({ ...view.state, number: view.content.path.numbers[view.state.point], drawn: view.cutter.position.toArray(), origin: view.content.origin_mm }));
      const row = rows[state.number];
      ["x", "y", "z"].forEach((axis, c) => {
        const expected = Number(row[`tip_${axis}_mm`]);
        assert.ok(Math.abs(state.tip_mm[c] - expected) < 1e-4);
        assert.ok(Math.abs(state.drawn[c] + state.origin[c] - expected) < 1e-4);
      });
      assert.match(await page.locator(".readout").textContent(), new RegExp(`point ${state.number} · ${row.move}`));
    }
    assert.deepEqual(page.faults, []);
  });

  test("play moves the tool forward, and pause stops it", async () => {
    const page = await open("saddle.html");
    await page.click("#play");
    await until(page, () => window.endmill.views.cut.state.point > 5);
    await page.click("#play");
    const at = await cut(page, (view) => view.state.point);
    await page.waitForTimeout(300);
    assert.equal(await cut(page, (view) => view.state.point), at);
  });

  test("colours and boxes change what is drawn", async () => {
    const page = await open("saddle.html");
    await page.selectOption("#colour", "pass");
    assert.match(await page.locator(".legend").nth(1).textContent(), /number of the pass: 0/);
    await page.uncheck("#show-part");
    assert.equal(await cut(page, (view) => view.parts.part.visible), false);
  });

  test("coordinates keep their digits in large and small parts, without -0", async () => {
    const rows = [[-1e6, -0.0001, 0], [999999.987, 2e-4, 1]];
    for (const scale of [1, 1e-9]) {
      const lines = rows.map((row, k) => `0,${k},cut,${row.map((x) => x * scale).join()}`);
      writeFileSync(join(folder, "p.csv"), ["pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm", ...lines].join("\n") + "\n");
      endmill("view", "p.csv", "--force", "-o", "p.html");
      const page = await open("p.html");
      const words = await page.locator(".readout").textContent();
      assert.match(words, scale === 1 ? /tip -1000000.000, 0.000, 0.000 mm/ : /tip -0.00100000, 0.00000000, 0.00000000 mm/);
      const [tip] = await cut(page, (view) => (view.show(1), [view.state.tip_mm]));
      assert.deepEqual(tip, rows[1].map((x) => x * scale));
    }
  });

  test("the scale bar has the length that it states", async () => {
    const page = await open("saddle.html");
    const { bar, words, pixels } = await cut(page, (view) => {
      view.view.drawNow();
      const { camera } = view.view;
      const end = (x) => view.cutter.position.clone().set(x, 0, 0).applyQuaternion(camera.quaternion).project(camera).x;
      return {
        bar: view.view.axes.bar.getBBox().width,
        words: view.view.axes.length.textContent,
        pixels: ((end(1) - end(0)) * view.view.node.clientWidth) / 2,
      };
    });
    assert.ok(Math.abs(bar - pixels * parseFloat(words)) < 0.5, `${words}: ${bar} pixels, 1 mm: ${pixels}`);
  });

  test("tool and part stay in sight, apart from axes and scale bar", async () => {
    for (const width of [1280, 375]) {
      const page = await open("saddle.html", { viewport: { width, height: 900 } });
      const seen = await cut(page, (view) => {
        const { camera, node } = view.view;
        const [wide, high] = [node.clientWidth, node.clientHeight];
        const box = { left: wide, right: 0, top: high, bottom: 0 };
        const add = (object) => {
          const points = object.geometry.getAttribute("position");
          object.updateWorldMatrix(true, false);
          for (let k = 0; k < points.count; ++k) {
            const at = object.position.clone().fromBufferAttribute(points, k).applyMatrix4(object.matrixWorld).project(camera);
            const [x, y] = [((at.x + 1) / 2) * wide, ((1 - at.y) / 2) * high];
            Object.assign(box, { left: Math.min(box.left, x), right: Math.max(box.right, x), top: Math.min(box.top, y), bottom: Math.max(box.bottom, y) });
          }
        };
        add(view.parts.part);
        for (let point = 0; point < view.content.path.numbers.length; ++point) {
          view.show(point);
          add(view.cutter);
        }
        const cross = view.view.axes.cross.getBBox();
        const moved = view.view.axes.cross.transform.baseVal[0].matrix;
        return { box, wide, high, crossTop: cross.y + moved.f, crossRight: cross.x + cross.width + moved.e };
      });
      const { box, wide, high, crossTop, crossRight } = seen;
      assert.ok(box.left >= 0 && box.right <= wide && box.top >= 0 && box.bottom <= high, JSON.stringify(seen));
      assert.ok(box.bottom <= crossTop || box.left >= crossRight, JSON.stringify(seen));
    }
  });

  test("of a plan in both directions the recommended one is shown", async () => {
    const page = await open("both-ways/page.html");
    const { recommended } = JSON.parse(readFileSync(join(folder, "both-ways/summary.json"), "utf8"));
    const rows = table(`both-ways/${recommended}/toolpath.csv`);
    const last = await cut(page, (view) => Array.from(view.content.path.tips.slice(-3)));
    assert.deepEqual(last, ["x", "y", "z"].map((axis) => Number(rows.at(-1)[`tip_${axis}_mm`])));
    await page.click("#tab-summary");
    const passes = JSON.parse(readFileSync(join(folder, "both-ways/u/summary.json"), "utf8")).passes;
    const folded = page.locator("details", { has: page.locator("summary", { hasText: /: u$/ }) });
    await folded.locator("summary").click();
    const shown = await folded.locator("tr").evaluateAll((lines) => lines.map((line) => [...line.cells].map((cell) => cell.innerText)));
    assert.deepEqual(shown.filter(([key]) => key === "passes"), [["passes", String(passes)]]);
  });

  test("the worst places stand where the summary says", async () => {
    const page = await open("saddle.html");
    const summary = JSON.parse(readFileSync(join(folder, "checked/summary.json"), "utf8"));
    const places = await cut(page, (view) => view.parts.places.children.map((ball) => ball.position.toArray().map((x, c) => x + view.content.origin_mm[c])));
    const named = [summary.max_gouge_at, summary.max_scallop_at].filter(Boolean);
    assert.equal(places.length, named.length);
    named.forEach(({ point_mm: expected }, k) =>
      expected.forEach((x, c) => assert.ok(Math.abs(x - places[k][c]) < 1e-3)));
  });
});

describe("on a machine", () => {
  for (const name of ["table", "head", "both"])
    test(`part and tool meet on the machine with axes in the ${name}`, async () => {
      const page = await open(`${name}.html`);
      await page.check("#on-machine");
      const { gap, tilt, turn, length } = await cut(page, (view) => {
        const { path, origin_mm: origin } = view.content;
        const worst = { gap: 0, tilt: 0, turn: 0, length: path.numbers.length };
        for (let point = 0; point < worst.length; point += 7) {
          view.show(point);
          // The tip and the axis of the path, carried by the part, against the tool, carried by the head.
          const tip = view.cutter.position.clone().set(...view.state.tip_mm.map((x, c) => x - origin[c]));
          const end = view.cutter.position.clone().set(...view.state.axis).add(tip);
          tip.applyMatrix4(view.world.matrix);
          end.applyMatrix4(view.world.matrix).sub(tip);
          const along = tip.clone().set(0, 0, 1).applyQuaternion(view.cutter.quaternion);
          worst.gap = Math.max(worst.gap, tip.distanceTo(view.cutter.position));
          worst.tilt = Math.max(worst.tilt, end.distanceTo(along));
          worst.turn = Math.max(worst.turn, ...view.state.positions.slice(3).map(Math.abs));
        }
        return worst;
      });
      assert.ok(length > 500 && turn > 20, "the path turns the axes");
      assert.ok(gap < 1e-6, `tips are ${gap} mm apart`);
      assert.ok(tilt < 1e-6, `axes are ${tilt} apart`);
      assert.deepEqual(page.faults, []);
    });

  test("the positions are those of the program", async () => {
    const page = await open("head.html");
    const words = readFileSync(join(folder, "head/toolpath.ngc"), "utf8").split("\n").map((line) =>
      Object.fromEntries([...line.replace(/\(.*?\)/g, "").matchAll(/([XYZBC])(-?[\d.]+)/g)].map(([, a, x]) => [a, Number(x)])));
    const programmed = new Set();
    const at = {};
    for (const line of words) {
      Object.assign(at, line);
      programmed.add(["X", "Y", "Z", "C", "B"].map((axis) => (at[axis] ?? 0).toFixed(3)).join());
    }
    const shown = await cut(page, ({ content: { path } }) =>
      Array.from(path.numbers, (_, k) => Array.from(path.positions.subarray(5 * k, 5 * k + 5), (x) => x.toFixed(3)).join()));
    const known = shown.filter((text) => programmed.has(text.replace(/-(0\.000)/g, "$1")) || programmed.has(text)).length;
    assert.ok(known > 0.95 * shown.length, `${known} of ${shown.length}`);
  });
});

test("sections follow the slider of planes", async () => {
  const page = await open("trimmed.html");
  await page.click("#tab-sections");
  const curves = (name) => new Set(table(name).filter((row) => row.plane === "3").map((row) => row.curve)).size;
  await page.locator("#plane").evaluate((slider) => {
    slider.value = 3;
    slider.dispatchEvent(new Event("input"));
  });
  const words = await page.locator(".readout").last().textContent();
  assert.match(words, new RegExp(`plane 3 \\(4 of 5\\), 70.000 mm across.*${curves("trimmed/sections.csv")} curves? before, ${curves("trimmed/trimmed.csv")} curves? after`));
  assert.equal(await page.locator("path.before").count(), curves("trimmed/sections.csv"));
  assert.deepEqual(page.faults, []);
});

test("sections can be chosen by the method of trimming, first in the plane that loses most", async () => {
  const page = await open("methods/page.html");
  await page.click("#tab-sections");
  const pointsOf = (file, plane) => table(file).filter((row) => row.plane === String(plane));
  const lengthOf = (rows) => rows.reduce((sum, row, k) => {
    const last = rows[k - 1];
    return last?.curve === row.curve ? sum + Math.hypot(row.s_mm - last.s_mm, row.z_mm - last.z_mm) : sum;
  }, 0);
  const lost = [0, 1, 2, 3, 4].map((plane) =>
    lengthOf(pointsOf("methods/sections.csv", plane)) - lengthOf(pointsOf("methods/1/trimmed.csv", plane)));
  const first = await page.evaluate(() => window.endmill.views.sections.state.plane);
  assert.ok(Math.abs(lost[first] - Math.max(...lost)) < 1e-3, `${lost}, not ${first}`);
  const names = await page.locator("#method option").allTextContents();
  assert.deepEqual(names, ["1", "2", "3", "3r", "envelope", "winding"]);
  for (const [k, name] of names.entries()) {
    await page.selectOption("#method", String(k));
    const drawn = await page.locator("path.after").evaluateAll((curves) =>
      curves.map((curve) => curve.getAttribute("d").split(/[ML]/).length - 1).reduce((a, b) => a + b, 0));
    assert.equal(drawn, pointsOf(`methods/${name}/trimmed.csv`, first).length, name);
  }
  assert.deepEqual(page.faults, []);
});

// The bits of visibility.bsm, as docs/file-formats.md describes them.
function visibility(file) {
  const bytes = readFileSync(join(folder, file));
  const facets = Number(bytes.readBigUInt64LE(16));
  const cells = Number(bytes.readBigUInt64LE(24));
  const names = bytes.readUInt32LE(48) + bytes.readUInt32LE(52);
  const dropped = bytes.readUInt32LE(56);
  const up8 = (count) => Math.ceil(count / 8) * 8;
  const start = 64 + up8(names) + up8(4 * dropped);
  const words = Math.ceil(facets / 64);
  const reaches = (facet, cell) => !((bytes[start + 8 * cell * words + (facet >> 3)] >> (facet & 7)) & 1);
  return { facets, cells, reaches };
}

describe("directions", () => {
  const numbers = (count) => Array.from({ length: count }, (_, k) => k);

  test("a click on a facet shows its cone, and one on a direction its facets", async () => {
    const page = await open("setup/page.html");
    await page.click("#tab-sphere");
    const { facets, cells, reaches } = visibility("setup/visibility.bsm");
    const [part, sphere] = await page.locator(".pair canvas:not(.printed)").all();
    const state = () => page.evaluate(() => ({ ...window.endmill.views.sphere.state }));
    await part.click();
    const { facet, cone } = await state();
    assert.notEqual(facet, null);
    assert.equal(cone, numbers(cells).filter((cell) => reaches(facet, cell)).length);
    await sphere.click();
    const { cell, facetsSeen } = await state();
    assert.notEqual(cell, null);
    assert.equal(facetsSeen, numbers(facets).filter((one) => reaches(one, cell)).length);
    await page.fill("#number-of-facet", "17");
    await page.press("#number-of-facet", "Enter");
    assert.equal((await state()).cone, numbers(cells).filter((one) => reaches(17, one)).length);
    assert.deepEqual(page.faults, []);
  });
});

test("directions beyond the reach of the machine are grey and unlit", async () => {
  const page = await open("limited/page.html");
  await page.click("#tab-sphere");
  const cells = await page.evaluate(() => {
    const { sphere, reachable } = window.endmill.views.sphere;
    const colours = sphere.geometry.getAttribute("color");
    const materialOf = (corner) => sphere.geometry.groups.find(({ start, count }) => start <= corner && corner < start + count).materialIndex;
    return Array.from(reachable, (isReachable, cell) => ({
      isReachable,
      isLit: sphere.material[materialOf(3 * cell)].type === "MeshLambertMaterial",
      isGrey: colours.getX(3 * cell) === colours.getY(3 * cell) && colours.getX(3 * cell) === colours.getZ(3 * cell),
    }));
  });
  const beyond = cells.filter(({ isReachable }) => !isReachable);
  assert.ok(beyond.length > 10 && beyond.length < cells.length);
  for (const { isReachable, isLit, isGrey } of cells) assert.deepEqual([isLit, isGrey], [isReachable === 1, isReachable === 0]);
  assert.match(await page.locator("main").textContent(), /beyond the rotary limits of the machine/);
  assert.deepEqual(page.faults, []);
});

describe("texts", () => {
  test("a hostile name stays text", async () => {
    const name = `<script>alert(1)</script>" onload="alert(2)'&amp;`;
    const part = JSON.parse(readFileSync(join(datasets, "surfaces/plane.json"), "utf8"));
    mkdirSync(join(folder, "hostile"));
    writeFileSync(join(folder, "hostile/part.json"), JSON.stringify({ ...part, name, source: name }));
    endmill("plan", "hostile/part.json", "--cutter", "ball:10", "--scallop", "1", "--strategy", "iso-u", "-o", "hostile/plan", "--html");
    const page = await open("hostile/plan/page.html");
    assert.equal(await page.locator("h1").textContent(), name);
    assert.equal(await page.title(), name);
    await page.click("#tab-summary");
    assert.equal(await page.locator("td", { hasText: "alert(1)" }).first().textContent(), name);
    assert.deepEqual(page.faults, []);
  });

  test("the summary shows every short value", async () => {
    const page = await open("saddle.html");
    await page.click("#tab-summary");
    const summary = JSON.parse(readFileSync(join(folder, "checked/summary.json"), "utf8"));
    assert.equal(await page.locator("tr", { has: page.locator(`th:text-is("verdict")`) }).last().locator("td").textContent(), summary.verdict);
    assert.match(await page.locator("main").textContent(), /SHA-256 [0-9a-f]{64}/);
  });
});

describe("every screen", () => {
  test("arrow keys choose the tab", async () => {
    const page = await open("saddle.html");
    await page.focus("#tab-cut");
    await page.keyboard.press("ArrowRight");
    assert.equal(await page.evaluate(() => window.endmill.tab), "summary");
    assert.equal(await page.locator("#tab-summary").getAttribute("aria-selected"), "true");
  });

  test("nothing is wider than a narrow screen", async () => {
    for (const name of ["saddle.html", "trimmed.html", "setup/page.html"]) {
      const page = await open(name, { viewport: { width: 375, height: 700 } });
      for (const tab of await page.locator("nav button").all()) {
        await tab.click();
        assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 375, name);
      }
    }
  });

  test("texts of sections and plots keep their size on a narrow screen", async () => {
    for (const [name, tab] of [["trimmed.html", "sections"], ["table.html", "cut"]]) {
      const page = await open(name, { viewport: { width: 375, height: 700 } });
      await page.click(`#tab-${tab}`);
      await page.waitForTimeout(300);
      const heights = await page.locator("svg.plot text").evaluateAll((texts) => texts.map((text) => text.getBoundingClientRect().height));
      assert.ok(heights.length > 3 && Math.min(...heights) >= 12, `${heights}`);
      await page.setViewportSize({ width: 800, height: 700 });
      await until(page, () => Math.abs(document.querySelector("section:not([hidden]) svg.plot").viewBox.baseVal.width - 770) < 12);
    }
  });

  test("print shows every tab", async () => {
    const page = await open("trimmed.html");
    await page.evaluate(() => { window.dispatchEvent(new Event("beforeprint")); });
    assert.deepEqual(await page.locator("main section").evaluateAll((views) => views.map((view) => view.hidden)), [false, false, false]);
    await page.evaluate(() => { window.dispatchEvent(new Event("afterprint")); });
    assert.equal(await page.locator("main section:not([hidden])").count(), 1);
    assert.equal(await page.evaluate(() => window.endmill.tab), "cut");
    assert.deepEqual(page.faults, []);
  });

  test("the printed page has its figures, light, whole and with texts of their size", async () => {
    for (const [name, tab, figures] of [["saddle.html", "cut", 1], ["setup/page.html", "sphere", 2], ["trimmed.html", "sections", 1]]) {
      const page = await open(name, { colorScheme: "dark" });
      await page.click(`#tab-${tab}`);
      // The pictures of the file: those of the 3D views have the size of a stage.
      const file = (await page.pdf()).toString("latin1");
      const images = [...file.matchAll(/\/Subtype \/Image\s+\/Width (\d+)\s+\/Height (\d+)/g)].map(([, ...size]) => size.map(Number));
      const stages = images.filter(([width, height]) => width > 300 && height > 410 && height < 425);
      assert.equal(stages.length, figures, `${name}: ${JSON.stringify(images)}`);
      // The same layout on the screen.
      await page.evaluate(() => { window.dispatchEvent(new Event("beforeprint")); });
      await page.emulateMedia({ media: "print" });
      const found = await page.evaluate(() => {
        const boxes = [...document.querySelectorAll(".stage, svg.plot, table, figure img")].map((node) => node.getBoundingClientRect());
        const [canvas] = document.querySelectorAll(".printed");
        const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
        const colours = new Set();
        for (let k = 0; k < data.length; k += 4) colours.add(data.slice(k, k + 3).join());
        return {
          widest: Math.max(...boxes.map(({ left, right }) => Math.max(right, 680 - left))),
          shapes: [...document.querySelectorAll(".printed")].map(({ width, height, clientWidth, clientHeight }) => [width, height, clientWidth, clientHeight]),
          corner: [...data.slice(0, 3)],
          colours: colours.size,
          rows: document.querySelectorAll("tr").length,
          texts: [...document.querySelectorAll("svg text")].map((text) => text.getBoundingClientRect().height).filter((height) => height > 0),
          controls: [...document.querySelectorAll("nav, .bar")].filter((node) => node.getBoundingClientRect().height > 0).length,
        };
      });
      assert.ok(found.widest <= 1280 / 2 + 680 / 2 + 1, `${name}: ${found.widest}`);
      for (const [width, height, shownWidth, shownHeight] of found.shapes)
        assert.ok(Math.abs(width - shownWidth) <= 1 && Math.abs(height - shownHeight) <= 1, `${name}: ${found.shapes}`);
      assert.deepEqual(found.corner, [255, 255, 255], "white though the screen is dark");
      assert.ok(found.colours > 50, `${found.colours} colours`);
      assert.ok(found.rows > 20 && found.controls === 0);
      assert.ok(Math.min(...found.texts) >= 12, `${found.texts}`);
      await page.emulateMedia({ media: null });
      await page.evaluate(() => { window.dispatchEvent(new Event("afterprint")); });
      assert.equal(await page.locator("main section:not([hidden])").count(), 1);
      assert.deepEqual(page.faults, []);
    }
  });

  test("pictures replace views where the browser has no WebGL", async () => {
    const without = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox", "--disable-3d-apis"] });
    const page = await without.newPage();
    await page.goto(`file://${join(folder, "saddle.html")}`);
    await until(page, () => window.endmill?.isReady);
    assert.match(await page.locator("main").textContent(), /no WebGL/);
    assert.ok(await page.locator("figure img").first().evaluate((image) => image.complete && image.naturalWidth > 0));
    await page.goto(`file://${join(folder, "table.html")}`);
    await until(page, () => window.endmill?.isReady);
    assert.match(await page.locator("main").textContent(), /no WebGL, and the results have no pictures/);
    await without.close();
  });

  // The share of points that differ clearly between two pictures of the page, within a box. The browser itself reads them.
  const difference = (page, first, second, box) => page.evaluate(async ([a, b, { x, y, width, height }]) => {
    const pixels = async (data) => {
      const image = new Image();
      image.src = `data:image/png;base64,${data}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      Object.assign(canvas, { width: image.width, height: image.height });
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      return context.getImageData(Math.round(x), Math.round(y), Math.round(width), Math.round(height)).data;
    };
    const [one, two] = [await pixels(a), await pixels(b)];
    let count = 0;
    for (let k = 0; k < one.length; k += 4)
      if (Math.max(...[0, 1, 2].map((c) => Math.abs(one[k + c] - two[k + c]))) > 48) ++count;
    return count / (one.length / 4);
  }, [first, second, box]);

  // Of the box of the drawing. Without the cutter 0.9 % differ, without the path 1.2 %, without the part 4 %.
  const mostOfDrawing = 0.004;
  // Of the whole page, whose letters may depend on the fonts of the machine.
  const mostOfPage = 0.02;

  for (const [name, tab] of [["saddle.html", "cut"], ["trimmed.html", "sections"], ["setup/page.html", "sphere"]])
    for (const width of [1280, 375])
      for (const colorScheme of ["light", "dark"])
        test(`${tab} at ${width} px, ${colorScheme}, looks as kept`, async () => {
          const page = await open(name, { viewport: { width, height: 900 }, colorScheme });
          await page.click(`#tab-${tab}`);
          await page.waitForTimeout(700);
          const picture = await page.screenshot();
          const file = join(kept, `${tab}-${width}-${colorScheme}.png`);
          if (process.env.UPDATE_PICTURES) writeFileSync(file, picture);
          assert.ok(existsSync(file), "no kept picture; UPDATE_PICTURES=1 writes it");
          const drawing = await page.locator(".view:not([hidden])").locator(".stage, svg.plot").first().boundingBox();
          const [now, then] = [picture.toString("base64"), readFileSync(file).toString("base64")];
          const share = await difference(page, now, then, drawing);
          assert.ok(share < mostOfDrawing, `${(100 * share).toFixed(1)} % of the drawing differ`);
          const whole = await difference(page, now, then, { x: 0, y: 0, width, height: 900 });
          assert.ok(whole < mostOfPage, `${(100 * whole).toFixed(1)} % of the page differ`);
        });
});
