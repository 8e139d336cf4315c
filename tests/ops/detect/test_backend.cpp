// Selection of the candidate finder, its replacement on failure, and statistics.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "ops/detect/backend.h"
#include "raster/height_map/drop_brackets.h"
#include "raster/zlist/software_zlists.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

/// Software z-lists that omit every second face.
class ForgetfulStage : public CandidateFinder {
 public:
  std::string name() const override { return "forgetful"; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    CandidatePairs out = m_stage.find_candidates(query, horizon);
    std::erase_if(out.pairs, [](const FacePair& p) { return p.face_moving % 2 == 0; });
    return out;
  }

 private:
  SoftwareZLists m_stage;
};

class StageThatGivesUp : public CandidateFinder {
 public:
  std::string name() const override { return "lazy"; }
  CandidatePairs find_candidates(const FirstContactQuery&, double) override { return {}; }
};

TEST(Backend, ListsNamesOfCommandLine) {
  EXPECT_EQ(backend_from_name("auto"), Backend::Auto);
  for (const char* name : {"gpu", "framebuffer", "compute"})
    EXPECT_EQ(backend_from_name(name), Backend::Gpu);
  EXPECT_EQ(backend_from_name("software"), Backend::Software);
  EXPECT_EQ(backend_from_name("bvh"), Backend::Bvh);
  EXPECT_THROW(backend_from_name("GPU"), Error);
}

TEST(Backend, ListsNamesOfConfirmation) {
  for (const char* name : {"auto", "embree", "off"})
    EXPECT_EQ(to_string(confirmation_from_name(name)), name);
  EXPECT_THROW(confirmation_from_name("Embree"), Error);
  BackendOptions options;
  options.backend = Backend::Software;
  options.confirmation = confirmation_from_name("off");
  EXPECT_EQ(to_string(make_detector(options)->confirmation()), "off");
}

TEST(Backend, SelfTestRejectsFaultyStages) {
  SoftwareZLists good;
  EXPECT_EQ(self_test(good), "");
  ForgetfulStage forgetful;
  EXPECT_NE(self_test(forgetful), "");
  StageThatGivesUp lazy;
  EXPECT_NE(self_test(lazy), "");
}

TEST(Backend, ReplacesUnavailableGpuByBvhs) {
  std::vector<std::string> notes;
  BackendOptions options;
  options.backend = Backend::Gpu;
  options.note = [&](const Sentence& note) { notes.push_back(in_english(note)); };
  EXPECT_EQ(make_detector(options)->name(), "bvh");  // a build without GPU support
  options.make_gpu_stage = [](const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
    throw Error(Error::Kind::Environment, "no EGL here");
  };
  EXPECT_EQ(make_detector(options)->name(), "bvh");
  options.make_gpu_stage = [](const GpuNotes&) { return std::make_unique<ForgetfulStage>(); };
  EXPECT_EQ(make_detector(options)->name(), "bvh");
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_NE(notes[1].find("no EGL here"), std::string::npos);
  EXPECT_NE(notes[2].find("forgetful fails its self-test"), std::string::npos);
  options.make_gpu_stage = [](const GpuNotes&) { return std::make_unique<SoftwareZLists>(); };
  EXPECT_EQ(make_detector(options)->name(), "gpu");
  EXPECT_EQ(notes.size(), 3u);
  options.backend = Backend::Auto;
  EXPECT_EQ(make_detector(options)->name(), "bvh");
}

TEST(Backend, CountsWorkOfEveryStage) {
  const test::MeshPool pool(5, 8);
  BackendOptions options;
  options.backend = Backend::Software;
  const std::unique_ptr<Detector> software = make_detector(options);
  Detector trees, lazy(std::make_unique<StageThatGivesUp>(), "lazy");
  constexpr int kNum = 200;
  for (int i = 0; i < kNum; ++i) {
    const test::RandomQuery q = test::random_query(pool, 5, i);
    q.ask([&](const FirstContactQuery& query) {
      const FirstContact truth = trees.first_contact(query);
      EXPECT_TRUE(test::same_answer(software->first_contact(query), truth));
      EXPECT_TRUE(test::same_answer(lazy.first_contact(query), truth));
      return 0;
    });
  }
  const DetectionWork& work = software->work();
  EXPECT_EQ(work.num_queries, kNum);
  EXPECT_EQ(work.fallbacks, 0);
  EXPECT_EQ(work.node_pairs, 0);
  EXPECT_GT(work.zlist.body_pairs, kNum / 4);
  EXPECT_GT(work.zlist.pixels, work.zlist.doubtful_pixels);
  EXPECT_GT(work.zlist.doubtful_pixels, kNum);
  EXPECT_GE(work.zlist.face_pairs, work.face_pairs);
  EXPECT_GT(work.face_pairs, kNum / 4);
  EXPECT_EQ(lazy.work().fallbacks, kNum);
  EXPECT_EQ(lazy.work().node_pairs, trees.work().node_pairs);
}

/// Brackets whose GPU takes `gpu_ms` and whose software takes 100 ms a request.
struct TimedBrackets {
  double now_ms = 0;
  int num_made = 0, num_on_gpu = 0;
  std::vector<std::string> notes;
  HeightMap object{2, 2, 0.5F}, scene{4, 3, 0.125F};

  /// @return of `num` requests, those that the GPU answered.
  int answered_by_gpu(double gpu_ms, int num, int most_on_gpu = 1000) {
    const auto on_gpu = [=, this](const HeightMap& o, const HeightMap& s, int columns, int rows) {
      if (++num_on_gpu > most_on_gpu) throw Error(Error::Kind::Environment, "context lost");
      now_ms += gpu_ms - 100;  // the clock adds 100
      return drop_brackets(o, s, columns, rows);
    };
    const auto make = [=, this]() -> DropBracketFunction { return ++num_made, on_gpu; };
    int num_asked = 0;
    FasterBrackets brackets(
        make, once_each([this](const Sentence& note) { notes.push_back(in_english(note)); }),
        [&] { return num_asked++ % 2 ? now_ms += 100 : now_ms; });
    int out = 0;
    for (int i = 0; i < num; ++i) out += brackets.find(object, scene, 3, 2).by_gpu;
    return out;
  }
};

