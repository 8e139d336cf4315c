#include "random_sequence.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <map>

#include "apps/demo/shapes/models.h"
#include "core/scene/fingerprint.h"
#include "ops/base/stopwatch.h"
#include "ops/files/json/operations.h"
#include "ops/operations/perform.h"
#include "support/real_models.h"
#include "support/same_scene.h"
#include "support/settle_options.h"
#include "support/shared_data.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

// --- models ------------------------------------------------------------------------------------

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
  loaded.path.clear();  // scene files keep the mesh of such models whole
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

// A fixed board somewhat above the floor, and `count` unplaced objects.
Scene start_scene(Random& random, ModelKind kind, int count) {
  Scene scene;
  Object board = object_of("board", box_triangles(Vec3(0.35, 0.3, 0.01)), true);
  auto model = std::make_shared<Model>(*board.model);
  model->path.clear();
  board.model = std::move(model);
  const ObjectId id = scene.add(std::move(board));
  EXPECT_TRUE(stand(scene, id, {{}, Vec3(0, 0, 0.05)}).ok());
  for (int i = 0; i < count; ++i) {
    const std::string name = std::string("o").append(std::to_string(i));
    if (kind == ModelKind::Real)
      add(scene, real(kRealModels[random.integer(0, std::size(kRealModels) - 1)]), name);
    else
      add(scene, made(kMadeModels[random.integer(0, std::size(kMadeModels) - 1)]), name);
  }
  return scene;
}

// --- operations --------------------------------------------------------------------------------

/// Any operation on any object of the scene except the board.
class Choice {
 public:
  Choice(Random& random, const Scene& scene) : m_random(random), m_scene(scene) {}

  Operation operation(int number) {
    const Object& object = any_object();
    m_name = object.name;
    switch (object.placed ? one_of(10) : one_of(13) == 12 ? 9 : 0) {
      case 0:
      case 1:
        return one_of(3) == 0 ? put_on() : put();
      case 2:
      case 3:
        return push();
      case 4:
        return turn();
      case 5:
        return pick_up();
      case 6:
      case 7:
        return translate();
      case 8:
        return rotate();
      default:
        return edit(number);
    }
  }

 private:
  int one_of(int count) { return m_random.integer(0, count - 1); }

  const Object& any_object() {
    const std::vector<ObjectId> ids = m_scene.ids();
    return m_scene.at(ids[m_random.integer(1, static_cast<int>(ids.size()) - 1)]);
  }

  Vec2 on_board() {
    const double x = m_random.uniform(-0.3, 0.3), y = m_random.uniform(-0.3, 0.3);
    return {x, y};
  }

  template <class Move>
  Move move() {
    Move out;
    out.object = m_name;
    out.settle_left = one_of(2);
    if constexpr (std::is_base_of_v<JointMoveOptions, Move>)
      if (one_of(8) == 0) out.together = {any_object().name};
    return out;
  }

  Operation put() {
    auto put = move<PutOperation>();
    put.start.translation = m_random.beside(0.3, 0.5);
    if (one_of(3) == 0) put.start.rotation = m_random.rotation();
    return put;
  }

  Operation put_on() {
    auto put = move<PutOperation>();
    PlaceOptions& place = put.place.emplace();
    const int on = one_of(3);
    place.on = on == 0 ? "board" : on == 1 ? "floor" : any_object().name;
    if (one_of(2)) place.near = on_board();
    place.seed = static_cast<std::uint64_t>(one_of(100));
    if (one_of(3) == 0) place.keep = m_random.uniform(0, 0.02);
    return put;
  }

  Operation push() {
    auto push = move<PushOperation>();
    push.slide = one_of(2);
    if (one_of(3) == 0) {
      push.to = on_board();
      for (int i = one_of(3); i > 0; --i) push.via.push_back(on_board());
      return push;
    }
    const double x = m_random.uniform(-1, 1), y = m_random.uniform(-1, 1);
    push.direction = Vec2(x, y);
    push.distance = m_random.uniform(0.01, 0.3);
    return push;
  }

  Operation turn() {
    auto turn = move<TurnOperation>();
    const int about = one_of(3);
    turn.about = about == 0   ? TurnOperation::About::Normal
                 : about == 1 ? TurnOperation::About::Line
                              : TurnOperation::About::Point;
    turn.angle_deg = m_random.uniform(-60, 60);
    turn.settle = one_of(2);
    return turn;
  }

  Operation pick_up() {
    auto pick_up = move<PickUpOperation>();
    pick_up.distance = m_random.uniform(0.01, 0.2);
    return pick_up;
  }

