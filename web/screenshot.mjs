// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// The picture of docs/report.md: node web/screenshot.mjs RUN/report.html docs/report.jpg (scripts/install_chromium first).
import { launchBrowser, openPage } from './test/browser.mjs';

const [path, picture] = process.argv.slice(2);
const browser = await launchBrowser();
if (!browser || !picture) process.exit(1);
const { page } = await openPage(browser, path, { width: 1100, height: 760 });
await page.waitForFunction(() => document.documentElement.dataset.scene);
if (await page.locator('#draw-scene').isVisible()) await page.click('#draw-scene');
await page.waitForFunction(() => document.documentElement.dataset.scene !== 'waiting', null, { timeout: 120000 });
await page.locator('#frame').evaluate((slider) => {
  slider.value = slider.max * 0.6;
  slider.dispatchEvent(new Event('input'));
});
await page.waitForTimeout(5000);
await page.screenshot({ path: picture, timeout: 120000 });
await browser.close();
