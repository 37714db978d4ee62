// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "framewise/simulation/scene.h"

namespace framewise {

inline constexpr std::uint32_t kNoHit = std::numeric_limits<std::uint32_t>::max();

// Eight rays: origin + t * direction for t in [near, far]. A ray with far < near is switched off.
struct alignas(32) Rays8 {
  std::array<float, 8> origin_x, origin_y, origin_z, near;
  std::array<float, 8> direction_x, direction_y, direction_z, far;

  void set(int i, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near_t, float far_t);
  void switch_off(int i) { set(i, {0, 0, 0}, {0, 0, 1}, 1, 0); }
};

struct Hit {
  std::uint32_t triangle;
  float t, weight1, weight2;
};

// The first triangle each ray meets, kNoHit where none; where in it (weights of its second and third corner).
struct Hits8 {
  std::array<std::uint32_t, 8> triangle;
  std::array<float, 8> t, weight1, weight2;

  void set(int i, const Hit& hit) {
    triangle[i] = hit.triangle;
    t[i] = hit.t;
    weight1[i] = hit.weight1;
    weight2[i] = hit.weight2;
  }
  Hit operator[](int i) const { return {triangle[i], t[i], weight1[i], weight2[i]}; }
};

// What a ray met, interpolated from the corners of the triangle.
struct SurfacePoint {
  const Material* material;
  Eigen::Vector3f normal;  // of the surface, about unit
  float u, v;
  Color light;
  Color tint = {1, 1, 1};  // times the reflectance
};

// Finds what rays meet in a scene (Embree). Reading is safe from many threads. Keeps a reference to the
// scene, as it was when this was made.
class RayTracer {
 public:
  explicit RayTracer(const Scene& scene);
  ~RayTracer();
  RayTracer(const RayTracer&) = delete;
  RayTracer& operator=(const RayTracer&) = delete;

  const Scene& scene() const { return scene_; }

  // Coherent: the rays start together and go about the same way.
  void intersect(const Rays8& rays, bool coherent, Hits8& hits) const;

  // Bit i is set where ray i meets something.
  std::uint8_t occluded(const Rays8& rays) const;

  SurfacePoint surface_point(const Hit& hit) const;

  // The plane of a triangle, n . x = d, n of any length.
  struct Plane {
    Eigen::Vector3d normal;
    double offset;
  };
  const Plane& plane(std::uint32_t triangle) const { return facets_[triangle].plane; }

  // The t at which a ray meets the plane of the triangle, in double precision: the t of a hit is single.
  double exact_t(std::uint32_t triangle, const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& direction) const {
    const auto& [normal, offset] = plane(triangle);
    return (offset - normal.dot(origin)) / normal.dot(direction);
  }

 private:
  struct Accelerator;
  Hit hit_of_primitive(std::uint32_t primitive, float t, float weight1, float weight2) const;
  // All there is to know of a triangle, side by side: normal, u, v and light of the first corner, and what is
  // added to them on the way to the two others.
  struct Facet {
    std::array<float, 8> at_first, to_second, to_third;
    Plane plane;
    std::uint32_t material;
  };
  static Facet facet_of(const Scene& scene, std::size_t triangle);

  const Scene& scene_;
  std::unique_ptr<Accelerator> accelerator_;
  std::vector<Facet> facets_;  // of each triangle
};

}  // namespace framewise
