// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
import { inkColor } from './theme.js';
import { drawScene } from './scene.js';

const PALETTE = ['#1f77b4', '#e07b00', '#7b4fc4', '#8a6d00', '#d1478f', '#13908c', '#8c564b', '#5a7d00', '#4a63d8', '#a02c5a'];

// The rows that are ticked, drawn over the truth of the data set that is chosen. Returns draw().
export function overlayTrajectories({ datasets, rows }) {
  const choice = document.getElementById('scene-dataset'), legend = document.getElementById('drawn');
  const boxes = [...document.querySelectorAll('#rows input[data-row]')];
  const maps = [...document.querySelectorAll('.maps')];
  choice.replaceChildren(...datasets.map(({ name }, i) => new Option(name, i)));
  choice.parentElement.hidden = datasets.length < 2;

  const drawMaps = (shown) => maps.forEach((map, i) => {
    map.hidden = i !== +choice.value;
    for (const group of map.querySelectorAll('[data-key]')) {
      const found = shown.find(({ index }) => String(index) === group.dataset.key);
      group.classList.toggle('off', !found);
      group.style.color = found?.color ?? '';
    }
  });
  const drawLegend = (shown) => {
    legend.replaceChildren(...[{ label: 'truth', color: inkColor('truth') }, ...shown].map(({ label, color }) => {
      const item = document.createElement('span');
      item.textContent = label;
      item.style.color = color;
      return item;
    }));
  };
  const draw = async () => {
    const dataset = datasets[+choice.value];
    if (!dataset) return false;
    const shown = boxes.filter((box) => box.checked).map((box) => +box.dataset.row).sort((a, b) => a - b)
      .filter((index) => rows[index].dataset === dataset.name && rows[index].points.length > 0)
      .map((index, i) => ({ index, label: rows[index].label, color: PALETTE[i % PALETTE.length] }));
    drawMaps(shown);
    drawLegend(shown);
    return drawScene([
      { name: 'truth', ink: 'truth', points: dataset.truth, width: 5 },
      ...shown.map(({ index, label, color }) => ({ name: label, color, points: rows[index].points, width: 4 })),
    ]);
  };
  choice.addEventListener('input', draw);
  for (const box of boxes) box.addEventListener('input', draw);
  return draw;
}
