// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/light_baking.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "framewise/simulation/ray_tracer.h"

namespace framewise {
namespace {

using Eigen::Vector3f;

constexpr int kLightGrid = 4;    // samples along each side of a light
constexpr int kDirections = 32;  // of the bounce
constexpr float kAway = 2e-3f;   // rays start this far off the surface (m)
// Light that has bounced more than once, as if it came from everywhere.
constexpr Color kAmbient{0.09f, 0.09f, 0.095f};

// Where the light of each vertex is measured: drawn in from edges, where other things touch the surface.
std::vector<Vector3f> measuring_points(const Scene& scene) {
  std::vector<Vector3f> sum(scene.vertices.size(), Vector3f::Zero());
  std::vector<int> count(scene.vertices.size(), 0);
  for (const auto& triangle : scene.triangles) {
    const Vector3f centre = (scene.vertices[triangle[0]].position + scene.vertices[triangle[1]].position +
                             scene.vertices[triangle[2]].position) /
                            3;
    for (const std::uint32_t corner : triangle) {
      sum[corner] += centre;
      ++count[corner];
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const Vertex& vertex = scene.vertices[i];
    const Vector3f inward =
        count[i] ? Vector3f(sum[i] / static_cast<float>(count[i]) - vertex.position) : Vector3f::Zero();
    sum[i] = vertex.position + 0.2f * inward + kAway * vertex.normal;
  }
  return sum;
}

Color direct_light(const RayTracer& tracer, const Vector3f& point, const Vector3f& normal) {
  Color total;
  for (const AreaLight& light : tracer.scene().lights) {
    const Vector3f area = light.edge_u.cross(light.edge_v), facing = area.normalized();
    for (int first = 0; first < kLightGrid * kLightGrid; first += 8) {
      Rays8 rays;
      std::array<float, 8> strength;
      bool any = false;
      for (int i = 0; i < 8; ++i) {
        const float s = (static_cast<float>((first + i) % kLightGrid) + 0.5f) / kLightGrid;
        const float t = (static_cast<float>((first + i) / kLightGrid) + 0.5f) / kLightGrid;
        const Vector3f way = light.corner + s * light.edge_u + t * light.edge_v - point;
        const float distance2 = way.squaredNorm();
        const float cosines =
            std::fmax(0.0f, way.dot(normal)) * std::fmax(0.0f, -way.dot(facing)) / distance2;
        strength[i] = cosines * area.norm() /
                      (static_cast<float>(M_PI) * kLightGrid * kLightGrid * std::fmax(distance2, 0.01f));
        any |= strength[i] > 0;
        if (strength[i] > 0)
          rays.set(i, point, way, 1e-4f, 0.999f);
        else
          rays.switch_off(i);
      }
      if (!any) continue;
      const std::uint8_t shadow = tracer.occluded(rays);
      for (int i = 0; i < 8; ++i)
        if (!(shadow >> i & 1)) total += light.radiance * strength[i];
    }
  }
  return total;
}

// Directions about +z with density cosine / pi: Hammersley points on the disc, lifted (Malley's method;
// Pharr, Jakob, Humphreys, Physically Based Rendering, 2016, section 13.6.3).
std::array<Vector3f, kDirections> cosine_directions() {
  std::array<Vector3f, kDirections> directions;
  for (std::uint32_t i = 0; i < kDirections; ++i) {
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < 5; ++bit) reversed |= (i >> bit & 1u) << (4 - bit);
    const float radius2 = (static_cast<float>(i) + 0.5f) / kDirections;
    const float angle = 2 * static_cast<float>(M_PI) * (static_cast<float>(reversed) + 0.5f) / kDirections;
    directions[i] = {std::sqrt(radius2) * std::cos(angle), std::sqrt(radius2) * std::sin(angle),
                     std::sqrt(1 - radius2)};
  }
  return directions;
}

// Reflectance of each material over the whole of it: what a bounce sees is blurred anyway.
std::vector<Color> mean_reflectances(const Scene& scene) {
  constexpr int kGrid = 5;
  std::vector<Color> means;
  for (const Material& material : scene.materials) {
    Color sum;
    for (int j = 0; j < kGrid; ++j)
      for (int i = 0; i < kGrid; ++i)
        sum += albedo(material, (static_cast<float>(i) + 0.5f) / kGrid * material.width,
                      (static_cast<float>(j) + 0.5f) / kGrid * material.height, 0.05f);
    // A surface that shines is an area light too, and is counted as such.
    means.push_back(material.emission > 0 ? Color{} : sum * (1.0f / (kGrid * kGrid)));
  }
  return means;
}

Color bounced_light(const RayTracer& tracer, const std::vector<Color>& reflectances, const Vector3f& point,
                    const Vector3f& normal) {
  static const std::array<Vector3f, kDirections> directions = cosine_directions();
  const Vector3f side = normal.unitOrthogonal(), other = normal.cross(side);
  Color total;
  for (int first = 0; first < kDirections; first += 8) {
    Rays8 rays;
    for (int i = 0; i < 8; ++i) {
      const Vector3f& d = directions[first + i];
      rays.set(i, point, d.x() * side + d.y() * other + d.z() * normal, 1e-4f, 100.0f);
    }
    Hits8 hits;
    tracer.intersect(rays, false, hits);
    for (const std::uint32_t triangle : hits.triangle) {
      if (triangle == kNoHit) continue;
      const Scene& scene = tracer.scene();
      const Color arriving = scene.vertices[scene.triangles[triangle][0]].light + kAmbient;
      total += reflectances[scene.material_of_triangle[triangle]] * arriving;
    }
  }
  return total * (1.0f / kDirections);
}

template <typename Function>
std::vector<Color> at_every_vertex(const Scene& scene, Function light) {
  std::vector<Color> result(scene.vertices.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, result.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) result[i] = light(i);
  });
  return result;
}

}  // namespace

void bake_light(Scene& scene) {
  const RayTracer tracer(scene);
  const std::vector<Vector3f> points = measuring_points(scene);
  const std::vector<Color> reflectances = mean_reflectances(scene);
  const auto direct = at_every_vertex(
      scene, [&](std::size_t i) { return direct_light(tracer, points[i], scene.vertices[i].normal); });
  for (std::size_t i = 0; i < direct.size(); ++i) scene.vertices[i].light = direct[i];
  const auto bounced = at_every_vertex(scene, [&](std::size_t i) {
    return bounced_light(tracer, reflectances, points[i], scene.vertices[i].normal);
  });
  for (std::size_t i = 0; i < bounced.size(); ++i) scene.vertices[i].light += bounced[i] + kAmbient * 0.5f;
}

}  // namespace framewise
