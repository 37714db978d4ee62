// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause

// The colour that a style sheet gives an ink, for what draws without style sheets.
export function inkColor(ink) {
  const probe = document.createElement('span');
  probe.className = `ink-${ink}`;
  document.body.append(probe);
  const color = getComputedStyle(probe).color;
  probe.remove();
  return color;
}

export function pageColor(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

// The button turns from what the system asks for to the other theme, and back.
export function followTheme(changed) {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const root = document.documentElement;
  document.getElementById('theme').addEventListener('click', () => {
    const isDark = root.dataset.theme ? root.dataset.theme === 'dark' : system.matches;
    root.dataset.theme = isDark ? 'light' : 'dark';
    changed();
  });
  system.addEventListener('change', changed);
}
