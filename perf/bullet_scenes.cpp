// Scenes of a recipe as `trivet batch` makes them, and as generators do that let a simulator settle
// them (BlenderProc, with Bullet): what a scene costs, and what is wrong with it. Markdown.
#include <filesystem>
#include <iostream>

#include "apps/farm/batch/batch.h"
#include "apps/farm/scene/scene_json.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/read_model.h"
#include "ops/files/json/input_text.h"
#include "ops/files/layout/paths.h"
#include "perf/bullet_fall.h"
#include "perf/report.h"
#include "perf/sampled_starts.h"
#include "perf/timing.h"

namespace trivet::perf {
namespace {

namespace fs = std::filesystem;

constexpr double kAfterwards = 2;  // s, simulated, to see what still moves

struct Arguments {
  std::string recipe, out;
  std::uint64_t count = 0, seed = 0;
};

// Cost of a way of making scenes, and its findings.
struct Totals {
  std::string name;
  int scenes = 0, objects = 0, without = 0, not_stopped = 0, moving = 0;
  int interpenetrating = 0, not_at_rest = 0, misplaced = 0;
  std::int64_t tries = 0, pairs = 0;
  double cpu_ms = 0, simulated_s = 0;
};

class Comparison {
 public:
  explicit Comparison(const Arguments& arguments) : m_out(arguments.out) {
    const std::string text =
        read_input_text(arguments.recipe, ImportLimits{}.max_file_bytes, TextKind::Json);
    const farm::PreparedRecipe prepared =
        farm::prepare_recipe(text, arguments.recipe, folder_of(arguments.recipe));
    for (const farm::BatchModel& model : prepared.models) farm::store_model(model, m_out);
    farm::BatchRun run;
    run.seed = arguments.seed;
    m_work = farm::work_of(prepared, run, ImportLimits{}, "", false);
    m_models = farm::load_models(m_work);
  }

  void scene(std::uint64_t k) {
    farm::MadeScene made;
    m_trivet.cpu_ms +=
        timed([&] { made = farm::make_scene(source(), k); }, CLOCK_PROCESS_CPUTIME_ID).cpu_ms;
    Poses poses;
    for (const ObjectId id : made.run.scene.ids()) {
      const Object& object = made.run.scene.at(id);
      if (object.placed && !object.fixed) poses[object.name] = object.pose;
    }
    m_trivet.without += static_cast<int>(made.left_out.size());
    BulletFall afterwards(made.run.scene, poses, m_pieces, m_rules);
    judge(k, made, poses, afterwards.moves_within(kAfterwards), m_trivet);
    for (Way& way : m_ways) fall(k, made, way);
  }

  void print() const {
    std::cout << bullet_fall_version(m_rules) << "\n\n"
              << "| scenes | objects; left out | CPU s per scene | scenes per CPU s "
                 "| interpenetrate: scenes; pairs of objects in each | not at rest, or floating "
                 "| move within 2 s more, in Bullet | not over what the recipe names | tries; "
                 "seconds simulated; ended by the limit |\n"
              << "|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    print(m_trivet, false);
    for (const Way& way : m_ways) print(way.totals, true);
  }

 private:
  struct Way {
    Way(const std::string& name, PartRule rule, bool is_lifted)
        : parts(rule), lifted(is_lifted), totals{.name = name} {}
    PartStore parts;
    bool lifted;
    Totals totals;
  };

  farm::SceneSource source() const { return {m_work.recipe, m_models, m_work.key}; }

  void fall(std::uint64_t k, const farm::MadeScene& made, Way& way) {
    for (const ObjectId id : made.run.scene.ids()) way.parts.of(*made.run.scene.at(id).shape);
    const Stopwatch watch(CLOCK_PROCESS_CPUTIME_ID);
    const Starts starts = way.lifted ? lifted_starts(made) : sampled_starts(source(), k, made);
    BulletFall bullet(made.run.scene, starts.poses, way.parts, m_rules);
    const bool stopped = bullet.run();
    const Poses poses = bullet.poses();
    way.totals.cpu_ms += watch.elapsed().cpu_ms;
    way.totals.tries += starts.tries;
    way.totals.without += static_cast<int>(starts.without.size());
    way.totals.simulated_s += bullet.simulated_s();
    way.totals.not_stopped += stopped ? 0 : 1;
    judge(k, made, poses, bullet.moves_within(kAfterwards), way.totals);
  }

