// Workers of batches: how many, their limits and their detectors.
#include <sched.h>

#include <algorithm>

#include "apps/trivet/in_child.h"
#include "apps/trivet/verb_batch_parts.h"

namespace trivet::apps {

using namespace trivet::farm;

int num_jobs(int asked, const CommonOptions& common) {
  if (asked > 0) return asked;
  if (common.num_threads > 0) return common.num_threads;
  cpu_set_t cores;
  CPU_ZERO(&cores);
  return sched_getaffinity(0, sizeof cores, &cores) == 0 ? std::max(1, CPU_COUNT(&cores)) : 1;
}

void add_worker_options(CLI::App& verb, int& jobs, WorkLimits& limits) {
  jobs = 0;
  verb.add_option("--jobs", jobs, "Processes that make scenes; 0: as many as cores")
      ->check(integer_from(0, 4096));
  verb.add_option("--scene-seconds", limits.scene_seconds,
                  "CPU time limit of a scene (s); by the clock ten times as much")
      ->check(number_from(0.001, 1e6));
  verb.add_option("--scene-memory-mb", limits.memory_mb,
                  "Memory limit of one worker process, in MB")
      ->check(integer_from(1, 100'000'000));
  verb.add_option("--retries", limits.retries, "Further tries of a scene that ends its process")
      ->check(integer_from(0, 100));
  verb.add_option("--recycle", limits.recycle, "Number of scenes after which a process is replaced")
      ->check(integer_from(1, 1'000'000'000));
}

std::uint64_t first_worker_of(const BatchOptions& options) {
  return options.shard.index * static_cast<std::uint64_t>(options.jobs);
}

namespace {

// Scenes that a worker makes side by side for a GPU: measured, see docs/guide/detectors.md.
constexpr int kScenesTogether = 8;

}  // namespace

WorkerDetection worker_detection(const CommonOptions& common, std::uint64_t first_worker) {
  DetectionChoice choice = common.detection();
  choice.num_threads = 1;
  in_child("EGL", [&] { return check_detection(choice), std::string(); });
  const Backend backend = backend_from_name(choice.detector);
  const bool chooses = backend == Backend::Auto && !graphics_hardware_here().empty();
  WorkerDetection out;
  if (backend == Backend::Bvh || (backend == Backend::Auto && !chooses)) return out;
  if (chooses)  // workers would all measure at the same time
    in_child("OpenGL's driver", [&] {
      make_machine(choice, print_notes(common))->calibration();
      return std::string();
    });
  out.make = [choice, first_worker](std::uint64_t worker, const GpuNotes& notes) {
    DetectionChoice here = choice;
    here.device = device_of_worker(choice, first_worker + worker);
    BackendOptions options =
        backend_options(here, [notes](const Sentence& text) { notes.tell_lost(text); });
    options.gpu_notes = notes;
    return std::make_unique<DetectorGroup>(options);
  };
  if (backend == Backend::Gpu) out.scenes_together = kScenesTogether;
  return out;
}

}  // namespace trivet::apps
