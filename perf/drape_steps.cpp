// trivet_perf_drape: the solver alone on the last operation of a layout, a drape: its time, and
// each of its steps judged by exact predicates.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "core/base/arena.h"
#include "core/base/error.h"
#include "core/exact/predicates.h"
#include "core/flex/levels.h"
#include "core/flex/self_crossings.h"
#include "ops/files/layout/run.h"
#include "ops/operations/drape_parts.h"
#include "perf/result_hash.h"
#include "perf/timing.h"

namespace trivet::perf {
namespace {

constexpr const char* kUsage =
    "usage: trivet_perf_drape LAYOUT.json [THREADS [judge|trace]]\n"
    "One row: vertices, steps, processor and elapsed seconds, how it ended, net force in weights "
    "of\n"
    "a vertex, stable or not, balance, own contacts, hash of the positions. With \"judge\": steps\n"
    "judged, and those after which it crosses itself or an obstacle. With \"trace\": each step.\n";

using Faces = std::vector<std::array<int, 3>>;

// A segment of a cable is a triangle without area; a cable beside itself is judged by distances.
bool crosses(const flex::Points& x, const Faces& faces, const flex::Obstacles& obstacles) {
  const bool is_cable = faces.front()[1] == faces.front()[2];
  if (!is_cable && flex::self_crossing(x, faces)) return true;
  const flex::Points& fixed = obstacles.vertices();
  bool found = false;
  for (const auto& f : faces) {
    Aabb box;
    for (const int v : f) box.extend(x[v]);
    obstacles.face_tree().visit(box, [&](int other) {
      const auto& o = obstacles.faces()[other];
      found = found || triangles_intersect({x[f[0]], x[f[1]], x[f[2]]},
                                           {fixed[o[0]], fixed[o[1]], fixed[o[2]]});
    });
  }
  return found;
}

/// Each step of all levels.
class StepJudge {
 public:
  StepJudge(const flex::DrapeProblem& problem, const flex::Obstacles& obstacles)
      : m_obstacles(obstacles) {
    // Faces of all levels, the coarsest first, as progress counts them.
    std::vector<flex::DrapeProblem> all{problem};
    const int levels = num_levels(problem, {});
    while (static_cast<int>(all.size()) < levels) all.push_back(coarser(all.back()));
    for (size_t i = all.size(); i-- > 0;) m_faces.push_back(body_of(all[i]).faces);
  }
  void judge(const flex::Progress& progress) { judge(progress.level, *progress.x); }
  void judge_end(const flex::Points& x) { judge(static_cast<int>(m_faces.size()) - 1, x); }
  void print() const { std::printf("\tjudged %d\tcrossing %d", m_judged, m_crossing); }

 private:
  void judge(int level, const flex::Points& x) {
    ++m_judged;
    m_crossing += crosses(x, m_faces[level], m_obstacles);
  }

  const flex::Obstacles& m_obstacles;
  std::vector<Faces> m_faces;
  int m_judged = 0, m_crossing = 0;
};

const char* name_of(flex::Ending ending) {
  switch (ending) {
    case flex::Ending::AtRest:
      return "at rest";
    case flex::Ending::OutOfSteps:
      return "out of steps";
    case flex::Ending::Stuck:
      return "stuck";
    case flex::Ending::Stopped:
      break;
  }
  return "stopped";
}

std::uint64_t hash_of(const flex::Points& x) {
  ResultHash hash;
  for (const Vec3& p : x) hash.add(p);
  return hash.value();
}

void trace(const flex::Progress& p) {
  std::printf("%d\t%d\t%.3e\t%.12g\n", p.level, p.step, p.residual, p.energy);
}

void measure(const flex::DrapeProblem& problem, const DrapeSurroundings& around,
             const flex::DrapeOptions& options, const std::string& mode) {
  StepJudge judge(problem, around.obstacles);
  const Stopwatch stopwatch(CLOCK_PROCESS_CPUTIME_ID);
  const flex::DrapeResult result =
      flex::drape(problem, around.obstacles, options, [&](const flex::Progress& progress) {
        if (mode == "trace") trace(progress);
        if (mode == "judge") judge.judge(progress);
        return true;
      });
  const Took took = stopwatch.elapsed();
  const RestCertificate& c = result.certificate;
  std::printf("%zu\t%d\t%.2f\t%.2f\t%s\t%.1e\t%s\t%.6f\t%d\t%016llx", result.x.size(), c.num_steps,
              took.cpu_ms / 1e3, took.wall_ms / 1e3, name_of(result.ending), c.net_force,
              c.stable ? "stable" : "not stable", c.balance, c.num_own_contacts,
              static_cast<unsigned long long>(hash_of(result.x)));
  if (mode == "judge") {
    judge.judge_end(result.x);
    judge.print();
  }
  std::printf("\n");
}

int run(const std::string& file, int threads, const std::string& mode) {
  Layout layout = read_layout(file);
  const auto* const drape =
      layout.operations.empty() ? nullptr : std::get_if<DrapeOperation>(&layout.operations.back());
  if (!drape) throw Error(Error::Kind::BadInput, "%1: its last operation is no drape", file);
  const DrapeOperation last = *drape;
  layout.operations.pop_back();
  RunOptions options;
  options.layout_file = file;
  const auto slash = file.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : file.substr(0, slash);
  const LayoutRun start = run_layout(layout, models_in_folder(folder), options);
  const auto made = drape_problem(start.scene, last);
  if (const auto* const why = std::get_if<Refusal>(&made))
    throw Error(Error::Kind::BadInput, "%1: %2", file, message(*why));
  const auto& problem = std::get<flex::DrapeProblem>(made);
  const DrapeSurroundings around = drape_surroundings(start.scene, problem.start, problem.length);
  flex::DrapeOptions limits;
  limits.minimiser.tolerance = last.net_force, limits.minimiser.max_steps = last.steps;
  in_arena(threads, [&] { measure(problem, around, limits, mode); });
  return 0;
}

}  // namespace
}  // namespace trivet::perf

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    std::fputs(trivet::perf::kUsage, stderr);
    return 2;
  }
  try {
    return trivet::perf::run(argv[1], argc > 2 ? std::atoi(argv[2]) : 1, argc > 3 ? argv[3] : "");
  } catch (const trivet::Error& e) {
    std::fprintf(stderr, "error: %s\n", e.what());
    return 1;
  }
}
