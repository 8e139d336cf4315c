// Draws and read-backs of whole operations: with a draw for each query, and with queries that share
// draws, as all programs ask them.
#include <functional>
#include <thread>

#include "apps/demo/arranged.h"
#include "apps/demo/demo.h"
#include "apps/farm/scene/make_scene.h"
#include "core/base/error.h"
#include "gpu/zlist/stage.h"
#include "ops/detect/detector.h"
#include "ops/detect/gathered_stage.h"
#include "ops/files/layout/run.h"
#include "perf/breakfast_recipe.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::perf {
namespace {

constexpr std::uint64_t kSceneSeed = 1;
constexpr int kScenesOfBatch = 8;  // that a worker makes side by side

constexpr const char* kHeapRecipe = R"({"trivet_recipe": 1, "groups": [{"name": "heap",
  "models": [{"model": "apple.glb"}, {"model": "banana.glb"}, {"model": "cup.glb"},
    {"model": "toast.glb"}, {"model": "bowl.glb"}, {"model": "spoon.glb"}],
  "count": 12, "rotation": "any", "heap": {"radius": 0.08, "height": 0.1, "rise": 0.05}}]})";

using Piece = std::function<void(Detector& detector, ResultHash& hash)>;

/// Pieces can be done side by side.
struct Task {
  std::string name;
  std::vector<Piece> pieces;
};

/// The stage without what it can do for many queries: each has a draw of its own, none is early.
class OneQueryADraw : public CandidateFinder {
 public:
  explicit OneQueryADraw(std::unique_ptr<CandidateFinder> stage) : m_stage(std::move(stage)) {}
  std::string name() const override { return m_stage->name(); }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override {
    return m_stage->find_candidates(query, horizon);
  }

 private:
  std::unique_ptr<CandidateFinder> m_stage;
};

void add_poses(const Scene& scene, ResultHash& hash) {
  for (const ObjectId id : scene.ids())
    if (scene.at(id).placed) hash.add(scene.at(id).pose);
}

Task breakfast_puts() {
  const auto demo = std::make_shared<DemoLayout>(make_demo("breakfast"));
  return {"PUT, all of BREAKFAST", {[demo](Detector& detector, ResultHash& hash) {
            const ModelSource source = [&](const std::string& file, const Tessellation&) {
              return demo->model(file);
            };
            RunOptions options;
            options.num_threads = 1;
            options.context.detector = &detector;
            add_poses(run_layout(demo->layout, source, options).scene, hash);
          }}};
}

/// A recipe with its models.
struct Source {
  farm::Recipe recipe;
  LoadedModels models;
  farm::PhiloxKey key;
};

Task scenes_of(const std::string& name, const std::string& recipe,
               const std::vector<DemoModel>& models, int num_scenes) {
  const auto source = std::make_shared<Source>();
  source->recipe = farm::parse_recipe(recipe, name);
  source->key = farm::recipe_key(recipe, kSceneSeed);
  for (const DemoModel& made : models)
    source->models[{made.file, {}}] = {std::make_shared<Model>(made.model),
                                       make_shape(made.model.mesh)};
  Task out{name, {}};
  for (int k = 0; k < num_scenes; ++k)
    out.pieces.emplace_back([source, k](Detector& detector, ResultHash& hash) {
      farm::SceneSource from{source->recipe, source->models, source->key};
      from.context.detector = &detector;
      add_poses(farm::make_scene(from, static_cast<std::uint64_t>(k)).run.scene, hash);
    });
  return out;
}

std::vector<Task> all_tasks() {
  const std::vector<DemoModel> models = make_demo("breakfast").models;
  const ArrangedDemo table = make_arranged_demo("tight-table");
  std::vector<Task> out;
  out.push_back(breakfast_puts());
  out.push_back(scenes_of("a heap of 12", kHeapRecipe, models, 1));
  out.push_back(scenes_of("arrange, TIGHT-TABLE", table.recipe, table.models, 1));
  out.push_back(scenes_of(text("batch, %d scenes like BREAKFAST", kScenesOfBatch), kBreakfastRecipe,
                          models, kScenesOfBatch));
  return out;
}

/// Detectors of a task's pieces that share one stage.
class Stage {
 public:
  Stage(std::unique_ptr<CandidateFinder> stage, bool shares)
      : m_gathered(std::move(stage)), m_shares(shares) {}

  std::unique_ptr<Detector> detector() {
    std::unique_ptr<CandidateFinder> member = m_gathered.join();
    if (!m_shares) member = std::make_unique<OneQueryADraw>(std::move(member));
    return std::make_unique<Detector>(std::move(member), "gpu");
  }
  bool shares() const { return m_shares; }

