// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// The surface on which a camera's measurement noise is the same in all directions and places. A
// correspondence is a pair of rays either way; this says how their errors are weighed.
enum class ImageSurface {
  kPlane,  // z = 1, a pinhole camera: (x / z, y / z), unit one focal length
  kSphere  // unit bearings, any camera: rad
};

}  // namespace framewise
