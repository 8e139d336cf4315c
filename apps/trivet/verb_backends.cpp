// Sources of candidates on this machine, their speed, and the one that `auto` takes.
#include <iomanip>
#include <iostream>
#include <sstream>

#include "apps/trivet/verbs.h"
#include "ops/detect/calibration_file.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kTriangles[] = {1'000, 15'000, 150'000, 1'500'000};  // of each of two meshes
constexpr Motion::Kind kKinds[] = {Motion::Kind::Translation, Motion::Kind::Rotation};

const char* name_of(Motion::Kind kind) {
  return kind == Motion::Kind::Translation ? "fall" : "turn";
}

QuerySize size_for(Motion::Kind kind, int triangles) {
  return {kind, 2.0 * triangles, QuerySize::kPixelsAlong * QuerySize::kPixelsAlong};
}

CostModel model_of(const SourceCost& source, Motion::Kind kind) {
  return kind == Motion::Kind::Translation ? source.drop : source.turn;
}

bool is_gpu(const SourceCost& source) { return source.name.starts_with("gpu"); }

bool is_measured(const SourceCost& source) {
  return source.failure.empty() && !(is_gpu(source) && source.on_cpu);
}

// Two digits of small numbers, no exponent in large ones.
std::string short_ms(double ms) {
  std::ostringstream out;
  if (ms < 99.5)
    out << std::setprecision(2) << ms;
  else
    out << std::fixed << std::setprecision(0) << ms;
  return out.str();
}

std::string note_on(const SourceCost& source) {
  if (!source.failure.empty()) return source.failure;
  if (!is_gpu(source)) return "ready at once";
  std::ostringstream out;
  out << "self-test passed; ready after " << short_ms(source.start_ms) << " ms";
  if (source.on_cpu) out << "; runs on the CPU, so never taken by auto";
  return out.str();
}

void print_row(std::ostream& out, const std::string& name, const std::vector<std::string>& cells) {
  out << "  " << std::left << std::setw(18) << name << std::right;
  for (const std::string& cell : cells) out << std::setw(18) << cell;
  out << "\n";
}

std::string table_text(Machine& machine, const Calibration& calibration, Motion::Kind kind) {
  std::ostringstream out;
  out << "\nexpected milliseconds of a query, " << name_of(kind)
      << ", by the triangles of each of two meshes\n";
  print_row(out, "", {"1K", "15K", "150K", "1.5M"});
  for (const SourceCost& source : calibration.sources) {
    if (!is_measured(source)) continue;
    std::vector<std::string> cells;
    for (const int n : kTriangles)
      cells.push_back(short_ms(model_of(source, kind).ms(size_for(kind, n))));
    print_row(out, source.name, cells);
  }
  std::vector<std::string> chosen;
  for (const int n : kTriangles) chosen.push_back(machine.choice(size_for(kind, n)));
  print_row(out, "auto takes", chosen);
  return out.str();
}

// The triangles of both meshes for which another source than BVHs is taken, such as " of 9957 to
// 1200000 triangles, both meshes together".
std::string range_of_others(Machine& machine, Motion::Kind kind) {
  constexpr int kMost = 100'000'000;
  int from = 0, to = 0;
  for (double n = 100; n <= kMost && to == 0; n *= 1.1) {
    const bool is_bvh = machine.choice(size_for(kind, static_cast<int>(n))) == Calibration::kBvh;
    if (from == 0 && !is_bvh) from = static_cast<int>(2 * n);
    if (from > 0 && is_bvh) to = static_cast<int>(2 * n);
  }
  if (from == 0) return " never is";
  return " of " + std::to_string(from) + (to > 0 ? " to " + std::to_string(to) : "") +
         " triangles" + (to > 0 ? "" : " and more") + ", both meshes together";
}

// The rule of `auto`, with the constants that were measured.
std::string rule_of(Machine& machine) {
  std::string out =
      "auto: BVHs, unless this machine's graphics hardware was measured to be faster for a query "
      "of that size";
  if (!machine.has_hardware()) return out + "; it has none";
  for (const Motion::Kind kind : kKinds)
    out += std::string("; a ") + name_of(kind) + range_of_others(machine, kind);
  return out;
}

std::string as_text(Machine& machine, const Calibration& calibration, const std::string& file) {
  std::ostringstream out;
  out << "processor: " << calibration.key.cpu << "\ngraphics hardware: "
      << (machine.has_hardware() ? calibration.key.hardware : "none, so auto takes BVHs") << "\n"
      << rule_of(machine) << "\nmeasured in " << short_ms(calibration.seconds) << " s; kept in "
      << (file.empty() ? "no file: neither XDG_CACHE_HOME nor HOME is set" : file) << "\n\n";
  for (const SourceCost& source : calibration.sources) {
    out << source.name << ": " << (source.device.empty() ? "" : source.device + "; ")
        << note_on(source);
    out << "\n";
  }
  out << "faces of doubtful pixels: listed by the GPU or in software, for each query by what costs "
         "less\n";
  for (const Motion::Kind kind : kKinds) out << table_text(machine, calibration, kind);
  return out.str();
}

std::string as_json(Machine& machine, const Calibration& calibration, const std::string& file) {
  OrderedJson choices = OrderedJson::array();
  for (const int n : kTriangles) {
    OrderedJson choice = {{"triangles", n}};
    for (const Motion::Kind kind : kKinds)
      choice[name_of(kind)] = machine.choice(size_for(kind, n));
    choices.push_back(std::move(choice));
  }
  OrderedJson json = OrderedJson::parse(to_json(calibration));
  json["file"] = file;
  json["gpu_lists"] = "auto";
  json["rule"] = rule_of(machine);
  json["choices"] = std::move(choices);
  return readable_json(json);
}

}  // namespace

std::vector<Verb> add_backends(CLI::App& app, const CommonOptions& common) {
  CLI::App* const verb = app.add_subcommand(
      "backends", "Show the available detectors, their speed, and the choice of --detector auto");
  const auto again = std::make_shared<bool>(false);
  verb->add_flag("--recalibrate", *again, "Measure again, and keep the result");
  return {
      {verb,
       [again, &common] {
         const std::shared_ptr<Machine> machine =
             make_machine(common.detection(), print_notes(common));
         const auto calibration = *again ? machine->recalibrate(nullptr) : machine->calibration();
         std::cout << (common.json ? as_json : as_text)(*machine, *calibration, calibration_path());
         return 0;
       },
       "trivet backends\n"
       "trivet backends --recalibrate --json\n",
       false}};
}

}  // namespace trivet::apps
