// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <type_traits>

#include "framewise/geometry/correspondences.h"
#include "framewise/io/hdf5_file.h"

// What the writer and the reader of an archive must agree on; correspondence_archive.h tells the whole.
namespace framewise::archive_layout {

inline constexpr const char* kFormat = "framewise correspondences";
inline constexpr const char* kFormatVersion = "1";

// Visits the name and the vector of each table of /matches.
template <typename Shared, typename Visit>
void each_column(Shared& shared, Visit&& visit) {
  visit("pixels1", shared.pixels1);
  visit("pixels2", shared.pixels2);
  visit("x1", shared.x1);
  visit("x2", shared.x2);
  visit("z1", shared.z1);
  visit("z2", shared.z2);
  visit("sigma1", shared.sigma1);
  visit("sigma2", shared.sigma2);
  visit("distance", shared.distance);
}
using MatchTables = std::array<hdf5::Table, 9>;

// make: hdf5::Table::create or open.
template <typename Make>
MatchTables make_match_tables(const hdf5::Handle& group, Make make) {
  MatchTables tables;
  const Correspondences rows;
  each_column(rows, [&, i = 0](const char* name, const auto& column) mutable {
    using Row = typename std::decay_t<decltype(column)>::value_type;
    constexpr bool is_float = std::is_same_v<Row, float>;
    tables[i++] = make(group, name, is_float ? hdf5::Number::kFloat : hdf5::Number::kDouble,
                       is_float ? 1 : sizeof(Row) / sizeof(double));
  });
  return tables;
}

// Rows of the 3 x 4 matrix [R t].
using PoseRow = std::array<double, 12>;

}  // namespace framewise::archive_layout
