// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/imaging.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "framewise/geometry/so3.h"
#include "framewise/simulation/mesh_builder.h"
#include "framewise/simulation/scene_catalog.h"

namespace framewise {
namespace {

RgbdOptions small_camera() {
  RgbdOptions options;
  options.camera = {CameraModel::kPinhole, 80, 60, 66, 66, 39.5, 29.5, {}, {}};
  return options;
}

// A black wall x = 3 with a white bar |y| < 0.1 before it, for a camera at the origin that looks along x.
Scene bar() {
  Scene scene;
  MeshBuilder builder(scene, 1);
  builder.quad({3, 6, -6}, {0, -12, 0}, {0, 0, 12}, {Texture::kPaint, {0, 0, 0}, {}, 1});
  builder.quad({2.99f, 0.1f, -6}, {0, -0.2f, 0}, {0, 0, 12}, {Texture::kPaint, {1, 1, 1}, {}, 1});
  for (Vertex& vertex : scene.vertices) vertex.light = {1, 1, 1};
  return scene;
}

// Looks along x and slides along y at 1 m/s: a point at 3 m moves by 22 pixels a second.
Motion sliding(double time) {
  Motion motion;
  motion.world_from_cam.R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  motion.world_from_cam.t = {0, time, 0};
  return motion;
}

double column_of_bar(const cv::Mat& light, int v) {
  double sum = 0, moment = 0;
  for (int u = 0; u < light.cols; ++u) {
    sum += light.at<cv::Vec3f>(v, u)[1];
    moment += u * light.at<cv::Vec3f>(v, u)[1];
  }
  return moment / sum;
}

double light_of_row(const cv::Mat& light, int v) {
  double sum = 0;
  for (int u = 0; u < light.cols; ++u) sum += light.at<cv::Vec3f>(v, u)[1];
  return sum;
}

double width_of_bar(const cv::Mat& light, int v) {
  const double middle = column_of_bar(light, v), sum = light_of_row(light, v);
  double variance = 0;
  for (int u = 0; u < light.cols; ++u)
    variance += (u - middle) * (u - middle) * light.at<cv::Vec3f>(v, u)[1] / sum;
  return std::sqrt(12 * variance);
}

TEST(Imaging, BlurSpreadsLightOverTheWayAndKeepsTheSumAndTheMiddle) {
  const Scene scene = bar();
  const RayTracer tracer(scene);
  const RgbdSensor sensor(small_camera());
  const cv::Mat sharp = expose(sensor, tracer, sliding, 0, {});
  const ImagingOptions blur{.exposure_time = 0.5, .blur_samples = 32};
  const cv::Mat blurred = expose(sensor, tracer, sliding, 0, blur);
  const double way = 0.5 * 66 / 2.99;  // pixels
  EXPECT_NEAR(light_of_row(blurred, 30), light_of_row(sharp, 30), 0.05 * light_of_row(sharp, 30));
  EXPECT_NEAR(column_of_bar(blurred, 30), column_of_bar(sharp, 30), 0.3);
  EXPECT_NEAR(width_of_bar(blurred, 30), std::hypot(width_of_bar(sharp, 30), way), 0.8);
}

// In which what surfaces show is taken from one view: the mean of views drawn one by one is the judge, with a
// lens, a lamp, and things before others.
TEST(Imaging, BlurIsTheMeanOfTheViewsOfItsInstants) {
  const SceneKind& kind = scene_kind("mine");
  const Scene scene = kind.build({.light_cell = 0.2f});
  const RayTracer tracer(scene);
  RgbdOptions camera;
  camera.camera = {CameraModel::kPinhole, 160, 120, 131, 131, 79.5, 59.5, {-0.2, 0.03, 0, 0, 0}, {}};
  camera.headlamp = 12;
  const RgbdSensor sensor(camera);
  const Path path = named_path("drone-race", kind.space, 1);
  const ImagingOptions blur{.exposure_time = 0.1, .blur_samples = 8};
  const cv::Mat blurred = expose(sensor, tracer, path, 2, blur);
  cv::Mat mean(blurred.size(), CV_32FC3, cv::Scalar::all(0));
  for (int k = 0; k < 8; ++k)
    mean += expose(sensor, tracer, path, 2 + 0.1 * ((k + 0.5) / 8 - 0.5), {}) * 0.125;
  const double light = cv::norm(mean, cv::NORM_L1), error = cv::norm(blurred, mean, cv::NORM_L1);
  EXPECT_LT(error, 0.06 * light);
  EXPECT_NEAR(cv::norm(blurred, cv::NORM_L1), light, 0.01 * light);
  // One sharp view alone is much farther off.
  EXPECT_GT(cv::norm(expose(sensor, tracer, path, 2, {}), mean, cv::NORM_L1), 3 * error);
}

TEST(Imaging, ARollingShutterShearsAndLeavesTheMiddleRow) {
  const Scene scene = bar();
  const RayTracer tracer(scene);
  const RgbdSensor sensor(small_camera());
  const cv::Mat still = expose(sensor, tracer, sliding, 0, {});
  const cv::Mat rolling = expose(sensor, tracer, sliding, 0, {.readout_time = 0.5});
  for (const int v : {0, 15, 30, 45, 59}) {
    const double late =
        0.5 * ((v + 0.5) / 60 - 0.5);  // s; the bar moves to the right as the camera to the left
    EXPECT_NEAR(column_of_bar(rolling, v) - column_of_bar(still, v), late * 66 / 2.99, 0.15) << v;
  }
}

struct Statistics {
  double mean = 0, variance = 0;
};

// Of many pixels with the same light, brought back from bytes to light.
Statistics statistics(float light, const ImagingOptions& options) {
  const Camera camera{CameraModel::kPinhole, 200, 150, 160, 160, 99.5, 74.5, {}, {}};
  const cv::Mat image = develop(cv::Mat(150, 200, CV_32FC3, cv::Scalar::all(light)), camera, options, 4);
  Statistics s;
  const double count = 3.0 * image.total();
  for (int pass = 0; pass < 2; ++pass)
    for (int v = 0; v < image.rows; ++v)
      for (int u = 0; u < image.cols; ++u)
        for (int k = 0; k < 3; ++k) {
          const double x = image.at<cv::Vec3b>(v, u)[k] / 255.0;
          if (pass == 0)
            s.mean += x / count;
          else
            s.variance += (x - s.mean) * (x - s.mean) / count;
        }
  return s;
}

// e electrons: mean e, variance e + read^2; of light: divided by photons. Linear bytes add 1/12 of a step^2.
TEST(Imaging, NoiseHasTheVarianceOfCountedPhotons) {
  for (const double light : {0.1, 0.3, 0.6}) {
    for (const double photons : {60.0, 400.0, 5000.0}) {
      for (const double read : {0.0, 4.0}) {
        if (light * photons < 30 && read > 0) continue;  // what is read below 0 is cut off there
        const Statistics s =
            statistics(static_cast<float>(light), {.photons = photons, .read_noise = read, .gamma = 1});
        const double variance =
            (light * photons + read * read) / (photons * photons) + 1 / (12 * 255.0 * 255.0);
        EXPECT_NEAR(s.mean, light, 0.004) << photons;
        EXPECT_NEAR(s.variance, variance, 0.06 * variance) << light << " " << photons << " " << read;
      }
    }
  }
}

TEST(Imaging, WithoutEffectsBytesAreTheCurveOfLight) {
  EXPECT_NEAR(statistics(0.5f, {}).mean * 255, 188, 0.6);  // IEC 61966-2-1
  EXPECT_NEAR(statistics(0.5f, {.gamma = 2.2}).mean * 255, 255 * std::pow(0.5, 1 / 2.2), 0.6);
  EXPECT_LT(statistics(0.5f, {}).variance, 1e-20);
  EXPECT_NEAR(statistics(7, {}).mean, 1, 1e-9);
}

TEST(Imaging, VignettingIsTheFourthPowerOfTheCosine) {
  const Camera camera{CameraModel::kPinhole, 81, 61, 40, 40, 40, 30, {}, {}};
  const cv::Mat image =
      develop(cv::Mat(61, 81, CV_32FC3, cv::Scalar::all(0.8)), camera, {.gamma = 1, .vignetting = 1}, 0);
  EXPECT_EQ(image.at<cv::Vec3b>(30, 40)[0], 204);
  const double cosine = 1 / std::sqrt(1 + 1 + 0.75 * 0.75);
  EXPECT_NEAR(image.at<cv::Vec3b>(0, 0)[0], 204 * std::pow(cosine, 4), 1);
}

TEST(Imaging, SameSeedSameBytes) {
  const Camera camera{CameraModel::kPinhole, 20, 15, 16, 16, 9.5, 7, {}, {}};
  const cv::Mat light(15, 20, CV_32FC3, cv::Scalar::all(0.4));
  const auto image = [&](std::uint64_t seed) { return develop(light, camera, {.photons = 100}, seed); };
  EXPECT_EQ(cv::norm(image(1), image(1), cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(image(1), image(2), cv::NORM_INF), 0);
}

TEST(Imaging, RefusesWhatNoCameraDoes) {
  EXPECT_NO_THROW(ImagingOptions().check(0.033));
  EXPECT_THROW((ImagingOptions{.exposure_time = 0.04}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.exposure_time = -1}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.blur_samples = 0}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.readout_time = 0.04}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.photons = std::nan("")}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.read_noise = 3}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.gamma = 0.01}).check(0.033), std::invalid_argument);
  EXPECT_THROW((ImagingOptions{.vignetting = 2}).check(0.033), std::invalid_argument);
}

}  // namespace
}  // namespace framewise
