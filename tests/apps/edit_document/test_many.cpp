// Many objects as one step: arrays, scattering, aligning, replacing.
#include <algorithm>
#include <cmath>
#include <set>

#include "apps/edit/document/many.h"
#include "apps/edit/document/names.h"
#include "apps/edit/document/pose_numbers.h"
#include "apps/edit_document/scene_checks.h"
#include "apps/edit_document/testing.h"

namespace trivet::edit::test {
namespace {

/// A tray on the floor, and boxes of 4 cm.
class Many : public testing::Test {
 protected:
  Many() : document(folder.file("recovery")) {
    write_boxes(folder.file("tray.obj"), {{{-0.3, -0.2, 0}, {0.3, 0.2, 0.02}}});
    write_boxes(folder.file("box.obj"), {{{-0.02, -0.02, 0}, {0.02, 0.02, 0.04}}});
    document.import(folder.file("tray.obj"), "tray", true);
    put("box", Vec3(-0.2, 0, 0.03));
  }

  void put(const std::string& name, const Vec3& at) {
    document.import(folder.file("box.obj"), name);
    PutOperation operation;
    operation.object = name;
    operation.start.translation = at;
    if (!document.done(document->perform(operation)))
      throw std::runtime_error(document.last_text());
  }

  /// Runs it; expects one step, which can be undone to the bit.
  void run(const ManyObjects& many) {
    const std::uint64_t before = fingerprint(*document->snapshot());
    const size_t steps = document->history().num_done;
    ASSERT_TRUE(document.done(document->perform_groups("many", many))) << document.last_text();
    EXPECT_EQ(document->history().num_done, steps + 1);
    EXPECT_FALSE(document->selection().objects.empty());
    for (const ObjectId id : document->selection().objects) {
      const std::string& name = scene().find(id)->object->name;
      EXPECT_EQ(std::count(many.names.begin(), many.names.end(), name), 1) << name;
    }
    EXPECT_EQ(wrong_with(*document->snapshot()), "");
    const std::uint64_t after = fingerprint(*document->snapshot());
    ASSERT_TRUE(document.done(document->undo()));
    EXPECT_EQ(fingerprint(*document->snapshot()), before);
    ASSERT_TRUE(document.done(document->redo()));
    EXPECT_EQ(fingerprint(*document->snapshot()), after);
  }

  /// By numbers, into whatever is there.
  void shift(const std::string& name, const Vec3& by) {
    TranslateOperation operation;
    operation.object = name;
    operation.by = by;
    operation.free = true;
    ASSERT_TRUE(document.done(document->perform(operation))) << document.last_text();
  }

  const Vec3& at(const std::string& name) { return document.object(name).pose.translation; }
  const SceneSnapshot& scene() { return *document->snapshot(); }
  std::vector<Vec3> positions() {
    std::vector<Vec3> out;
    out.reserve(scene().objects.size());
    for (const ObjectSnapshot& o : scene().objects) out.push_back(o->pose.translation);
    return out;
  }

