#include <iostream>

#include "apps/farm/batch/exports.h"
#include "apps/farm/batch/source.h"
#include "apps/farm/batch/stop_signals.h"
#include "apps/trivet/verb_batch_parts.h"

namespace trivet::apps {
namespace {

using namespace trivet::farm;

struct ExportBatchArguments {
  std::string scenes, shard;
  std::vector<std::string> kinds;
  std::uint64_t per_unit = 0;
  BatchOptions options;
};

int make(const ExportBatchArguments& arguments, const CommonOptions& common) {
  come_again_when_stopped();
  BatchRun run = exports_of(arguments.scenes, arguments.kinds);
  run.version = TRIVET_VERSION;
  if (arguments.per_unit > 0) run.per_unit = arguments.per_unit;
  BatchOptions options = arguments.options;
  const StopSignals from_here;  // as of scenes
  check_run(options.out, run);
  const Work work = export_work(run, arguments.scenes, options.out, common.limits());
  options.shard = arguments.shard.empty() ? shard_from_environment(process_environment())
                                          : shard_from_text(arguments.shard);
  options.jobs = num_jobs(options.jobs, common);
  report_to_terminal(options, common);
  options.on_models_read = [&] { claim_run(options.out, run); };
  options.is_ready = [&](std::uint64_t unit) {
    return scenes_are_there(run, arguments.scenes, work.exports->scenes, unit);
  };
  return print_totals(run_batch(run, work, options), options, common);
}

}  // namespace

Verb add_batch_export(CLI::App& batch, const CommonOptions& common) {
  CLI::App* const verb =
      batch.add_subcommand("export", "Write simulator files of a batch's scenes, from their poses")
          ->fallthrough();
  const auto a = std::make_shared<ExportBatchArguments>();
  verb->add_option("folder", a->scenes, "The batch of the scenes: --out of trivet batch")
      ->required()
      ->type_name("DIR");
  verb->add_option("--out", a->options.out,
                   "Folder of the files; meshes that scenes share are in its folder meshes")
      ->required()
      ->type_name("DIR");
  verb->add_option("--as", a->kinds, "Formats to write, with commas between them")
      ->required()
      ->check(one_of(export_kinds()))
      ->delimiter(',');
  verb->add_option("--shard", a->shard, "Make every N-th unit from I; default: as for trivet batch")
      ->type_name("I/N");
  verb->add_option("--per-folder", a->per_unit, "Scenes per folder; default: as the scenes")
      ->check(integer_from(1, 1'000'000));
  add_worker_options(*verb, a->options.jobs, a->options.limits);
  return {verb, [a, &common] { return make(*a, common); }, "", true,
          [a] {
            return VerbFiles{{}, {}, {}, {a->options.out}};
          }};
}

}  // namespace trivet::apps
