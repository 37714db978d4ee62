// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace framewise {

// Options of `framewise run` by their names, without dashes, in the order written.
using OptionList = std::vector<std::pair<std::string, std::string>>;

// A name and its options: a method, or features.
struct GridEntry {
  std::string name;
  OptionList options;
  std::size_t line = 0;  // it begins here, from 1
};

// What `framewise compare` runs: every method with every features.
struct Grid {
  std::filesystem::path source;  // the file, or the name of what was built in
  std::vector<GridEntry> methods;
  std::vector<GridEntry> features;
};

// A grid in YAML:
//   axes:                                    # optional: the product of these, the first varies slowest
//     scale: {C: centroid, S: first-pair}    # several values, each with its part of the method's name
//     solver: [eigensolver, nister-5pt]      # or each its own part
//     ransac: two-stage                      # or one value, no part
//   rows:                                    # optional: methods one by one, after those of the axes
//     - {name: Kabsch, solver: kabsch}       # an option may have several values here too
//   exclude:                                 # optional: methods that have all of these values are left out
//     - {scale: centroid, solver: nister-5pt}
//   features:                                # optional: options besides; none: those of `run`
//     - {name: ORB, detector: orb, descriptor: orb}
// A method's name is the row's name and the parts of its values, those that are not empty, joined by dots;
// where there is neither, its values. Throws InputError naming the line, what was found and expected: for
// keys that are not these, values that are no plain values, names that come twice, and a grid without
// methods. Whether the options are options of `run` is the program's to say.
Grid read_grid_file(const std::filesystem::path& path);
Grid parse_grid(std::string_view text, const std::filesystem::path& source);

}  // namespace framewise
