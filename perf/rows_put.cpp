#include "ops/operations/perform.h"
#include "perf/result_hash.h"
#include "perf/rows.h"
#include "perf/scenes.h"

namespace trivet::perf {
namespace {

constexpr double kJitter = 0.02;  // metres, of random starts

// PUTs of one kind; refused ones are not timed.
struct Puts {
  Samples samples;
  std::vector<double> motions, queries, per_motion_ms;
  size_t refused = 0;

  // Works on a copy of the scene.
  void run(const Scene& scene, ObjectId id, const Pose& start, ResultHash* hash) {
    OperationResult result;
    Scene after = scene;
    Took took = timed([&] { result = put(after, id, start, test::perfect_friction()); });
    if (took.wall_ms < kLong_ms) {  // repeated with warm caches
      after = scene;
      took = timed([&] { result = put(after, id, start, test::perfect_friction()); });
    }
    if (!result.ok()) {
      ++refused;
      hash->add(std::uint64_t{1});
      return;
    }
    samples.add(took);
    motions.push_back(result.num_motions);
    queries.push_back(static_cast<double>(result.num_queries));
    if (result.num_motions > 0) per_motion_ms.push_back(took.wall_ms / result.num_motions);
    hash->add(after.at(id).pose);
  }

  Row row(const std::string& what, double goal_ms) const {
    return {
        what, samples, goal_ms, 0,
        text("medians: %.2f ms per motion, %.0f motions (at most %.0f), %.0f queries; refused %zu",
             median(per_motion_ms), median(motions), quantile(motions, 1), median(queries),
             refused)};
  }
};

void append(const Puts& from, Puts* to) {
  const auto join = [](const std::vector<double>& more, std::vector<double>* all) {
    all->insert(all->end(), more.begin(), more.end());
  };
  to->samples.append(from.samples);
  join(from.motions, &to->motions);
  join(from.queries, &to->queries);
  join(from.per_motion_ms, &to->per_motion_ms);
  to->refused += from.refused;
}

struct DemoMeasure {
  int num_random;    // starts per object
  bool each_object;  // adds a row per object
  double goal_ms;
  const char* paper;  // the paper's figure [Shinya 1995]; may be null
};

// Puts each object from random starts, then permanently from the layout's start.
void measure_demo(DemoScene demo, const DemoMeasure& what, Report& report) {
  ResultHash hash;
  test::Random random(5);
  Puts own, any;
  for (const PutOperation& operation : demo.operations) {
    const ObjectId id = *demo.scene.find(operation.object);
    Puts of_object;
    for (int i = 0; i < what.num_random; ++i)
      of_object.run(demo.scene, id, random_start(operation.start, kJitter, random), &hash);
    if (what.each_object)
      report.add(of_object.row("PUT of " + operation.object + ", random starts", 0));
    append(of_object, &any);
    own.run(demo.scene, id, operation.start, &hash);
    put(demo.scene, id, operation.start, test::perfect_friction());
  }
  report.add(any.row(text("all %zu PUTs, random starts", demo.operations.size()), what.goal_ms));
  report.add(own.row("the same from the layout's own starts", what.goal_ms));
  if (what.paper) report.remark("one movement in [Shinya 1995], IRIS 4D/310 VGX", what.paper);
  report.add_hash(hash.value());
}

std::string title(const char* name, const DemoScene& demo) {
  return text("PUT in %s (%zu PUTs, %s triangles); any orientation, up to 20 mm aside", name,
              demo.operations.size(), short_count(demo.num_triangles).c_str());
}

}  // namespace

void put_rows(Report& report) {
  DemoScene spoon = make_demo_scene("spoon-saucer");
  report.section(title("SPOON-SAUCER", spoon));
  measure_demo(std::move(spoon), {60, true, 2, "410 ms"}, report);

  DemoScene breakfast = make_demo_scene("breakfast");
  const int splits = splits_for(breakfast, 1'500'000);
  report.section(title("BREAKFAST", breakfast));
  measure_demo(std::move(breakfast), {20, true, 5, "2,000 ms"}, report);

  DemoScene fine = make_demo_scene("breakfast", splits);
  report.section(title("BREAKFAST, every triangle split", fine));
  measure_demo(std::move(fine), {6, false, 50, nullptr}, report);
}

}  // namespace trivet::perf
