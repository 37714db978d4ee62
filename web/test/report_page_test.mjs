// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
// The report as a reader meets it. FRAMEWISE names the program; OUT, where screenshots are kept.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launchBrowser, openPage } from './browser.mjs';

const FRAMEWISE = process.env.FRAMEWISE;
const work = mkdtempSync(join(tmpdir(), 'report-'));
const shots = process.env.OUT ?? work;
const framewise = (...args) => execFileSync(FRAMEWISE, args, { stdio: 'pipe' });
const MB = 1e6;

const browser = await launchBrowser();
const skip = browser === null;

// A run of 30 frames, whose folder each test that changes it copies.
const run = join(work, 'run');
before(() => {
  if (skip) return;
  mkdirSync(shots, { recursive: true });
  framewise('simulate', 'room', '--out', join(work, 'room'), '--frames', '30', '--width', '320', '--height', '240', '--quiet');
  framewise('run', join(work, 'room'), '--out', run, '--quiet');
});
after(async () => {
  await browser?.close();
  rmSync(work, { recursive: true });
});

function changedRun(name, change) {
  const folder = join(work, name);
  cpSync(run, folder, { recursive: true });
  change(folder);
  framewise('report', folder, '--quiet');
  return join(folder, 'report.html');
}

const edit = (path, change) => writeFileSync(path, change(readFileSync(path, 'utf8')));

// How many colours a part of the page shows.
async function coloursOf(page, selector) {
  const png = (await page.locator(selector).screenshot()).toString('base64');
  return page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data: bytes } = context.getImageData(0, 0, image.width, image.height);
    const colours = new Set();
    for (let i = 0; i < bytes.length; i += 4) colours.add((bytes[i] << 16) | (bytes[i + 1] << 8) | bytes[i + 2]);
    return colours.size;
  }, png);
}

// Asks for the scene where it waits to be asked; drawn, or none in a program without plotly.
async function drawScene(page) {
  const stateIs = (states) => page.waitForFunction((wanted) => wanted.includes(document.documentElement.dataset.scene), states, { timeout: 120000 });
  await stateIs(['drawn', 'none', 'waiting']);
  if (await page.locator('#draw-scene').isVisible()) await page.click('#draw-scene');
  await stateIs(['drawn', 'none']);
  return page.evaluate(() => document.documentElement.dataset.scene);
}

async function setSlider(page, value) {
  await page.locator('#frame').evaluate((slider, to) => {
    slider.value = to;
    slider.dispatchEvent(new Event('input'));
  }, value);
  await page.waitForFunction((to) => document.getElementById('frame-text').textContent.startsWith(`frame ${to} `), value);
}

test('a run: the scene is drawn, the slider moves everything, nothing is asked of the network', { skip }, async () => {
  for (const [width, theme] of [[1280, 'light'], [1280, 'dark'], [390, 'light'], [390, 'dark']]) {
    const { page, complaints, close } = await openPage(browser, join(run, 'report.html'), { width, theme });
    const hasPlotly = await page.locator('#plotly').count();
    assert.equal(await drawScene(page), hasPlotly ? 'drawn' : 'none');
    if (hasPlotly) assert.ok((await coloursOf(page, '#space')) > 20, 'the scene is empty');
    const state = () => page.evaluate(() => [document.getElementById('match').dataset.index, document.getElementById('match-image').src,
      document.getElementById('match-lines').innerHTML, document.querySelector('svg .now').getAttribute('d'), document.querySelector('#maps .here').getAttribute('cx')]);
    await setSlider(page, 3);
    const early = await state();
    await setSlider(page, 25);
    const late = await state();
    early.forEach((value, i) => assert.notEqual(value, late[i]));
    assert.match(late[2], /inliers lines" d="M/);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, 'the page scrolls sideways');
    await page.screenshot({ path: join(shots, `run-${width}-${theme}.png`), fullPage: true });
    assert.deepEqual(complaints, []);
    await close();
  }
});

test('without JavaScript figures and tables are there', { skip }, async () => {
  const { page, close } = await openPage(browser, join(run, 'report.html'), { javaScriptEnabled: false });
  assert.ok((await page.locator('svg.plot path.line').count()) > 10);
  assert.match(await page.locator('#evaluation table').innerText(), /ATE \(m\)/);
  await close();
});

test('a click in a plot goes to the frame of that time', { skip }, async () => {
  const { page, close } = await openPage(browser, join(run, 'report.html'));
  const plot = page.locator('svg.plot[data-frames="1"]').nth(1);
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  await plot.click({ position: { x: box.width * 0.97, y: box.height / 2 } });
  await page.waitForFunction(() => document.getElementById('frame').value > 25);
  await close();
});

test('the button turns to the other theme and back', { skip }, async () => {
  const { page, close } = await openPage(browser, join(run, 'report.html'));
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const before = await paper();
  await page.click('#theme');
  assert.notEqual(await paper(), before);
  await page.click('#theme');
  assert.equal(await paper(), before);
  await close();
});

