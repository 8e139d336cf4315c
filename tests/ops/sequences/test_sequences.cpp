// Random sequences of operations: after each of them the scene is valid, its load-support list is
// the one that follows from the poses, and the whole session goes back to its start and forth to
// its end, to the bit, on every backend and number of threads.
//
// TRIVET_TEST_EFFORT=50 runs 2,000; TRIVET_SEQUENCE=SEED runs one and tells what it does.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <map>

#include "core/scene/fingerprint.h"
#include "core/shapes/models.h"
#include "ops/check.h"
#include "ops/detect/detector.h"
#include "ops/layout/operation_json.h"
#include "ops/session/session.h"
#include "raster/software_zlists.h"
#include "support/effort.h"
#include "support/same_scene.h"
#include "support/shared_data.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

constexpr double kClearance = 2e-6;
constexpr int kOperations = 20;

// --- models ------------------------------------------------------------------------------------

struct RealModel {
  const char* file;
  double scale;
  UpAxis up;
};
constexpr RealModel kRealModels[] = {{"sh3d_by_choppingBoard.obj", 0.00998942, UpAxis::Y},
                                     {"contactdb_bowl.stl", 1, UpAxis::Z},
                                     {"gazebo_plastic_cup.obj", 1, UpAxis::Z},
                                     {"sh3d_by_spoon.obj", 0.00998615, UpAxis::Y},
                                     {"sh3d_s_toaster.obj", 0.00999713, UpAxis::Y},
                                     {"gso_silver_tape.obj", 1, UpAxis::Z},
                                     {"sh3d_s_bandeja.obj", 0.00998825, UpAxis::Y},
                                     {"ripc_nut-big.obj", 0.004, UpAxis::Y},
                                     {"sh3d_c0_bread.obj", 0.00999396, UpAxis::Y},
                                     {"sh3d_s_marteau.obj", 0.0100125, UpAxis::Y}};
constexpr const char* kMadeModels[] = {"saucer", "plate", "cup",   "glass", "bowl", "spoon",
                                       "knife",  "apple", "toast", "loaf",  "egg"};

// Loaded once.
const Object& stored(const std::string& key, const std::function<Object()>& make) {
  static std::map<std::string, Object> objects;
  const auto it = objects.find(key);
  return it != objects.end() ? it->second : objects.emplace(key, make()).first->second;
}

Object object_with(Model loaded, double scale, UpAxis up) {
  Object object;
  object.shape = make_shape(loaded.mesh);
  object.model = std::make_shared<const Model>(std::move(loaded));
  object.scale = scale;
  object.up = up;
  return object;
}

Object made(const std::string& name) {
  return stored(name, [&] { return object_with(shapes::make_model(name), 1, UpAxis::Z); });
}

Object real(const RealModel& m) {
  return stored(m.file, [&] {
    return object_with(read_model(shared_data("models/") + m.file), m.scale, m.up);
  });
}

void add(Scene& scene, Object object, const std::string& name) {
  object.name = name;
  scene.add(std::move(object));
}

// A board that does not move, somewhat above the floor, and `count` objects out of the scene.
Scene start_scene(Random& random, bool of_real, int count) {
  Scene scene;
  Object board = object_of("board", box_triangles(Vec3(0.35, 0.3, 0.01)), true);
  const ObjectId id = scene.add(std::move(board));
  EXPECT_TRUE(stand(scene, id, {{}, Vec3(0, 0, 0.05)}).ok());
  for (int i = 0; i < count; ++i) {
    const std::string name = std::string("o").append(std::to_string(i));
    if (of_real)
      add(scene, real(kRealModels[random.integer(0, std::size(kRealModels) - 1)]), name);
    else
      add(scene, made(kMadeModels[random.integer(0, std::size(kMadeModels) - 1)]), name);
  }
  return scene;
}

// --- operations --------------------------------------------------------------------------------

Operation random_put(Random& random, const std::string& name) {
  PutOperation put;
  put.object = name;
  put.settle_left = random.integer(0, 1);
  put.start.translation = random.beside(0.3, 0.5);
  if (random.integer(0, 2) == 0) put.start.rotation = random.rotation();
  return put;
}

