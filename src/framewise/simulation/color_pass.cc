// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/color_pass.h"

#include "framewise/image/depth.h"

namespace framewise {
namespace {

cv::Vec3b to_bytes(const Color& display) {
  const auto byte = [](float x) { return static_cast<std::uint8_t>(x + 0.5f); };
  return {byte(display.b), byte(display.g), byte(display.r)};
}

}  // namespace

Centres trace_centres(const View& view, bool with_radiance, bool with_depth) {
  const int width = view.options.camera.width, height = view.options.camera.height;
  Centres centres{cv::Mat(height, width, CV_8UC3, cv::Scalar::all(0)),
                  cv::Mat(height, width, CV_32S, cv::Scalar(-1)),
                  cv::Mat(height, width, CV_32F, cv::Scalar(0)),
                  {},
                  {}};
  if (with_radiance) centres.radiance = cv::Mat(height, width, CV_32FC3, cv::Scalar::all(0));
  if (with_depth) centres.depth = cv::Mat(height, width, CV_32F, cv::Scalar(kUnknownDepth));
  const auto keep = [&](ExactDepth& exact_z, const Hit& hit, const Packet& packet, int i) {
    const cv::Point pixel = packet.pixels[i];
    const Color light = shade(view, hit, packet.ray_in_cam(i), packet.direction(i), 1);
    centres.color.at<cv::Vec3b>(pixel) = to_bytes(view.displayed(light));
    centres.triangle.at<int>(pixel) = static_cast<int>(hit.triangle);
    centres.distance.at<float>(pixel) = hit.t * packet.z_in_cam[i];
    if (with_radiance) centres.radiance.at<cv::Vec3f>(pixel) = {light.b, light.g, light.r};
    if (!with_depth) return;
    const double z = exact_z(pixel, hit.triangle);
    if (z <= view.options.max_depth) centres.depth.at<float>(pixel) = static_cast<float>(z);
  };
  for_each_tile(width, height, [&](const cv::Rect& tile) {
    ExactDepth exact_z(view);
    trace_tile(view, tile,
               [&](const Hit& hit, const Packet& packet, int i) { keep(exact_z, hit, packet, i); });
  });
  return centres;
}

}  // namespace framewise
