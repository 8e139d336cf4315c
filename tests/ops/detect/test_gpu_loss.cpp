// A GPU that is lost while it answers queries and places: one note, and the right answers.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/candidates/gpu_notes.h"

#ifdef TRIVET_HAS_GPU
#include "gpu/zlist/drop_brackets_gpu.h"
#include "gpu/zlist/stage.h"
#include "ops/detect/backend.h"
#include "raster/height_map/drop_brackets.h"
#include "support/random_queries.h"
#endif

namespace trivet {
namespace {

TEST(GpuNotes, TellEachKindOnce) {
  std::vector<std::string> told;
  const GpuNotes notes = once_each([&](const Sentence& text) { told.push_back(in_english(text)); });
  const std::vector<GpuNotes> copies(2, notes);
  notes.tell_recovered("a");
  copies[0].tell_recovered("b");
  copies[1].tell_lost("c");
  notes.tell_lost("d");
  notes.tell_recovered("e");
  EXPECT_EQ(told, (std::vector<std::string>{"a", "c"}));
  GpuNotes().tell_lost("nobody listens");
  once_each(GpuNotes::Note()).tell_lost("nobody listens");
}

TEST(GpuNotes, TellNoRecoveryAfterALoss) {
  std::vector<std::string> told;
  const GpuNotes notes = once_each([&](const Sentence& text) { told.push_back(in_english(text)); });
  notes.tell_lost("a");
  notes.tell_recovered("b");
  EXPECT_EQ(told, std::vector<std::string>{"a"});
}

#ifdef TRIVET_HAS_GPU
constexpr unsigned kLossSeed = 1914;
constexpr int kNumQueries = 40, kFaultAt = 4;

/// A renderer that is said to be hardware, for queries and places. A fault at some query, or place,
/// after which the device is or is not there.
struct Lossy {
  explicit Lossy(bool away) : stays_away(away) {}

  bool stays_away, is_armed = false, was_reset = false;
  int num_asked = 0, num_contexts_lost = 0;
  std::vector<std::string> notes;

  GpuFaults faults() {
    GpuFaults out;
    // A reset is seen once, by the context that lived then.
    out.resets = [this, seen = std::make_shared<bool>()] {
      was_reset = was_reset || (is_armed && ++num_asked > kFaultAt);
      const bool sees = was_reset && !std::exchange(*seen, true);
      num_contexts_lost += sees;
      return sees;
    };
    out.is_gone = [this] { return stays_away && was_reset; };
    return out;
  }

  std::unique_ptr<Detector> detector(Backend backend) {
    const auto make = [this](GpuNotes told) {
      GpuZListOptions gpu;
      gpu.method = GpuMethod::Compute;
      gpu.resolution = 32;
      gpu.notes = std::move(told);
      if (!m_stage_faults) m_stage_faults = faults();
      gpu.faults = *m_stage_faults;
      return make_gpu_candidate_finder(gpu);
    };
    BackendOptions options;
    options.backend = backend;
    options.note = [this](const Sentence& note) { notes.push_back(in_english(note)); };
    options.make_gpu_stage = make;
    options.make_gpu_brackets = [this](bool) -> DropBracketFunction {
      if (!m_bracket_faults) m_bracket_faults = faults();
      const auto gpu = std::make_shared<GpuDropBrackets>(EglOptions{}, *m_bracket_faults);
      return [gpu](const HeightMap& object, const HeightMap& scene, int columns, int rows) {
        return (*gpu)(object, scene, columns, rows);
      };
    };
    const CostModel slow{10, 0, 0, 0}, fast{0.01, 0, 0, 0};
    const std::string device = make({})->device();
    MachineOptions machine;
    machine.hardware = "a card";
    machine.gpu = {{"gpu compute", [make](bool, const GpuNotes& told) { return make(told); }}};
    options.machine = std::make_shared<Machine>(
        machine, Calibration{{},
                             0,
                             {{"bvh", "cpu", true, "", 0, slow, slow},
                              {"gpu compute", device, false, "", 0, fast, fast}}});
    return make_detector(options);
  }

 private:
  std::optional<GpuFaults> m_stage_faults, m_bracket_faults;
};

struct LossCase {
  Backend backend;
  bool stays_away, places;
};

class GpuLoss : public testing::TestWithParam<LossCase> {};

void ask_for_places(Detector& detector, bool wants_gpu) {
  const HeightMap object(24, 24, 0.5F), scene(224, 224, 0.125F);
  const auto truth = drop_brackets(object, scene, 200, 200);
  const std::int64_t before = detector.work().places_on_gpu;
  for (int i = 0; i < 2000; ++i) {
    const auto found = detector.drop_brackets(object, scene, 200, 200);
    ASSERT_EQ(found.size(), truth.size());
    for (size_t k = 0; k < truth.size(); ++k) {
      ASSERT_EQ(found[k].lower, truth[k].lower);
      ASSERT_EQ(found[k].upper, truth[k].upper);
    }
    if (!wants_gpu || detector.work().places_on_gpu > before) break;
  }
}

TEST_P(GpuLoss, IsToldOnceForQueriesAndPlaces) {
  const LossCase& c = GetParam();
  Lossy lossy(c.stays_away);
  std::unique_ptr<Detector> detector;
  try {
    const GpuDropBrackets available;
    detector = lossy.detector(c.backend);
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  if (c.places) ask_for_places(*detector, true);
  const test::MeshPool pool(kLossSeed, 4);
  Detector trees;
  for (int i = 0; i < kNumQueries; ++i) {
    if (i == 1) {
      EXPECT_EQ(detector->name(), c.backend == Backend::Auto ? "gpu compute" : "gpu");
      EXPECT_EQ(detector->work().fallbacks, 0);
      EXPECT_TRUE(lossy.notes.empty());
      lossy.is_armed = true;
    }
    test::random_query(pool, kLossSeed, i).ask([&](const FirstContactQuery& query) {
      const FirstContact truth = trees.first_contact(query);
      EXPECT_TRUE(test::same_answer(detector->first_contact(query), truth)) << i;
      return 0;
    });
  }
  if (c.places) ask_for_places(*detector, false);
  EXPECT_EQ(lossy.num_contexts_lost, c.places ? 2 : 1);
  EXPECT_EQ(detector->work().fallbacks > 0, c.stays_away);
  ASSERT_EQ(lossy.notes.size(), 1u) << lossy.notes.back();
  EXPECT_NE(lossy.notes[0].find(c.stays_away ? "BVHs and software answer instead of the GPU"
                                             : "a new OpenGL context goes on"),
            std::string::npos)
      << lossy.notes[0];
}

INSTANTIATE_TEST_SUITE_P(
    Cases, GpuLoss,
    testing::Values(LossCase{Backend::Auto, false, false}, LossCase{Backend::Auto, false, true},
                    LossCase{Backend::Auto, true, false}, LossCase{Backend::Auto, true, true},
                    LossCase{Backend::Gpu, false, true}, LossCase{Backend::Gpu, true, true}),
    [](const auto& one) {
      const LossCase& c = one.param;
      return std::string(c.backend == Backend::Auto ? "Auto" : "Gpu") +
             (c.stays_away ? "Gone" : "Reset") + (c.places ? "WithPlaces" : "");
    });
#endif

}  // namespace
}  // namespace trivet
