// Per-mesh precomputation, with Google Benchmark.
#include <benchmark/benchmark.h>

#include "perf/sweeps.h"

namespace trivet::perf {
namespace {

void count_triangles(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void build_bvh(benchmark::State& state) {
  const Mesh mesh = make_sphere_mesh(static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(trivet::build_bvh(mesh));
  count_triangles(state);
}

void adjacency(benchmark::State& state) {
  const Mesh mesh = make_sphere_mesh(static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(make_adjacency(mesh));
  count_triangles(state);
}

void shape(benchmark::State& state) {
  const Mesh mesh = make_sphere_mesh(static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(make_shape(mesh));
  count_triangles(state);
}

// Embree builds on all cores, so wall time is measured.
#define TRIVET_SIZES \
  Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime()
BENCHMARK(build_bvh)->TRIVET_SIZES;
BENCHMARK(adjacency)->TRIVET_SIZES;
BENCHMARK(shape)->TRIVET_SIZES;

}  // namespace
}  // namespace trivet::perf
