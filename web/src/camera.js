// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause

// Pose: x y z and the quaternion x y z w of world_from_cam.
function toWorld([tx, ty, tz, x, y, z, w], [px, py, pz]) {
  const cx = 2 * (y * pz - z * py), cy = 2 * (z * px - x * pz), cz = 2 * (x * py - y * px);
  return [tx + px + w * cx + y * cz - z * cy, ty + py + w * cy + z * cx - x * cz, tz + pz + w * cz + x * cy - y * cx];
}

// The pyramid that a camera sees through, as one line with gaps (null): size is its depth.
export function frustum(pose, size) {
  const corners = [[-0.6, -0.45, 1], [0.6, -0.45, 1], [0.6, 0.45, 1], [-0.6, 0.45, 1]].map((corner) => toWorld(pose, corner.map((value) => value * size)));
  const apex = pose.slice(0, 3), [a, b, c, d] = corners, gap = [null, null, null];
  return [a, b, c, d, a, apex, b, gap, c, apex, d, gap];
}
