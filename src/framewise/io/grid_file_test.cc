// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/grid_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "framewise/io/input_error.h"

namespace framewise {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

std::vector<std::string> names(const std::vector<GridEntry>& entries) {
  std::vector<std::string> names;
  for (const GridEntry& entry : entries) names.push_back(entry.name);
  return names;
}

TEST(GridFile, AxesAreAProductWhoseFirstVariesSlowest) {
  const Grid grid = parse_grid(R"(
axes:
  scale: {C: centroid, S: first-pair}
  solver: [eigensolver, nister-5pt]
  ransac: two-stage
)",
                               "g.yaml");
  EXPECT_THAT(names(grid.methods),
              ElementsAre("C.eigensolver", "C.nister-5pt", "S.eigensolver", "S.nister-5pt"));
  EXPECT_THAT(grid.methods[2].options, ElementsAre(Pair("scale", "first-pair"), Pair("solver", "eigensolver"),
                                                   Pair("ransac", "two-stage")));
  EXPECT_THAT(names(grid.features), ElementsAre("default"));
  EXPECT_TRUE(grid.features[0].options.empty());
}

TEST(GridFile, RowsFollowTheAxesAndMayBeProductsThemselves) {
  const Grid grid = parse_grid(R"(
axes: {solver: [eigensolver]}
rows:
  - {name: Kabsch, solver: kabsch}
  - {name: 5-point, solver: nister-5pt, ransac: {RANSAC: on, "": off}}
  - {solver: eight-point, scale: none}
features:
  - {name: ORB, detector: orb, descriptor: orb}
  - {detector: sift}
)",
                               "g.yaml");
  EXPECT_THAT(names(grid.methods),
              ElementsAre("eigensolver", "Kabsch", "5-point.RANSAC", "5-point", "eight-point.none"));
  EXPECT_THAT(grid.methods[2].options, ElementsAre(Pair("solver", "nister-5pt"), Pair("ransac", "on")));
  EXPECT_THAT(names(grid.features), ElementsAre("ORB", "sift"));
  EXPECT_EQ(grid.methods[1].line, 4u);
  EXPECT_EQ(grid.features[1].line, 9u);
}

TEST(GridFile, ExcludeLeavesOutWhatHasAllItsValues) {
  const Grid grid = parse_grid(R"(
axes: {solver: [a, b], scale: [x, y]}
exclude: [{solver: a, scale: y}]
)",
                               "g.yaml");
  EXPECT_THAT(names(grid.methods), ElementsAre("a.x", "b.x", "b.y"));
}

TEST(GridFile, SaysInOneLineWhatIsWrong) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& words) {
    try {
      parse_grid(text, "g.yaml");
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("g.yaml"));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
      for (const std::string& word : words) EXPECT_THAT(error.what(), HasSubstr(word));
      return;
    }
    ADD_FAILURE() << "taken: " << text;
  };
  refused("", {"empty grid"});
  refused("- a\n", {"a list", "rows: or axes:"});
  refused("rows:\n", {"without methods"});
  refused("features: [{detector: orb}]\n", {"without methods"});
  refused("lines: []\n", {":1:", "'lines'", "axes, rows, exclude or features"});
  refused("rows: {solver: a}\n", {"rows: found a map, expected a list"});
  refused("rows:\n  - solver\n", {":2: rows: found 'solver'"});
  refused("rows:\n  - {}\n", {"no options"});
  refused("rows:\n  - {solver: [[a]]}\n", {":2: rows: solver: found a list, expected one value"});
  refused("rows:\n  - {solver: []}\n", {"solver: found no values"});
  refused("rows:\n  - {solver: }\n", {"solver: found nothing"});
  refused("axes: [a]\n", {"axes: found a list, expected a map"});
  refused("rows: [{solver: a}, {solver: a}]\n", {"'a' twice"});
  refused("rows: [{solver: a}]\nfeatures: [{detector: [a, b]}]\n", {":2: features: detector: found a list"});
  refused("rows: [{solver: a}]\nexclude: [{solver: b}]\n", {":2: exclude:", "no method meets"});
  refused("rows: [{solver: a}]\nexclude: [{solver: a}]\n", {"without methods"});
  refused("rows: [{solver: a}\n", {"YAML"});
  refused(
      "axes: {a: [1,2,3,4,5,6,7,8,9,10], b: [1,2,3,4,5,6,7,8,9,10], c: [1,2,3,4,5,6,7,8,9,10],"
      " d: [1,2,3,4,5,6,7,8,9,10], e: [1,2]}\n",
      {"more than 10000"});
}

TEST(GridFile, NeedsAFile) { EXPECT_THROW(read_grid_file("/nowhere/grid.yaml"), InputError); }

}  // namespace
}  // namespace framewise
