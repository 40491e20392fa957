// SPDX-License-Identifier: GPL-3.0-or-later
// Prints, as JSON, the time to the first frame in s and the frames a second of a page that turns.
//
//   NODE_PATH=MODULES CHROMIUM=PROGRAM node frames.mjs PAGE SECONDS

import { createRequire } from "node:module";
import { join } from "node:path";

const { chromium } = createRequire(join(process.env.NODE_PATH, "x"))("playwright-core");
const [, , file, seconds] = process.argv;
const flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
const start = performance.now();
await page.goto(`file://${file}`);
while (!(await page.evaluate(() => window.endmill?.views.cut?.view.frames > 0))) await page.waitForTimeout(10);
const firstFrame = (performance.now() - start) / 1000;
const framesPerSecond = await page.evaluate(async (most) => {
  const { view } = window.endmill.views.cut;
  const context = view.renderer.getContext();
  const pixel = new Uint8Array(4);
  const begin = performance.now();
  let frames = 0;
  while (performance.now() - begin < 1000 * most) {
    view.camera.position.applyAxisAngle(view.camera.up, 0.02);
    view.camera.lookAt(view.controls.target);
    view.renderer.render(view.scene, view.camera);
    context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, pixel); // waits for the drawing
    ++frames;
    await new Promise((done) => setTimeout(done, 0));
  }
  return frames / ((performance.now() - begin) / 1000);
}, Number(seconds));
console.log(JSON.stringify({ first_frame_s: firstFrame, frames_per_s: framesPerSecond }));
await browser.close();
