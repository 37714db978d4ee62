// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
import { frustum } from './camera.js';
import { inkColor, pageColor } from './theme.js';

// A trace of plotly from points [x, y, z]; null coordinates are gaps.
function trace(name, color, points, width) {
  const [x, y, z] = [0, 1, 2].map((axis) => points.map((point) => point[axis]));
  return { type: 'scatter3d', mode: 'lines', name, x, y, z, line: { color, width }, hoverinfo: name ? 'name' : 'skip', connectgaps: false };
}

function layout() {
  const axis = (title) => ({ title: { text: `${title} (m)` }, color: pageColor('muted'), gridcolor: pageColor('grid'), zerolinecolor: pageColor('grid') });
  return {
    margin: { l: 0, r: 0, t: 0, b: 0 }, showlegend: false, uirevision: 'kept', paper_bgcolor: pageColor('paper'),
    scene: { aspectmode: 'data', xaxis: axis('x'), yaxis: axis('y'), zaxis: axis('z') },
  };
}

// plotly stands in the page as text, so that its 2 MB delay nothing: it is run when a scene is first drawn.
function loadPlotly() {
  const text = document.getElementById('plotly');
  if (window.Plotly || !text) return;
  const script = document.createElement('script');
  script.textContent = text.textContent;
  document.head.append(script);
}

// Whether WebGL is drawn by the processor: then a scene takes seconds in which the page stands still.
export function drawsInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const renderer = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(renderer);
}

let isWanted = false;

export function wantScenes() {
  isWanted = true;
}

// Draws traces {name, ink or color, points, width} into #space; false where the page or the browser cannot.
export async function drawScene(traces) {
  const place = document.getElementById('space');
  if (!isWanted || !place) return false;
  loadPlotly();
  if (!window.Plotly || !traces.some((one) => one.points.length > 0)) return false;
  place.hidden = false;
  try {
    await window.Plotly.react(place, traces.map(({ name, ink, color, points, width }) => trace(name, color ?? inkColor(ink), points, width)), layout(), { displaylogo: false, responsive: true });
    return true;
  } catch (error) {
    place.hidden = true;  // no WebGL: the maps show the same
    return false;
  }
}

export function moveTrace(index, points) {
  const [x, y, z] = [0, 1, 2].map((axis) => points.map((point) => point[axis]));
  window.Plotly.restyle(document.getElementById('space'), { x: [x], y: [y], z: [z] }, [index]);
}

const points = (frames, what) => frames.map((frame) => frame[what] ?? [null, null, null]);

// About so many frusta stand along the path.
const STANDING = 24;

function extent(frames) {
  const known = frames.flatMap((frame) => [frame.estimate, frame.truth]).filter(Boolean);
  const size = (axis) => known.reduce(([low, high], pose) => [Math.min(low, pose[axis]), Math.max(high, pose[axis])], [Infinity, -Infinity]);
  return Math.max(...[0, 1, 2].map(size).map(([low, high]) => high - low), 1e-3);
}

function differences(frames) {
  const both = frames.filter((frame) => frame.truth && frame.estimate);
  const every = Math.ceil(both.length / 200);
  return both.filter((_, i) => i % every === 0).flatMap((frame) => [frame.truth.slice(0, 3), frame.estimate.slice(0, 3), [null, null, null]]);
}

// The scene of a run; returns show(frame), which moves the thick frustum, or null where nothing was drawn.
export async function drawRun(frames) {
  const hasTruth = frames.some((frame) => frame.truth && frame.estimate);
  const posed = frames.filter((frame) => frame.estimate);
  const size = 0.04 * extent(frames);
  const every = Math.max(1, Math.ceil(posed.length / STANDING));
  const standing = posed.filter((_, i) => i % every === 0).flatMap((frame) => frustum(frame.estimate, size));
  const drawn = await drawScene([
    { name: 'difference', ink: 'difference', points: hasTruth ? differences(frames) : [], width: 2 },
    { name: 'truth', ink: 'truth', points: hasTruth ? points(frames, 'truth') : [], width: 5 },
    { name: 'estimate', ink: 'estimate', points: points(frames, 'estimate'), width: 5 },
    { name: 'cameras', ink: 'other', points: standing, width: 1.5 },
    { name: 'this frame', ink: 'final', points: posed.length > 0 ? frustum(posed[0].estimate, 2.5 * size) : [], width: 6 },
  ]);
  if (!drawn) return null;
  return (frame) => {
    if (frame.estimate) moveTrace(4, frustum(frame.estimate, 2.5 * size));
  };
}
