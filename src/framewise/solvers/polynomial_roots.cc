// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/polynomial_roots.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace framewise {
namespace {

// To about 4 %: a third of the exponent (and mantissa) read as an integer. A start for an iteration.
double rough_cube_root(double x) {
  if (x == 0) return 0;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2A9F789300000000u);
}

// s^3 + c2 s^2 + c1 s + c0 around its inflection: u^3 - 3 e^2 u + value, u = s - inflection, extrema at u =
// -e and e.
struct Cubic {
  double c2, c1, c0, inflection, value, e;

  Cubic(double c2, double c1, double c0) : c2(c2), c1(c1), c0(c0), inflection(-c2 / 3) {
    value = c0 + inflection * (c1 + inflection * (c2 + inflection));
    const double d = c2 * c2 - 3 * c1;
    e = d > 0 ? std::sqrt(d) / 3 : 0;
  }

  // A little beyond the outermost root on the side that has one for sure; there the cubic bends away from its
  // axis.
  double reach() const {
    // u = e w with w^3 - 3 w = value / e^3: between 0 and 4, where w is sqrt(3) to 2.2, a parabola is close.
    const double ratio = std::abs(value) / (e * e * e);
    return ratio < 4 ? e * (1.7320508 + ratio * (0.16667 - 0.0163 * ratio))
                     : rough_cube_root(std::abs(value)) + e;
  }

  // Halley's method: with three digits right the next step makes nine of them.
  double descend(double s) const {
    for (int i = 0; i < 50; ++i) {
      const double f = c0 + s * (c1 + s * (c2 + s)), slope = c1 + s * (2 * c2 + 3 * s),
                   half_bend = c2 + 3 * s;
      const double step = f * slope / (slope * slope - f * half_bend);
      if (!std::isfinite(step)) break;
      s -= step;
      if (!(std::abs(step) > 1e-5 * std::abs(s))) break;
    }
    return s;
  }
};

// Roots of y^2 + b y + c, less shift.
void add_quadratic_roots(double b, double c, double shift, Hypotheses<double, 4>& roots) {
  const double half = 0.5 * b, discriminant = half * half - c;
  if (!(discriminant > -1e-9 * (half * half + std::abs(c)))) return;
  const double far = -half - std::copysign(std::sqrt(std::max(discriminant, 0.0)), half);
  roots.push_back(far - shift);
  roots.push_back((far == 0 ? 0 : c / far) - shift);
}

}  // namespace

double outermost_cubic_root(double c2, double c1, double c0) {
  const Cubic f(c2, c1, c0);
  return f.descend(f.value > 0 ? f.inflection - f.reach() : f.inflection + f.reach());
}

double largest_cubic_root(double c2, double c1, double c0) {
  const Cubic f(c2, c1, c0);
  if (f.value <= 0) return f.descend(f.inflection + f.reach());
  // Two roots on the right, from e to sqrt(3) e, when the minimum at e is below zero (or a double root, but
  // for rounding).
  if (f.value < (2 + 1e-10) * f.e * f.e * f.e) return f.descend(f.inflection + 1.7320508 * f.e);
  return f.descend(f.inflection - f.reach());
}

Hypotheses<double, 4> quartic_roots(double c3, double c2, double c1, double c0) {
  Hypotheses<double, 4> roots;
  // y = x - shift: x^4 + p x^2 + q x + r
  const double shift = c3 / 4, shift2 = shift * shift;
  const double p = c2 - 6 * shift2, q = c1 - 2 * c2 * shift + 8 * shift2 * shift;
  const double r = c0 - c1 * shift + c2 * shift2 - 3 * shift2 * shift2;
  // (x^2 + s x + m)(x^2 - s x + n) with s^2 = z, a positive root of the resolvent
  const double z = largest_cubic_root(2 * p, p * p - 4 * r, -q * q);
  if (!(z > 1e-14 * (std::abs(p) + std::sqrt(std::abs(r))))) {
    // x^4 + p x^2 + r
    const double discriminant = 0.25 * p * p - r;
    if (!(discriminant >= 0)) return roots;
    const double root = std::sqrt(discriminant);
    for (const double x2 : {-0.5 * p + root, -0.5 * p - root})
      if (x2 >= 0) roots.push_back(std::sqrt(x2) - shift), roots.push_back(-std::sqrt(x2) - shift);
    return roots;
  }
  const double s = std::sqrt(z), sum = 0.5 * (p + z), difference = 0.5 * q / s;
  add_quadratic_roots(s, sum - difference, shift, roots);
  add_quadratic_roots(-s, sum + difference, shift, roots);
  return roots;
}

}  // namespace framewise
