// Embree 3.12 to 3.13 and 4: what differs between them is here. Private: only this folder uses it.
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <memory>
#include <type_traits>

namespace trivet {

#if RTC_VERSION_MAJOR != 3 && RTC_VERSION_MAJOR != 4
#error "Trivet supports Embree 3 and 4; check embree.h before adding another version"
#endif

/// Device of the whole program; made when first needed.
/// @throws Error (Environment) when Embree cannot start.
RTCDevice embree_device();

struct ReleaseEmbree {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <class Handle>
using EmbreePointer = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseEmbree>;

/// A ray's query, of which callbacks get the address; derive from it to tell them more.
#if RTC_VERSION_MAJOR == 3
using EmbreeRayQuery = RTCIntersectContext;
#else
using EmbreeRayQuery = RTCRayQueryContext;
#endif

/// Calls the intersection function of user geometries for the primitives whose boxes the ray meets.
inline void find_hits(RTCScene scene, EmbreeRayQuery& query, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR == 3
  rtcInitIntersectContext(&query);
  rtcIntersect1(scene, &query, &ray);
#else
  rtcInitRayQueryContext(&query);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query;
  rtcIntersect1(scene, &ray, &arguments);
#endif
}

/// The nearest hits of eight rays. @param valid  -1: traced, 0: not.
inline void intersect_packet(RTCScene scene, const int* valid, EmbreeRayQuery& query,
                             RTCRayHit8& rays) {
#if RTC_VERSION_MAJOR == 3
  rtcInitIntersectContext(&query);
  rtcIntersect8(valid, scene, &query, &rays);
#else
  rtcInitRayQueryContext(&query);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query;
  rtcIntersect8(valid, scene, &rays, &arguments);
#endif
}

/// Tests eight rays for occlusion: tfar of those that meet anything becomes negative.
inline void occlude_packet(RTCScene scene, const int* valid, EmbreeRayQuery& query, RTCRay8& rays) {
#if RTC_VERSION_MAJOR == 3
  rtcInitIntersectContext(&query);
  rtcOccluded8(valid, scene, &query, &rays);
#else
  rtcInitRayQueryContext(&query);
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &query;
  rtcOccluded8(valid, scene, &rays, &arguments);
#endif
}

/// @throws Error (Environment) if Embree has failed since the last call; `what` was being done.
void throw_embree_error(const char* what);

}  // namespace trivet
