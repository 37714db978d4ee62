// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause

const SVG = 'http://www.w3.org/2000/svg';

function add(plot, name, classes) {
  const element = document.createElementNS(SVG, name);
  element.setAttribute('class', classes);
  element.style.display = 'none';
  plot.append(element);
  return element;
}

// Where on the paper a plot shows a value of its x.
function acrossAt(plot, value) {
  const { low, high, left, length } = plot.dataset;
  return +left + ((value - low) / (high - low)) * length;
}

function upAt(plot, value) {
  const { yLow, yHigh, top, bottom } = plot.dataset;
  return +bottom + ((value - yLow) / (yHigh - yLow)) * (top - bottom);
}

// A line across every plot over time; a click or drag in one asks for the frame at that time. Returns
// show(frame).
export function markCurves(plots, ask) {
  const lines = plots.map((plot) => {
    plot.addEventListener('pointermove', (event) => event.buttons && askAt(event));
    plot.addEventListener('pointerdown', (event) => askAt(event));
    const askAt = (event) => {
      const box = plot.getBoundingClientRect();
      const x = ((event.clientX - box.left) / box.width) * plot.viewBox.baseVal.width;
      ask(+plot.dataset.low + ((x - plot.dataset.left) / plot.dataset.length) * (plot.dataset.high - plot.dataset.low));
    };
    return add(plot, 'path', 'now');
  });
  return (frame) => plots.forEach((plot, i) => {
    lines[i].setAttribute('d', `M${acrossAt(plot, frame.time).toFixed(1)} ${plot.dataset.top}V${plot.dataset.bottom}`);
    lines[i].style.display = frame.time === null ? 'none' : '';
  });
}

// A dot where the camera is, in each of the three maps.
export function markMaps(plots) {
  const axes = [[0, 1], [0, 2], [1, 2]];
  const dots = plots.map((plot) => add(plot, 'circle', 'here'));
  return (frame) => plots.forEach((plot, i) => {
    dots[i].style.display = frame.estimate ? '' : 'none';
    if (!frame.estimate) return;
    dots[i].setAttribute('r', 5);
    dots[i].setAttribute('cx', acrossAt(plot, frame.estimate[axes[i][0]]));
    dots[i].setAttribute('cy', upAt(plot, frame.estimate[axes[i][1]]));
  });
}
