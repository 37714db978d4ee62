// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace framewise {

// Polynomials in three unknowns a, b, c of degree up to 4: 35 monomials ordered by degree, the 20 up to
// degree 3 first; within a degree by falling powers of a, then b. A linear form (4), a quadratic (10) and a
// cubic (20) are the heads of this list.
struct Monomials {
  int index[5][5][5] = {};  // of a^i b^j c^k
  int power[35][3] = {};
  int product[10][10] = {};  // of two monomials up to degree 2
};

constexpr Monomials make_monomials() {
  Monomials m;
  int n = 0;
  for (int degree = 0; degree <= 4; ++degree)
    for (int i = degree; i >= 0; --i)
      for (int j = degree - i; j >= 0; --j, ++n) {
        m.index[i][j][degree - i - j] = n;
        m.power[n][0] = i, m.power[n][1] = j, m.power[n][2] = degree - i - j;
      }
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y)
      m.product[x][y] = m.index[m.power[x][0] + m.power[y][0]][m.power[x][1] + m.power[y][1]]
                               [m.power[x][2] + m.power[y][2]];
  return m;
}

inline constexpr Monomials kMonomials = make_monomials();

// A 4 x 6 matrix of linear forms in (1, a, b, c): form[row][column][coefficient].
struct LinearForms {
  double form[4][6][4];
};

// The 15 minors of size 4, each a quartic of 35 coefficients. They vanish together where the rank is below 4.
void quartic_minors(const LinearForms& matrix, double (&quartics)[15][35]);

}  // namespace framewise
