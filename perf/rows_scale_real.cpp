// The same among real models: heaps of ten, repeated in rows.
#include <filesystem>
#include <stdexcept>

#include "core/io/read_model.h"
#include "core/model/model.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "perf/rows.h"
#include "perf/scale.h"
#include "tests/support/random_shapes.h"

namespace trivet::perf {
namespace {

constexpr int kNumRealObjects[] = {1'000, 3'000};
constexpr double kHeapSpacing = 4.0;  // metres between the middles of heaps
constexpr int kTrials = 50;

struct RealModel {
  const char *name, *file;
  double scale;
  UpAxis up;
};
constexpr RealModel kHeap[] = {{"board", "sh3d_by_choppingBoard.obj", 0.00998942, UpAxis::Y},
                               {"bowl", "contactdb_bowl.stl", 1, UpAxis::Z},
                               {"cup", "gazebo_plastic_cup.obj", 1, UpAxis::Z},
                               {"spoon", "sh3d_by_spoon.obj", 0.00998615, UpAxis::Y},
                               {"toaster", "sh3d_s_toaster.obj", 0.00999713, UpAxis::Y},
                               {"tape", "gso_silver_tape.obj", 1, UpAxis::Z},
                               {"tray", "sh3d_s_bandeja.obj", 0.00998825, UpAxis::Y},
                               {"nut", "ripc_nut-big.obj", 0.004, UpAxis::Y},
                               {"bread", "sh3d_c0_bread.obj", 0.00999396, UpAxis::Y},
                               {"hammer", "sh3d_s_marteau.obj", 0.0100125, UpAxis::Y}};

Object object_of(const RealModel& m) {
  Object out;
  out.name = m.name;
  out.model = std::make_shared<const Model>(
      read_model(std::string(TRIVET_SHARED_DIR "/data/models/") + m.file));
  out.shape = make_shape(out.model->mesh);
  out.up = m.up, out.scale = m.scale;
  return out;
}

/// Each of the models, PUT at random within half a metre.
Scene heap() {
  Scene scene;
  test::Random random(5);
  for (const RealModel& m : kHeap) {
    const ObjectId id = scene.add(object_of(m));
    for (int i = 0; !scene.at(id).placed; ++i) {
      if (i == kTrials) throw std::runtime_error(std::string(m.name) + " cannot be put");
      put(scene, id, {random.rotation(), random.beside(0.25, 1)}, scale_options());
    }
  }
  return scene;
}

/// Copies in rows, with a number after each name, and "more", which is not placed.
Scene many_heaps(const Scene& one, int count) {
  Scene out;
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i)
    for (const ObjectId id : one.ids()) {
      Object object = one.at(id);
      object.name += text("_%d", i);
      object.pose.translation += kHeapSpacing * Vec3(i % side - side / 2, i / side - side / 2, 0);
      object.contacts.clear();
      out.add(std::move(object));
    }
  Object more = one.at(*one.find("cup"));
  more.name = "more";
  more.placed = false;
  more.state = ObjectState::Unplaced;
  more.contacts.clear();
  out.add(std::move(more));
  return out;
}

std::int64_t num_triangles(const Scene& scene) {
  std::int64_t sum = 0;
  for (const ObjectId id : scene.ids())
    sum += static_cast<std::int64_t>(scene.at(id).shape->mesh.triangles.size());
  return sum;
}

void add_rows(const Scene& one, int num, Report& report) {
  std::optional<Scene> scene = many_heaps(one, num / static_cast<int>(std::size(kHeap)));
  report.section(text("Real models in heaps of ten: %s objects, %s triangles",
                      short_count(num).c_str(), short_count(num_triangles(*scene)).c_str()));
  Samples contacts;
  contacts.add(timed([&] { update_contacts(*scene, kScaleClearance); }));
  report.add({"contacts of all of them", contacts, 0, 0, ""});
  ResultHash hash;
  const Rotation tilted = Rotation::about_axis(Vec3(1, 2, 3).normalized(), 0.2);
  const Vec3 between(0.5 * kHeapSpacing, 0.5 * kHeapSpacing, 1), upon(0.05, 0.05, 1);
  report.add({"PUT between four heaps",
              repeated(*scene, PutOperation{{"more"}, {tilted, between}, {}}, hash), 0, 0, ""});
  report.add({"PUT onto a heap", repeated(*scene, PutOperation{{"more"}, {tilted, upon}, {}}, hash),
              0, 0, ""});
  report.add({"PUSH of a cup by 5 cm", repeated(*scene, push_of("cup_0", 0.05), hash), 0, 0, ""});
  report.add_hash(hash.value());
  report.add(check_row(*scene));
  Session session(std::move(*scene), {}, {});
  report.add(
      {"a session's step, PUSH of a cup by 1 cm", session_steps(session, "cup_0"), 0, 0, ""});
}

}  // namespace

void real_scale_rows(Report& report) {
  if (!std::filesystem::exists(TRIVET_SHARED_DIR "/data/models")) {
    report.remark("real models: 1,000 and 3,000 objects",
                  "skipped: no ../shared/data/models beside the checkout");
    return;
  }
  const Scene one = heap();
  for (const int num : kNumRealObjects) add_rows(one, num, report);
}

}  // namespace trivet::perf
