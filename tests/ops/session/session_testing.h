// A small session of boxes, in memory.
#pragma once

#include "core/scene/fingerprint.h"
#include "ops/session/session.h"
#include "support/same_scene.h"
#include "support/solids.h"

namespace trivet::test {

/// Unplaced boxes "a", "b", "c".
inline Session small_session() {
  Scene scene;
  for (const char* name : {"a", "b", "c"})
    scene.add(object_of(name, box_triangles(Vec3(0.1, 0.1, 0.05))));
  const ModelSource models = [](const std::string& name, const Tessellation&) {
    return Model(*object_of(name, box_triangles(Vec3(0.2, 0.1, 0.1))).model);
  };
  return Session(std::move(scene), {}, models);
}

inline Operation put_at(const std::string& name, double x, double y, double z = 1) {
  PutOperation put;
  put.object = name;
  put.start.translation = Vec3(x, y, z);
  return put;
}

inline AppendOperation append_of(const std::string& name, const std::string& model) {
  AppendOperation append;
  append.object = name;
  append.model = model;
  return append;
}

inline DeleteOperation delete_of(const std::string& name) {
  DeleteOperation operation;
  operation.object = name;
  return operation;
}

}  // namespace trivet::test
