#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/exact/interpenetration.h"
#include "ops/operations/perform.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/scenes.h"
#include "perf/settling.h"

namespace trivet::perf {
namespace {

constexpr int kStarts = 30;
constexpr double kSettlingBudget_ms = 60000;  // for a row; then the remaining starts are skipped
constexpr size_t kFewestStarts = 3;
constexpr double kDensity = 7800;  // kg per cubic metre; steel
constexpr double kCell = 0.012;    // metres, of the pieces for convex hulls
constexpr double kDropHeight = 0.01;

struct Table {
  Scene scene;  // with the saucer
  ObjectId spoon;
  Object moving, fixed;
  Pose start;  // the layout's
};

Table set_table() {
  DemoScene demo = make_demo_scene("spoon-saucer");
  put(demo.scene, *demo.scene.find("saucer"), demo.operations[0].start, test::perfect_friction());
  const ObjectId spoon = *demo.scene.find("spoon"), saucer = *demo.scene.find("saucer");
  const Object moving = demo.scene.at(spoon), fixed = demo.scene.at(saucer);
  return {std::move(demo.scene), spoon, moving, fixed, demo.operations[1].start};
}

Aabb box_at(const Object& object, const Pose& pose) {
  Aabb box;
  for (const Vec3& p :
       world_positions(*object.shape, world_from_object(pose, object.up, object.scale)))
    box.extend(p);
  return box;
}

// Random rotation about the vertical, tilt of up to 10 degrees, 10 mm above the saucer: easier for
// simulators than a fall from a height.
Pose lying_start(const Table& table, test::Random& random) {
  const double turn = std::tan(random.uniform(-0.5, 0.5) * 0.999 * std::numbers::pi);
  const double way = random.uniform(0, 2 * std::numbers::pi), tilt = random.uniform(0, 0.0875);
  const Rotation tilted = Rotation::about_axis({std::cos(way), std::sin(way), 0}, tilt);
  Pose out{(tilted * Rotation::about_axis(Vec3::UnitZ(), turn)).normalized(),
           table.start.translation + random.in_cube(0.01)};
  const double top = box_at(table.fixed, table.fixed.pose).upper.z();
  out.translation.z() += top + kDropHeight - box_at(table.moving, out).lower.z();
  return out;
}

// State at rest, or when given up.
struct Leavings {
  size_t at_rest = 0, crossing = 0;
  std::vector<double> crossings, depth_mm, gap_mm, speed_mm, spin, higher_mm;

  void add(const Remains& r, const Settled& s, double higher) {
    at_rest += s.at_rest;
    crossing += r.crossings > 0;
    if (r.crossings > 0) crossings.push_back(static_cast<double>(r.crossings));
    if (r.depth > 0) depth_mm.push_back(1e3 * r.depth);
    if (r.gap > 0) gap_mm.push_back(1e3 * r.gap);
    speed_mm.push_back(1e3 * s.speed);
    spin.push_back(s.spin);
    higher_mm.push_back(1e3 * std::abs(higher));
  }

  std::string text_of(size_t n) const {
    std::string out = text("at rest: %zu of %zu; interpenetrate: %zu", at_rest, n, crossing);
    if (crossing) out += text(" (median %.0f pairs of faces)", median(crossings));
    out += text("; sunk in or below the floor: %zu", depth_mm.size());
    if (!depth_mm.empty()) out += text(" (up to %.3g mm deep)", quantile(depth_mm, 1));
    if (!gap_mm.empty()) out += text("; gap where clear: median %.3g mm", median(gap_mm));
    return out;
  }
  std::string motion_text() const {
    return text(
        "; speed at the end, median and most: %.2g, %.2g mm/s; %.2g, %.2g rad/s; centre of "
        "mass from ours in height: median %.2g mm",
        median(speed_mm), quantile(speed_mm, 1), median(spin), quantile(spin, 1),
        median(higher_mm));
  }
};

double height(const Object& object, const Pose& pose) {
  return world_from_object(pose, object.up, object.scale).apply(object.shape->mass.centre).z();
}

struct Ours {
  std::vector<Pose> starts, ends;
  std::vector<Took> took;
};

Ours our_row(const Table& table, Report& report) {
  test::Random random(9);
  Ours out;
  Row row{"Trivet, PUT", {}, 2, 0, ""};
  Leavings leavings;
  ResultHash hash;
  for (int i = 0; i < kStarts; ++i) {
    const Pose start = lying_start(table, random);
    Scene after;
    OperationResult result;
    const Took took = timed_warm([&] {
      after = table.scene;
      result = put(after, table.spoon, start, test::perfect_friction());
    });
    if (!result.ok()) continue;
    const Pose end = after.at(table.spoon).pose;
    out.starts.push_back(start);
    out.ends.push_back(end);
    out.took.push_back(took);
    row.samples.add(took);
    hash.add(end);
    leavings.add(judge(table.moving, end, table.fixed), {true, end, 0, 0, 0}, 0);
  }
  row.outcome = leavings.text_of(out.starts.size()) +
                text("; hash %016llx", static_cast<unsigned long long>(hash.value()));
  report.mix(hash.value());
  report.add(std::move(row));
  return out;
}

void their_row(const Table& table, const Ours& ours, Simulator& simulator, Report& report) {
  Row row{simulator.name(), {}, 0, 0, ""};
  Samples our_samples;
  Leavings leavings;
  double spent_ms = 0;
  for (size_t i = 0; i < ours.starts.size(); ++i) {
    if (spent_ms > kSettlingBudget_ms && row.samples.count() >= kFewestStarts) break;
    Settled settled;
    const Took took = timed([&] { settled = simulator.settle(ours.starts[i]); });
    spent_ms += took.wall_ms;
    row.samples.add(took);
    our_samples.add(ours.took[i]);
    leavings.add(judge(table.moving, settled.pose, table.fixed), settled,
                 height(table.moving, settled.pose) - height(table.moving, ours.ends[i]));
  }
  row.ours_ms = our_samples.median_cpu_ms();
  row.outcome = leavings.text_of(row.samples.count()) + leavings.motion_text();
  report.add(std::move(row));
}

}  // namespace

void settling_rows(Report& report) {
  const Table table = set_table();
  const SettleTask task = make_task(table.moving, table.fixed, kDensity, kCell);
  const SimulationRules rules;
  report.section(
      text("The spoon from 10 mm above its saucer until it rests: slower than %g mm/s "
           "and %g rad/s for %g s; given up after %g s of simulated time, which count",
           1e3 * rules.rest_speed, rules.rest_spin, rules.rest_duration, rules.longest));
  const Ours ours = our_row(table, report);
  for (const auto& simulator : bullet_simulators(task, rules))
    their_row(table, ours, *simulator, report);
  for (const auto& simulator : mujoco_simulators(task, rules))
    their_row(table, ours, *simulator, report);
}

}  // namespace trivet::perf
