// Random scenes of a few boxes, and operations on them.
#pragma once

#include <gtest/gtest.h>

#include "ops/operations/perform.h"
#include "support/random_shapes.h"
#include "support/solids.h"

namespace trivet::test {

inline constexpr int kNumBoxes = 5;

/// A board on the floor and some boxes, in a pile if `seed` says so; the last one is not placed.
inline Scene random_scene(Random& random) {
  Scene scene;
  const ObjectId board = scene.add(object_of("board", box_triangles(Vec3(0.5, 0.5, 0.02)), true));
  EXPECT_TRUE(stand(scene, board, {{}, Vec3(0, 0, 0.03)}).ok());
  for (int i = 0; i < kNumBoxes; ++i) {
    const Vec3 half(random.uniform(0.03, 0.1), random.uniform(0.03, 0.1), 0.05);
    const std::string name = "box" + std::to_string(i);
    const ObjectId id = scene.add(object_of(name, box_triangles(half)));
    if (i + 1 == kNumBoxes) break;
    const Vec3 from(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.8);
    put(scene, id, {random.rotation(), from});
  }
  return scene;
}

inline PushOperation push_of(const std::string& name, bool release, const Vec2& direction,
                             double distance) {
  PushOperation push;
  push.object = name;
  push.settle_left = release;
  push.direction = direction;
  push.distance = distance;
  return push;
}

inline Operation random_operation(Random& random) {
  const std::string name = "box" + std::to_string(random.integer(0, kNumBoxes - 1));
  const Vec3 from(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.8);
  const bool release = random.integer(0, 1) == 1;
  switch (random.integer(0, 6)) {
    case 0:
      return PutOperation{{name, release}, {random.rotation(), from}, {}};
    case 1:
      return push_of(name, release, Vec2(random.uniform(-1, 1), 1), 0.1);
    case 2:
      return TranslateOperation{{{name, release}}, Vec3(0.05, 0, 0.1), false, release};
    case 3:
      return RotateOperation{{{name, release}}, random.direction(), 40, {}, true};
    case 4:
      return DeleteOperation{{name, release}};
    case 5:
      return UnplaceOperation{{name, release}};
    default:
      return DuplicateOperation{name, "copy"};
  }
}

/// Which of up to `most` allocations fail: all of few, some of many.
inline std::vector<std::int64_t> chosen(std::int64_t num, std::int64_t most, Random& random) {
  std::vector<std::int64_t> out;
  for (std::int64_t n = 0; n < num; ++n)
    if (num <= most || random.integer(0, static_cast<int>(num / most)) == 0) out.push_back(n);
  return out;
}

}  // namespace trivet::test
