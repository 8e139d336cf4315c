// Random sequences of operations: after each of them the scene is valid; its contacts, ratings and
// stability are the same bits as where it is saved and read again; and the whole session is undone
// to its start and redone to its end bit for bit, on every backend and number of threads.
//
// TRIVET_TEST_EFFORT=50 runs 2,000; TRIVET_SEQUENCE=76 runs one and prints its operations,
// TRIVET_SEQUENCE=100-199 a hundred.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/tunables.h"
#include "core/scene/fingerprint.h"
#include "ops/check/check.h"
#include "ops/detect/backend.h"
#include "ops/files/report/scene_file.h"
#include "ops/operations/perform.h"
#include "ops/settle/friction_settling.h"
#include "ops/stability/stability.h"
#include "ops/stability/weight.h"
#include "random_sequence.h"
#include "support/effort.h"
#include "support/same_scene.h"
#include "support/shared_data.h"
#ifdef TRIVET_HAS_GPU
#include "gpu/zlist/stage.h"
#endif

namespace trivet::test {
namespace {

// --- saved and read again --------------------------------------------------------------------

void add_to(Hash& hash, const Scene& scene, const Support& with) {
  hash.add(with.is_floor() ? "floor" : scene.at(with.object()).name);
}

void add_to(Hash& hash, const Vec3& v) {
  for (const double x : v) hash.add(x);
}

std::uint64_t hash_of_supports(const Scene& scene) {
  Hash hash;
  for (const LoadSupport::Entry& e : load_support(scene).entries) {
    std::set<std::string> supports, loads;
    for (const ObjectId id : e.supports) supports.insert(scene.at(id).name);
    for (const ObjectId id : e.loads) loads.insert(scene.at(id).name);
    hash.add(scene.at(e.object).name).add(std::uint64_t{e.on_floor});
    for (const auto* names : {&supports, &loads}) {
      hash.add(std::uint64_t{names->size()});
      for (const std::string& name : *names) hash.add(name);
    }
  }
  return hash.value();
}

std::uint64_t hash_of_stability(const Scene& scene) {
  StabilityOptions options;
  options.clearance = kSequenceClearance;
  const Stability s = stability(scene, options);
  Hash hash;
  hash.add(to_string(s.status)).add(to_string(s.method)).add(s.residual).add(s.margin);
  for (const ObjectStability& o : s.objects) {
    hash.add(scene.at(o.object).name).add(o.weight).add(o.margin);
    hash.add(std::uint64_t{o.topples} | std::uint64_t{o.marginal} << 1);
    add_to(hash, o.motion.velocity);
    add_to(hash, o.motion.spin);
  }
  for (const ContactForce& f : s.forces) {
    add_to(hash, scene, f.on);
    add_to(hash, scene, f.from);
    add_to(hash, f.point);
    add_to(hash, f.force);
  }
  return hash.value();
}

// @return whether the scene is the same after it was saved and read.
bool expect_same_in_file(const Scene& scene, const SettleOptions& settle) {
  SceneFileOptions options;
  options.clearance = kSequenceClearance;
  SceneFile file = read_scene_bytes(scene_file_bytes(scene, {}, options));
  update_contacts(file.scene, kSequenceClearance, settle);
  const std::string difference = difference_in_file(scene, file.scene);
  const bool same_supports = hash_of_supports(scene) == hash_of_supports(file.scene);
  const bool same_stability = hash_of_stability(scene) == hash_of_stability(file.scene);
  EXPECT_EQ(difference, "");
  EXPECT_TRUE(same_supports);
  EXPECT_TRUE(same_stability);
  return difference.empty() && same_supports && same_stability;
}

// --- invariants ------------------------------------------------------------------------------

bool is_reported(ObjectState state) {
  return state != ObjectState::Stable && state != ObjectState::Fixed;
}

// After a free move; one of the two objects carries the state.
bool is_invalid(const Scene& scene, const std::string& name) {
  const auto id = scene.find(name);  // not found for the floor
  return id && scene.at(*id).state == ObjectState::Invalid;
}

const LoadSupport::Entry* entry_of(const LoadSupport& list, ObjectId id) {
  for (const LoadSupport::Entry& e : list.entries)
    if (e.object == id) return &e;
  return nullptr;
}

// An object's carrier lists it, and takes it along when it is lifted by 4 mm.
void expect_lift_takes_along(const Scene& scene, ObjectId support, ObjectId load,
                             const SettleOptions& settle) {
  const Object& object = scene.at(support);
  if (object.fixed || object.locked || object.state == ObjectState::Invalid) return;
  Scene copy = scene;
  const OperationResult lifted =
      perform(copy, TranslateOperation{{{object.name}}, Vec3(0, 0, 0.004)}, settle);
  if (!lifted.ok()) return;  // something on it is locked or fixed
  EXPECT_TRUE(std::find(lifted.carried.begin(), lifted.carried.end(), scene.at(load).name) !=
              lifted.carried.end())
      << object.name << " leaves " << scene.at(load).name << " behind";
}

// By the report: linked from below, or a carrier by the forces of the whole.
std::vector<Support> listed_supports(const LoadSupport::Entry& e,
                                     const std::vector<CarriedBy>& carried) {
  std::vector<Support> out(e.supports.begin(), e.supports.end());
  if (e.on_floor) out.push_back(Support::floor());
  for (const CarriedBy& c : carried)
    if (c.object == e.object && std::find(out.begin(), out.end(), c.by) == out.end())
      out.push_back(c.by);
  return out;
}

// A body that pushes up more than a hundredth of its weight, by the forces that prove rest, is
// listed.
void expect_carriers_listed(const Scene& scene, const Stability& verdict, ObjectId id,
                            const std::vector<Support>& listed) {
  std::map<std::string, double> pushes;
  for (const ContactForce& f : verdict.forces)
    if (f.on == id) pushes[f.from.is_floor() ? "" : scene.at(f.from.object()).name] += f.force.z();
  for (const Support& by : listed) pushes.erase(by.is_floor() ? "" : scene.at(by.object()).name);
  for (const auto& [name, up] : pushes)
    EXPECT_LE(up, kCarriedPart * weight_of(scene.at(id)))
        << (name.empty() ? "the floor" : name) << " carries " << scene.at(id).name;
}

// Listed supports touch it, or nearly.
void expect_near(const Object& object, const Support& by) {
  const auto link = std::find_if(object.contacts.begin(), object.contacts.end(),
                                 [&](const ObjectContact& entry) { return entry.with == by; });
  ASSERT_TRUE(link != object.contacts.end()) << object.name;
  const double tolerance = link->across_gap ? kCarryingTolerance : kContactTolerance;
  for (const ContactPoint& p : link->contact.points)
    EXPECT_LE(p.gap, tolerance * kSequenceClearance) << object.name;
}

// One set of contacts and one verdict: who is at rest is held at its material's friction, by
// somebody; who carries it by the forces of the whole is listed, and nobody from afar; and lifted
// supports take it along.
void expect_told_supports(const Scene& scene, const SettleOptions& settle) {
  if (settle.perfect_friction) return;
  StabilityOptions of_whole;
  of_whole.clearance = kSequenceClearance;
  const Stability verdict = stability(scene, of_whole);
  const std::vector<CarriedBy> carried = carried_by_forces(scene, verdict);
  const LoadSupport list = load_support(scene);
  for (const ObjectId id : scene.ids()) {
    const Object& o = scene.at(id);
    if (!o.placed || o.fixed || o.state != ObjectState::Stable || !o.group.empty()) continue;
    EXPECT_LE(o.least_friction, o.material.friction) << o.name;
    const std::vector<Support> listed = listed_supports(*entry_of(list, id), carried);
    EXPECT_FALSE(listed.empty()) << o.name << " is held by nothing";
    if (verdict.stable()) expect_carriers_listed(scene, verdict, id, listed);
    for (const Support& by : listed) {
      expect_near(o, by);
      if (by.is_object()) expect_lift_takes_along(scene, by.object(), id, settle);
    }
  }
}

// @return whether the scene is valid.
bool expect_valid(const Scene& scene, const SettleOptions& settle) {
  bool valid = true;
  std::set<std::string> crossing;
  const SceneCheck check = check_scene(scene, 1, kSequenceClearance, settle);
  for (const auto* findings : {&check.crossings, &check.float32_crossings, &check.contained})
    for (const SceneCheck::PairFinding& f : *findings) {
      crossing.insert({f.a, f.b});
      if (is_invalid(scene, f.a) || is_invalid(scene, f.b)) continue;
      ADD_FAILURE() << f.a << " and " << f.b << ": " << f.count << " pairs interpenetrate";
      valid = false;
    }
  for (const std::string& name : check.not_at_rest)
    if (!is_reported(scene.at(*scene.find(name)).state)) {
      ADD_FAILURE() << name << " is not at rest, and not reported so";
      valid = false;
    }
  for (const ObjectId id : scene.ids())
    if (const Object& o = scene.at(id); is_invalid(scene, o.name) && !crossing.count(o.name)) {
      ADD_FAILURE() << o.name << " is called invalid, and interpenetrates nothing";
      valid = false;
    }
  expect_told_supports(scene, settle);
  return valid && expect_same_in_file(scene, settle);
}

void run_all(ModelKind kind, int count, const SettleOptions& settle = perfect_friction()) {
  SequenceOptions options;
  options.settle = settle;
  options.holds = [&](const Scene& scene) { return expect_valid(scene, settle); };
  options.tell = is_one_seed();
  int num_done = 0, num_all = 0;
  Hash all;
  for (const unsigned seed : chosen_seeds(count)) {
    SCOPED_TRACE("TRIVET_SEQUENCE=" + std::to_string(seed));
    const Outcome one = run_sequence(seed, kind, options);
    num_done += one.num_done;
    num_all += kOperations;
    all.add(one.hash);
  }
  EXPECT_GT(num_done, num_all / 3) << "of " << num_all;
  std::printf("%d sequences, %d of %d operations done, hash %s\n", num_all / kOperations, num_done,
              num_all, all.text().c_str());
}

TEST(SequencesOfBuiltInModels, AreValidAndUndone) {
  run_all(ModelKind::OfTheProject, with_effort(20));
}

TEST(SequencesOfRealModels, AreValidAndUndone) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  run_all(ModelKind::Real, with_effort(20));
}

// The default rules: friction of the materials, the whole at rest.
TEST(SequencesOfBuiltInModels, AreValidAndUndoneWithFriction) {
  run_all(ModelKind::OfTheProject, with_effort(6), SettleOptions());
}

TEST(SequencesOfRealModels, AreValidAndUndoneWithFriction) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  run_all(ModelKind::Real, with_effort(6), SettleOptions());
}

