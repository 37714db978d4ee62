// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
import { followTheme } from './theme.js';
import { makeFilterable, makeSortable } from './table.js';
import { overlayTrajectories } from './overlay.js';

function offer(id, name, text, type) {
  document.getElementById(id).addEventListener('click', () => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  });
}

// Makes the page usable and returns what draws the scene.
export function startComparison(data) {
  const table = document.getElementById('rows');
  makeSortable(table);
  makeFilterable(table);
  offer('csv', 'comparison.csv', data.csv, 'text/csv');
  offer('latex', 'comparison.tex', data.latex, 'application/x-tex');
  const draw = overlayTrajectories(data);
  followTheme(draw);
  draw();
  return draw;
}