 private:
  GatheredStage m_gathered;
  bool m_shares;
};

std::unique_ptr<CandidateFinder> make_stage() {
  GpuZListOptions options;
  options.software_lists = std::make_shared<SoftwareDoubtfulLists>();
  return make_gpu_candidate_finder(options);
}

/// A piece that is done.
struct Done {
  ResultHash hash;
  DetectionWork work;
};

// The detector ends with its piece: the others' queries wait for it no more.
Done done(const Piece& piece, std::unique_ptr<Detector> detector) {
  Done out;
  piece(*detector, out.hash);
  out.work = detector->work();
  return out;
}

std::vector<Done> in_turn(const Task& task,
                          const std::function<std::unique_ptr<Detector>()>& detector) {
  std::vector<Done> out;
  for (const Piece& piece : task.pieces) out.push_back(done(piece, detector()));
  return out;
}

// A thread for each piece, as in a worker of a batch.
std::vector<Done> side_by_side(const Task& task, Stage& stage) {
  std::vector<Done> out(task.pieces.size());
  std::vector<std::unique_ptr<Detector>> detectors;
  for (std::size_t i = 0; i < out.size(); ++i) detectors.push_back(stage.detector());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < out.size(); ++i)
    threads.emplace_back([&, i] { out[i] = done(task.pieces[i], std::move(detectors[i])); });
  for (std::thread& thread : threads) thread.join();
  return out;
}

struct Tally {
  std::int64_t queries = 0, early = 0, draws = 0, read_backs = 0;
  Samples samples;
  ResultHash hash;

  void add(const Done& piece) {
    queries += piece.work.num_queries;
    early += piece.work.early;
    draws += piece.work.zlist.draws;
    read_backs += piece.work.zlist.read_backs;
    hash.add(piece.hash.value());
  }
};

Tally tally(const Task& task, bool shares) {
  Stage stage(make_stage(), shares);
  std::vector<Done> pieces;
  Tally out;
  out.samples.add(timed(
      [&] {
        pieces =
            shares ? side_by_side(task, stage) : in_turn(task, [&] { return stage.detector(); });
      },
      CLOCK_PROCESS_CPUTIME_ID));
  for (const Done& piece : pieces) out.add(piece);
  return out;
}

std::uint64_t truth_of(const Task& task) {
  Tally out;
  for (const Done& piece : in_turn(task, [] { return std::make_unique<Detector>(); }))
    out.add(piece);
  return out.hash.value();
}

std::string cell(std::int64_t count) { return text(" %lld |", static_cast<long long>(count)); }

std::string table_line(const Task& task, const Tally& before, const Tally& after) {
  const auto asked = static_cast<double>(after.queries + after.early);
  return "| " + task.name + " |" + cell(before.queries) + cell(before.draws) +
         cell(before.read_backs) + cell(after.queries) + cell(after.early) + cell(after.draws) +
         cell(after.read_backs) + text(" %.2f |", asked / static_cast<double>(after.draws)) +
         text(" %.2f |\n", static_cast<double>(after.draws) / static_cast<double>(before.draws));
}

void add_row(const Task& task, const char* how, const Tally& tally, std::uint64_t truth,
             Report& report) {
  report.add({task.name + ", " + how, tally.samples, 0, 0,
              text("%lld queries, %lld asked early, %lld draws, %lld read-backs; %s",
                   static_cast<long long>(tally.queries), static_cast<long long>(tally.early),
                   static_cast<long long>(tally.draws), static_cast<long long>(tally.read_backs),
                   tally.hash.value() == truth ? "the same bits" : "WRONG")});
}

std::string measure_task(const Task& task, Report& report) {
  const std::uint64_t truth = truth_of(task);
  const Tally before = tally(task, false), after = tally(task, true);
  add_row(task, "a draw for each query", before, truth, report);
  add_row(task, "sharing draws", after, truth, report);
  return table_line(task, before, after);
}

}  // namespace

void draw_rows(Report& report) try {
  report.section("Draws of whole operations, " + make_stage()->name());
  std::string lines;
  for (const Task& task : all_tasks()) lines += measure_task(task, report);
  report.append(
      "\n## Draws of whole operations\n\nBefore: a draw for each query. After: motions of a step "
      "and scenes of a worker share draws.\nA query may need more than one draw, or none.\n\n"
      "| work | queries before | draws | read-backs | queries after | asked early | draws | "
      "read-backs | queries a draw | draws, of before |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n" +
      lines);
} catch (const Error& e) {
  report.remark("draws", e.what());
}

}  // namespace trivet::perf
