#include "ops/detect/calibration.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/candidates/self_test.h"
#include "ops/base/stopwatch.h"
#include "ops/detect/calibration_queries.h"
#include "raster/zlist/software_zlists.h"

namespace trivet {
namespace {

// Spheres have 1K, 13K, 97K and 720K triangles. Without large ones the costs of a GPU, whose draws
// hide the faces of small meshes, would be taken for constant.
constexpr int kSizes[] = {11, 40, 110, 300};
constexpr int kRepeats = 3;         // the fastest counts; a first run warms the caches
constexpr double kBudget_ms = 300;  // of a source and kind of motion; larger queries are left out

using Ask = std::function<void(const FirstContactQuery&)>;
using Spheres = std::vector<std::shared_ptr<const Shape>>;

double fastest_run_ms(const FirstContactQuery& query, const Ask& ask) {
  // The first run builds trees and warms caches; it is not counted.
  ask(query);
  double out = kInfinity;
  for (int i = 0; i < kRepeats; ++i) {
    const Stopwatch stopwatch;
    ask(query);
    out = std::min(out, stopwatch.milliseconds());
  }
  return std::max(out, 1e-6);
}

CostModel measure(const Spheres& spheres, Motion::Kind kind, CostGrowth growth, const Ask& ask) {
  std::vector<CostSample> samples;
  const Stopwatch stopwatch;
  // Small queries always run, larger ones as long as the budget lasts.
  for (std::size_t size = 0; size < spheres.size(); ++size) {
    const std::vector<CalibrationQuery> queries = calibration_queries(spheres[size], kind);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const bool is_needed = i == 0 && size < 2;  // two sizes make a slope
      if (!is_needed && stopwatch.milliseconds() > kBudget_ms) break;
      queries[i].with_query([&](const FirstContactQuery& query) {
        samples.push_back({size_of(query), fastest_run_ms(query, ask)});
      });
    }
  }
  return fit_cost(samples, growth);
}

void measure_both(const Spheres& spheres, CostGrowth growth, const Ask& ask, SourceCost& out) {
  out.drop = measure(spheres, Motion::Kind::Translation, growth, ask);
  out.turn = measure(spheres, Motion::Kind::Rotation, growth, ask);
}

// On hardware, else on a renderer that runs on the CPU.
std::unique_ptr<CandidateFinder> make_stage(const GpuSource& source, SourceCost& out) {
  try {
    auto stage = source.make(false, {});
    out.on_cpu = false;
    return stage;
  } catch (const Error&) {
    return source.make(true, {});
  }
}

SourceCost measure_gpu(const GpuSource& source, const Spheres& spheres) {
  SourceCost out;
  out.name = source.name;
  try {
    // Starting is part of the cost, as a process pays it once.
    const Stopwatch stopwatch;
    const std::unique_ptr<CandidateFinder> stage = make_stage(source, out);
    out.device = stage->device();
    out.failure = self_test(*stage);
    out.start_ms = stopwatch.milliseconds();
    if (!out.failure.empty()) out.failure = "fails its self-test: " + out.failure;
    // A renderer on the processor works, and is never faster than software.
    if (out.failure.empty() && !out.on_cpu)
      measure_both(
          spheres, CostGrowth::Linear,
          [&](const FirstContactQuery& query) { first_contact(query, *stage); }, out);
  } catch (const Error& error) {
    out.failure = error.what();
  }
  return out;
}

}  // namespace

double SourceCost::ms(const QuerySize& size) const {
  // A renderer on the processor is never faster than software, and is not asked.
  const bool is_gpu = name != Calibration::kBvh && name != Calibration::kSoftware;
  if (!failure.empty() || (is_gpu && on_cpu)) return kInfinity;
  return (size.kind == Motion::Kind::Rotation ? turn : drop).ms(size);
}

bool SourceCost::is_for_auto() const { return name != Calibration::kSoftware; }

const SourceCost* Calibration::fastest(const QuerySize& size) const {
  const SourceCost* out = nullptr;
  double best = kInfinity;
  for (const SourceCost& source : sources) {
    const double ms = source.is_for_auto() ? source.ms(size) : kInfinity;
    if (ms < best) best = ms, out = &source;
  }
  return out;
}

std::string processor_name() {
  std::string model = "unknown processor";
  // The name tells machines apart whose home folder is the same.
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
      model = line.substr(line.find(": ") + 2);
      break;
    }
  return model + ", " + std::to_string(std::max(1U, std::thread::hardware_concurrency())) +
         " cores";
}

Calibration calibrate(const MachineKey& key, const std::vector<GpuSource>& gpu) {
  const Stopwatch stopwatch;
  // All sources answer the same queries, of spheres of growing size.
  Spheres spheres;
  for (const int n : kSizes) spheres.push_back(wavy_sphere(n));
  Calibration out{key, 0, {}};
  SourceCost bvh{Calibration::kBvh, "cpu", true, "", 0, {}, {}};
  measure_both(
      spheres, CostGrowth::Root, [](const FirstContactQuery& query) { first_contact(query); }, bvh);
  out.sources.push_back(bvh);
  // z-lists cost in proportion to faces, BVHs about to the root of them: the fit assumes it.
  SoftwareZLists zlists(SoftwareZListOptions{0, 0});
  SourceCost software{Calibration::kSoftware, "cpu", true, "", 0, {}, {}};
  measure_both(
      spheres, CostGrowth::Linear,
      [&](const FirstContactQuery& query) { first_contact(query, zlists); }, software);
  out.sources.push_back(software);
  for (const GpuSource& source : gpu) out.sources.push_back(measure_gpu(source, spheres));
  out.seconds = stopwatch.milliseconds() / 1000;
  return out;
}

}  // namespace trivet