const LONG = 3000;

function writeLongRun(folder) {
  const pose = (i) => [0.01 * i, Math.sin(i / 50), Math.cos(i / 70), 0, 0, 0, 1];
  const lines = Array.from({ length: LONG }, (_, i) => i);
  const time = (i) => (i / 30).toFixed(6);
  writeFileSync(join(folder, 'trajectory.tum'), lines.map((i) => [time(i), ...pose(i)].join(' ')).join('\n'));
  writeFileSync(join(folder, 'report_data', 'truth.tum'), lines.map((i) => [time(i), ...pose(i * 1.01)].join(' ')).join('\n'));
  writeFileSync(join(folder, 'frames.csv'), ['index,time,status,matches,inliers,load_ms,features_ms,match_ms,step_ms,parallax_deg',
    ...lines.map((i) => [i, time(i), ['ok', 'low-parallax', 'lost'][i % 3], 500 + (i % 97), 300 + (i % 89), 5, 20 + (i % 7), 6, 1, 0.5].join())].join('\n'));
  edit(join(folder, 'report_data', 'frames.json'), (text) => {
    const kept = JSON.parse(text);
    const frame = kept.frames[10];
    kept.frames = Array.from({ length: 48 }, (_, k) => ({ ...frame, index: k * 60 }));
    return JSON.stringify(kept);
  });
}

test('3,000 frames make a page below 8 MB that is usable within 2 s', { skip }, async () => {
  const path = changedRun('long', writeLongRun);
  assert.ok(statSync(path).size < 8 * MB, `${statSync(path).size} bytes`);
  const { page, complaints, seconds, close } = await openPage(browser, path);
  console.log(`3,000 frames: ${(statSync(path).size / MB).toFixed(2)} MB, usable after ${seconds.toFixed(2)} s`);
  await setSlider(page, 0);
  assert.deepEqual(complaints, []);
  await close();
});

const BAD = {
  'no truth': [(folder) => rmSync(join(folder, 'report_data', 'truth.tum')), /truth/],
  'no pictures': [(folder) => rmSync(join(folder, 'report_data'), { recursive: true }), /truth was not kept/],
  'one frame': [(folder) => {
    for (const name of ['trajectory.tum', 'frames.csv']) edit(join(folder, name), (text) => `${text.split('\n').slice(0, 2).join('\n')}\n`);
  }, /one frame/],
  'no frame': [(folder) => edit(join(folder, 'frames.csv'), (text) => `${text.split('\n')[0]}\n`), null],
  'all lost': [(folder) => edit(join(folder, 'frames.csv'), (text) => text.replaceAll(',ok,', ',lost,')), /no measured motion/],
  'NaN in columns': [(folder) => edit(join(folder, 'frames.csv'), (text) => text.replace(/^(\d+),([\d.]+),ok,\d+,\d+/gm, '$1,$2,ok,nan,inf')), /no finite numbers/],
  'NaN in every time': [(folder) => edit(join(folder, 'frames.csv'), (text) => text.replace(/^(\d+),[\d.]+,/gm, '$1,nan,')), /time/],
  'NaN in the trajectory': [(folder) => edit(join(folder, 'trajectory.tum'), (text) => text.replace(/\n[\d.]+ \S+/, '\n0 nan')), /trajectory.tum/],
  'no columns but two': [(folder) => edit(join(folder, 'frames.csv'), (text) => text.split('\n').filter(Boolean).map((line) => line.split(',').slice(0, 2).join()).join('\n')), /no column status/],
  'no record': [(folder) => rmSync(join(folder, 'run.json')), /run.json/],
  'a record of other things': [(folder) => writeFileSync(join(folder, 'run.json'), '{"dataset": 3, "options": [1], "evaluation": "x", "frames_per_second": "fast"}'), null],
};

for (const [name, [change, says]] of Object.entries(BAD)) {
  test(`bad: ${name}: the page opens and says what is missing`, { skip }, async () => {
    const { page, complaints, close } = await openPage(browser, changedRun(`bad ${name}`, change));
    if (says) assert.match(await page.locator('.hints').innerText(), says);
    const slider = page.locator('#frame');
    if (await slider.isVisible()) await slider.press('ArrowRight');
    assert.deepEqual(complaints, []);
    await close();
  });
}

test('names that are code are text', { skip }, async () => {
  const name = `</script><script>window.broken = 1</script><img src=x onerror="window.broken=1">"'&<!--`;
  const path = changedRun('names', (folder) => {
    edit(join(folder, 'run.json'), (text) => {
      const record = JSON.parse(text);
      record.dataset.name = name;
      record.command = `framewise run '${name}'`;
      record.options.solver = name;
      return JSON.stringify(record);
    });
    edit(join(folder, 'frames.csv'), (text) => text.replace(/,ok,/g, `,"</script>""'><b onclick=x>",`));
  });
  const { page, complaints, close } = await openPage(browser, path);
  assert.equal(await page.locator('h1').innerText(), name);
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.deepEqual(complaints, []);
  await close();
});

