// First contact of bumpy spheres, of two triangles, and contact points, with Google Benchmark.
#include <benchmark/benchmark.h>

#include <map>

#include "core/contact/contact_points.h"
#include "perf/sweeps.h"

namespace trivet::perf {
namespace {

constexpr int kBenchSweeps = 32;

const SpherePair& spheres(int num_triangles) {
  static std::map<int, SpherePair> made;
  const auto it = made.find(num_triangles);
  if (it != made.end()) return it->second;
  return made.emplace(num_triangles, make_sphere_pair(num_triangles)).first->second;
}

std::vector<Sweep> sweeps(int num_triangles, Motion::Kind kind) {
  test::Random random(7);
  std::vector<Sweep> out;
  for (int i = 0; i < kBenchSweeps; ++i)
    out.push_back(kind == Motion::Kind::Translation ? random_drop(spheres(num_triangles), random)
                                                    : random_turn(spheres(num_triangles), random));
  return out;
}

void first_contact_of(benchmark::State& state, Motion::Kind kind) {
  const std::vector<Sweep> cases = sweeps(static_cast<int>(state.range(0)), kind);
  size_t i = 0;
  std::int64_t node_pairs = 0, face_pairs = 0;
  for (auto _ : state) {
    const FirstContact contact = cases[i++ % cases.size()].first_contact();
    node_pairs += contact.work.node_pairs;
    face_pairs += contact.work.face_pairs;
  }
  const auto per_query = benchmark::Counter::kAvgIterations;
  state.counters["node_pairs"] = {static_cast<double>(node_pairs), per_query};
  state.counters["face_pairs"] = {static_cast<double>(face_pairs), per_query};
}

void drop(benchmark::State& state) { first_contact_of(state, Motion::Kind::Translation); }
void turn(benchmark::State& state) { first_contact_of(state, Motion::Kind::Rotation); }
BENCHMARK(drop)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(turn)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

// Triangles of size 1 that move towards each other over a distance of about 3.
void triangle_pair(benchmark::State& state, bool rotation) {
  struct Pair {
    Triangle a, b;
    Motion motion;
  };
  test::Random random(3);
  std::vector<Pair> pairs(1024);
  for (Pair& p : pairs) {
    const Vec3 at = 3 * random.direction();
    for (int k = 0; k < 3; ++k) p.a[k] = at + random.in_cube(1), p.b[k] = random.in_cube(1);
    p.motion = rotation ? Motion::rotation(at.cross(random.direction()), random.direction(), 1)
                        : Motion::translation(-at.normalized(), 3);
  }
  size_t i = 0;
  for (auto _ : state) {
    const Pair& p = pairs[i++ % pairs.size()];
    benchmark::DoNotOptimize(first_contact(p.a, p.b, p.motion, Clearance{1e-6}));
  }
}
BENCHMARK_CAPTURE(triangle_pair, drop, false);
BENCHMARK_CAPTURE(triangle_pair, turn, true);

// Poses at the end of the drops: within the contact tolerance.
void contact_points_of(benchmark::State& state) {
  struct Touching {
    Body moving, fixed;
    double clearance;
  };
  std::vector<Touching> touching;
  for (const Sweep& s : sweeps(static_cast<int>(state.range(0)), Motion::Kind::Translation)) {
    Sweep end = s;
    const FirstContact contact = s.first_contact();
    if (contact.status != FirstContact::Status::Contact) continue;
    end.pose_moving = moved_pose(s.pose_moving, s.motion, contact.time);
    touching.push_back({end.moving(), end.fixed(), s.clearance.distance});
  }
  size_t i = 0, points = 0;
  for (auto _ : state) {
    const Touching& t = touching[i++ % touching.size()];
    points += contact_points(t.moving, t.fixed, 2 * t.clearance, 0.05 * t.clearance).size();
  }
  state.counters["points"] = {static_cast<double>(points), benchmark::Counter::kAvgIterations};
}
BENCHMARK(contact_points_of)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace trivet::perf
