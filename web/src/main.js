// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
import { startComparison } from './comparison.js';
import { startRun } from './run.js';
import { drawsInSoftware, wantScenes } from './scene.js';

// The page is usable before its scene, which takes longer, is drawn; without a graphics card it waits to be asked.
const data = JSON.parse(document.getElementById('data').textContent);
const page = document.documentElement.dataset;
const button = document.getElementById('draw-scene');
const drawScenes = (data.kind === 'run' ? startRun : startComparison)(data);
page.ready = Math.round(performance.now());

async function drawNow() {
  button.hidden = true;
  wantScenes();
  page.scene = (await drawScenes()) ? 'drawn' : 'none';
}

addEventListener('load', () => setTimeout(() => {
  if (!button) {
    page.scene = 'none';
  } else if (drawsInSoftware()) {
    button.hidden = false;
    button.addEventListener('click', drawNow);
    page.scene = 'waiting';
  } else {
    drawNow();
  }
}, 50));
