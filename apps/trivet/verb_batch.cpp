#include <algorithm>
#include <iostream>
#include <set>

#include "apps/farm/batch/batch.h"
#include "apps/farm/batch/stop_signals.h"
#include "apps/farm/batch/templates.h"
#include "apps/trivet/verb_batch_parts.h"
#include "core/base/bad_input.h"
#include "core/base/count_of.h"
#include "ops/files/json/input_text.h"
#include "ops/files/layout/paths.h"

namespace trivet::apps {
namespace {

using namespace trivet::farm;

struct BatchArguments {
  std::string recipe, shard, format = "tar", engine;
  std::vector<std::string> with;
  std::vector<std::uint64_t> only;
  BatchRun run;
  BatchOptions options;
  bool dry_run = false;
  const CLI::App* verb = nullptr;
};

UnitFormat format_from_name(const std::string& name) {
  if (name == "dir") return UnitFormat::Dir;
  return name == "poses" ? UnitFormat::Poses : UnitFormat::Tar;
}

void check_arguments(const BatchArguments& a) {
  if (a.recipe.empty())
    bad_input(
        "batch: a recipe is missing; accepted: RECIPE.json, or pictures, export, status, verify, "
        "merge or materialise and the folder of a batch");
  if (a.run.count == 0) bad_input("--count is missing; accepted: the number of scenes");
  if (a.format == "poses" && !a.with.empty())
    bad_input("--with: is not accepted with --format poses; accepted: --format tar or dir");
  if (a.options.out.empty() && a.only.empty() && !a.dry_run && a.engine.empty())
    bad_input("--out is missing; accepted: a folder, or --only, --dry-run or --template");
  for (const std::uint64_t k : a.only)
    if (k >= a.run.count)
      bad_input("--only: %1 is not accepted; accepted: 0 to %2", k, a.run.count - 1);
}

BatchRun run_of(const BatchArguments& arguments) {
  BatchRun run = arguments.run;
  run.format = format_from_name(arguments.format);
  for (const std::string& what : arguments.with)
    (what == "scene"      ? run.with_scene
     : what == "contacts" ? run.with_contacts
                          : run.with_report) = true;
  run.version = TRIVET_VERSION;
  return run;
}

int print_plan(const BatchRun& run, const PreparedRecipe& prepared, const BatchOptions& options,
               const CommonOptions& common) {
  std::uint64_t units = 0, there = 0, scenes = 0;
  for (std::uint64_t t = options.shard.index; t < run.num_units(); t += options.shard.count) {
    ++units;
    scenes += run.end_scene(t) - run.first_scene(t);
    there += !options.out.empty() && unit_exists(options.out, t, run.format) ? 1 : 0;
  }
  if (common.json)
    std::cout << json_line({{"shard", options.shard.index},
                            {"shards", options.shard.count},
                            {"shard_from", options.shard.from},
                            {"units", units},
                            {"units_there", there},
                            {"scenes", scenes},
                            {"models", prepared.models.size()},
                            {"recipe_sha256", sha256_hex(prepared.canonical)}});
  else
    std::cout << "shard " << options.shard.index << " of " << options.shard.count << ": "
              << count_of(units, "unit") << ", " << there << " of them there; "
              << count_of(scenes, "scene") << ", " << count_of(prepared.models.size(), "model")
              << "; recipe " << sha256_hex(prepared.canonical) << "\n";
  return 0;
}

int print_only(const BatchArguments& arguments, const Work& work, const CommonOptions& common) {
  bool failed = false;
  const auto print = [&](const SceneMembers& made) {
    failed = failed || made.scene.at("status") == "failed";
    std::cout << json_line(made.scene) << std::flush;
  };
  const auto note = [&](const std::string& text) { print_note(common, text); };
  const bool done = make_only(work, arguments.only, arguments.options.jobs,
                              arguments.options.limits, print, note);
  return done ? failed : kComeAgain;
}

int make_batch(const BatchArguments& arguments, BatchRun run, const PreparedRecipe& prepared,
               const CommonOptions& common) {
  BatchOptions options = arguments.options;
  const StopSignals from_here;  // also before the first scene
  const WorkerDetection detection = worker_detection(common, first_worker_of(options));
  check_run(options.out, run);
  report_to_terminal(options, common);
  options.on_models_read = [&] {
    for (const BatchModel& model : prepared.models) store_model(model, options.out);
    claim_run(options.out, run);
  };
  Work work = work_of(prepared, run, common.limits(), options.out, false);
  work.detection = detection;
  return print_totals(run_batch(run, work, options), options, common);
}

BatchJob job_of(const BatchArguments& a) {
  const std::set<std::string> elsewhere = {"--count", "--seed",  "--per-tar", "--out",
                                           "--jobs",  "--shard", "--template"};
  BatchJob job;
  job.recipe = a.recipe;
  job.count = a.run.count, job.seed = a.run.seed, job.per_unit = a.run.per_unit;
  if (!a.options.out.empty()) job.out = a.options.out;
  job.jobs = std::max(1, a.options.jobs);
  if (const auto shards = shards_from_environment(process_environment())) job.shards = *shards;
  for (const CLI::Option* const option : a.verb->get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || option->get_lnames().empty() || elsewhere.count(name) != 0)
      continue;
    job.more.push_back(name);
    if (option->get_items_expected_max() > 0)
      job.more.push_back(CLI::detail::join(option->results(), ","));
  }
  return job;
}

int batch(const BatchArguments& given, const CommonOptions& common) {
  BatchArguments arguments = given;
  check_arguments(arguments);
  if (!arguments.engine.empty()) {
    std::cout << engine_template(arguments.engine, job_of(arguments));
    return 0;
  }
  come_again_when_stopped();
  arguments.options.shard = arguments.shard.empty() ? shard_from_environment(process_environment())
                                                    : shard_from_text(arguments.shard);
  arguments.options.jobs = num_jobs(arguments.options.jobs, common);
  const std::string text =
      read_input_text(arguments.recipe, common.limits().max_file_bytes, TextKind::Json);
  const PreparedRecipe prepared =
      prepare_recipe(text, arguments.recipe, folder_of(arguments.recipe));
  BatchRun run = run_of(arguments);
  run.recipe = prepared.canonical;
  if (arguments.dry_run) return print_plan(run, prepared, arguments.options, common);
  if (!arguments.only.empty()) {
    std::set<std::uint64_t> seen;
    std::erase_if(arguments.only, [&](std::uint64_t k) { return !seen.insert(k).second; });
    Work work = work_of(prepared, run, common.limits(), "", false);
    work.detection = worker_detection(common, 0);
    return print_only(arguments, work, common);
  }
  return make_batch(arguments, run, prepared, common);
}

void add_batch_options(CLI::App& verb, BatchArguments& a) {
  verb.add_option("recipe", a.recipe, "The recipe, JSON; see trivet schema recipe")
      ->type_name("RECIPE.json");
  verb.add_option("--count", a.run.count, "Number of scenes to make; they are numbered from 0")
      ->check(integer_from(1, 1'000'000'000'000));
  verb.add_option("--seed", a.run.seed, "Seed; each seed gives a different set of scenes")
      ->check(integer_from(0, std::numeric_limits<long>::max()));
  verb.add_option("--out", a.options.out,
                  "Folder of the batch; units that are there are not made again")
      ->type_name("DIR");
  verb.add_option("--shard", a.shard,
                  "I/N: every N-th unit from I; default: by the variables of Slurm, Kubernetes, "
                  "AWS Batch, GNU parallel, ..., else all")
      ->type_name("I/N");
  verb.add_option("--format", a.format,
                  "Form of units: tar, dir, or poses (a line of JSON per scene)")
      ->check(one_of({"tar", "dir", "poses"}));
  verb.add_option("--per-tar", a.run.per_unit, "Scenes per unit")
      ->check(integer_from(1, 1'000'000));
  verb.add_option("--with", a.with, "Store more than poses: scene (.glb), contacts, report (all)")
      ->check(one_of({"scene", "contacts", "report"}))
      ->delimiter(',');
  verb.add_option("--only", a.only, "Print these scenes as JSON, write nothing")
      ->type_name("K,...")
      ->delimiter(',');
  add_worker_options(verb, a.options.jobs, a.options.limits);
  verb.add_flag("--dry-run", a.dry_run, "Print the work that is left, and do nothing");
  verb.add_option(
          "--template", a.engine,
          "Print a job file for an engine, with the other options; TRIVET_SHARDS says how many "
          "shards")
      ->check(one_of({"slurm", "kubernetes", "aws-batch", "parallel"}));
}

}  // namespace

