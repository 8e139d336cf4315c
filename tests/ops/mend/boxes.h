// Scenes of boxes at places, and what is true of a scene.
#pragma once

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "support/solids.h"

namespace trivet::test {

inline Mesh box_of(const Vec3& half) {
  std::vector<Triangle> triangles;
  const auto corner = [&](int i) {
    return Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                i & 4 ? half.z() : -half.z());
  };
  for (const std::array<int, 4>& q :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    triangles.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
    triangles.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
  }
  return weld(triangles);
}

/// Boxes at places, on a floor.
struct Boxes {
  Scene scene;
  std::vector<ObjectId> ids;

  ObjectId add(const std::string& name, const Vec3& half, const Vec3& at, bool fixed = false,
               const Rotation& rotation = {}) {
    return add(name, box_of(half), at, fixed, rotation);
  }
  ObjectId add(const std::string& name, Mesh mesh, const Vec3& at, bool fixed = false,
               const Rotation& rotation = {}) {
    auto model = std::make_shared<Model>();
    model->mesh = std::move(mesh);
    Object object;
    object.name = name;
    object.shape = make_shape(model->mesh);
    object.model = std::move(model);
    object.fixed = fixed;
    object.pose = {rotation, at};
    object.placed = true;
    ids.push_back(scene.add(std::move(object)));
    return ids.back();
  }
  Vec3 at(ObjectId id) const { return scene.at(id).pose.translation; }
};

inline bool is_true(const Scene& given) {
  Scene scene = given;
  update_contacts(scene);
  return check_scene(scene).ok();
}

inline bool same_bits(const Scene& a, const Scene& b) {
  for (const ObjectId id : a.ids()) {
    const Pose &p = a.at(id).pose, &q = b.at(id).pose;
    if (p.translation != q.translation || p.rotation.w != q.rotation.w ||
        p.rotation.x != q.rotation.x || p.rotation.y != q.rotation.y ||
        p.rotation.z != q.rotation.z)
      return false;
  }
  return true;
}

}  // namespace trivet::test
