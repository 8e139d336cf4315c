// Crossing faces and blocking faces, compared with all pairs of faces.
#include "core/base/tunables.h"
#include "core/contact/triangle_distance.h"
#include "core/exact/predicates.h"
#include "ops/base/stopwatch.h"
#include "ops/operations/live_move.h"
#include "ops/operations/stage.h"
#include "ops/placement/interference.h"
#include "ops/placement/neighbourhood.h"
#include "support/effort.h"

namespace trivet {
namespace {

using namespace test;

constexpr int kNoLimit = std::numeric_limits<int>::max();
using Faces = std::map<std::string, std::vector<Index>>;

Faces named(const Scene& scene, const InterferingFaces& found) {
  Faces out;
  for (const FacesOfObject& of : found.objects) out[scene.at(of.id).name] = of.faces;
  return out;
}

Triangle world_triangle(const Object& object, const Pose& pose, Index face) {
  Triangle t = object.shape->mesh.triangle(face);
  const Affine world = world_from_object(pose, object.up, object.scale);
  for (Vec3& p : t) p = world.apply(p);
  return t;
}

Index num_faces(const Object& object) {
  return static_cast<Index>(object.shape->mesh.triangles.size());
}

void sort_faces(Faces& faces) {
  for (auto& [name, of] : faces) {
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
  }
}

Faces crossing_by_brute_force(const Scene& scene, const Placement& moved) {
  Faces out;
  const Object& a = scene.at(moved.id);
  for (Index i = 0; i < num_faces(a); ++i) {
    const Triangle t = world_triangle(a, moved.pose, i);
    for (const Vec3& p : t)
      if (scene.floor && p.z() < 0) out[a.name].push_back(i);
    for (const ObjectId id : scene.ids()) {
      const Object& b = scene.at(id);
      if (id == moved.id || !b.placed) continue;
      for (Index j = 0; j < num_faces(b); ++j)
        if (triangles_intersect(t, world_triangle(b, b.pose, j)))
          out[a.name].push_back(i), out[b.name].push_back(j);
    }
  }
  sort_faces(out);
  return out;
}

/// A bumpy ball among boxes, a post and another ball.
struct Heap : Stage {
  Heap() {
    fix("table", box_triangles(Vec3(0.6, 0.6, 0.1)), {0, 0, 0.1 + 1e-5});
    fix("post", cylinder(0.05, 0.8, 24), {0.25, 0.1, 0.7});
    fix("ball", moved(ball(0.15, 10, 16), {0, 0, 0}), {-0.25, 0.1, 0.5});
    put("stone", scaled(bumpy_sphere(9, 14, 0.2, 4), 0.12), {0, -0.3, 1});
  }
  static Triangles scaled(Triangles triangles, double by) {
    for (Triangle& t : triangles)
      for (Vec3& p : t) p *= by;
    return outward(triangles);
  }
};

TEST(Interference, FindsAllCrossingFaces) {
  const unsigned seed = 20261122;
  SCOPED_TRACE(seed);
  Random random(seed);
  const Heap heap;
  const ObjectId stone = *heap.scene.find("stone");
  int num_crossing = 0, num_floor = 0;
  const int num = with_effort(200);
  for (int i = 0; i < num; ++i) {
    const Placement moved{stone, {random.rotation(), Vec3(0, 0, 0.45) + random.in_cube(0.5)}};
    const Faces found = named(heap.scene, crossing_faces(heap.scene, {&moved, 1}, kNoLimit));
    EXPECT_EQ(found, crossing_by_brute_force(heap.scene, moved)) << i;
    num_crossing += !found.empty();
    num_floor += moved.pose.translation.z() < 0.1 && found.count("stone");
  }
  EXPECT_GT(num_crossing, num / 3);
  EXPECT_LT(num_crossing, num);
  if (num >= 100) {
    EXPECT_GT(num_floor, 0);
  }
}

TEST(Interference, FindsExactlyTouchingFacesOfInvalidObjects) {
  Heap heap;
  heap.put("box", box_triangles(Vec3(0.05, 0.05, 0.05)), {0.1, 0.4, 1});
  // Its lower face in the table's upper one, coplanar: touching counts.
  const double top = heap.at("table").world_from_object().apply(Vec3(0, 0, 0.1f)).z();
  TranslateOperation down;
  down.object = "box";
  down.free = true;
  down.by = Vec3(0, 0, top + 0.05f - heap.position("box").z());
  ASSERT_TRUE(perform(heap.scene, down).ok());
  ASSERT_EQ(heap.at("box").state, ObjectState::Invalid);
  const Placement moved{*heap.scene.find("box"), heap.at("box").pose};
  const InterferingFaces found = crossing_faces(heap.scene, {&moved, 1});
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(named(heap.scene, found), crossing_by_brute_force(heap.scene, moved));
  EXPECT_EQ(named(heap.scene, found).count("table"), 1u);
}

TEST(Interference, ReportsReachedLimit) {
  const Heap heap;
  const Placement moved{*heap.scene.find("stone"), {{}, heap.position("ball") + Vec3(0.1, 0, 0)}};
  const InterferingFaces all = crossing_faces(heap.scene, {&moved, 1}, kNoLimit);
  const InterferingFaces some = crossing_faces(heap.scene, {&moved, 1}, 10);
  EXPECT_TRUE(all.complete);
  EXPECT_FALSE(some.complete);
  ASSERT_EQ(all.objects.size(), 2u);
  EXPECT_LT(some.objects.empty() ? 0 : some.objects[0].faces.size(), all.objects[0].faces.size());
}

// Two balls of 160,000 faces at nearly the same place: prints the cost of the query.
TEST(Interference, StaysWithinLimitOfPairs) {
  Stage stage;
  const ObjectId a = stage.fix("a", ball(0.2, 200, 400), {0, 0, 0.5});
  const ObjectId b = stage.scene.add(object_of("b", ball(0.2, 200, 400)));
  const Placement moved{b, {{}, Vec3(0.01, 0, 0.5)}};
  Stopwatch watch;
  const InterferingFaces crossing = crossing_faces(stage.scene, {&moved, 1});
  const double ms = watch.milliseconds();
  const InterferingFaces near = blocking_faces(stage.scene, {&moved, 1}, {a, Vec3::Zero()}, 1e-5);
  std::printf("%d pairs of fine faces: crossing %.2f ms, blocking %.2f ms\n", kMostFacePairs, ms,
              watch.milliseconds() - ms);
  for (const InterferingFaces& found : {crossing, near}) {
    EXPECT_FALSE(found.complete);
    ASSERT_EQ(found.objects.size(), 2u);
    EXPECT_GT(found.objects[0].faces.size(), 20u);
  }
}

/// All pairs within the tolerance, among equal ones the one nearest to the stop; of each object
/// those facing it, if any.
Faces blocking_by_brute_force(const Scene& scene, const std::vector<Placement>& moved,
                              const Blockage& blockage, double tolerance) {
  struct Face {
    std::string name;
    Index face;
    bool looks_there;
  };
  struct Pair {
    Face a, b;
    Vec3 towards;
    double squared_distance;
  };
  const auto looks_along = [](const Triangle& t, const Vec3& direction) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    return std::abs(normal.dot(direction)) > 0.1 * normal.norm();
  };
  std::vector<Pair> near;
  const Object& b = scene.at(blockage.by.object());
  for (const Placement& placement : moved) {
    const Object& a = scene.at(placement.id);
    for (Index i = 0; i < num_faces(a); ++i)
      for (Index j = 0; j < num_faces(b); ++j) {
        const Triangle s = world_triangle(a, placement.pose, i), t = world_triangle(b, b.pose, j);
        const ClosestPoints c = closest_points(s, t);
        if (c.distance > tolerance) continue;
        const Vec3 towards = (c.point_a - c.point_b) / c.distance;
        near.push_back({{a.name, i, looks_along(s, towards)},
                        {b.name, j, looks_along(t, towards)},
                        towards,
                        (c.point_b - blockage.at).squaredNorm()});
      }
  }
  const auto first = std::min_element(near.begin(), near.end(), [](const Pair& p, const Pair& q) {
    return p.squared_distance < q.squared_distance;
  });
  Faces all, looking;
  for (const Pair& p : near)
    for (const Face& face : {p.a, p.b}) {
      if (p.towards.dot(first->towards) < 0.5) continue;
      all[face.name].push_back(face.face);
      if (face.looks_there) looking[face.name].push_back(face.face);
    }
  for (const auto& [name, faces] : looking) all[name] = faces;
  sort_faces(all);
  return all;
}

TEST(Interference, FindsAllBlockingFaces) {
  const unsigned seed = 20261123;
  SCOPED_TRACE(seed);
  Random random(seed);
  Heap heap;
  const double tolerance = kContactTolerance * heap.clearance();
  int num_blocked = 0;
  const int num = with_effort(120);
  for (int i = 0; i < num; ++i) {
    SCOPED_TRACE(i);
    TranslateOperation move;
    move.object = "stone";
    LiveMove live(heap.scene, move, {});
    live.follow(Vec3(0, 0, 0.3) + random.in_cube(0.2));
    live.follow(Vec3(0, 0.4, 0.2) + random.in_cube(0.4));
    const OperationResult& result = live.result();
    if (result.end != OperationResult::End::Blocked) continue;
    ++num_blocked;
    const Blockage blockage{*result.blocked_by.support, result.blocked_at};
    const InterferingFaces found =
        blocking_faces(heap.scene, live.placements(), blockage, tolerance, kNoLimit);
    ASSERT_EQ(found.objects.size(), 2u) << "of the moving object and of the one that stopped it";
    EXPECT_EQ(named(heap.scene, found),
              blocking_by_brute_force(heap.scene, live.placements(), blockage, tolerance));
  }
  EXPECT_GT(num_blocked, num / 4);
}

// A box that lies on a step and is pushed against its wall: of a single object that both carries
// and stops it, the wall is shown.
TEST(Interference, OmitsSupportingFacesOfBlocker) {
  Stage stage;
  stage.fix("step",
            joined(box_triangles(Vec3(0.5, 0.5, 0.1)),
                   moved(box_triangles(Vec3(0.1, 0.5, 0.2)), {0.4, 0, 0.35})),
            {0, 0, 0.1 + 1e-5});
  stage.put("box", box_triangles(Vec3(0.1, 0.1, 0.1)), {0, 0, 1});
  PushOperation push;
  push.object = "box";
  LiveMove live(stage.scene, push, {});
  live.follow(Vec3(0.45, 0, 0));
  ASSERT_EQ(live.result().blocked_by.name, "step");
  const Blockage blockage{*live.result().blocked_by.support, live.result().blocked_at};
  const double tolerance = kContactTolerance * stage.clearance();
  const InterferingFaces found =
      blocking_faces(stage.scene, live.placements(), blockage, tolerance);
  ASSERT_EQ(found.objects.size(), 2u);
  for (const FacesOfObject& of : found.objects) {
    const Object& object = stage.scene.at(of.id);
    EXPECT_LE(of.faces.size(), 2u) << object.name;
    for (const Index face : of.faces) {
      const Triangle t = object.shape->mesh.triangle(face);
      EXPECT_GT(std::abs((t[1] - t[0]).cross(t[2] - t[0]).normalized().x()), 0.99) << object.name;
    }
  }
}

TEST(Interference, HandlesFloor) {
  Stage stage;
  stage.put("box", box_triangles(Vec3(0.1, 0.1, 0.1)), {0, 0, 1});
  const std::vector<Placement> there{{*stage.scene.find("box"), stage.at("box").pose}};
  const double tolerance = kContactTolerance * stage.clearance();
  const InterferingFaces found =
      blocking_faces(stage.scene, there, {Support::floor(), Vec3::Zero()}, tolerance);
  ASSERT_EQ(found.objects.size(), 1u);
  EXPECT_GE(found.objects[0].faces.size(), 2u) << "all with a corner there";
  const ObjectId none{99, 1};
  EXPECT_TRUE(blocking_faces(stage.scene, there, {none, Vec3::Zero()}, tolerance).empty());
  EXPECT_TRUE(crossing_faces(stage.scene, there).empty());
}

}  // namespace
}  // namespace trivet
