// SPDX-FileCopyrightText: 2026 The Framewise authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The calls whose form differs between Embree 3 (Debian 12, Ubuntu 22.04) and Embree 4 (Ubuntu 24.04).
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace framewise::embree {

#if RTC_VERSION_MAJOR >= 4

inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8* rays, bool coherent) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  rtcIntersect8(valid, scene, rays, &arguments);
}

inline void occluded8(const int* valid, RTCScene scene, RTCRay8* rays) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  rtcOccluded8(valid, scene, rays, &arguments);
}

#else

inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8* rays, bool coherent) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcIntersect8(valid, scene, &context, rays);
}

inline void occluded8(const int* valid, RTCScene scene, RTCRay8* rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded8(valid, scene, &context, rays);
}

#endif

}  // namespace framewise::embree