  TemporaryFolder folder;
  Recorder document;
};

TEST_F(Many, PutsALine) {
  ArrayWish wish;
  wish.object = "box";
  wish.count = 6;
  wish.step = Vec3(0.07, 0.01, 0);
  run(array_of(scene(), wish));
  const Vec3 first = at("box");
  for (int i = 1; i < 6; ++i) {
    const Vec3 by = at("box " + std::to_string(i + 1)) - first;
    EXPECT_LT((by - i * wish.step).norm(), 1e-4) << i;
  }
  EXPECT_EQ(scene().objects.size(), 7u);
}

TEST_F(Many, PutsAGrid) {
  ArrayWish wish;
  wish.kind = ArrayWish::Kind::Grid;
  wish.object = "box";
  wish.rows = 4, wish.columns = 3;
  wish.step = Vec3(0.06, 0.05, 0);
  run(array_of(scene(), wish));
  EXPECT_EQ(scene().objects.size(), 13u);
  std::set<std::pair<int, int>> cells;
  for (const ObjectSnapshot& o : scene().objects) {
    if (o->fixed) continue;
    const Vec3 by = o->pose.translation - at("box");
    cells.insert({std::lround(by.x() / 0.06), std::lround(by.y() / 0.05)});
    EXPECT_NEAR(by.z(), 0, 1e-4);
  }
  EXPECT_EQ(cells.size(), 12u);
  EXPECT_EQ(*cells.rbegin(), std::pair(3, 2));
}

TEST_F(Many, PutsACircle) {
  ArrayWish wish;
  wish.kind = ArrayWish::Kind::Circle;
  wish.object = "box";
  wish.count = 8;
  wish.centre = Vec2(0.1, 0);
  run(array_of(scene(), wish));
  const Vec3 centre = at("box") + Vec3(0.1, 0, 0);
  for (int i = 1; i < 8; ++i) {
    const Object& o = document.object("box " + std::to_string(i + 1));
    EXPECT_NEAR((o.pose.translation - centre).head<2>().norm(), 0.1, 1e-4);
    EXPECT_NEAR(std::remainder(angles_deg(o.pose.rotation).z() - 45 * i, 360), 0, 1e-2);
  }
}

TEST_F(Many, LeavesOutWhatIsRefusedAndSaysSo) {
  put("obstacle", Vec3(-0.06, 0, 0.03));
  ArrayWish wish;
  wish.object = "box";
  wish.count = 4;
  wish.step = Vec3(0.07, 0, 0);
  run(array_of(scene(), wish));  // the second copy crosses the obstacle
  EXPECT_TRUE(scene().find("box 2"));
  EXPECT_FALSE(scene().find("box 3"));
  EXPECT_TRUE(scene().find("box 4"));
  bool told = false;
  for (const Message& message : document.messages())
    told = told || (message.text.find("2 of 3") != std::string::npos &&
                    message.text.find("obstacle") != std::string::npos);
  EXPECT_TRUE(told) << document.last_text();
}

TEST_F(Many, ChangesNothingIfAllIsRefused) {
  ArrayWish wish;
  wish.object = "box";
  wish.step = Vec3(0.01, 0, 0);
  wish.count = 2;
  const auto before = document->snapshot();
  EXPECT_FALSE(document.done(document->perform_groups("line", array_of(scene(), wish))));
  EXPECT_EQ(document->snapshot(), before);
  EXPECT_EQ(document.messages().back().kind, Message::Kind::Refused);
}

TEST_F(Many, ScattersOnASupport) {
  ScatterWish wish;
  wish.objects = {"box"};
  wish.count = 12;
  wish.on = "tray";
  wish.keep = 0.01;
  wish.turn = RandomTurn::Yaw;
  run(scattered(scene(), wish));
  ASSERT_EQ(scene().objects.size(), 14u);
  std::set<double> yaws;
  for (const ObjectSnapshot& o : scene().objects) {
    if (o->fixed || o->name == "box") continue;
    EXPECT_NEAR(o->pose.translation.z(), 0.02, 1e-3);
    EXPECT_LT(std::abs(o->pose.translation.x()), 0.3);
    yaws.insert(std::round(angles_deg(o->pose.rotation).z()));
  }
  EXPECT_GT(yaws.size(), 6u);
}

TEST_F(Many, ScattersTheSameBySeed) {
  ScatterWish wish;
  wish.objects = {"box"};
  wish.count = 5;
  wish.on = "tray";
  const auto poses = [&](std::uint64_t seed) {
    wish.seed = seed;
    if (!document.done(document->perform_groups("scatter", scattered(scene(), wish))))
      throw std::runtime_error(document.last_text());
    std::vector<Vec3> out = positions();
    document.done(document->undo());
    return out;
  };
  const auto first = poses(5);
  EXPECT_EQ(poses(5), first);
  EXPECT_NE(poses(6), first);
}

TEST_F(Many, ScattersInARegion) {
  ScatterWish wish;
  wish.objects = {"box"};
  wish.count = 4;
  wish.region = {Vec2(1, 1), Vec2(1.4, 1.3)};
  wish.turn = RandomTurn::None;
  run(scattered(scene(), wish));
  for (int i = 2; i < 6; ++i) {
    const Vec3& p = at("box " + std::to_string(i));
    EXPECT_TRUE(p.x() > 0.95 && p.x() < 1.45 && p.y() > 0.95 && p.y() < 1.35) << p.transpose();
  }
}

TEST_F(Many, PutsAllThatAreNotPlaced) {
  for (const char* const name : {"a", "b", "c"}) document.import(folder.file("box.obj"), name);
  EXPECT_EQ(unplaced_names(scene()), (std::vector<std::string>{"a", "b", "c"}));
  ScatterWish wish;
  wish.objects = unplaced_names(scene());
  wish.count = 3;
  wish.on = "tray";
  run(scattered(scene(), wish));
  EXPECT_TRUE(unplaced_names(scene()).empty());
  EXPECT_EQ(scene().objects.size(), 5u);
}

TEST_F(Many, PoursAPileIntoABox) {
  write_boxes(folder.file("crate.obj"), {{{-0.1, -0.1, 0}, {0.1, 0.1, 0.01}},
                                         {{-0.1, -0.1, 0.01}, {-0.09, 0.1, 0.1}},
                                         {{0.09, -0.1, 0.01}, {0.1, 0.1, 0.1}},
                                         {{-0.09, -0.1, 0.01}, {0.09, -0.09, 0.1}},
                                         {{-0.09, 0.09, 0.01}, {0.09, 0.1, 0.1}}});
  document.import(folder.file("crate.obj"), "crate");
  PutOperation put;
  put.object = "crate";
  put.start.translation = Vec3(0.1, 0, 0.03);
  ASSERT_TRUE(document.done(document->perform(put))) << document.last_text();
  ScatterWish wish;
  wish.objects = {"box"};
  wish.count = 24;
  wish.on = "crate";
  wish.pile = true;
  wish.turn = RandomTurn::Any;
  run(scattered(scene(), wish));
  const Aabb crate = world_box(document.object("crate"));
  int num_inside = 0, num_above = 0;
  for (const ObjectSnapshot& o : scene().objects) {
    if (o->name == "box" || o->model->path != document.object("box").model->path) continue;
    const Vec3 centre = o->centre_of_mass();
    num_inside += std::abs(centre.x() - 0.1) < 0.1 && std::abs(centre.y()) < 0.1;
    num_above += centre.z() > crate.lower.z() + 0.055;
  }
  EXPECT_GE(num_inside, 20) << document.last_text();
  EXPECT_GE(num_above, 4) << "they lie on each other";
}

TEST_F(Many, KeepsWhatIsPlacedWhenCancelled) {
  ScatterWish wish;
  wish.objects = {"box"};
  wish.count = 500;
  wish.on = "tray";
  wish.pile = true;
  const size_t steps = document->history().num_done;
  const auto stop =
      QObject::connect(&*document, &Document::progressed, [&](const QString&, int done, int total) {
        if (total == 500 && done >= 5) document->cancel();
      });
  EXPECT_TRUE(document.done(document->perform_groups("pour", scattered(scene(), wish))));
  QObject::disconnect(stop);
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_GE(scene().objects.size(), 6u);
  EXPECT_LT(scene().objects.size(), 400u);
  EXPECT_EQ(document.messages().back().kind, Message::Kind::Info);
  EXPECT_NE(document.last_text().find("stopped after"), std::string::npos) << document.last_text();
  EXPECT_EQ(wrong_with(scene()), "");
}

TEST_F(Many, AlignsAndSpacesEvenly) {
  put("b", Vec3(-0.1, 0.05, 0.03));
  put("c", Vec3(0.05, -0.1, 0.03));
  put("d", Vec3(0.2, 0.1, 0.03));
  AlignWish wish;
  wish.objects = {"box", "b", "c", "d"};
  wish.axis = 1;
  for (const auto how : {AlignWish::How::Lower, AlignWish::How::Centre, AlignWish::How::Upper}) {
    wish.how = how;
    run(aligned(scene(), wish));
    for (const char* const name : {"box", "b", "c"}) EXPECT_NEAR(at(name).y(), 0.1, 1e-4) << name;
    ASSERT_TRUE(document.done(document->undo()));
  }
  wish.axis = 0;
  wish.how = AlignWish::How::Gaps;
  run(aligned(scene(), wish));
  EXPECT_NEAR(at("b").x() - at("box").x(), 0.4 / 3, 1e-4);
  EXPECT_NEAR(at("c").x() - at("b").x(), 0.4 / 3, 1e-4);
  EXPECT_NEAR(at("box").x(), -0.2, 1e-9);
}

TEST_F(Many, ReplacesByACopy) {
  put("b", Vec3(0, 0, 0.03));
  write_boxes(folder.file("tall.obj"), {{{-0.02, -0.02, -0.05}, {0.02, 0.02, 0.05}}});
  document.import(folder.file("tall.obj"), "tall");
  run(replaced(scene(), {"box", "b", "tall"}, "tall", 0.02));
  EXPECT_FALSE(scene().find("box"));
  EXPECT_FALSE(scene().find("b"));
  EXPECT_NEAR(at("tall 2").x(), -0.2, 1e-4);
  EXPECT_NEAR(at("tall 3").x(), 0, 1e-4);
  EXPECT_NEAR(world_box(document.object("tall 2")).lower.z(), 0.02, 1e-3);
}

TEST_F(Many, LayoutMakesTheSameScene) {
  ScatterWish wish;
  wish.objects = {"box"};
  wish.count = 3;
  wish.on = "tray";
  run(scattered(scene(), wish));
  const std::vector<Vec3> before = positions();
  ASSERT_TRUE(document.done(document->save_as(folder.file("layout.json")))) << document.last_text();
  ASSERT_TRUE(document.done(document->open(folder.file("layout.json")))) << document.last_text();
  EXPECT_EQ(positions(), before);
}

// The first that is free, again and again.
TEST_F(Many, NewNamesAreThoseOfASearchFromTwo) {
  put("box 3", Vec3(-0.1, 0, 0.03));
  put("lid", Vec3(0, 0, 0.03));
  NewNames names(scene());
  std::set<std::string> taken = {"tray", "box", "box 3", "lid"};
  for (int i = 0; i < 200; ++i) {
    const std::string like = i % 3 == 0 ? "lid" : i % 3 == 1 ? "box 7" : "box";
    const std::string stem = i % 3 == 0 ? "lid" : "box";
    int number = 2;
    while (!taken.insert(stem + " " + std::to_string(number)).second) ++number;
    EXPECT_EQ(names.like(like), stem + " " + std::to_string(number));
  }
  EXPECT_EQ(names.like("box "), "box  2");
  EXPECT_EQ(names.like("12"), "12 2");
}

TEST_F(Many, MendsAsOneStep) {
  put("other", Vec3(-0.1, 0, 0.03));
  shift("other", Vec3(-0.0605, 0, 0.001));  // half a millimetre in "box", and in the air
  const std::uint64_t before = fingerprint(*document->snapshot());
  const size_t steps = document->history().num_done;
  EXPECT_EQ(document.object("other").state, ObjectState::Invalid);
  RepairOperation mend;
  mend.mends = true;
  document.forget();
  ASSERT_TRUE(document.done(document->perform(mend))) << document.last_text();
  EXPECT_EQ(document->history().num_done, steps + 1);
  EXPECT_EQ(document->history().steps.back(), "mend");
  EXPECT_NE(document.last_text().find("objects moved, by "), std::string::npos)
      << document.last_text();
  EXPECT_NE(document.last_text().find("2 of 2 supports kept"), std::string::npos);
  EXPECT_EQ(wrong_with(*document->snapshot()), "");
  EXPECT_EQ(document.object("other").state, ObjectState::Stable);
  EXPECT_GE(at("other").x() - at("box").x(), 0.04);
  EXPECT_LT(at("other").x() - at("box").x(), 0.0402);
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_EQ(fingerprint(*document->snapshot()), before);
}

TEST_F(Many, SettlesWhatFloatsAlone) {
  put("other", Vec3(0.1, 0, 0.03));
  shift("other", Vec3(0, 0, 0.01));
  const Vec3 box = at("box");
  RepairOperation settle;
  settle.only = {"other", "tray"};
  ASSERT_TRUE(document.done(document->perform(settle))) << document.last_text();
  EXPECT_NEAR(at("other").z(), at("box").z(), 1e-5);
  EXPECT_EQ(at("box"), box);
  EXPECT_NE(document.last_text().find("moved, by 10.0 mm at most"), std::string::npos);
}

TEST_F(Many, RepairsOfATrueSceneAreNoStep) {
  const size_t steps = document->history().num_done;
  for (const bool mends : {true, false}) {
    RepairOperation repair;
    repair.mends = mends;
    document.forget();
    ASSERT_TRUE(document.done(document->perform(repair)));
    EXPECT_EQ(document->history().num_done, steps);
    EXPECT_NE(document.last_text().find("no object passes through another"), std::string::npos);
  }
}

}  // namespace
}  // namespace trivet::edit::test
