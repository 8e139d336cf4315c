#include <tbb/global_control.h>

#include "core/exact/interpenetration.h"
#include "perf/fcl_baseline.h"
#include "perf/result_hash.h"
#include "perf/rows.h"

namespace trivet::perf {
namespace {

constexpr int kFclSweeps = 40;
constexpr double kFclBudget_ms = 4000;  // for a row of FCL; then the remaining sweeps are skipped
constexpr size_t kFewestSweeps = 2;

struct Measured {
  Sweep sweep;
  FirstContact contact;
  Took took;
};

// Number of intersecting pairs of faces at the stop of a motion.
std::int64_t crossings_at(const Sweep& sweep, double time) {
  const Pose end = moved_pose(sweep.pose_moving, sweep.motion, time);
  const Affine a = world_from_object(end, UpAxis::Z, 1);
  const Affine b = world_from_object(sweep.pose_fixed, UpAxis::Z, 1);
  const Shape &moving = *sweep.spheres->moving, &fixed = *sweep.spheres->fixed;
  const Positions pa = world_positions(moving, a), pb = world_positions(fixed, b);
  return count_crossings({&moving, &pa, a, 0}, {&fixed, &pb, b, 0});
}

std::vector<Measured> our_sweeps(const SpherePair& spheres, Motion::Kind kind) {
  test::Random random(11);
  std::vector<Measured> out;
  for (int i = 0; i < kFclSweeps; ++i) {
    Measured m{kind == Motion::Kind::Translation ? random_drop(spheres, random)
                                                 : random_turn(spheres, random),
               {},
               {}};
    m.took = timed_warm([&] { m.contact = m.sweep.first_contact(); });
    out.push_back(m);
  }
  return out;
}

double goal_ms(int num_triangles, Motion::Kind kind) {
  if (num_triangles != 100'000) return 0;
  return kind == Motion::Kind::Translation ? 1 : 4;
}

const char* name_of(Motion::Kind kind) {
  return kind == Motion::Kind::Translation ? "drop" : "quarter turn";
}

void add_ours(const std::vector<Measured>& sweeps, int num_triangles, Report& report) {
  const Motion::Kind kind = sweeps[0].sweep.motion.kind;
  Row row{std::string("Trivet, ") + name_of(kind), {}, goal_ms(num_triangles, kind), 0, ""};
  std::vector<double> node_pairs, face_pairs;
  size_t contacts = 0, crossing = 0;
  ResultHash hash;
  for (const Measured& m : sweeps) {
    row.samples.add(m.took);
    node_pairs.push_back(static_cast<double>(m.contact.work.node_pairs));
    face_pairs.push_back(static_cast<double>(m.contact.work.face_pairs));
    contacts += m.contact.status == FirstContact::Status::Contact;
    crossing += crossings_at(m.sweep, std::min(m.contact.time, m.sweep.motion.limit)) > 0;
    hash.add(m.contact);
  }
  row.outcome = text(
      "%zu of %zu touch, end poses that interpenetrate: %zu; median node pairs %.0f, "
      "face pairs %.0f; hash %016llx",
      contacts, sweeps.size(), crossing, median(node_pairs), median(face_pairs),
      static_cast<unsigned long long>(hash.value()));
  report.mix(hash.value());
  report.add(std::move(row));
}

struct Rival {
  const char* name;
  FclSolver solver;
  int samples;
  int largest;  // largest number of triangles to measure
};
constexpr Rival kRivals[] = {
    {"FCL naive, 10 samples", FclSolver::Naive, 10, 1'000'000},
    {"FCL naive, 1,000 samples", FclSolver::Naive, 1000, 1'000'000},
    {"FCL naive, 1,000,000 samples (a clearance apart)", FclSolver::Naive, 1'000'000, 1'000'000},
    {"FCL distance() in a loop", FclSolver::DistanceLoop, 0, 1'000'000},
    {"FCL conservative advancement", FclSolver::ConservativeAdvancement, 10, 100'000},
};

// Differences between others' answers and ours.
struct Differences {
  size_t touching = 0, found = 0, crossing = 0;
  std::vector<double> late_mm, crossings;

  void add(const Measured& ours, const FclAnswer& theirs) {
    touching += ours.contact.status == FirstContact::Status::Contact;
    if (!theirs.found) return;
    ++found;
    const Sweep& s = ours.sweep;
    late_mm.push_back(
        1e3 * (s.travel(theirs.time) - s.travel(std::min(ours.contact.time, s.motion.limit))));
    const std::int64_t count = crossings_at(s, theirs.time);
    crossing += count > 0;
    if (count > 0) crossings.push_back(static_cast<double>(count));
  }

  std::string text_of() const {
    if (found == 0) return text("finds 0 of %zu contacts", touching);
    std::string out = text(
        "finds %zu of %zu; late by %.3g mm (median; %.3g at most); end poses that "
        "interpenetrate: %zu",
        found, touching, median(late_mm), quantile(late_mm, 1), crossing);
    if (crossing > 0) out += text(", by %.0f pairs of faces (median)", median(crossings));
    return out;
  }
};

void add_theirs(const std::vector<Measured>& sweeps, const FclPair& fcl, const Rival& rival,
                Report& report) {
  Row row{std::string(rival.name) + ", " + name_of(sweeps[0].sweep.motion.kind), {}, 0, 0, ""};
  Samples ours;
  Differences differences;
  double spent_ms = 0;
  for (const Measured& m : sweeps) {
    if (spent_ms > kFclBudget_ms && row.samples.count() >= kFewestSweeps) break;
    FclAnswer answer;
    const Took took = timed_warm([&] { answer = fcl.sweep(m.sweep, rival.solver, rival.samples); });
    spent_ms += took.wall_ms;
    row.samples.add(took);
    ours.add(m.took);
    differences.add(m, answer);
  }
  row.ours_ms = ours.median_cpu_ms();
  row.outcome = differences.text_of();
  report.add(std::move(row));
}

void rows_of_size(int num_triangles, Report& report) {
  const std::string size = short_count(num_triangles);
  report.section("First contact of " + size + " triangles against " + size +
                 " (bumpy spheres of radius 1 m)");
  const SpherePair spheres = make_sphere_pair(num_triangles);
  std::unique_ptr<FclPair> fcl;
  Row once{"FCL, both models (once)", {}, 0, 0, "against both of our shapes on one core"};
  once.samples.add(timed([&] { fcl = make_fcl_pair(spheres); }));
  const tbb::global_control one_core(tbb::global_control::max_allowed_parallelism, 1);
  const auto shapes = [&] {
    make_shape(spheres.moving->mesh)->bvh(), make_shape(spheres.fixed->mesh)->bvh();
  };
  once.ours_ms = timed(shapes).cpu_ms;
  if (fcl) report.add(std::move(once));
  for (const Motion::Kind kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    const std::vector<Measured> sweeps = our_sweeps(spheres, kind);
    add_ours(sweeps, num_triangles, report);
    for (const Rival& rival : kRivals)
      if (fcl && num_triangles <= rival.largest) add_theirs(sweeps, *fcl, rival, report);
  }
}

}  // namespace

void first_contact_rows(Report& report) {
  for (const int n : {10'000, 100'000, 1'000'000}) rows_of_size(n, report);
}

}  // namespace trivet::perf
