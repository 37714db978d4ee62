// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause

// Lines and their ends of the matches that are inliers, or are not.
function paths(matches, wanted) {
  let lines = '', ends = '';
  for (let i = 0; i < matches.length; i += 5) {
    if (matches[i + 4] !== wanted) continue;
    const [x1, y1, x2, y2] = matches.slice(i, i + 4);
    lines += `M${x1} ${y1}L${x2} ${y2}`;
    ends += `M${x2} ${y2}h0`;
  }
  return { lines, ends };
}

// The image kept nearest to a frame, with where each feature came from. Returns show(frame).
export function matchViewer({ images, width, height }) {
  const figure = document.getElementById('match');
  const image = document.getElementById('match-image'), drawing = document.getElementById('match-lines'), text = document.getElementById('match-text');
  if (images.length === 0 || !(width > 0) || !(height > 0)) return () => {};
  figure.hidden = false;
  figure.firstElementChild.style.aspectRatio = `${width} / ${height}`;
  drawing.setAttribute('viewBox', `-0.5 -0.5 ${width} ${height}`);
  drawing.setAttribute('preserveAspectRatio', 'none');
  let shown = -1;
  return (frame) => {
    const nearest = images.reduce((best, one) => (Math.abs(one.index - frame.index) < Math.abs(best.index - frame.index) ? one : best));
    if (nearest.index !== shown) {
      shown = nearest.index;
      image.hidden = !nearest.source;
      if (nearest.source) image.src = nearest.source;
      figure.dataset.index = shown;
      drawing.innerHTML = [['outliers', 0], ['inliers', 1]].map(([name, wanted]) => {
        const { lines, ends } = paths(nearest.matches, wanted);
        return `<path class="${name} lines" d="${lines}"/><path class="${name} ends" d="${ends}"/>`;
      }).join('');
    }
    const inliers = nearest.matches.filter((value, i) => i % 5 === 4 && value === 1).length;
    const near = shown === frame.index ? '' : ` (kept nearest to frame ${frame.index})`;
    text.textContent = `Frame ${shown}${near}: each line leads from where a feature was to where it is; ${inliers} inliers in green, ${nearest.matches.length / 5 - inliers} outliers in red are drawn.`;
  };
}
