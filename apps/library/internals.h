// The types behind the interface of include/trivet, and conversions between the two.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

#include "core/base/error.h"
#include "core/index/shape.h"
#include "core/model/model.h"
#include "core/motion/pose.h"
#include "trivet/base.h"
#include "trivet/geometry.h"
#include "trivet/model.h"

#ifndef TRIVET_IMPLEMENTATION
#error "TRIVET_IMPLEMENTATION is to be defined: both sets of types are seen here"
#endif

namespace trivet::v0 {

struct Shape::Internal {
  std::shared_ptr<const trivet::Shape> shape;
};

struct Model::Internal {
  std::shared_ptr<const trivet::Model> model;
  std::string path;  // the model itself has none: scene files keep its geometry
  std::vector<std::string> notes;
};

/// Calls f(); errors behind the interface become those of the interface.
template <class F>
auto guarded(F&& f) {
  try {
    return std::forward<F>(f)();
  } catch (const trivet::Error& error) {
    throw Error(error.kind() == trivet::Error::Kind::BadInput ? Error::Kind::BadInput
                                                              : Error::Kind::Environment,
                error.what());
  }
}

inline trivet::Vec3 inner(const Vec3& v) { return {v.x, v.y, v.z}; }
inline trivet::Vec2 inner(const Vec2& v) { return {v.x, v.y}; }
inline Vec3 outer(const trivet::Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec2 outer(const trivet::Vec2& v) { return {v.x(), v.y()}; }
inline Box outer(const Aabb& box) { return {outer(box.lower), outer(box.upper)}; }

/// @throws trivet::Error (BadInput) for a quaternion of length 0 or one that is not finite.
Rotation inner(const Quaternion& q);
trivet::Pose inner(const Pose& pose);
Pose outer(const trivet::Pose& pose);

}  // namespace trivet::v0