test('figures are SVG and PNG, one of each', { skip }, () => {
  const figures = join(work, 'figures');
  framewise('report', run, '--figures', figures, '--quiet');
  for (const name of ['map-xy', 'error-step-translation', 'error-by-axis', 'error-cumulative', 'statuses']) {
    assert.match(readFileSync(join(figures, `${name}.svg`), 'utf8'), /^<svg [^]*<\/svg>\n$/);
    assert.equal(readFileSync(join(figures, `${name}.png`)).subarray(1, 4).toString(), 'PNG');
  }
});

test('--no-report leaves nothing of a report', { skip }, () => {
  framewise('run', join(work, 'room'), '--out', join(work, 'bare'), '--quiet');
  framewise('run', join(work, 'room'), '--out', join(work, 'bare'), '--quiet', '--no-report');
  assert.ok(!existsSync(join(work, 'bare', 'report.html')));
  assert.ok(!existsSync(join(work, 'bare', 'report_data')));
});

const GRID = `rows:
  - {name: Kabsch, solver: kabsch}
  - {name: "5-point", solver: nister-5pt, scale: truth}
  - {name: "</script>\\"'<b>", solver: eight-point, scale: none}
  - {name: never, solver: kabsch, min-inliers: 100000}
features:
  - {name: ORB, detector: orb, descriptor: orb, features: 300}
`;

test('a comparison: sorting, filtering, overlays, files', { skip }, async () => {
  writeFileSync(join(work, 'grid.yaml'), GRID);
  const out = join(work, 'compared');
  framewise('compare', join(work, 'room'), '--grid', join(work, 'grid.yaml'), '--repeats', '3', '--out', out, '--quiet', '--figures', join(work, 'compared-figures'));
  for (const [width, theme] of [[1280, 'light'], [390, 'dark']]) {
    const { page, complaints, close } = await openPage(browser, join(out, 'report.html'), { width, theme });
    await drawScene(page);
    const methods = () => page.locator('#rows tbody tr:visible td:nth-child(3)').allInnerTexts();
    const heading = page.locator('#rows th button', { hasText: 'RPE (mm)' });
    await heading.click();
    const ascending = await methods();
    assert.equal(ascending[0], 'Kabsch');
    assert.equal(ascending.at(-1), 'never', 'a failed row sorts last');
    await heading.click();
    const descending = await methods();
    assert.equal(descending.at(-1), 'never', 'a failed row sorts last');
    assert.equal(descending[2], 'Kabsch');
    await page.fill('#filter', '5-POINT');
    assert.deepEqual(await methods(), ['5-point']);
    await page.fill('#filter', '');
    assert.match(await page.locator('.hints').innerText(), /rows that failed in every repeat: never with ORB \(1 in all\)/);
    assert.match(await page.locator('tr.failed').innerText(), /failed/);

    const lines = () => page.locator('.maps svg:first-child g[data-key]:not(.off)').count();
    const drawnBefore = await lines();
    await page.locator('#rows tbody tr', { hasText: '5-point' }).locator('input').check();
    assert.equal(await lines(), drawnBefore + 3);

    for (const [id, words] of [['csv', 'dataset,'], ['latex', '\\begin{tabular}']]) {
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`#${id}`)]);
      assert.ok(readFileSync(await download.path(), 'utf8').includes(words));
    }
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, 'the page scrolls sideways');
    await page.screenshot({ path: join(shots, `comparison-${width}-${theme}.png`), fullPage: true });
    assert.deepEqual(complaints, []);
    await close();
  }
});

test('a comparison of 102 rows makes a page below 10 MB', { skip }, async () => {
  const folder = join(work, 'many');
  cpSync(join(work, 'compared'), folder, { recursive: true });
  edit(join(folder, 'results.json'), (text) => {
    const results = JSON.parse(text);
    results.rows = Array.from({ length: 102 }, (_, i) => ({ ...results.rows[i % 4], method: `method ${i}` }));
    return JSON.stringify(results);
  });
  for (const row of [0, 1, 2]) {
    const { folder: runs } = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8')).rows[row];
    writeFileSync(join(folder, runs, 'seed_0', 'trajectory.tum'),
      Array.from({ length: LONG }, (_, i) => `${i / 30} ${i / 100} ${Math.sin(i / 50)} ${Math.cos(i / 9)} 0 0 0 1`).join('\n'));
  }
  rmSync(join(folder, 'datasets'), { recursive: true });
  framewise('report', folder, '--quiet');
  const path = join(folder, 'report.html');
  assert.ok(statSync(path).size < 10 * MB, `${statSync(path).size} bytes`);
  const { complaints, seconds, close } = await openPage(browser, path);
  console.log(`102 rows: ${(statSync(path).size / MB).toFixed(2)} MB, usable after ${seconds.toFixed(2)} s`);
  assert.deepEqual(complaints, []);
  await close();
});
