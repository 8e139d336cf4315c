#include <iomanip>
#include <iostream>

#include "apps/farm/node/node_checks.h"
#include "apps/trivet/verbs.h"
#include "core/base/error.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

using farm::NodeCheck;

constexpr int kLacking = 3;  // exit status: the environment

struct DoctorArguments {
  farm::NodeNeeds needs;
  bool gpu = false;
};

// Without hardware, pictures are drawn by rays and detection is by BVHs: a note, unless asked for.
NodeCheck check_graphics(bool needed, const DetectionChoice& choice) {
  const std::string hardware = graphics_hardware_here();
  if (hardware.empty())
    return {"graphics", needed ? NodeCheck::Verdict::Lacking : NodeCheck::Verdict::Note,
            "no graphics hardware: pictures are drawn by rays on the processor"};
  try {
    make_gpu_stage(choice, {});
  } catch (const Error& e) {
    return {"graphics", needed ? NodeCheck::Verdict::Lacking : NodeCheck::Verdict::Note,
            hardware + ": " + e.what()};
  }
  return {"graphics", NodeCheck::Verdict::Ok, hardware + ", OpenGL through EGL"};
}

// Says what --detector and --device come to here.
NodeCheck check_detector(const DetectionChoice& choice) {
  std::string why;
  const BackendOptions options =
      backend_options(choice, [&](const Sentence& text) { why = in_english(text); });
  if (options.backend == Backend::Auto) {
    const bool chooses = options.machine->has_hardware();
    return {"detector", NodeCheck::Verdict::Ok,
            chooses ? "auto: for each query what was measured as the fastest; see trivet backends"
                    : "auto: BVHs, as there is no graphics hardware"};
  }
  const std::unique_ptr<Detector> detector = make_detector(options);
  if (!why.empty()) return {"detector", NodeCheck::Verdict::Note, why};
  return {"detector", NodeCheck::Verdict::Ok,
          choice.detector + ": " + detector->name() + ", " + detector->device()};
}

int examine(const DoctorArguments& arguments, const CommonOptions& common) {
  std::vector<NodeCheck> checks = farm::check_node(arguments.needs);
  checks.push_back(check_graphics(arguments.gpu, common.detection()));
  checks.push_back(check_detector(common.detection()));
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  bool lacking = false;
  for (const NodeCheck& check : checks) {
    lacking = lacking || check.verdict == NodeCheck::Verdict::Lacking;
    list.push_back(
        {{"check", check.name}, {"verdict", to_string(check.verdict)}, {"text", check.text}});
    if (!common.json)
      std::cout << std::left << std::setw(9) << to_string(check.verdict) << std::setw(10)
                << check.name << check.text << "\n";
  }
  if (common.json) std::cout << readable_json({{"ok", !lacking}, {"checks", list}}) << "\n";
  return lacking ? kLacking : 0;
}

}  // namespace

std::vector<Verb> add_doctor(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "doctor",
      "Check whether this machine has what batches need: importer and its sandbox, memory, disk, "
      "files, clock, graphics, detector. The exit status is 3 if something is missing");
  const auto arguments = std::make_shared<DoctorArguments>();
  verb->add_option("--out", arguments->needs.out,
                   "Folder for batches, to check for free space and hard links")
      ->type_name("DIR");
  verb->add_option("--memory-mb", arguments->needs.memory_mb, "Memory that a batch needs (MB)")
      ->check(number_from(0, 1e9))
      ->capture_default_str();
  verb->add_option("--disk-mb", arguments->needs.disk_mb,
                   "Free space that a batch needs in --out (MB)")
      ->check(number_from(0, 1e12))
      ->capture_default_str();
  verb->add_flag("--gpu", arguments->gpu, "Require graphics hardware, too");
  return {{verb, [arguments, &common] { return examine(*arguments, common); },
           "trivet doctor\n"
           "trivet doctor --out . --disk-mb 100 --json\n",
           false}};
}

}  // namespace trivet::apps
