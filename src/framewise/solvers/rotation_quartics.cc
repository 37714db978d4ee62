// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/solvers/rotation_quartics.h"

#include <cstddef>
#include <utility>

namespace framewise {
namespace {

struct Quadratic {
  double c[10];
};

// sum += sign * u v
template <std::size_t... I>
void add_product_unrolled(const Quadratic& u, const Quadratic& v, double sign, double* sum,
                          std::index_sequence<I...>) {
  const double s[10] = {sign * u.c[0], sign * u.c[1], sign * u.c[2], sign * u.c[3], sign * u.c[4],
                        sign * u.c[5], sign * u.c[6], sign * u.c[7], sign * u.c[8], sign * u.c[9]};
  ((sum[kMonomials.product[I / 10][I % 10]] += s[I / 10] * v.c[I % 10]), ...);
}
void add_product(const Quadratic& u, const Quadratic& v, double sign, double* sum) {
  add_product_unrolled(u, v, sign, sum, std::make_index_sequence<100>());
}

// u0 v1 - u1 v0 of linear forms
Quadratic determinant(const double* u0, const double* v0, const double* u1, const double* v1) {
  Quadratic q = {};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) q.c[kMonomials.product[i][j]] += u0[i] * v1[j] - u1[i] * v0[j];
  return q;
}

}  // namespace

void quartic_minors(const LinearForms& matrix, double (&quartics)[15][35]) {
  const auto& f = matrix.form;
  // Laplace: minors of rows 0, 1 times those of rows 2, 3.
  Quadratic upper[6][6], lower[6][6];
  for (int i = 0; i < 6; ++i)
    for (int j = i + 1; j < 6; ++j) {
      upper[i][j] = determinant(f[0][i], f[0][j], f[1][i], f[1][j]);
      lower[i][j] = determinant(f[2][i], f[2][j], f[3][i], f[3][j]);
    }
  int n = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = i + 1; j < 6; ++j)
      for (int k = j + 1; k < 6; ++k)
        for (int l = k + 1; l < 6; ++l, ++n) {
          double sum[35] = {};
          add_product(upper[i][j], lower[k][l], 1, sum);
          add_product(upper[i][k], lower[j][l], -1, sum);
          add_product(upper[i][l], lower[j][k], 1, sum);
          add_product(upper[j][k], lower[i][l], 1, sum);
          add_product(upper[j][l], lower[i][k], -1, sum);
          add_product(upper[k][l], lower[i][j], 1, sum);
          for (int m = 0; m < 35; ++m) quartics[n][m] = sum[m];
        }
}

}  // namespace framewise
