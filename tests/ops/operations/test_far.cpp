// Distant objects, and small objects in a large scene: the clearance becomes too coarse. A small
// scene that is far out as a whole is as good as one that is near.
#include "core/base/tunables.h"
#include "core/io/atomic_file.h"
#include "core/io/mesh_model.h"
#include "core/io/read_model.h"
#include "core/model/exported_floats.h"
#include "ops/files/report/scene_file.h"
#include "ops/placement/clearance.h"
#include "stage.h"

namespace trivet::test {
namespace {

constexpr double kFar[] = {1e8, 1e9, 1e14};
constexpr const char* kSays = "is too coarse for \"cup\" of 0.1732 m; accepted: coordinates and";

struct Table : Stage {
  Table() {
    fix("table", box_triangles(Vec3(0.5, 0.5, 0.05)), Vec3(0, 0, 0.06));
    put("cup", box_triangles(Vec3(0.05, 0.05, 0.05)), Vec3(0, 0, 1));
    put("beside", box_triangles(Vec3(0.1, 0.1, 0.1)), Vec3(2, 0, 1));
  }
};

TEST(Far, RefusesEveryOperationThatLeadsThere) {
  for (const double far : kFar) {
    Table s;
    s.refused(TranslateOperation{{"beside"}, Vec3(far, 0, 0)}, kSays);
    s.refused(TranslateOperation{{"beside"}, Vec3(0, 0, far), true}, kSays);
    s.refused(TranslateOperation{{"beside"}, Vec3(0, -far, 0), false, true}, kSays);
    s.refused(RotateOperation{{"beside"}, Vec3::UnitZ(), 30, Vec3(0, far, 0)}, kSays);
    s.refused(PickUpOperation{{"beside"}, far, {}}, kSays);
    s.refused(PushOperation{{"beside"}, Vec2::UnitX(), far, {}}, kSays);
    s.refused(PutOperation{{"beside"}, Pose{{}, Vec3(far, 0, 1)}, {}}, kSays);
    const ObjectId id = s.scene.add(object_of("k", box_triangles(Vec3(0.1, 0.1, 0.1))));
    const OperationResult stood = stand(s.scene, id, {{}, Vec3(0, far, 1)});
    EXPECT_NE(stood.reason().find(kSays), std::string::npos) << stood.reason();
    EXPECT_EQ(stood.reason().find("\"k\" reaches a coordinate of "), 0u) << stood.reason();
  }
}

// An object that falls from there ends nearby; where double itself is too coarse it is refused.
TEST(Far, AcceptsHighStart) {
  Table s;
  const OperationResult result = s.run(PutOperation{{"beside"}, Pose{{}, Vec3(2, 0, 1e4)}, {}});
  EXPECT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(s.position("beside").z(), 0.1, 1e-5);
  s.run(PutOperation{{"beside"}, Pose{{}, Vec3(2, 0, 1e14)}, {}});
}

TEST(Far, NamesAcceptedRange) {
  Table s;
  const std::string reason =
      perform(s.scene, TranslateOperation{{"beside"}, Vec3(1e9, 0, 0)}).reason();
  const size_t at = reason.find("up to ");
  ASSERT_NE(at, std::string::npos) << reason;
  const double accepted = std::stod(reason.substr(at + 6));
  EXPECT_TRUE(perform(s.scene, TranslateOperation{{"beside"}, Vec3(0.99 * accepted, 0, 0)}).ok());
  s.refused(TranslateOperation{{"beside"}, Vec3(0.03 * accepted, 0, 0)}, kSays);
  EXPECT_TRUE(perform(s.scene, TranslateOperation{{"beside"}, Vec3(-0.5 * accepted, 0, 0)}).ok());
}

// The same distance is acceptable for large objects.
TEST(Far, AcceptsLargeScenes) {
  Stage city;
  city.fix("ground", box_triangles(Vec3(5e4, 5e4, 10)), Vec3(0, 0, 11));
  city.put("tower", box_triangles(Vec3(20, 20, 100)), Vec3(0, 0, 500));
  EXPECT_TRUE(city.run(TranslateOperation{{"tower"}, Vec3(0, 1e4, 10)}).ok());
  Stage hall;
  hall.fix("floor of 1 km", box_triangles(Vec3(500, 500, 0.5)), Vec3(0, 0, 0.6));
  hall.put("cup of 10 cm", box_triangles(Vec3(0.05, 0.05, 0.05)), Vec3(100, 0, 3));
  EXPECT_TRUE(hall.run(TranslateOperation{{"cup of 10 cm"}, Vec3(0, 100, 0.1)}).ok());
}

// A bead of a third of a millimetre, for which the clearance of a room is too coarse.
TEST(Far, UsesRequestedClearance) {
  constexpr const char* kBead = "is too coarse for \"bead\" of 0.0003464 m";
  Table s;
  s.put("bead", box_triangles(Vec3::Constant(1e-4)), Vec3(0.3, 0, 1));
  const Operation away = TranslateOperation{{"beside"}, Vec3(20, 0, 0)};
  s.refused(TranslateOperation{{"beside"}, Vec3(20, 0, 0)}, kBead);
  SettleOptions fine;
  fine.clearance = 2e-6;
  const OperationResult result = perform(s.scene, away, fine);
  ASSERT_TRUE(result.ok()) << result.reason();
  s.refused(TranslateOperation{{"beside"}, Vec3(1, 0, 0)}, kBead);
  EXPECT_TRUE(perform(s.scene, TranslateOperation{{"beside"}, Vec3(-20, 0, 0)}, fine).ok());
  fine.clearance = 5.5e-6;  // too coarse itself
  EXPECT_NE(perform(s.scene, away, fine).reason().find(kBead), std::string::npos);
}

/// The table somewhere: a cup on a plate on it, pushed along it.
struct SetTable : Stage {
  Vec3 at;

