// Scenes and arrangements of boxes for the tests.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/base/hash.h"
#include "core/scene/transaction.h"
#include "ops/arrange/arrange.h"
#include "ops/check/check.h"
#include "ops/stability/stability.h"
#include "support/solids.h"

namespace trivet::test {

/// Names, poses and what is placed, as one number.
inline std::uint64_t state_of(const Scene& scene) {
  Hash hash;
  for (const ObjectId id : scene.ids()) {
    const Object& o = scene.at(id);
    hash.add(o.name).add(std::uint64_t{o.placed});
    for (const double v :
         {o.pose.rotation.w, o.pose.rotation.x, o.pose.rotation.y, o.pose.rotation.z,
          o.pose.translation.x(), o.pose.translation.y(), o.pose.translation.z()})
      hash.add(v);
  }
  return hash.value();
}

/// A scene, what stands in it, and an arrangement in the making.
class Stage {
 public:
  Scene scene;
  Arrangement arrangement;

  /// Never moves, with its model's origin here.
  void fix(const std::string& name, const Triangles& triangles, const Vec3& at = Vec3::Zero()) {
    Object object = object_of(name, triangles, true);
    object.pose.translation = at;
    object.placed = true;
    object.state = ObjectState::Fixed;
    scene.add(std::move(object));
  }
  void add(const std::string& name, const Triangles& triangles, Thing thing = {}) {
    scene.add(object_of(name, triangles));
    thing.object = name;
    arrangement.things.push_back(thing);
  }
  void add_cube(const std::string& name, double edge = 0.1) {
    add(name, box_between(Vec3(-0.5 * edge, -0.5 * edge, 0), Vec3(0.5 * edge, 0.5 * edge, edge)));
  }
  template <class K>
  Relation& relate(const std::string& a, const std::string& b = "") {
    return relate(a, K(), b);
  }
  Relation& relate(const std::string& a, relations::Kind kind, const std::string& b = "") {
    Relation relation;
    relation.kind = std::move(kind);
    relation.a = a;
    relation.b = b;
    arrangement.relations.push_back(relation);
    return arrangement.relations.back();
  }
  ArrangeResult run(std::uint64_t seed = 1) {
    arrangement.seed = seed;
    return arrange(scene, arrangement, {}, {});
  }
  const Object& at(const std::string& name) const { return scene.at(*scene.find(name)); }
  /// Box of its vertices.
  Aabb box(const std::string& name) const {
    Aabb out;
    for (const Vec3& v : at(name).shape->mesh.vertices)
      out.extend(at(name).world_from_object().apply(v));
    return out;
  }
};

/// Boards 2 cm thick with these upper sides, 0.8 x 0.3 m between two sides.
inline Triangles shelf(const std::vector<double>& boards) {
  const double high = boards.back();
  Triangles out = joined(box_between(Vec3(-0.42, -0.15, 0), Vec3(-0.4, 0.15, high)),
                         box_between(Vec3(0.4, -0.15, 0), Vec3(0.42, 0.15, high)));
  for (const double top : boards)
    out = joined(out, box_between(Vec3(-0.4, -0.15, top - 0.02), Vec3(0.4, 0.15, top)));
  return out;
}

/// A tray with walls 2 cm thick and 3 cm high about this room.
inline Triangles tray(double length, double width) {
  const double x = 0.5 * length, y = 0.5 * width, t = 0.02;
  Triangles out = box_between(Vec3(-x - t, -y - t, 0), Vec3(x + t, y + t, t));
  for (const double side : {-1.0, 1.0}) {
    const Vec3 a(side < 0 ? -x - t : x, -y - t, t), b(side < 0 ? -x : x + t, y + t, t + 0.03);
    const Vec3 c(-x, side < 0 ? -y - t : y, t), d(x, side < 0 ? -y : y + t, t + 0.03);
    out = joined(joined(out, box_between(a, b)), box_between(c, d));
  }
  return out;
}

// All that a finished scene must be, by programs of their own.
inline void expect_true(Stage& stage, const ArrangeResult& result) {
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.placed.size(), stage.arrangement.things.size());
  EXPECT_TRUE(stage.scene.is_consistent());
  const SceneCheck check = check_scene(stage.scene, 1);
  EXPECT_TRUE(check.ok());
  EXPECT_TRUE(stability(stage.scene).stable());
  for (const ArrangeResult::Holds& r : result.relations)
    EXPECT_LE(r.hard ? r.cost : 0, 1) << r.relation;
}

}  // namespace trivet::test