TEST(FasterBrackets, BeginInSoftwareAndKeepTheFaster) {
  TimedBrackets few, fast, slow;
  EXPECT_EQ(few.answered_by_gpu(1, 3), 0);
  EXPECT_EQ(few.num_made, 0);
  EXPECT_EQ(fast.answered_by_gpu(99, 10), 7);
  EXPECT_EQ(fast.num_made, 1);
  EXPECT_EQ(slow.answered_by_gpu(101, 10), 2);  // one to warm up, one that was timed
  EXPECT_TRUE(fast.notes.empty() && slow.notes.empty());
}

TEST(FasterBrackets, StayInSoftwareOnceTheGpuFails) {
  TimedBrackets lost;
  EXPECT_EQ(lost.answered_by_gpu(1, 10, 4), 4);
  EXPECT_EQ(lost.num_on_gpu, 6);  // one of them by another context
  EXPECT_EQ(lost.num_made, 2);
  ASSERT_EQ(lost.notes.size(), 1u);
  EXPECT_NE(lost.notes[0].find("context lost"), std::string::npos);
}

// Places, too, never go to a renderer that runs on the CPU unless it was asked for.
TEST(Backend, AsksForHardwareForPlacesUnderAuto) {
  const HeightMap object(2, 2, 0.5F), scene(4, 3, 0.125F);
  for (const Backend backend : {Backend::Auto, Backend::Gpu}) {
    std::vector<bool> allowed;
    std::vector<std::string> notes;
    BackendOptions options;
    options.backend = backend;
    MachineOptions machine;
    machine.hardware = "a node without a driver";
    options.machine = std::make_shared<Machine>(machine, Calibration{});
    options.make_gpu_stage = [](const GpuNotes&) { return std::make_unique<SoftwareZLists>(); };
    options.note = [&](const Sentence& note) { notes.push_back(in_english(note)); };
    // Only a renderer that runs on the CPU is here.
    options.make_gpu_brackets = [&](bool allow_software) -> DropBracketFunction {
      allowed.push_back(allow_software);
      if (!allow_software) throw Error(Error::Kind::Environment, "runs on the CPU");
      return drop_brackets;
    };
    const auto detector = make_detector(options);
    const HeightMap large(64, 64, 0.5F), below(600, 400, 0.125F);
    for (int i = 0; i < 400 && allowed.empty(); ++i)
      detector->drop_brackets(large, below, 500, 300);  // until a GPU would pay
    for (int i = 0; i < 3; ++i) detector->drop_brackets(object, scene, 3, 2);
    ASSERT_EQ(allowed.size(), 1u);
    EXPECT_EQ(allowed[0], backend == Backend::Gpu);
    EXPECT_EQ(detector->work().places_on_gpu > 0, backend == Backend::Gpu);
    EXPECT_EQ(notes.size(), backend == Backend::Gpu ? 0u : 1u);
  }
}

// With an unavailable or failing GPU, brackets equal those of the software.
TEST(Backend, FallsBackToSoftwareForPlaces) {
  HeightMap object(2, 2, 0.5F), scene(4, 3, 0.125F);
  scene.bound[5] = 0.25F;
  const auto truth = drop_brackets(object, scene, 3, 2);
  int num_made = 0, num_asked = 0;
  BackendOptions options;
  std::vector<std::string> notes;
  options.note = [&](const Sentence& note) { notes.push_back(in_english(note)); };
  options.backend = Backend::Gpu;
  options.make_gpu_stage = [](const GpuNotes&) { return std::make_unique<SoftwareZLists>(); };
  const auto ask = [&](Detector& detector) {
    const auto found = drop_brackets_of(&detector)(object, scene, 3, 2);
    ASSERT_EQ(found.size(), truth.size());
    for (size_t i = 0; i < truth.size(); ++i) {
      EXPECT_EQ(found[i].lower, truth[i].lower);
      EXPECT_EQ(found[i].upper, truth[i].upper);
    }
  };
  // Works once, then fails.
  options.make_gpu_brackets = [&](bool) -> DropBracketFunction {
    ++num_made;
    return [&](const HeightMap& o, const HeightMap& s, int columns, int rows) {
      if (++num_asked > 1) throw Error(Error::Kind::Environment, "context lost");
      return drop_brackets(o, s, columns, rows);
    };
  };
  const auto breaks = make_detector(options);
  EXPECT_EQ(num_made, 0);
  for (int i = 0; i < 3; ++i) ask(*breaks);
  EXPECT_EQ(num_made, 2);
  EXPECT_EQ(num_asked, 3);
  EXPECT_EQ(breaks->work().places, 18);
  EXPECT_EQ(breaks->work().places_on_gpu, 6);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("context lost; BVHs and software answer"), std::string::npos);
  // Unavailable.
  options.make_gpu_brackets = [](bool) -> DropBracketFunction {
    throw Error(Error::Kind::Environment, "no OpenGL 4.3");
  };
  const auto without = make_detector(options);
  ask(*without);
  ask(*without);
  EXPECT_EQ(without->work().places_on_gpu, 0);
  EXPECT_EQ(notes.size(), 2u);
  // A GPU that was not selected is not used.
  options.backend = Backend::Software;
  ask(*make_detector(options));
  EXPECT_EQ(notes.size(), 2u);
}

}  // namespace
}  // namespace trivet
