// PUTs of the demos, from the layouts' own starts, with Google Benchmark.
#include <benchmark/benchmark.h>

#include <stdexcept>

#include "ops/operations/perform.h"
#include "perf/scenes.h"

namespace trivet::perf {
namespace {

void put_last_object(benchmark::State& state, const std::string& name, int splits) {
  DemoScene demo = make_demo_scene(name, splits);
  const PutOperation last = demo.operations.back();
  demo.operations.pop_back();
  for (const PutOperation& o : demo.operations)
    if (!put(demo.scene, *demo.scene.find(o.object), o.start, test::perfect_friction()).ok())
      throw std::runtime_error(o.object + " cannot be put");
  const ObjectId id = *demo.scene.find(last.object);
  int num_motions = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Scene scene = demo.scene;
    state.ResumeTiming();
    num_motions = put(scene, id, last.start, test::perfect_friction()).num_motions;
  }
  state.counters["triangles"] = static_cast<double>(demo.num_triangles);
  state.counters["motions"] = num_motions;
}
BENCHMARK_CAPTURE(put_last_object, spoon_on_saucer, "spoon-saucer", 1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(put_last_object, loaf_on_breakfast, "breakfast", 1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(put_last_object, loaf_on_refined_breakfast, "breakfast", 10)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace trivet::perf
