// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#include "framewise/simulation/ray_tracer.h"

#include <tbb/task_arena.h>

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
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Accelerator() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

RayTracer::RayTracer(const Scene& scene) : scene_(scene), accelerator_(std::make_unique<Accelerator>()) {
  accelerator_->device = rtcNewDevice(nullptr);
  if (!accelerator_->device)
    throw std::runtime_error("Embree gives no device (error " + std::to_string(rtcGetDeviceError(nullptr)) +
                             ")");
  accelerator_->scene = rtcNewScene(accelerator_->device);
  rtcSetSceneFlags(accelerator_->scene, RTC_SCENE_FLAG_ROBUST);

  RTCGeometry mesh = rtcNewGeometry(accelerator_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene.vertices.data(), 0,
                             sizeof(Vertex), scene.vertices.size());
  rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, scene.triangles.data(), 0,
                             sizeof(scene.triangles[0]), scene.triangles.size());
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(accelerator_->scene, mesh);
  rtcReleaseGeometry(mesh);
  // Built on one thread: where two triangles share an edge, which of them a ray meets depends on the tree. A
  // device of "threads=1" would do, but it holds all of TBB to one thread as long as it lives.
  tbb::task_arena(1).execute([&] { rtcJoinCommitScene(accelerator_->scene); });
  if (const RTCError error = rtcGetDeviceError(accelerator_->device); error != RTC_ERROR_NONE)
    throw std::runtime_error("Embree cannot build the scene (error " + std::to_string(error) + ")");
  planes_.reserve(scene.triangles.size());
  for (const auto& corner : scene.triangles) {
    const Eigen::Vector3d a = scene.vertices[corner[0]].position.cast<double>();
    const Eigen::Vector3d b = scene.vertices[corner[1]].position.cast<double>();
    const Eigen::Vector3d c = scene.vertices[corner[2]].position.cast<double>();
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    planes_.push_back({normal, normal.dot(a)});
  }
}

RayTracer::~RayTracer() = default;

void RayTracer::intersect(const Rays8& rays, bool coherent, Hits8& hits) const {
  RTCRayHit8 query;
  copy_rays(rays, query.ray);
  for (int i = 0; i < 8; ++i) query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect8(kAllLanes.data(), accelerator_->scene, &query, coherent);
  for (int i = 0; i < 8; ++i) {
    hits.triangle[i] = query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kNoHit : query.hit.primID[i];
    hits.t[i] = query.ray.tfar[i];
    hits.weight1[i] = query.hit.u[i];
    hits.weight2[i] = query.hit.v[i];
  }
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
  const auto& [triangle, t, weight1, weight2] = hit;
  const auto& corner = scene_.triangles[triangle];
  const Vertex &a = scene_.vertices[corner[0]], &b = scene_.vertices[corner[1]],
               &c = scene_.vertices[corner[2]];
  const float weight0 = 1 - weight1 - weight2;
  const Eigen::Vector2f uv = weight0 * a.uv + weight1 * b.uv + weight2 * c.uv;
  SurfacePoint point{&scene_.materials[scene_.material_of_triangle[triangle]],
                     weight0 * a.normal + weight1 * b.normal + weight2 * c.normal, uv.x(), uv.y(),
                     a.light * weight0 + b.light * weight1 + c.light * weight2};
  if (!scene_.tints.empty())
    point.tint = scene_.tints[corner[0]] * weight0 + scene_.tints[corner[1]] * weight1 +
                 scene_.tints[corner[2]] * weight2;
  return point;
}

// Möller, Trumbore, Fast, minimum storage ray-triangle intersection, JGT 1997.
Hit RayTracer::meet_plane(std::uint32_t triangle, const Eigen::Vector3f& origin,
                          const Eigen::Vector3f& direction) const {
  const auto& corner = scene_.triangles[triangle];
  const Eigen::Vector3f& a = scene_.vertices[corner[0]].position;
  const Eigen::Vector3f edge1 = scene_.vertices[corner[1]].position - a,
                        edge2 = scene_.vertices[corner[2]].position - a, from_a = origin - a;
  const Eigen::Vector3f p = direction.cross(edge2), q = from_a.cross(edge1);
  const float scale = 1 / edge1.dot(p);
  return {triangle, scale * edge2.dot(q), scale * from_a.dot(p), scale * direction.dot(q)};
}

double RayTracer::exact_t(std::uint32_t triangle, const Eigen::Vector3d& origin,
                          const Eigen::Vector3d& direction) const {
  const auto& [normal, offset] = planes_[triangle];
  return (offset - normal.dot(origin)) / normal.dot(direction);
}

}  // namespace framewise
