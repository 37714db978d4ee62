// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
import { followTheme } from './theme.js';
import { markCurves, markMaps } from './marks.js';
import { matchViewer } from './matches.js';
import { drawRun } from './scene.js';

function describe({ index, time, status, matches, inliers, parallax }) {
  const known = (value, text) => (value === null ? '' : ` · ${text}`);
  return `frame ${index} · ${time ?? '?'} s · ${status}${known(inliers, `${inliers} of ${matches ?? '?'} inliers`)}${known(parallax, `parallax ${parallax} deg`)}`;
}

// The frame at a time, or the one nearest to it.
function nearestIndex(frames, time) {
  let best = 0;
  for (let i = 1; i < frames.length; ++i) if (Math.abs(frames[i].time - time) < Math.abs(frames[best].time - time)) best = i;
  return best;
}

function playOn(button, slider, go) {
  let timer = 0;
  button.addEventListener('click', () => {
    if (timer) {
      timer = clearInterval(timer) ?? 0;
    } else {
      const step = Math.max(1, Math.round((+slider.max + 1) / 300));
      timer = setInterval(() => go(+slider.value >= +slider.max ? 0 : Math.min(+slider.value + step, +slider.max)), 66);
    }
    button.textContent = timer ? '❚❚' : '▶';
  });
}

// Makes the page usable and returns what draws the scene.
export function startRun(data) {
  const { frames } = data;
  const slider = document.getElementById('frame');
  const shows = [];
  let asked = false;
  const draw = () => {
    asked = false;
    const frame = frames[+slider.value];
    document.getElementById('frame-text').textContent = describe(frame);
    for (const show of shows) show(frame);
  };
  const go = (index) => {
    slider.value = index;
    if (!asked) requestAnimationFrame(draw);
    asked = true;
  };
  const hasFrames = frames.length > 0;
  if (hasFrames) {
    document.querySelector('.slider').hidden = false;
    slider.max = frames.length - 1;
    shows.push(markCurves([...document.querySelectorAll('svg.plot[data-frames="1"]')], (time) => go(nearestIndex(frames, time))));
    shows.push(markMaps([...document.querySelectorAll('#maps svg')]));
    shows.push(matchViewer(data));
    slider.addEventListener('input', () => go(+slider.value));
    playOn(document.getElementById('play'), slider, go);
    slider.value = 1;  // the first frame has no matches
    draw();
  }
  const redraw = async () => {
    const show = hasFrames && (await drawRun(frames));
    shows.length = Math.min(shows.length, 3);  // of the curves, the maps and the matches
    if (!show) return false;
    shows.push(show);
    draw();
    return true;
  };
  followTheme(redraw);
  return redraw;
}