std::vector<Verb> add_batch(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb =
      app.add_subcommand("batch", "Make random scenes from a recipe, on one machine or many");
  const auto arguments = std::make_shared<BatchArguments>();
  arguments->verb = verb;
  add_batch_options(*verb, *arguments);
  std::vector<Verb> audits = add_batch_audits(*verb, common);
  audits.push_back(add_batch_pictures(*verb, common));
  audits.push_back(add_batch_export(*verb, common));
  return {{verb,
           [arguments, audits, &common] {
             for (const Verb& audit : audits)
               if (audit.app->parsed()) return audit.run();
             return batch(*arguments, common);
           },
           "trivet batch recipe.json --count 100 --seed 7 --out scenes\n"
           "trivet batch recipe.json --count 100 --seed 7 --out scenes --shard 2/8\n"
           "trivet batch recipe.json --count 100 --seed 7 --only 17\n"
           "trivet batch status scenes\n",
           true,
           [arguments, audits] {
             for (const Verb& audit : audits)
               if (audit.app->parsed()) return audit.files ? audit.files() : VerbFiles();
             // A plan or a job file may be for another machine.
             const bool writes = !arguments->dry_run && arguments->engine.empty();
             return VerbFiles{{}, {}, {}, {writes ? arguments->options.out : ""}};
           }}};
}

}  // namespace trivet::apps