  explicit SetTable(const Vec3& where) : at(where) {
    fix("table", box_triangles(Vec3(0.5, 0.5, 0.05)), at + Vec3(0, 0, 0.06));
    put("plate", box_triangles(Vec3(0.1, 0.1, 0.01)), at + Vec3(0, 0.2, 1));
    put("cup", ball(0.05, 8, 12), at + Vec3(0.01, 0.2, 1));
    EXPECT_TRUE(run(PushOperation{{"plate"}, Vec2::UnitX(), 0.2, {}}).ok());
    EXPECT_TRUE(run(PushOperation{{"plate"}, -Vec2::UnitY(), 0.3, {}}).ok());
  }

  double gap_below_plate() const { return position("plate").z() - 0.01 - 0.11; }
};

// One kilometre away; the clearance followed coordinates, and objects hovered by up to 1 mm.
TEST(Far, RestsWithinClearanceOneKilometreAway) {
  const SetTable near(Vec3::Zero());
  for (const Vec3& where : {Vec3(1000, 0, 0), Vec3(-600, 800, 0), Vec3(123456.7, 1, 0)}) {
    const SetTable far(where);
    EXPECT_GT(far.gap_below_plate(), 0);
    EXPECT_LT(far.gap_below_plate(), std::max(8 * near.clearance(), 2e-9 * where.norm()));
    for (const char* name : {"plate", "cup"})
      EXPECT_LT((far.position(name) - where - near.position(name)).norm(), 1e3 * far.clearance())
          << name;
    EXPECT_TRUE(check_scene(far.scene).ok());
  }
}

// With z far out, too: there is no floor.
TEST(Far, RestsWithinClearanceWithoutFloor) {
  Stage s;
  s.scene.floor = false;
  s.fix("table", box_triangles(Vec3(0.5, 0.5, 0.05)), Vec3(0, 700, 3000));
  s.put("cup", box_triangles(Vec3(0.05, 0.05, 0.05)), Vec3(0, 700, 3001));
  const double gap = s.position("cup").z() - 0.05 - 3000.05;
  EXPECT_GT(gap, 0);
  EXPECT_LT(gap, 5e-6);
}

// A plate against a wall, a clearance away. The hall makes the scene as large as its distance, so
// that it is exported about the world's origin, where float32 has steps of 0.06 mm: the objects
// have places of their own then.
TEST(Far, LetsAnotherObjectMoveTheOrigin) {
  for (int i = 0; i < 8; ++i) {
    SetTable s(Vec3(900.3 + 0.137 * i, 1100.7, 0));
    s.fix("wall", box_triangles(Vec3(0.05, 0.5, 0.2)), s.at + Vec3(0.45, 0, 0.32));
    EXPECT_TRUE(s.run(PushOperation{{"plate"}, Vec2::UnitX(), 1, {}}).ok());
    const ObjectId id = s.scene.add(object_of("hall", box_triangles(Vec3(5, 5, 5)), true));
    const OperationResult result = stand(s.scene, id, {{}, Vec3(0, 0, 5.1)});
    EXPECT_TRUE(result.ok()) << result.reason();
    EXPECT_TRUE(export_origin(s.scene.box()).isZero(0));
    EXPECT_TRUE(check_scene(s.scene).ok());
  }
}

// A box of 10 cm, put down somewhere. The other objects are where `others` says.
struct LoneBox : Stage {
  LoneBox(const Vec3& where, const std::vector<Vec3>& others) {
    for (size_t i = 0; i < others.size(); ++i)
      fix("far " + std::to_string(i), box_triangles(Vec3(0.3, 0.3, 0.3)), others[i]);
    put("box", box_triangles(Vec3::Constant(0.05)), where + Vec3(0, 0, 1));
  }
  double gap() const { return position("box").z() - 0.05; }
};

TEST(Far, GapsDoNotGrowWithTheScene) {
  for (const double x : {0.0, 10.0, 1e3, 1e4}) {
    const LoneBox alone(Vec3(x, 0, 0), {});
    EXPECT_GT(alone.gap(), 0);
    EXPECT_LE(alone.gap(), 1e-5) << x;
    for (const double distance : {60.0, 100.0, 1e3, 2e4}) {
      const LoneBox wide(Vec3(x, 0, 0), {Vec3(x - distance, 0, 0.31)});
      EXPECT_EQ(wide.position("box"), alone.position("box")) << x << ", " << distance;
      EXPECT_TRUE(check_scene(wide.scene).ok()) << x << ", " << distance;
      EXPECT_EQ(wide.at("box").state, ObjectState::Stable);
    }
    for (const double distance : {0.4, 1.0, 3.0, 9.0, 12.0, 16.0, 19.9}) {
      const LoneBox near(Vec3(x, 0, 0), {Vec3(x - distance, 0, 0.31)});
      EXPECT_LE(near.gap(), 1e-5) << x << ", " << distance;
      EXPECT_TRUE(check_scene(near.scene).ok()) << x << ", " << distance;
    }
  }
}

// The effect of another object on the clearance fades away: boxes side by side have clearances of
// one size.
TEST(Far, ClearancesChangeLittleFromPlaceToPlace) {
  Stage s;
  s.fix("far", box_triangles(Vec3(0.3, 0.3, 0.3)), Vec3::Zero() + Vec3(0, 0, 0.31));
  double before = 0;
  for (double x = 0.4; x < 25; x += 0.05) {
    const Aabb place{Vec3(x, -0.05, 0), Vec3(x + 0.1, 0.05, 0.1)};
    const ObjectId id =
        s.scene.add(object_of(std::to_string(x), box_triangles(Vec3::Constant(0.05))));
    const PlacedBox here{id, place};
    const double now = clearance_range_near(s.scene, place, {&here, 1}).usual;
    EXPECT_LE(now, kRelativeClearance * kClearanceReach);
    if (before > 0) {
      EXPECT_GT(now, 0.2 * before) << x;
      EXPECT_LT(now, 5 * before) << x;
    }
    EXPECT_LE(now, clearance_range(s.scene, place).usual) << x;
    before = now;
    s.scene.remove(id);
  }
  EXPECT_LT(before, 1e-6) << "alone";
}

// Scenes in millimetres, and large turned supports, whose float32 copies are coarse.
TEST(Far, ClearancesFollowLargeObjects) {
  Stage s;
  s.fix("slab", box_triangles(Vec3(1e4, 1e4, 0.5)), Vec3(0, 0, 0.6));
  const Aabb place{Vec3(-0.05, -0.05, 1.1), Vec3(0.05, 0.05, 1.2)};
  EXPECT_EQ(clearance_range_near(s.scene, place).usual, kRelativeClearance * kClearanceReach);
  s.edit("slab", [](Object& object) {
    object.pose.rotation = {std::cos(0.05), std::sin(0.05), 0, 0};
  });
  EXPECT_GT(clearance_range_near(s.scene, place).usual, kRelativeClearance * 1e4);
  Stage millimetres;
  millimetres.fix("table", box_triangles(Vec3(600, 400, 10)), Vec3(0, 0, 11));
  millimetres.put("cup", ball(50, 8, 12), Vec3(30, 40, 500));
  const double gap = millimetres.position("cup").z() - 50 - 21;
  EXPECT_LT(gap, 1e-2);
  EXPECT_TRUE(check_scene(millimetres.scene).ok());
}

/// World box of all vertices.
Aabb vertex_box(const Scene& scene) {
  Aabb out;
  for (const ObjectId id : scene.ids())
    for (const Vec3& v : scene.at(id).shape->mesh.vertices)
      out.extend(scene.at(id).world_from_object().apply(v));
  return out;
}

TEST(Far, StaysWholeInSceneFiles) {
  SetTable s(Vec3(-600, 800, 0));
  for (const char* name : {"table", "plate", "cup"})  // keeps the doubles
    s.edit(name, [](Object& object) {
      object.model = std::make_shared<const Model>(model_of_mesh(object.shape->mesh));
    });
  const std::string bytes = scene_file_bytes(s.scene, {}, {});
  SceneFile back = read_scene_bytes(bytes);
  for (const Sentence& note : back.notes) ADD_FAILURE() << in_english(note);
  update_contacts(back.scene);
  update_contacts(s.scene);
  EXPECT_EQ(snapshot(back.scene), snapshot(s.scene));
  // A reader in double: the origin's translation, and float32 numbers below it.
  EXPECT_LT((export_origin(s.scene.box()) - s.at).norm(), 10);
  const std::string path = testing::TempDir() + "/far.glb";
  write_file_atomically(path, bytes);
  Aabb read;  // y up
  for (const Vec3& v : read_model(path).mesh.vertices) read.extend(Vec3(v.x(), -v.z(), v.y()));
  const Aabb box = vertex_box(s.scene);
  EXPECT_LT((read.lower - box.lower).norm() + (read.upper - box.upper).norm(), 1e-6);
}

TEST(Far, RefusesClearancesThatDrownInRounding) {
  const SetTable s(Vec3(1e5, 0, 0));
  SettleOptions fine;
  fine.clearance = 1e-6;
  Scene scene = s.scene;
  const OperationResult result = perform(scene, TranslateOperation{{"cup"}, Vec3(0, 0, 0.1)}, fine);
  ASSERT_TRUE(result.refusal);
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::InvalidClearance) << result.reason();
}

// The bounds as they are printed are accepted; a little beyond is not.
TEST(Far, NamesClearancesThatAreAccepted) {
  for (const double x : {1e4, 12345.678, 33333.3, 98765.4321}) {
    const SetTable s(Vec3(x, 0, 0));
    const Operation lift = TranslateOperation{{"cup"}, Vec3(0, 0, 0.1)};
    const auto with = [&](double clearance) {
      SettleOptions options;
      options.clearance = clearance;
      Scene scene = s.scene;
      return perform(scene, lift, options);
    };
    const std::string reason = with(1e-10).reason();
    const size_t between = reason.find("not between ");
    ASSERT_NE(between, std::string::npos) << reason;
    size_t read = 0;
    const std::string bounds = reason.substr(between + 12);
    const double smallest = std::stod(bounds, &read);
    const double largest = std::stod(bounds.substr(read + 5));
    EXPECT_GE(smallest, 1e-10 * x) << reason;
    for (const double accepted : {smallest, largest})
      EXPECT_EQ(with(accepted).reason().find("not between"), std::string::npos) << reason;
    for (const double refused : {0.998 * smallest, 1.002 * largest})
      EXPECT_NE(with(refused).reason().find("not between"), std::string::npos) << reason;
  }
}

}  // namespace
}  // namespace trivet::test
