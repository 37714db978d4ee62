// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "framewise/solvers/hypotheses.h"

namespace framewise {

// One real root of s^3 + c2 s^2 + c1 s + c0: the outermost, on the side that is sure to have one.
double outermost_cubic_root(double c2, double c1, double c0);

// The largest real root of s^3 + c2 s^2 + c1 s + c0.
double largest_cubic_root(double c2, double c1, double c0);

// The real roots of y^4 + c3 y^3 + c2 y^2 + c1 y + c0, by Ferrari's factors: good starts for a polish on what
// the quartic came from. A complex pair within rounding of the real axis counts as a double root.
Hypotheses<double, 4> quartic_roots(double c3, double c2, double c1, double c0);

}  // namespace framewise