// --- the same on every backend -----------------------------------------------------------------

std::unique_ptr<Detector> detector(Backend backend, int num_threads) {
  BackendOptions options;
  options.backend = backend;
  options.num_threads = num_threads;
#ifdef TRIVET_HAS_GPU
  options.make_gpu_stage = [](const GpuNotes&) { return make_gpu_candidate_finder(); };
#endif
  return make_detector(options);
}

/// Detectors of one backend, with several numbers of threads.
class Workers {
 public:
  Workers(Backend backend, const std::vector<int>& nums_of_threads) {
    for (const int num : nums_of_threads) {
      m_detectors.push_back(detector(backend, num));
      m_workers.push_back({m_detectors.back().get(), num});
    }
  }
  std::string name() const { return m_detectors.front()->name(); }
  const std::vector<Worker>& all() const { return m_workers; }
  void tell(size_t num_sequences, double seconds) const {
    std::int64_t queries = 0, fallbacks = 0;
    for (const auto& d : m_detectors)
      queries += d->work().num_queries, fallbacks += d->work().fallbacks;
    std::printf("%s: %zu sequences, %.1f s, %lld queries, %lld fallbacks\n", name().c_str(),
                num_sequences, seconds, static_cast<long long>(queries),
                static_cast<long long>(fallbacks));
  }