  // Verdict of `trivet check` on the layout that is left in the folder.
  void judge(std::uint64_t k, const farm::MadeScene& made, const Poses& poses, bool moves,
             Totals& totals) {
    const Layout layout = farm::layout_of_poses(m_work.recipe, with_poses(k, made, poses), "scene");
    const std::string file = m_out + "/" + totals.name + "-" + std::to_string(k) + ".json";
    write_file_atomically(file, write_layout(layout));
    const LayoutRun run = judged(layout);
    ++totals.scenes;
    totals.objects += static_cast<int>(poses.size());
    totals.interpenetrating += run.check.crossings.empty() && run.check.contained.empty() ? 0 : 1;
    totals.pairs +=
        static_cast<std::int64_t>(run.check.crossings.size() + run.check.contained.size());
    totals.not_at_rest += is_at_rest(run) ? 0 : 1;
    totals.misplaced += misplaced(m_work.recipe, made.run.scene, poses).empty() ? 0 : 1;
    totals.moving += moves ? 1 : 0;
  }

  static farm::Json with_poses(std::uint64_t k, const farm::MadeScene& made, const Poses& poses) {
    farm::Json scene = farm::scene_json(k, made);
    for (farm::Json& object : scene.at("objects")) {
      const auto pose = poses.find(object.at("name"));
      if (pose == poses.end()) {
        if (!object.contains("fixed")) object["position"] = object["rotation"] = nullptr;
        continue;
      }
      const Vec3& p = pose->second.translation;
      const Rotation& r = pose->second.rotation;
      object["position"] = {p.x(), p.y(), p.z()};
      object["rotation"] = {r.w, r.x, r.y, r.z};
    }
    return scene;
  }

  LayoutRun judged(const Layout& layout) const {
    RunOptions options;
    options.num_threads = 1;
    options.layout_file = "scene";
    return run_start_only(
        layout,
        [this](const std::string& name, const Tessellation& tessellation) {
          return *m_models.at({name, tessellation}).model;
        },
        options);
  }

  static bool is_at_rest(const LayoutRun& run) {
    return run.check.not_at_rest.empty() && run.stability.status != Stability::Status::Unstable;
  }

  static void print(const Totals& t, bool falls) {
    const double scenes = t.scenes, cpu_s = t.cpu_ms / 1e3;
    const auto share = [&](int number) { return text("%.0f %%", 100 * number / scenes); };
    std::cout << text("| %s | %.1f; %.2f | %.3f | %.2f | %s; %.2f | %s | %s | %s | ",
                      t.name.c_str(), t.objects / scenes, t.without / scenes, cpu_s / scenes,
                      scenes / cpu_s, share(t.interpenetrating).c_str(),
                      static_cast<double>(t.pairs) / scenes, share(t.not_at_rest).c_str(),
                      share(t.moving).c_str(), share(t.misplaced).c_str());
    if (falls)
      std::cout << text("%.0f; %.1f; %s |\n", static_cast<double>(t.tries) / scenes,
                        t.simulated_s / scenes, share(t.not_stopped).c_str());
    else
      std::cout << "|\n";
  }

  std::string m_out;
  farm::Work m_work;
  LoadedModels m_models;
  FallRules m_rules;
  PartStore m_pieces{PartRule::Decomposition};
  Totals m_trivet{.name = "trivet"};
  std::vector<Way> m_ways{{"bullet-hulls", PartRule::Hull, false},
                          {"bullet-pieces", PartRule::Decomposition, false},
                          {"bullet-hulls-lifted", PartRule::Hull, true},
                          {"bullet-pieces-lifted", PartRule::Decomposition, true}};
};

Arguments parsed(int argc, char** argv) {
  if (argc != 4 && argc != 5)
    throw Error(Error::Kind::BadInput,
                "usage: trivet_perf_bullet_scenes RECIPE.json COUNT DIR [SEED]");
  return {argv[1], argv[3], std::stoull(argv[2]), argc == 5 ? std::stoull(argv[4]) : 0};
}

int run(int argc, char** argv) {
  const Arguments arguments = parsed(argc, argv);
  fs::create_directories(arguments.out);
  Comparison comparison(arguments);
  for (std::uint64_t k = 0; k < arguments.count; ++k) {
    comparison.scene(k);
    std::cerr << "scene " << k << " of " << arguments.count << "\n";
  }
  comparison.print();
  return 0;
}

}  // namespace
}  // namespace trivet::perf

int main(int argc, char** argv) {
  try {
    return trivet::perf::run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "trivet_perf_bullet_scenes: " << e.what() << "\n";
    return 2;
  }
}
