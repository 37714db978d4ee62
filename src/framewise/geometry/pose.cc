// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/geometry/pose.h"

#include "framewise/geometry/so3.h"

namespace framewise {

Pose interpolate(const Pose& a, const Pose& b, double s) {
  return {a.R * so3_exp(s * so3_log(a.R.transpose() * b.R)), (1.0 - s) * a.t + s * b.t};
}

}  // namespace framewise
