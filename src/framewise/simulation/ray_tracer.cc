// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/ray_tracer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "framewise/simulation/embree_api.h"

namespace framewise {
namespace {

// Embree reads 16 bytes at each vertex position.
static_assert(sizeof(Vertex) >= 16 && offsetof(Vertex, position) == 0);

// Eight lanes, all switched on; a lane whose far lies before its near meets nothing.
alignas(32) constexpr std::array<int, 8> kAllLanes = {-1, -1, -1, -1, -1, -1, -1, -1};

template <typename Lanes>
void copy_rays(const Rays8& from, Lanes& to) {
  for (int i = 0; i < 8; ++i) {
    to.org_x[i] = from.origin_x[i];
    to.org_y[i] = from.origin_y[i];
    to.org_z[i] = from.origin_z[i];
    to.dir_x[i] = from.direction_x[i];
    to.dir_y[i] = from.direction_y[i];
    to.dir_z[i] = from.direction_z[i];
    to.tnear[i] = from.near[i];
    to.tfar[i] = from.far[i];
    to.time[i] = 0;
    to.mask[i] = ~0u;
    to.id[i] = 0;
    to.flags[i] = 0;
  }
}

// Triangles as Embree meets them: those of no flat grid one by one, then two for each grid.
struct MetTriangles {
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint32_t> single;  // which triangle of the scene each of the first is
};

MetTriangles met_triangles(const Scene& scene) {
  MetTriangles met;
  std::uint32_t next = 0;
  const auto add_single_up_to = [&](std::uint32_t end) {
    for (; next < end; ++next) {
      met.corners.push_back(scene.triangles[next]);
      met.single.push_back(next);
    }
  };
  for (const FlatGrid& grid : scene.flat_grids) {
    add_single_up_to(grid.first_triangle);
    next += 2 * (grid.nu - 1) * (grid.nv - 1);
  }
  add_single_up_to(static_cast<std::uint32_t>(scene.triangles.size()));
  for (const FlatGrid& grid : scene.flat_grids) {
    const std::uint32_t a = grid.first_vertex, b = a + grid.nu - 1, c = a + grid.nu * (grid.nv - 1),
                        d = c + grid.nu - 1;
    met.corners.push_back({a, b, d});
    met.corners.push_back({a, d, c});
  }
  return met;
}

// Where in its cells a flat grid is met: below its diagonal or above.
Hit hit_of_cell(const FlatGrid& grid, bool above, const Hit& hit) {
  const float across = static_cast<float>(grid.nu - 1), up = static_cast<float>(grid.nv - 1);
  const float x = across * (above ? hit.weight1 : hit.weight1 + hit.weight2),
              y = up * (above ? hit.weight1 + hit.weight2 : hit.weight2);
  const std::uint32_t i = static_cast<std::uint32_t>(std::clamp(x, 0.0f, across - 1)),
                      j = static_cast<std::uint32_t>(std::clamp(y, 0.0f, up - 1)),
                      cell = j * (grid.nu - 1) + i;
  const float s = x - static_cast<float>(i), t = y - static_cast<float>(j);
  if (s >= t) return {grid.first_triangle + 2 * cell, hit.t, s - t, t};
  return {grid.first_triangle + 2 * cell + 1, hit.t, s, t - s};
}

}  // namespace

void Rays8::set(int i, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near_t,
                float far_t) {
  origin_x[i] = origin.x();
  origin_y[i] = origin.y();
  origin_z[i] = origin.z();
  direction_x[i] = direction.x();
  direction_y[i] = direction.y();
  direction_z[i] = direction.z();
  near[i] = near_t;
  far[i] = far_t;
}

struct RayTracer::Accelerator {
  std::vector<std::array<std::uint32_t, 3>> corners;  // Embree reads them in place
  std::vector<std::uint32_t> single;                  // see MetTriangles
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Accelerator() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

RayTracer::RayTracer(const Scene& scene) : scene_(scene), accelerator_(std::make_unique<Accelerator>()) {
  MetTriangles met = met_triangles(scene);
  accelerator_->corners = std::move(met.corners);
  accelerator_->single = std::move(met.single);
  accelerator_->device = rtcNewDevice(nullptr);
  if (!accelerator_->device)
    throw std::runtime_error("Embree gives no device (error " + std::to_string(rtcGetDeviceError(nullptr)) +
                             ")");
  accelerator_->scene = rtcNewScene(accelerator_->device);
  rtcSetSceneFlags(accelerator_->scene, RTC_SCENE_FLAG_ROBUST);

  RTCGeometry mesh = rtcNewGeometry(accelerator_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene.vertices.data(), 0,
                             sizeof(Vertex), scene.vertices.size());
  const auto& corners = accelerator_->corners;
  rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners.data(), 0,
                             sizeof(corners[0]), corners.size());
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(accelerator_->scene, mesh);
  rtcReleaseGeometry(mesh);
  // Built on one thread: where two triangles share an edge, which of them a ray meets depends on the tree. A
  // device of "threads=1" would do, but it holds all of TBB to one thread as long as it lives.
  tbb::task_arena(1).execute([&] { rtcJoinCommitScene(accelerator_->scene); });
  if (const RTCError error = rtcGetDeviceError(accelerator_->device); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the scene (error " + std::to_string(error) + ")");
  facets_.reserve(scene.triangles.size());
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) facets_.push_back(facet_of(scene, i));
}

RayTracer::Facet RayTracer::facet_of(const Scene& scene, std::size_t triangle) {
  const auto& corner = scene.triangles[triangle];
  const auto values = [&](int k) -> std::array<float, 8> {
    const Vertex& v = scene.vertices[corner[k]];
    return {v.normal.x(), v.normal.y(), v.normal.z(), v.uv.x(), v.uv.y(), v.light.r, v.light.g, v.light.b};
  };
  Facet facet{values(0), values(1), values(2), {}, scene.material_of_triangle[triangle]};
  for (int i = 0; i < 8; ++i) {
    facet.to_second[i] -= facet.at_first[i];
    facet.to_third[i] -= facet.at_first[i];
  }
  const Eigen::Vector3d a = scene.vertices[corner[0]].position.cast<double>();
  const Eigen::Vector3d b = scene.vertices[corner[1]].position.cast<double>();
  const Eigen::Vector3d c = scene.vertices[corner[2]].position.cast<double>();
  facet.plane.normal = (b - a).cross(c - a);
  facet.plane.offset = facet.plane.normal.dot(a);
  return facet;
}

RayTracer::~RayTracer() = default;

void RayTracer::intersect(const Rays8& rays, bool coherent, Hits8& hits) const {
  RTCRayHit8 query;
  copy_rays(rays, query.ray);
  for (int i = 0; i < 8; ++i) query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect8(kAllLanes.data(), accelerator_->scene, &query, coherent);
  for (int i = 0; i < 8; ++i) {
    hits.triangle[i] = kNoHit;
    if (query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
      hits.set(i, hit_of_primitive(query.hit.primID[i], query.ray.tfar[i], query.hit.u[i], query.hit.v[i]));
  }
}

Hit RayTracer::hit_of_primitive(std::uint32_t primitive, float t, float weight1, float weight2) const {
  const auto& single = accelerator_->single;
  if (primitive < single.size()) return {single[primitive], t, weight1, weight2};
  const auto half = primitive - static_cast<std::uint32_t>(single.size());
  return hit_of_cell(scene_.flat_grids[half / 2], half % 2 == 1, {primitive, t, weight1, weight2});
}

std::uint8_t RayTracer::occluded(const Rays8& rays) const {
  RTCRay8 query;
  copy_rays(rays, query);
  embree::occluded8(kAllLanes.data(), accelerator_->scene, &query);
  std::uint8_t mask = 0;
  // Embree marks an occluded ray with tfar = -infinity.
  for (int i = 0; i < 8; ++i)
    if (query.tfar[i] < 0 && rays.far[i] >= rays.near[i]) mask |= static_cast<std::uint8_t>(1u << i);
  return mask;
}

SurfacePoint RayTracer::surface_point(const Hit& hit) const {
  const Facet& facet = facets_[hit.triangle];
  std::array<float, 8> x;
  for (int i = 0; i < 8; ++i)
    x[i] = facet.at_first[i] + hit.weight1 * facet.to_second[i] + hit.weight2 * facet.to_third[i];
  SurfacePoint point{&scene_.materials[facet.material], {x[0], x[1], x[2]}, x[3], x[4], {x[5], x[6], x[7]}};
  if (!scene_.tints.empty()) {
    const auto& corner = scene_.triangles[hit.triangle];
    point.tint = scene_.tints[corner[0]] * (1 - hit.weight1 - hit.weight2) +
                 scene_.tints[corner[1]] * hit.weight1 + scene_.tints[corner[2]] * hit.weight2;
  }
  return point;
}

}  // namespace framewise
