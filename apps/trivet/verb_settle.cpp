// settle and mend: scenes of other programs, written back with other poses.
#include <cstdio>
#include <iostream>

#include "apps/trivet/check_many.h"
#include "apps/trivet/verbs.h"
#include "core/base/count_of.h"
#include "core/base/error.h"
#include "core/base/quoted.h"
#include "ops/files/foreign/repair_json.h"

namespace trivet::apps {
namespace {

struct RepairArguments {
  std::string file, out;
  ForeignArguments foreign;
  SettleArguments settle;
  MendOptions how;
};

std::string move_text(const Scene& scene, const SettledObject& o) {
  char text[120];
  const double up = o.to.translation.z() - o.from.translation.z();
  std::snprintf(text, sizeof text, ": %.4g mm%s, turned by %.3g degrees\n", 1000 * o.moved,
                up > 0.7 * o.moved    ? " up"
                : up < -0.7 * o.moved ? " down"
                                      : "",
                o.turned_deg);
  return "  " + quoted(scene.at(o.id).name) + text;
}

void tell_moves(const Scene& scene, const SettledScene& settled) {
  std::cout << count_of(settled.moved.size(), "object") << " moved\n";
  for (const SettledObject& o : settled.moved) std::cout << move_text(scene, o);
  for (const UnsettledObject& o : settled.unable)
    std::cout << "  " << quoted(scene.at(o.id).name) << " stays where it was: " << in_english(o.why)
              << "\n";
}

std::string quoted_names(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + quoted(name);
  return out;
}

void tell_relations(const MendedScene& mended) {
  if (mended.num_meant == 0) return;
  char text[120];
  std::snprintf(text, sizeof text,
                "%zu of %zu supports kept; poses were taken to be off by %.3g mm\n",
                mended.num_kept, mended.num_meant, 1000 * mended.tolerance);
  std::cout << text;
  for (const ChangedRelation& r : mended.relations) {
    std::cout << "  " << quoted(r.object);
    if (!r.lost.empty()) std::cout << " no longer rests on " << quoted_names(r.lost);
    if (!r.gained.empty())
      std::cout << (r.lost.empty() ? " now rests on " : ", but on ") << quoted_names(r.gained)
                << (r.lost.empty() ? ", too" : "");
    std::cout << "\n";
  }
}

OpenedScene opened_for_repair(const RepairArguments& arguments, const CommonOptions& common) {
  if (!is_of_others(arguments.file))
    throw Error(Error::Kind::BadInput,
                "%1: is not a scene of another program; accepted: MJCF, URDF, SDF, glTF",
                arguments.file);
  return open_scene(arguments.file, open_options(arguments.foreign, common));
}

nlohmann::ordered_json repaired_json(const OpenedScene& opened, const SettledScene& settled) {
  return settled_json(opened.judged.scene, opened.judged.lift, settled);
}
nlohmann::ordered_json repaired_json(const OpenedScene& opened, const MendedScene& mended) {
  return mended_json(opened.judged.scene, opened.judged.lift, mended);
}

// @param repair  changes the scene, and tells.
template <class Repair>
int repair_file(const RepairArguments& arguments, const CommonOptions& common,
                const Repair& repair) {
  OpenedScene opened = opened_for_repair(arguments, common);
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, arguments.settle, detector.get());
  if (!(options.settle.clearance > 0)) options.settle.clearance = opened.judged.clearance;
  MendOptions how = arguments.how;
  how.settle = options.settle;
  how.context = options.context;
  const auto repaired = repair(opened.judged.scene, how);
  NewPoses poses;
  for (const SettledObject& o : repaired.moved) poses[o.id] = o.to;
  opened.write(poses, arguments.out);
  const SceneVerdict verdict = judge(opened, options);
  clear_progress_line(common);
  if (common.json) {
    nlohmann::ordered_json json = repaired_json(opened, repaired);
    json["verdict"] = nlohmann::ordered_json::parse(verdict_json(verdict));
    std::cout << json.dump() << "\n";
  } else if (!common.quiet) {
    tell_moves(opened.judged.scene, repaired);
    if constexpr (std::is_same_v<decltype(repaired), const MendedScene>) tell_relations(repaired);
    std::cout << verdict_text(verdict);
  }
  return verdict.ok() ? 0 : 1;
}

void add_repair_options(CLI::App& verb, RepairArguments& arguments) {
  verb.add_option("file", arguments.file, "A scene: MJCF, URDF, SDF or glTF")
      ->required()
      ->type_name("SCENE");
  verb.add_option("-o,--output", arguments.out, "Write the same scene with new poses")->required();
  verb.add_option("--only", arguments.how.only, "Names of the objects that may move");
  verb.add_option(
          "--seconds", arguments.how.seconds,
          "Time limit of the whole scene (s); objects that are left over then stay where they "
          "are; 0: none")
      ->check(number_from(0, 1e6));
  add_foreign_options(verb, arguments.foreign);
  add_settle_options(verb, arguments.settle);
}

// @param verb  has its own option already. @param repair  changes the scene, and tells.
template <class Repair>
Verb repair_verb(CLI::App* verb, const std::shared_ptr<RepairArguments>& arguments,
                 const CommonOptions& common, const Repair& repair, const char* examples) {
  add_repair_options(*verb, *arguments);
  return {verb, [arguments, repair, &common] { return repair_file(*arguments, common, repair); },
          examples, true,
          [arguments] {
            return VerbFiles{{}, {arguments->out}, {arguments->file}};
          }};
}

}  // namespace

std::vector<Verb> add_settle(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "settle",
      "Bring the floating and sunk objects of a scene of another program to rest, and write their "
      "poses back with nothing else changed");
  const auto arguments = std::make_shared<RepairArguments>();
  verb->add_option("--lift", arguments->how.most_lift,
                   "Largest height, metres, to lift an object before it is let go")
      ->check(number_from(0, 1));
  const auto repair = [](Scene& scene, const MendOptions& how) { return settle_scene(scene, how); };
  return {repair_verb(verb, arguments, common, repair,
                      "trivet settle kitchen.xml -o settled.xml\n"
                      "trivet settle kitchen.xml -o settled.xml --only pan --lift 0.05\n")};
}

std::vector<Verb> add_mend(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand("mend",
                                            "Find the nearest scene in which nothing "
                                            "interpenetrates, everything rests, and what stood on "
                                            "what still does, and write it as settle does");
  const auto arguments = std::make_shared<RepairArguments>();
  verb->add_option("--tolerance", arguments->how.tolerance,
                   "Largest error of the poses (metres); 0: found from the poses")
      ->check(number_from(0, 1));
  const auto repair = [](Scene& scene, const MendOptions& how) { return mend_scene(scene, how); };
  return {repair_verb(verb, arguments, common, repair,
                      "trivet mend kitchen.xml -o mended.xml\n"
                      "trivet mend kitchen.xml -o mended.xml --tolerance 0.005\n")};
}

}  // namespace trivet::apps