 private:
  std::vector<std::unique_ptr<Detector>> m_detectors;
  std::vector<Worker> m_workers;
};

/// Expects the same scenes as with BVHs in one thread.
void compare(ModelKind kind, int count, const SettleOptions& settle = perfect_friction()) {
  const std::vector<unsigned> seeds = chosen_seeds(count);
  std::vector<Outcome> expected;
  Hash all;
  SequenceOptions plain;
  plain.settle = settle;
  for (const unsigned seed : seeds) {
    expected.push_back(run_sequence(seed, kind, plain));
    all.add(expected.back().hash);
  }
  std::printf("%zu sequences, hash %s\n", seeds.size(), all.text().c_str());
  const std::vector<int> one_to_four = {1, 2, 4};
  for (const auto& [backend, nums_of_threads] :
       {std::pair(Backend::Bvh, one_to_four), std::pair(Backend::Software, one_to_four),
        std::pair(Backend::Gpu, std::vector<int>{4})}) {
    const Workers workers(backend, nums_of_threads);
    if (backend == Backend::Gpu && workers.name() != "gpu") GTEST_SKIP() << "no GPU z-lists here";
    double seconds = 0;
    for (size_t i = 0; i < seeds.size(); ++i) {
      SCOPED_TRACE("TRIVET_SEQUENCE=" + std::to_string(seeds[i]) + " on " + workers.name());
      SequenceOptions options = plain;
      options.workers = workers.all();
      const Outcome outcome = run_sequence(seeds[i], kind, options);
      EXPECT_EQ(outcome.hash, expected[i].hash);
      seconds += outcome.seconds;
    }
    workers.tell(seeds.size(), seconds);
  }
}

TEST(SequencesOfBuiltInModels, AreTheSameOnEveryBackendAndNumberOfThreads) {
  compare(ModelKind::OfTheProject, with_effort(2));
}

TEST(SequencesOfRealModels, AreTheSameOnEveryBackendAndNumberOfThreads) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  compare(ModelKind::Real, with_effort(2));
}

TEST(SequencesOfRealModels, AreTheSameOnEveryBackendWithFriction) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  compare(ModelKind::Real, with_effort(1), SettleOptions());
}

}  // namespace
}  // namespace trivet::test
