// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/image/flexion.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "framewise/image/depth_images_for_tests.h"
#include "framewise/image/gray_levels.h"
#include "framewise/image/inverse_depth_smoothing.h"

namespace framewise {
namespace {

FlexionOptions options_of(FlexionForm form, int distance_px = 1, double sigma_px = 0) {
  FlexionOptions options;
  options.form = form;
  options.distance_px = distance_px;
  options.smoothing_sigma_px = sigma_px;
  return options;
}

constexpr FlexionForm kBothForms[] = {FlexionForm::kPublished, FlexionForm::kNormalised};

// The definition, word for word.
cv::Mat plain_flexion(const cv::Mat& depth, const DepthRays& rays, const FlexionOptions& options) {
  const int n = options.distance_px;
  cv::Mat image(depth.size(), CV_32F, cv::Scalar(kNoDepth));
  for (int v = n; v < depth.rows - n; ++v)
    for (int u = n; u < depth.cols - n; ++u) {
      const PlainDifferences d = plain_differences(depth, rays, u, v, n);
      Eigen::Vector3d c0 = d.d0.normalized().cross(d.d1.normalized());
      Eigen::Vector3d c1 = d.d2.normalized().cross(d.d3.normalized());
      if (options.form == FlexionForm::kNormalised) {
        c0.normalize();
        c1.normalize();
      }
      image.at<float>(v, u) = static_cast<float>(std::min(std::abs(c0.dot(c1)), 1.0));
    }
  return image;
}

TEST(Flexion, IsItsDefinitionForEveryCameraFormAndDistance) {
  for (const DepthRays& rays : all_rays())
    for (const FlexionForm form : kBothForms)
      for (const int n : {1, 3}) {
        const FlexionOptions options = options_of(form, n);
        const cv::Mat depth = random_depth(64, 48, 1);
        EXPECT_LT(
            largest_difference(flexion_image(depth, rays, options), plain_flexion(depth, rays, options)),
            1e-5)
            << name_of(rays.camera.model) << " " << name_of(rays.type) << " " << n;
      }
}

TEST(Flexion, OfAPlaneIsOneInTheNormalisedForm) {
  for (const DepthRays& rays : all_rays())
    for (const Eigen::Vector3d& normal : {Eigen::Vector3d(0, 0, 1), {0.3, -0.2, 1}, {-0.5, 0.4, 1}}) {
      const cv::Mat image =
          flexion_image(plane_depth(rays, normal, 2), rays, options_of(FlexionForm::kNormalised, 2));
      int seen = 0;
      for (int v = 0; v < image.rows; ++v)
        for (int u = 0; u < image.cols; ++u)
          if (const float f = image.at<float>(v, u); !std::isnan(f)) {
            // Far along the plane the differences are a small part of the depths, and rounding shows.
            const double slant =
                std::abs(normal.normalized().dot(*rays.camera.bearing(Eigen::Vector2d(u, v))));
            if (slant < 0.3) continue;
            ++seen;
            ASSERT_NEAR(f, 1, 1e-5) << name_of(rays.camera.model) << " " << u << " " << v;
          }
      EXPECT_GT(seen, 100);
    }
}

TEST(Flexion, PublishedIsOneOnlyWhereAPlaneIsFaced) {
  Camera camera = pinhole_camera(200, 200);
  camera.fx = camera.fy = 500;
  const DepthRays rays(camera, DepthType::kZ);
  const auto at_centre = [&](double slant) {
    const cv::Mat depth = plane_depth(rays, {std::sin(slant), 0, std::cos(slant)}, 2);
    return flexion_image(depth, rays, {}).at<float>(104, 98);  // the principal point
  };
  EXPECT_NEAR(at_centre(0), 1, 1e-4);
  // d0 is as it was and d1 is longer by 1 / cos: the diagonals are no longer at right angles.
  for (const double slant : {0.3, 0.8, 1.2}) {
    const double stretch = 1 / std::cos(slant);
    EXPECT_NEAR(at_centre(slant), 2 * stretch / (1 + stretch * stretch), 5e-3) << slant;
  }
}

TEST(Flexion, OfASphereIsNearOneInsideAndFallsAtItsOutline) {
  const DepthRays rays(pinhole_camera(200, 200), DepthType::kRange);
  const Eigen::Vector3d centre(0, 0, 3);
  const double radius = 1;
  cv::Mat depth(200, 200, CV_32F);
  for (int v = 0; v < 200; ++v)
    for (int u = 0; u < 200; ++u) {
      const Eigen::Vector3d b = ray_of(rays, u, v);
      const double along = b.dot(centre), gap2 = centre.squaredNorm() - along * along;
      depth.at<float>(v, u) =
          static_cast<float>(gap2 < radius * radius ? along - std::sqrt(radius * radius - gap2) : 8 / b.z());
    }
  const cv::Mat image = flexion_image(depth, rays, options_of(FlexionForm::kNormalised));
  EXPECT_GT(image.at<float>(104, 98), 0.999f);
  int dark = 0, dark_off_the_outline = 0;
  for (int v = 1; v < 199; ++v)
    for (int u = 1; u < 199; ++u) {
      if (image.at<float>(v, u) > 0.9f) continue;
      ++dark;
      const double from_axis = std::acos(ray_of(rays, u, v).z()), outline = std::asin(radius / 3);
      dark_off_the_outline += std::abs(from_axis - outline) > 3 / rays.camera.fx;
    }
  EXPECT_GT(dark, 50);
  EXPECT_EQ(dark_off_the_outline, 0);
  EXPECT_GT(image.at<float>(20, 20), 0.999f);  // the wall behind
}

TEST(Flexion, DoesNotDependOnTheUnitOfDepth) {
  for (const DepthRays& rays : all_rays())
    for (const FlexionForm form : kBothForms)
      for (const double sigma : {0.0, 2.0}) {
        const cv::Mat depth = random_depth(64, 48, 2);
        const cv::Mat in_metres = flexion_image(depth, rays, options_of(form, 1, sigma));
        for (const double unit : {1000.0, 5000.0, 1e-3})
          EXPECT_LT(
              largest_difference(in_metres, flexion_image(depth * unit, rays, options_of(form, 1, sigma))),
              2e-5)
              << name_of(rays.camera.model) << " " << unit << " " << sigma;
        // A power of two changes no rounding at all.
        EXPECT_TRUE(same_bytes(in_metres, flexion_image(depth * 1024, rays, options_of(form, 1, sigma))));
      }
}

TEST(Flexion, SmoothedIsThatOfTheSmoothedDepth) {
  for (const DepthRays& rays : all_rays()) {
    cv::Mat depth = random_depth(64, 48, 3);
    depth(cv::Rect(20, 15, 7, 9)) = kNoDepth;
    depth.at<float>(40, 40) = kNoDepth;
    if (!rays.z_per_range.empty()) continue;  // what is smoothed there is z
    const cv::Mat smoothed = smooth_inverse_depth(depth, 2);
    EXPECT_LT(largest_difference(flexion_image(depth, rays, options_of(FlexionForm::kNormalised, 2, 2)),
                                 flexion_image(smoothed, rays, options_of(FlexionForm::kNormalised, 2))),
              1e-5)
        << name_of(rays.camera.model);
  }
}

TEST(Flexion, IsUnknownAtTheBorderAndWhereANeighbourIs) {
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  cv::Mat depth = random_depth(64, 48, 4);
  const float bad[] = {kNoDepth, 0, -1, std::numeric_limits<float>::infinity()};
  for (int k = 0; k < 4; ++k) depth.at<float>(20, 10 + 10 * k) = bad[k];
  const cv::Mat image = flexion_image(depth, rays, options_of(FlexionForm::kNormalised, 2));
  EXPECT_EQ(count_unknown(image), 64 * 48 - 60 * 44 + 4 * 8);  // the pixel itself does not count
  EXPECT_FALSE(std::isnan(image.at<float>(20, 10)));
  EXPECT_TRUE(std::isnan(image.at<float>(22, 8)));
}

TEST(Flexion, PublishedTakesUnknownDepthForThePointOfTheCamera) {
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  cv::Mat depth = random_depth(64, 48, 5);
  depth.at<float>(20, 10) = kNoDepth;
  cv::Mat with_zero = depth.clone();
  with_zero.at<float>(20, 10) = 0;
  FlexionOptions options;
  const cv::Mat image = flexion_image(depth, rays, options);
  EXPECT_LT(largest_difference(image, plain_flexion(with_zero, rays, options)), 1e-5);
  options.unknown_at_camera = false;
  EXPECT_EQ(count_unknown(flexion_image(depth, rays, options)), 64 * 48 - 62 * 46 + 8);
}

TEST(Flexion, OfNothingIsUnknown) {
  for (const DepthRays& rays : all_rays())
    for (const double sigma : {0.0, 3.0}) {
      const cv::Mat nothing(48, 64, CV_32F, cv::Scalar(kNoDepth));
      EXPECT_EQ(count_unknown(flexion_image(nothing, rays, options_of(FlexionForm::kPublished, 1, sigma))),
                64 * 48);
    }
  const DepthRays one({CameraModel::kPinhole, 1, 1, 1, 1, 0, 0}, DepthType::kZ);
  EXPECT_EQ(count_unknown(flexion_image(cv::Mat(1, 1, CV_32F, cv::Scalar(2)), one, {})), 1);
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  EXPECT_EQ(
      count_unknown(flexion_image(random_depth(64, 48, 6), rays, options_of(FlexionForm::kPublished, 30))),
      64 * 48);
}

TEST(Flexion, ReusesMemoryThatFitsAndNeverItsInput) {
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  const cv::Mat depth = random_depth(64, 48, 8), expected = flexion_image(depth, rays, {});
  cv::Mat memory(48, 64, CV_32F);
  const cv::Mat reused = flexion_image(depth, rays, {}, memory);
  EXPECT_EQ(reused.data, memory.data);
  EXPECT_EQ(largest_difference(reused, expected), 0);
  EXPECT_EQ(largest_difference(flexion_image(depth, rays, {}, cv::Mat(3, 3, CV_8U)), expected), 0);
  const cv::Mat kept = depth.clone();
  EXPECT_EQ(largest_difference(flexion_image(depth, rays, {}, depth), expected), 0);
  EXPECT_TRUE(same_bytes(depth, kept));
}

TEST(Flexion, RefusesWhatIsNoDepthImageOfTheCamera) {
  const DepthRays rays(pinhole_camera(), DepthType::kZ);
  EXPECT_THROW(flexion_image({}, rays, {}), std::invalid_argument);
  EXPECT_THROW(flexion_image(cv::Mat(48, 64, CV_16U), rays, {}), std::invalid_argument);
  EXPECT_THROW(flexion_image(cv::Mat(48, 64, CV_32FC3), rays, {}), std::invalid_argument);
  EXPECT_THROW(flexion_image(cv::Mat(64, 48, CV_32F), rays, {}), std::invalid_argument);
  EXPECT_THROW(DepthRays(equirectangular_camera(), DepthType::kZ), std::invalid_argument);
  const cv::Mat depth = random_depth(64, 48, 7);
  for (const auto& [n, sigma] :
       {std::pair(0, 0.0), {-1, 0.0}, {1, -1.0}, {1, 0.2}, {1, 99.0}, {1, std::nan("")}})
    EXPECT_THROW(flexion_image(depth, rays, options_of(FlexionForm::kPublished, n, sigma)),
                 std::invalid_argument)
        << n << " " << sigma;
}

// The image of a Kinect v2 in a mine as the authors of the flexion image computed it.
TEST(Flexion, AgreesWithTheReferenceAtEveryPixel) {
  const char* golden = std::getenv("FRAMEWISE_GOLDEN");
  const auto folder = (golden ? std::filesystem::path(golden)
                              : std::filesystem::path(FRAMEWISE_SOURCE_DIR) / ".." / "shared" / "golden") /
                      "flexion";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "no " << folder << "; FRAMEWISE_GOLDEN names the folder it is in";
  const cv::Mat raw = cv::imread((folder / "kinect-depth.png").string(), cv::IMREAD_UNCHANGED);
  const cv::Mat reference =
      cv::imread((folder / "kinect-flexion-reference.png").string(), cv::IMREAD_UNCHANGED);
  const Camera camera{CameraModel::kPinhole, raw.cols, raw.rows, 519.226, 479.462, 522.23, 272.737};
  // In the sensor's own units: millimetres are exact in float, metres are not, and their rounding is 2
  // levels.
  cv::Mat depth;
  raw.convertTo(depth, CV_32F);
  const cv::Mat image = to_16_bit(flexion_image(depth, DepthRays(camera, DepthType::kZ), {}));
  int worst = 0, unequal = 0;
  for (int v = 0; v < raw.rows; ++v)
    for (int u = 0; u < raw.cols; ++u) {
      const int difference = std::abs(image.at<std::uint16_t>(v, u) - reference.at<std::uint16_t>(v, u));
      worst = std::max(worst, difference);
      unequal += difference > 0;
    }
  EXPECT_LT(worst, 2);
  // The reference's levels are rounded, so nearly all are the very same.
  EXPECT_LT(unequal, 0.01 * raw.total());
}

}  // namespace
}  // namespace framewise
