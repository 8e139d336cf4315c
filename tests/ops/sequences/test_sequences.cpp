// Random sequences of operations: after each of them the scene is valid, its load-support list is
// the one that follows from the poses, and the whole session goes back to its start and forth to
// its end, to the bit, on every backend and number of threads.
//
// TRIVET_TEST_EFFORT=50 runs 2,000; TRIVET_SEQUENCE=76 runs one and tells what it does,
// TRIVET_SEQUENCE=100-199 a hundred.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

#include "core/base/error.h"
#include "core/scene/fingerprint.h"
#include "ops/check.h"
#include "ops/detect/backend.h"
#include "random_sequence.h"
#include "support/effort.h"
#include "support/shared_data.h"
#ifdef TRIVET_HAS_GPU
#include "gpu/zlist_gpu.h"
#endif

namespace trivet::test {
namespace {

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
  const SceneCheck check = check_scene(scene, 1, kSequenceClearance);
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
  update_contacts(rebuilt, kSequenceClearance);
  const bool same = named(scene) == named(rebuilt);
  EXPECT_TRUE(same) << "the load-support list is not the one that follows from the poses";
  return valid && same;
}

void run_all(ModelKind kind, int count) {
  SequenceOptions options;
  options.holds = expect_valid;
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

TEST(Sequences, OfTheProjectsModels) { run_all(ModelKind::OfTheProject, with_effort(20)); }

TEST(Sequences, OfRealModels) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  run_all(ModelKind::Real, with_effort(20));
}

// --- the same on every backend -----------------------------------------------------------------

std::unique_ptr<Detector> detector(Backend backend, int num_threads) {
  BackendOptions options;
  options.backend = backend;
  options.num_threads = num_threads;
#ifdef TRIVET_HAS_GPU
  options.make_gpu_stage = [] { return make_gpu_zlist_stage(); };
#endif
  return make_detector(options);
}

struct Tried {
  Backend backend;
  int num_threads;
  std::unique_ptr<Detector> detector;
  double seconds = 0;
  int num_sequences = 0;
};

std::vector<Tried> all_backends() {
  std::vector<Tried> out;
  for (const Backend backend : {Backend::Bvh, Backend::Software, Backend::Gpu})
    for (const int num_threads : {1, 2, 4}) {
      if (backend == Backend::Gpu && num_threads != 4) continue;
      out.push_back({backend, num_threads, detector(backend, num_threads)});
      if (backend == Backend::Gpu && out.back().detector->name() != "gpu") out.pop_back();
    }
  return out;
}

void run_on_all(ModelKind kind, int count) {
  std::vector<Tried> tried = all_backends();
  for (const unsigned seed : chosen_seeds(count)) {
    const Outcome expected = run_sequence(seed, kind, {});
    for (Tried& t : tried) {
      SCOPED_TRACE("TRIVET_SEQUENCE=" + std::to_string(seed) + " on " + t.detector->name() +
                   " with " + std::to_string(t.num_threads) + " threads");
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                        static_cast<size_t>(t.num_threads));
      SequenceOptions options;
      options.detector = t.detector.get();
      const Outcome outcome = run_sequence(seed, kind, options);
      EXPECT_EQ(outcome.hash, expected.hash);
      t.seconds += outcome.seconds;
      ++t.num_sequences;
    }
  }
  for (const Tried& t : tried)
    std::printf("%s, %d threads: %d sequences, %.1f s, %lld queries, %lld fallbacks\n",
                t.detector->name().c_str(), t.num_threads, t.num_sequences, t.seconds,
                static_cast<long long>(t.detector->work().num_queries),
                static_cast<long long>(t.detector->work().fallbacks));
}

TEST(Sequences, OfTheProjectsModelsOnEveryBackend) {
  run_on_all(ModelKind::OfTheProject, with_effort(2));
}

TEST(Sequences, OfRealModelsOnEveryBackend) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  run_on_all(ModelKind::Real, with_effort(1));
}

}  // namespace
}  // namespace trivet::test
