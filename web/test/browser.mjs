// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// Pages in Debian's Chromium, watched: what it complains of and what it asks the network for.
import { accessSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const CHROMIUM = process.env.FRAMEWISE_CHROMIUM ?? '/usr/bin/chromium';

// Null, with the reason said, where scripts/install_chromium was not run.
export async function launchBrowser() {
  try {
    accessSync(CHROMIUM);
    const { chromium } = createRequire(join(root, 'build', 'web', 'package.json'))('playwright-core');
    return await chromium.launch({ executablePath: CHROMIUM, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
  } catch (error) {
    console.log(`SKIPPED: no browser to open pages in (scripts/install_chromium installs one): ${error.message.split('\n')[0]}`);
    return null;
  }
}

// Opens a file; `complaints` are console errors, exceptions and requests to anywhere but the page itself.
export async function openPage(browser, path, { width = 1280, height = 900, theme = 'light', javaScriptEnabled = true } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: theme, javaScriptEnabled, acceptDownloads: true });
  const page = await context.newPage();
  const complaints = [];
  const url = pathToFileURL(path).href;
  page.on('console', (message) => message.type() === 'error' && complaints.push(`console: ${message.text()}`));
  page.on('pageerror', (error) => complaints.push(`exception: ${error.message}`));
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && request.url() !== url) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(url);
  if (javaScriptEnabled) await page.waitForFunction(() => document.documentElement.dataset.ready, null, { timeout: 20000 });
  const seconds = javaScriptEnabled ? (await page.evaluate(() => +document.documentElement.dataset.ready)) / 1000 : 0;
  return { page, complaints, seconds, close: () => context.close() };
}
