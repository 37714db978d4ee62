// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/io/published_tables.h"

#include <gtest/gtest.h>

#include <fstream>

#include "framewise/io/input_error.h"
#include "framewise/io/test_files_for_tests.h"

namespace framewise {
namespace {

TEST(PublishedTables, AreReadIntoOurNames) {
  const auto path = test_file("published.csv");
  std::ofstream(path) << "sequence,solver,translation,ransac_error,feature,ate_rmse_m,rpe_trans_rmse_m,"
                         "rpe_rot_rmse_deg,outcome\n"
                         "fr3_house,nister-5pt,first-pair-scale,reprojection,Surf,1.5,0.25,42.5,ok\n"
                         "fr3_house,kabsch,full-3d,point-to-point,ORB,,,,failed\n";
  const auto figures = read_published_figures(path);
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].scale, "first-pair");
  EXPECT_EQ(figures[0].features, "SURF");
  EXPECT_EQ(figures[0].ate, 1.5);
  EXPECT_EQ(figures[0].rpe_translation, 0.25);
  EXPECT_EQ(figures[0].rpe_rotation_deg, 42.5);
  EXPECT_EQ(figures[1].scale, "depth");
  EXPECT_FALSE(figures[1].ate);
  EXPECT_EQ(figures[1].outcome, "failed");
  std::ofstream(path) << "sequence,solver\na,b\n";
  EXPECT_THROW(read_published_figures(path), InputError);
  std::filesystem::remove(path);
}

TEST(PublishedTables, KnowTheirSequenceByTheDataSetsName) {
  EXPECT_TRUE(is_of_sequence("rgbd_dataset_freiburg3_long_office_household", "fr3_long_office_household"));
  EXPECT_TRUE(is_of_sequence("fr3_long_office_household_validation", "fr3_long_office_household"));
  EXPECT_TRUE(is_of_sequence("PUTKK_Dataset_1_Kin_1", "putkk_Dataset_1_Kin_1"));
  EXPECT_FALSE(is_of_sequence("rgbd_dataset_freiburg1_rpy", "fr3_long_office_household"));
  EXPECT_FALSE(is_of_sequence("anything", ""));
}

}  // namespace
}  // namespace framewise
