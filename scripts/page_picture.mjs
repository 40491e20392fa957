// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a page of endmill view as a picture 1280 pixels wide, for scripts/write_pictures.py:
//
//   node scripts/page_picture.mjs PAGE PICTURE TAB [POINT [HIDDEN]]
//
// TAB is the view, such as cut. The tool stands at the share POINT of the path; the box HIDDEN, such as path, is
// unchecked. CHROMIUM is the browser; NODE_PATH leads to playwright-core.

import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const { chromium } = createRequire(join(process.env.NODE_PATH, "x"))("playwright-core");
const flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const mostMs = 60000;

const [file, picture, tab, point, hidden] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: flags });
const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, colorScheme: "light" });
const page = await context.newPage();
await page.goto(`file://${resolve(file)}`);
const start = Date.now();
while (!(await page.evaluate(() => window.endmill?.isReady)) && Date.now() - start < mostMs) await page.waitForTimeout(50);
await page.click(`#tab-${tab}`);
if (hidden) await page.uncheck(`#show-${hidden}`);
if (point)
  await page.locator("#point").evaluate((slider, share) => {
    slider.value = Math.round(share * slider.max);
    slider.dispatchEvent(new Event("input"));
  }, Number(point));
await page.waitForTimeout(1000); // until the last frame is drawn
await page.screenshot({ path: picture, fullPage: true });
await browser.close();