  Operation translate() {
    auto translate = move<TranslateOperation>();
    translate.by = m_random.in_cube(0.2);
    translate.free = one_of(6) == 0;
    translate.settle = !translate.free && one_of(2);
    return translate;
  }

  Operation rotate() {
    auto rotate = move<RotateOperation>();
    rotate.axis = m_random.direction();
    rotate.angle_deg = m_random.uniform(-90, 90);
    rotate.free = one_of(6) == 0;
    rotate.settle = !rotate.free && one_of(2);
    return rotate;
  }

  Operation edit(int number) {
    switch (one_of(6)) {
      case 0:
        return move<DeleteOperation>();
      case 1:
        return DuplicateOperation{m_name, std::string("copy").append(std::to_string(number))};
      case 2:
        return LockOperation{m_name, true};
      case 3:
        return LockOperation{m_name, false};
      case 4:
        return FixOperation{m_name, one_of(3) == 0};
      default:
        return GroupOperation{m_name, one_of(2) ? "group" : ""};
    }
  }

  Random& m_random;
  const Scene& m_scene;
  std::string m_name;
};

// --- a whole sequence --------------------------------------------------------------------------

class Sequence {
 public:
  Sequence(unsigned seed, ModelKind kind, const SequenceOptions& options)
      : m_random(seed),
        m_session(start_scene(m_random, kind, kind == ModelKind::Real ? 6 : 7), {}, {}),
        m_options(options),
        m_start(m_session.scene()) {
    m_settle = options.settle;
    m_settle.clearance = kSequenceClearance;
    m_states.push_back(fingerprint(m_session.scene()));
  }

  Outcome run() {
    for (int i = 0; i < kOperations; ++i)
      if (!do_one(i)) break;
    go_back_and_forth();
    Hash hash;
    for (const std::uint64_t state : m_states) hash.add(state);
    m_outcome.hash = hash.value();
    return m_outcome;
  }

 private:
  /// @return whether to continue.
  bool do_one(int i) {
    const Operation operation = Choice(m_random, m_session.scene()).operation(i);
    const Worker& worker = m_options.workers[static_cast<size_t>(i) % m_options.workers.size()];
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<size_t>(worker.num_threads));
    m_context.detector = worker.detector;
    const Stopwatch stopwatch;
    const OperationResult result = m_session.perform(operation, m_settle, m_context);
    m_outcome.seconds += stopwatch.milliseconds() / 1000;
    const std::string text = operation_json(operation).dump();
    SCOPED_TRACE("operation " + std::to_string(i) + ": " + text);
    if (m_options.tell)
      std::printf("%2d %s: %s\n", i, text.c_str(), result.ok() ? "ok" : result.reason().c_str());
    if (!result.ok()) {
      EXPECT_FALSE(result.reason().empty());
      EXPECT_EQ(fingerprint(m_session.scene()), m_states.back());
      return true;
    }
    ++m_outcome.num_done;
    m_states.push_back(fingerprint(m_session.scene()));
    return !m_options.holds || m_options.holds(m_session.scene());
  }

  void go_back_and_forth() {
    for (size_t i = m_states.size() - 1; i-- > 0;) {
      EXPECT_TRUE(m_session.undo());
      EXPECT_EQ(fingerprint(m_session.scene()), m_states[i]);
    }
    EXPECT_EQ(difference(m_session.scene(), m_start), "");
    for (size_t i = 1; i < m_states.size(); ++i) {
      EXPECT_TRUE(m_session.redo());
      EXPECT_EQ(fingerprint(m_session.scene()), m_states[i]);
    }
  }

  Random m_random;
  Session m_session;
  const SequenceOptions& m_options;
  const Scene m_start;
  SettleOptions m_settle;
  RunContext m_context;
  std::vector<std::uint64_t> m_states;
  Outcome m_outcome;
};

}  // namespace

Outcome run_sequence(unsigned seed, ModelKind kind, const SequenceOptions& options) {
  return Sequence(seed, kind, options).run();
}

std::vector<unsigned> chosen_seeds(int count) {
  unsigned first = 0, last = static_cast<unsigned>(count) - 1;
  if (const char* text = std::getenv("TRIVET_SEQUENCE")) {
    char* end = nullptr;
    first = last = static_cast<unsigned>(std::strtoul(text, &end, 10));
    if (*end == '-') last = static_cast<unsigned>(std::strtoul(end + 1, nullptr, 10));
  }
  std::vector<unsigned> out;
  for (unsigned seed = first; seed <= last; ++seed) out.push_back(seed);
  return out;
}

bool is_one_seed() {
  return std::getenv("TRIVET_SEQUENCE") != nullptr && chosen_seeds(1).size() == 1;
}

}  // namespace trivet::test