Operation random_push(Random& random, const std::string& name) {
  PushOperation push;
  push.object = name;
  push.settle_left = random.integer(0, 1);
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
  push.direction = Vec2(x, y);
  push.distance = random.uniform(0.01, 0.3);
  push.slide = random.integer(0, 1);
  return push;
}

Operation random_turn(Random& random, const std::string& name) {
  TurnOperation turn;
  turn.object = name;
  turn.settle_left = random.integer(0, 1);
  const int about = random.integer(0, 2);
  turn.about = about == 0   ? TurnOperation::About::Normal
               : about == 1 ? TurnOperation::About::Line
                            : TurnOperation::About::Point;
  turn.angle_deg = random.uniform(-60, 60);
  turn.settle = random.integer(0, 1);
  return turn;
}

Operation random_pick_up(Random& random, const std::string& name) {
  PickUpOperation pick_up;
  pick_up.object = name;
  pick_up.settle_left = random.integer(0, 1);
  pick_up.distance = random.uniform(0.01, 0.2);
  return pick_up;
}

Operation random_translate(Random& random, const std::string& name) {
  TranslateOperation translate;
  translate.object = name;
  translate.settle_left = random.integer(0, 1);
  translate.by = random.in_cube(0.2);
  translate.settle = random.integer(0, 1);
  return translate;
}

Operation random_rotate(Random& random, const std::string& name) {
  RotateOperation rotate;
  rotate.object = name;
  rotate.settle_left = random.integer(0, 1);
  rotate.axis = random.direction();
  rotate.angle_deg = random.uniform(-90, 90);
  rotate.settle = random.integer(0, 1);
  return rotate;
}

Operation random_edit(Random& random, const std::string& name, int number) {
  switch (random.integer(0, 4)) {
    case 0: {
      DeleteOperation remove;
      remove.object = name;
      remove.settle_left = random.integer(0, 1);
      return remove;
    }
    case 1:
      return DuplicateOperation{name, std::string("copy").append(std::to_string(number))};
    case 2:
      return LockOperation{name, true};
    case 3:
      return LockOperation{name, false};
    default:
      return GroupOperation{name, random.integer(0, 1) ? "group" : ""};
  }
}

Operation random_operation(Random& random, const Scene& scene, int number) {
  const std::vector<ObjectId> ids = scene.ids();
  const Object& object = scene.at(ids[random.integer(1, static_cast<int>(ids.size()) - 1)]);
  const int kind = object.placed ? random.integer(0, 9) : random.integer(0, 12) == 12 ? 9 : 0;
  switch (kind) {
    case 0:
    case 1:
      return random_put(random, object.name);
    case 2:
    case 3:
      return random_push(random, object.name);
    case 4:
      return random_turn(random, object.name);
    case 5:
      return random_pick_up(random, object.name);
    case 6:
    case 7:
      return random_translate(random, object.name);
    case 8:
      return random_rotate(random, object.name);
    default:
      return random_edit(random, object.name, number);
  }
}

// --- what must hold ----------------------------------------------------------------------------

using Names = std::vector<std::string>;

std::map<std::string, std::pair<Names, Names>> named(const Scene& scene) {
  std::map<std::string, std::pair<Names, Names>> out;
  for (const LoadSupport::Entry& e : load_support(scene).entries) {
    auto& [supports, loads] = out[scene.at(e.object).name];
    if (e.on_floor) supports.push_back("floor");
    for (const ObjectId id : e.supports) supports.push_back(scene.at(id).name);
    for (const ObjectId id : e.loads) loads.push_back(scene.at(id).name);
  }
  return out;
}

bool is_reported(ObjectState state) {
  return state != ObjectState::Stable && state != ObjectState::Fixed;
}

