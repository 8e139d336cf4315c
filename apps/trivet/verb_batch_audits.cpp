#include <algorithm>
#include <cstdio>
#include <iostream>

#include "apps/farm/batch/audit.h"
#include "apps/farm/batch/stop_signals.h"
#include "apps/trivet/outputs.h"
#include "apps/trivet/verb_batch_parts.h"
#include "core/base/count_of.h"

namespace trivet::apps {
namespace {

using namespace trivet::farm;

struct AuditArguments {
  std::string folder, output;
  std::uint64_t k = 0;
  VerifyOptions verify;
};

std::string missing_text(const BatchStatus& status) {
  constexpr size_t kMostShown = 10;
  std::string out;
  const size_t shown = std::min(status.first_missing.size(), kMostShown);
  for (size_t i = 0; i < shown; ++i)
    out += (i > 0 ? ", " : "") + std::to_string(status.first_missing[i]);
  const std::uint64_t others = status.run.num_units() - status.units_there - shown;
  return others == 0 ? out : out + " and " + count_of(others, "other");
}

Json reasons_json(const BatchStatus& status) {
  Json out = Json::object();
  for (const auto& [reason, count] : status.reasons) out[reason] = count;
  return out;
}

Json notes_json(const BatchStatus& status) {
  Json out = Json::array();
  for (const BatchNote& note : status.notes)
    out.push_back({{"scene", note.scene}, {"note", note.text}});
  return out;
}

void print_status(const BatchStatus& status, std::optional<double> seconds_left) {
  const std::uint64_t made = status.ok + status.refused + status.failed;
  std::cout << "units: " << status.units_there << " of " << status.run.num_units()
            << "; scenes: " << made << " of " << status.run.count << ": " << status.ok << " ok, "
            << status.refused << " refused, " << status.failed << " failed\n";
  if (!status.complete()) std::cout << "missing units: " << missing_text(status) << "\n";
  if (status.scenes_per_second) {
    std::cout << "rate: " << *status.scenes_per_second << " scenes/s";
    if (seconds_left && !status.complete())
      std::cout << ", about " << readable_duration(*seconds_left) << " left";
    std::cout << "\n";
  }
  if (status.num_temporaries > 0)
    std::cout << "being written, or left by processes that were killed: " << status.num_temporaries
              << "\n";
  for (const BatchNote& note : status.notes)
    std::cout << "note at scene " << note.scene << ": " << note.text << "\n";
  std::vector<std::pair<std::uint64_t, std::string>> reasons;
  for (const auto& [reason, count] : status.reasons) reasons.emplace_back(count, reason);
  std::stable_sort(reasons.begin(), reasons.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr size_t kMostShown = 20;
  for (size_t i = 0; i < std::min(reasons.size(), kMostShown); ++i)
    std::cout << "  " << reasons[i].first << " " << reasons[i].second << "\n";
  if (reasons.size() > kMostShown)
    std::cout << "  and " << reasons.size() - kMostShown << " other reasons\n";
}

int show_status(const AuditArguments& arguments, const CommonOptions& common) {
  const BatchStatus status = batch_status(arguments.folder);
  const std::uint64_t made = status.ok + status.refused + status.failed;
  std::optional<double> seconds_left;
  if (status.scenes_per_second)
    seconds_left = static_cast<double>(status.run.count - made) / *status.scenes_per_second;
  if (common.json)
    std::cout << json_line(
        {{"units", status.run.num_units()},
         {"units_there", status.units_there},
         {"first_missing", status.first_missing},
         {"scenes", status.run.count},
         {"ok", status.ok},
         {"refused", status.refused},
         {"failed", status.failed},
         {"scenes_per_second", status.scenes_per_second ? Json(*status.scenes_per_second) : Json()},
         {"seconds_left", seconds_left ? Json(*seconds_left) : Json()},
         {"temporaries", status.num_temporaries},
         {"notes", notes_json(status)},
         {"reasons", reasons_json(status)}});
  else
    print_status(status, seconds_left);
  return status.complete() ? 0 : 1;
}

int verify(const AuditArguments& arguments, const CommonOptions& common) {
  VerifyOptions options = arguments.verify;
  options.jobs = num_jobs(options.jobs, common);
  options.import = common.limits();
  options.version = TRIVET_VERSION;
  options.make_opengl = opengl_pictures(common, 0);
  options.before_opengl = [&] { tried_opengl(common); };
  options.detection = worker_detection(common, 0);
  const Verification result = verify_batch(arguments.folder, options);
  if (common.json) {
    std::cout << json_line(
        {{"units", result.units},
         {"scenes", result.scenes},
         {"made_again", result.made_again},
         {"findings", result.findings},
         {"other_version", result.other_version.empty() ? Json() : Json(result.other_version)}});
  } else {
    for (const std::string& finding : result.findings) std::cout << finding << "\n";
    std::cout << count_of(result.units, "unit") << ", " << count_of(result.scenes, "scene") << ", "
              << result.made_again << " made again: " << count_of(result.findings.size(), "finding")
              << "\n";
    if (!result.other_version.empty())
      std::cout << "Trivet " << result.other_version << " made this batch; only the same version "
                << "makes its scenes again, bit for bit.\n";
  }
  return result.stopped ? kComeAgain : !result.findings.empty();
}

int merge(const AuditArguments& arguments, const CommonOptions& common) {
  const std::uint64_t scenes = merge_manifests(arguments.folder, arguments.output);
  if (!common.quiet) std::cout << count_of(scenes, "scene") << "\n";
  return 0;
}

int write_one(const AuditArguments& arguments, const CommonOptions& common) {
  check_extension(arguments.output, {".glb", ".gltf", ".obj", ".ply", ".stl"});
  materialise(arguments.folder, arguments.k, arguments.output, common.limits());
  return 0;
}

}  // namespace

std::vector<Verb> add_batch_audits(CLI::App& batch, const CommonOptions& common) {
  using Action = int (*)(const AuditArguments&, const CommonOptions&);
  const auto arguments = std::make_shared<AuditArguments>();
  const auto add = [&](const char* name, const char* what, Action action) {
    CLI::App* const verb = batch.add_subcommand(name, what)->fallthrough();
    verb->add_option("folder", arguments->folder, "The batch: --out of trivet batch")
        ->required()
        ->type_name("DIR");
    return Verb{verb, [arguments, action, &common] { return action(*arguments, common); }, "", true,
                [arguments] {
                  return VerbFiles{{}, {arguments->output}};
                }};
  };
  std::vector<Verb> verbs{
      add("status",
          "Show the progress of a batch; the exit status is 0 when it is complete, else 1",
          show_status),
      add("verify", "Check every byte of a batch, and make a sample of scenes again", verify),
      add("merge", "Write one manifest of all units, and delete old temporary files", merge),
      add("materialise", "Write a scene as a file, from its poses", write_one)};
  verbs[1]
      .app
      ->add_option("--sample", arguments->verify.sample,
                   "Share of the scenes to make again, at least one; 0: none")
      ->check(number_from(0, 1));
  verbs[1]
      .app
      ->add_option("--scenes", arguments->verify.scenes,
                   "Batch of the scenes, for a batch of pictures")
      ->type_name("DIR");
  add_worker_options(*verbs[1].app, arguments->verify.jobs, arguments->verify.limits);
  verbs[3]
      .app->add_option("scene", arguments->k, "Its number")
      ->required()
      ->type_name("K")
      ->check(integer_from(0, std::numeric_limits<long>::max()));
  for (const size_t i : {2, 3})
    verbs[i]
        .app
        ->add_option("-o,--output", arguments->output,
                     i == 2 ? "The manifest: .jsonl or .csv" : "The scene: .glb, ...")
        ->required();
  return verbs;
}

}  // namespace trivet::apps
