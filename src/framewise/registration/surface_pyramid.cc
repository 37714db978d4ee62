// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/registration/surface_pyramid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/image/image_check.h"
#include "framewise/registration/option_check.h"
#include "framewise/registration/surface_kernels.h"

namespace framewise {
namespace {

// An image of inverse depth with the margin that the kernels want.
class PaddedImage {
 public:
  PaddedImage(int width, int height)
      : stride_(width + 2 * kFitReach + kLanes), values_(stride_ * (height + 2 * kFitReach)) {}

  float* row(int v) { return values_.data() + (v + kFitReach) * stride_ + kFitReach; }

 private:
  std::size_t stride_;
  std::vector<float> values_;
};

SurfaceGrid coarser(const SurfaceGrid& fine) {
  return {fine.width / 2,
          fine.height / 2,
          fine.fx / 2,
          fine.fy / 2,
          (fine.cx + 0.5f) / 2 - 0.5f,
          (fine.cy + 0.5f) / 2 - 0.5f};
}

Surface empty_surface(const SurfaceGrid& grid) {
  Surface surface;
  surface.grid = grid;
  for (auto* column : {&surface.measured_inverse, &surface.inverse_depth, &surface.nx, &surface.ny,
                       &surface.nz, &surface.distance, &surface.precision})
    column->resize(grid.size() + kLanes);
  return surface;
}

PlaneModel plane_model(const SurfaceGrid& grid, const SurfaceOptions& options, double full_fx) {
  PlaneModel model{};
  model.fx = grid.fx, model.fy = grid.fy, model.cx = grid.cx;
  model.noise_floor = static_cast<float>(options.noise.floor);
  model.noise_growth = static_cast<float>(options.noise.growth);
  model.noise_nearest = static_cast<float>(options.noise.nearest);
  model.sideways = static_cast<float>(options.sideways_px / full_fx);
  model.least_cosine = static_cast<float>(options.least_cosine);
  return model;
}

// What is summed over the known pixels of a surface.
struct Totals {
  std::size_t known = 0;
  double x = 0, y = 0, z = 0, squares = 0, feigned = 0;
};

void add_row(const Surface& surface, int v, const std::vector<float>& feigned, Totals& totals) {
  const SurfaceGrid& grid = surface.grid;
  const float y = (static_cast<float>(v) - grid.cy) / grid.fy;
  float sums[5] = {};
  for (int u = 0; u < grid.width; ++u) {
    const float w = surface.inverse_depth[static_cast<std::size_t>(v) * grid.width + u];
    if (!(w > 0)) continue;
    const float x = (static_cast<float>(u) - grid.cx) / grid.fx, z = 1 / w;
    ++totals.known;
    sums[0] += x * z, sums[1] += y * z, sums[2] += z;
    sums[3] += (x * x + y * y + 1) * z * z, sums[4] += feigned[u];
  }
  totals.x += sums[0], totals.y += sums[1], totals.z += sums[2];
  totals.squares += sums[3], totals.feigned += sums[4];
}

void summarise(const Totals& totals, Surface& surface) {
  surface.known = totals.known;
  if (totals.known == 0) return;
  const double n = static_cast<double>(totals.known);
  surface.centre = Eigen::Vector3d(totals.x, totals.y, totals.z) / n;
  surface.radius = std::sqrt(std::max(0.0, totals.squares / n - surface.centre.squaredNorm()));
  surface.feigned_information = totals.feigned / n;
}

Surface fit_surface(PaddedImage& image, const SurfaceGrid& grid, const SurfaceOptions& options,
                    double full_fx) {
  Surface surface = empty_surface(grid);
  std::vector<float> row_buffers[5];
  for (auto& buffer : row_buffers) buffer.resize(grid.width + kLanes);
  const FittedRow fitted{row_buffers[0].data(), row_buffers[1].data(), row_buffers[2].data(),
                         row_buffers[3].data()};
  std::vector<float>& feigned = row_buffers[4];
  PlaneModel model = plane_model(grid, options, full_fx);
  const int reach = options.reach_px, side = 2 * reach + 1;
  Totals totals;
  for (int v = 0; v < grid.height; ++v) {
    const float* rows[2 * kFitReach + 1];
    for (int k = 0; k < side; ++k) rows[k] = image.row(v + k - reach);
    const std::size_t at = static_cast<std::size_t>(v) * grid.width;
    std::copy_n(image.row(v), grid.width, surface.measured_inverse.data() + at);
    fit_planes(rows, reach, grid.width, static_cast<float>(options.tolerance),
               0.5f * static_cast<float>(side * side), fitted);
    model.y = (static_cast<float>(v) - grid.cy) / grid.fy;
    convert_planes(fitted, model, grid.width,
                   {&surface.inverse_depth[at], &surface.nx[at], &surface.ny[at], &surface.nz[at],
                    &surface.distance[at], &surface.precision[at], feigned.data()});
    add_row(surface, v, feigned, totals);
  }
  // The last row's lanes that are no pixels.
  std::fill(surface.inverse_depth.begin() + grid.size(), surface.inverse_depth.end(), 0.0f);
  std::fill(surface.precision.begin() + grid.size(), surface.precision.end(), 0.0f);
  summarise(totals, surface);
  return surface;
}

PaddedImage halved(PaddedImage& fine, const SurfaceGrid& grid, double tolerance) {
  PaddedImage coarse(grid.width, grid.height);
  for (int v = 0; v < grid.height; ++v)
    halve_rows(fine.row(2 * v), fine.row(2 * v + 1), grid.width, static_cast<float>(tolerance),
               coarse.row(v));
  return coarse;
}

}  // namespace

void SurfaceOptions::check() const {
  check_option(decimation == 1 || decimation == 2, "decimation", decimation, "1 or 2");
  check_option(levels >= 1 && levels <= 8, "levels", levels, "1 to 8");
  check_option(reach_px >= 1 && reach_px <= kFitReach, "reach_px", reach_px, "1 to 4");
  check_option(tolerance > 0 && tolerance < 1, "tolerance", tolerance, "a share above 0 and below 1");
  check_option(min_depth > 0, "min_depth", min_depth, "more than 0 (m)");
  check_option(max_depth > min_depth && std::isfinite(max_depth), "max_depth", max_depth,
               "more than min_depth (m)");
  check_option(sideways_px >= 0 && std::isfinite(sideways_px), "sideways_px", sideways_px, "0 or more");
  check_option(least_cosine >= 0 && least_cosine < 1, "least_cosine", least_cosine, "0 or more, below 1");
  noise.check();
}

SurfaceMaker::SurfaceMaker(const Camera& camera, const SurfaceOptions& options)
    : camera_(camera), options_(options) {
  camera.check();
  options.check();
  if (camera.model == CameraModel::kEquirectangular)
    throw std::invalid_argument("camera: found equirectangular, expected pinhole or fisheye");
  const double d = options.decimation;
  grid_ = {camera.width / options.decimation,
           camera.height / options.decimation,
           static_cast<float>(camera.fx / d),
           static_cast<float>(camera.fy / d),
           static_cast<float>((camera.cx + 0.5) / d - 0.5),
           static_cast<float>((camera.cy + 0.5) / d - 0.5)};
  places_.resize(grid_.size());
  for (int v = 0; v < grid_.height; ++v)
    for (int u = 0; u < grid_.width; ++u) {
      Place& place = places_[static_cast<std::size_t>(v) * grid_.width + u];
      place = {-1, 0, 0};
      const auto pixel = camera.project(
          {(u - double{grid_.cx}) / double{grid_.fx}, (v - double{grid_.cy}) / double{grid_.fy}, 1});
      if (!pixel) continue;
      const double column = std::clamp(std::floor(pixel->x() + 1e-3), 0.0, camera.width - 2.0);
      const double row = std::clamp(std::floor(pixel->y() + 1e-3), 0.0, camera.height - 2.0);
      const double right = pixel->x() - column, down = pixel->y() - row;
      if (!(right > -1e-2 && right < 1.01 && down > -1e-2 && down < 1.01)) continue;
      if (camera.width < 2 || camera.height < 2) continue;
      place.corner = static_cast<std::int32_t>(row * camera.width + column);
      place.right = static_cast<float>(std::clamp(right, 0.0, 1.0));
      place.down = static_cast<float>(std::clamp(down, 0.0, 1.0));
    }
}

std::vector<float> SurfaceMaker::sample(const cv::Mat& depth) const {
  const float least = static_cast<float>(options_.min_depth), most = static_cast<float>(options_.max_depth);
  const float same = 1 - static_cast<float>(options_.tolerance);
  const float* z = depth.ptr<float>();
  const auto inverse = [&](float metres) { return metres >= least && metres <= most ? 1 / metres : 0.0f; };
  std::vector<float> sampled(grid_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    if (place.corner < 0) continue;
    const float* here = z + place.corner;
    const float* below = here + depth.cols;
    const float w[4] = {inverse(here[0]), inverse(here[1]), inverse(below[0]), inverse(below[1])};
    const float weight[4] = {(1 - place.right) * (1 - place.down), place.right * (1 - place.down),
                             (1 - place.right) * place.down, place.right * place.down};
    const float nearest = std::max(std::max(w[0], w[1]), std::max(w[2], w[3]));
    float sum = 0, total = 0;
    for (int k = 0; k < 4; ++k) {
      const float kept = w[k] > nearest * same ? weight[k] : 0.0f;
      sum += kept * w[k];
      total += kept;
    }
    if (total > 0.2f) sampled[i] = sum / total;
  }
  return sampled;
}

SurfacePyramid SurfaceMaker::operator()(const cv::Mat& depth) const {
  check_image("depth", depth, CV_32F);
  check_image_size("depth", depth, camera_.width, camera_.height);
  return from_inverse_depth(sample(depth.isContinuous() ? depth : depth.clone()));
}

SurfacePyramid SurfaceMaker::from_inverse_depth(const std::vector<float>& inverse_depth) const {
  if (inverse_depth.size() != grid_.size())
    throw std::invalid_argument("inverse_depth: found " + std::to_string(inverse_depth.size()) +
                                " numbers, expected " + std::to_string(grid_.size()));
  const int side = 2 * options_.reach_px + 1;
  SurfaceGrid grid = grid_;
  SurfacePyramid pyramid;
  if (grid.width < side || grid.height < side) return pyramid;
  PaddedImage image(grid.width, grid.height);
  for (int v = 0; v < grid.height; ++v)
    std::copy_n(inverse_depth.data() + static_cast<std::size_t>(v) * grid.width, grid.width, image.row(v));
  while (true) {
    pyramid.push_back(fit_surface(image, grid, options_, camera_.fx));
    grid = coarser(grid);
    if (static_cast<int>(pyramid.size()) == options_.levels || grid.width < 2 * side ||
        grid.height < 2 * side)
      return pyramid;
    image = halved(image, grid, options_.tolerance);
  }
}

}  // namespace framewise