// @return whether it holds.
bool expect_valid(const Scene& scene) {
  bool valid = true;
  const SceneCheck check = check_scene(scene, 1, kClearance);
  for (const auto* findings : {&check.crossings, &check.float32_crossings, &check.contained})
    for (const SceneCheck::PairFinding& f : *findings) {
      ADD_FAILURE() << f.a << " and " << f.b << ": " << f.count << " pairs interpenetrate";
      valid = false;
    }
  for (const std::string& name : check.not_at_rest)
    if (!is_reported(scene.at(*scene.find(name)).state)) {
      ADD_FAILURE() << name << " is not at rest, and nobody said so";
      valid = false;
    }
  Scene rebuilt = scene;
  update_contacts(rebuilt, kClearance);
  const bool same = named(scene) == named(rebuilt);
  EXPECT_TRUE(same) << "the load-support list is not the one that follows from the poses";
  return valid && same;
}

struct Outcome {
  std::uint64_t hash = 0;
  int num_done = 0;
  bool whole = true;  // nothing was wrong
};

// @param checked  all that must hold is looked at; otherwise only the hash is made.
Outcome run_sequence(unsigned seed, bool of_real, bool checked, Detector* detector, bool tell) {
  Random random(seed);
  Session session(start_scene(random, of_real, of_real ? 6 : 7), {}, {});
  SettleOptions options;
  options.clearance = kClearance;
  options.detector = detector;
  std::vector<std::uint64_t> states{fingerprint(session.scene())};
  const Scene start = session.scene();
  Outcome outcome;
  for (int i = 0; i < kOperations; ++i) {
    const Operation operation = random_operation(random, session.scene(), i);
    const std::uint64_t before = fingerprint(session.scene());
    const OperationResult result = session.perform(operation, options);
    const std::string text = operation_json(operation).dump();
    SCOPED_TRACE("operation " + std::to_string(i) + ": " + text);
    if (tell)
      std::printf("%2d %s: %s\n", i, text.c_str(), result.ok() ? "ok" : result.reason.c_str());
    if (result.ok()) {
      ++outcome.num_done;
      states.push_back(fingerprint(session.scene()));
      outcome.whole = !checked || expect_valid(session.scene());
      if (!outcome.whole) break;
    } else {
      EXPECT_FALSE(result.reason.empty());
      EXPECT_EQ(fingerprint(session.scene()), before);
    }
  }
  for (size_t i = states.size() - 1; i-- > 0;) {
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(fingerprint(session.scene()), states[i]);
  }
  EXPECT_EQ(difference(session.scene(), start), "");
  for (size_t i = 1; i < states.size(); ++i) {
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(fingerprint(session.scene()), states[i]);
  }
  Hash hash;
  for (const std::uint64_t state : states) hash.add(state);
  outcome.hash = hash.value();
  return outcome;
}

bool is_one_seed(unsigned seed) {
  const char* text = std::getenv("TRIVET_SEQUENCE");
  return !text || std::strtoul(text, nullptr, 10) == seed;
}

void run_all(bool of_real, int count) {
  const bool tell = std::getenv("TRIVET_SEQUENCE") != nullptr;
  int num_done = 0, num_run = 0;
  Hash all;
  for (unsigned seed = 0; seed < static_cast<unsigned>(count); ++seed) {
    if (!is_one_seed(seed)) continue;
    SCOPED_TRACE("TRIVET_SEQUENCE=" + std::to_string(seed));
    const Outcome one = run_sequence(seed, of_real, true, nullptr, tell);
    num_done += one.num_done;
    ++num_run;
    all.add(one.hash);
    if (seed % 4 == 0 && one.whole) {
      SoftwareZListOptions software;
      software.num_threads = seed % 8 == 0 ? 1 : 3;
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                        software.num_threads);
      Detector detector(std::make_unique<SoftwareZLists>(software), "software");
      EXPECT_EQ(run_sequence(seed, of_real, false, &detector, false).hash, one.hash);
    }
  }
  EXPECT_GT(num_done, num_run * kOperations / 3) << "of " << num_run * kOperations;
  std::printf("%d sequences, %d of %d operations done, hash %s\n", num_run, num_done,
              num_run * kOperations, all.text().c_str());
}

TEST(Sequences, OfTheProjectsModels) { run_all(false, with_effort(20)); }

TEST(Sequences, OfRealModels) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  run_all(true, with_effort(20));
}

}  // namespace
}  // namespace trivet::test
