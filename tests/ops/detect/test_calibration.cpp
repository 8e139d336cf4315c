// Cost models, the measurement of a machine, and the file that keeps it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "ops/detect/calibration_file.h"
#include "ops/detect/calibration_queries.h"
#include "ops/detect/machine.h"
#include "support/random_shapes.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

Calibration example(test::Random& random) {
  const auto model = [&] {
    return CostModel{random.uniform(0, 1), random.uniform(0, 1e-3), random.uniform(0, 0.1) / 3,
                     random.uniform(0, 1e-6) / 7};
  };
  Calibration out{
      {"1.2", "gpu compute", "processor \"x\", 2 cores", "renderD128", 2}, 0.1 + 0.2, {}};
  out.sources.push_back({"bvh", "cpu", true, "", 5e-4, model(), model()});
  out.sources.push_back({"gpu compute", "card", false, "fails", 1 / 3.0, model(), model()});
  return out;
}

bool same(const CostModel& a, const CostModel& b) {
  return a.fixed_ms == b.fixed_ms && a.ms_per_triangle == b.ms_per_triangle &&
         a.ms_per_root == b.ms_per_root && a.ms_per_pixel == b.ms_per_pixel;
}

bool same(const Calibration& a, const Calibration& b) {
  bool out = a.key == b.key && a.seconds == b.seconds && a.sources.size() == b.sources.size();
  for (size_t i = 0; out && i < a.sources.size(); ++i) {
    const SourceCost &x = a.sources[i], &y = b.sources[i];
    out = x.name == y.name && x.device == y.device && x.on_cpu == y.on_cpu &&
          x.failure == y.failure && x.start_ms == y.start_ms && same(x.drop, y.drop) &&
          same(x.turn, y.turn);
  }
  return out;
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST(CostModel, IsFoundFromItsOwnSamples) {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    // Terms that are 0 now and then, which noise must not make negative.
    const auto term = [&](double most) { return std::max(0.0, random.uniform(-0.5, 1)) * most; };
    const CostModel linear{0.01 + term(1), term(1e-4), 0, term(1e-4)};
    const CostModel root{0.01 + term(1), 0, term(1e-2), 0};
    std::vector<CostSample> straight, curved;
    for (const double n : {1e3, 2e4, 2e5})
      for (const double pixels : {16384.0, 9000.0, 5000.0}) {
        const QuerySize size{Motion::Kind::Translation, n, pixels};
        straight.push_back({size, linear.ms(size)});
        curved.push_back({size, root.ms(size)});
      }
    for (const QuerySize& size : {QuerySize{{}, 3e6, 12000}, QuerySize{{}, 500, 16000}}) {
      EXPECT_NEAR(fit_cost(straight, CostGrowth::Linear).ms(size), linear.ms(size),
                  1e-6 * linear.ms(size));
      EXPECT_NEAR(fit_cost(curved, CostGrowth::Root).ms(size), root.ms(size), 1e-6 * root.ms(size));
    }
  }
}

TEST(CostModel, HasNoNegativeTerm) {
  test::Random random(4);
  for (int i = 0; i < 100; ++i) {
    std::vector<CostSample> samples;
    for (int k = 1 + i % 5; k >= 0; --k)
      samples.push_back(
          {{{}, random.uniform(1, 1e5), random.uniform(1, 2e4)}, random.uniform(0.01, 10)});
    for (const CostGrowth growth : {CostGrowth::Linear, CostGrowth::Root}) {
      const CostModel model = fit_cost(samples, growth);
      EXPECT_GE(
          std::min({model.fixed_ms, model.ms_per_triangle, model.ms_per_root, model.ms_per_pixel}),
          0);
      EXPECT_TRUE(std::isfinite(model.ms(samples[0].size)));
      EXPECT_GT(model.ms(samples[0].size), 0);
    }
  }
}

// So that no row of the measurement is an empty image, or a free motion.
TEST(CalibrationQueries, EndInContactsAndDifferInPixels) {
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    double fewest = kInfinity, most = 0;
    for (const CalibrationQuery& q : calibration_queries(wavy_sphere(11), kind))
      q.with_query([&](const FirstContactQuery& query) {
        EXPECT_EQ(first_contact(query).status, FirstContact::Status::Contact);
        const QuerySize size = size_of(query);
        EXPECT_EQ(size.kind, kind);
        EXPECT_EQ(size.triangles, 2 * 8 * 11 * 11);
        fewest = std::min(fewest, size.pixels);
        most = std::max(most, size.pixels);
      });
    EXPECT_GT(most, 1.5 * fewest);
  }
  const auto sphere = wavy_sphere(6);
  EXPECT_EQ(sphere->mesh.vertices.size(), sphere->mesh.triangles.size() / 2 + 2) << "closed";
  EXPECT_GT(sphere->mass.volume, 3.5) << "outside out";
}

TEST(Calibration, MeasuresWhatIsHere) {
  const std::vector<GpuSource> gpu = {
      {"gpu compute", [](bool, const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
         throw Error(Error::Kind::Environment, "no EGL here");
       }}};
  const Calibration found = calibrate({"1", "2", "3", "4", 5}, gpu);
  ASSERT_EQ(found.sources.size(), 3u);
  EXPECT_EQ(found.sources[2].failure, "no EGL here");
  EXPECT_EQ(found.key.hardware, "4");
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    const QuerySize small{kind, 2e3, 16384}, large{kind, 2e5, 16384};
    for (int i = 0; i < 2; ++i) {
      EXPECT_GT(found.sources[i].ms(small), 0) << i;
      EXPECT_LE(found.sources[i].ms(small), found.sources[i].ms(large)) << i;
      EXPECT_LT(found.sources[i].ms(large), 1e4) << i;
    }
    EXPECT_EQ(found.sources[2].ms(small), kInfinity);
    ASSERT_NE(found.fastest(large), nullptr);
  }
}

TEST(CalibrationFile, KeepsEveryBit) {
  const test::TemporaryFolder folder;
  test::Random random(5);
  for (int i = 0; i < 20; ++i) {
    const Calibration written = example(random);
    const std::string path = folder.file("a/b/backends.json");
    write_calibration(written, path);
    EXPECT_TRUE(same(read_calibration(path), written));
  }
}

TEST(CalibrationFile, RefusesWhatIsDamaged) {
  test::Random random(6);
  const std::string good = to_json(example(random));
  for (size_t length = 0; length + 2 < good.size(); ++length)
    EXPECT_THROW(calibration_from_json(good.substr(0, length)), Error) << length;
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"format\": 3", "\"format\": 2"},
           {"\"start_ms\": 0.0", "\"start_ms\": -1"},
           {"\"start_ms\": 0.0", "\"start_ms\": 1e999"},
           {"\"start_ms\": 0.0", "\"start_ms\": \"1\""},
           {"\"on_cpu\": true", "\"on_cpu\": 7"},
           {"\"device\": \"cpu\"", "\"device\": []"},
           {"\"sources\": [", "\"sources\": [3,"},
           {"\"name\"", "\"nome\""}}) {
    std::string bad = good;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), from.size(), to);
    EXPECT_THROW(calibration_from_json(bad), Error) << to;
  }
  EXPECT_THROW(read_calibration("/nonexistent/backends.json"), Error);
  EXPECT_THROW(read_calibration("/"), Error);
}

TEST(CalibrationFile, IsInTheUsersCacheFolder) {
  const char* const before = std::getenv("XDG_CACHE_HOME");
  const std::string kept = before ? before : "";
  setenv("XDG_CACHE_HOME", "/x/cache", 1);
  EXPECT_EQ(calibration_path(), "/x/cache/trivet/backends.json");
  setenv("XDG_CACHE_HOME", "relative", 1);
  const char* const home = std::getenv("HOME");
  if (home && home[0] == '/') {
    EXPECT_EQ(calibration_path(), std::string(home) + "/.cache/trivet/backends.json");
  }
  before ? setenv("XDG_CACHE_HOME", kept.c_str(), 1) : unsetenv("XDG_CACHE_HOME");
}

/// A machine whose calibration is kept in a folder, and what it tells.
struct Kept {
  std::vector<std::string> notes;
  int num_measured = 0;
  MachineOptions options;

  explicit Kept(const std::string& file) {
    options.version = "1";
    options.file = file;
    options.gpu = {
        {"gpu compute",
         [this](bool allow_software, const GpuNotes&) -> std::unique_ptr<CandidateFinder> {
           num_measured += allow_software;
           throw Error(Error::Kind::Environment, "none");
         }}};
    options.note = [this](const Sentence& note) { notes.push_back(in_english(note)); };
  }
};

TEST(Machine, MeasuresOnceForAllThreadsAndLaterRuns) {
  const test::TemporaryFolder folder;
  Kept kept(folder.file("backends.json"));
  Machine first(kept.options);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back([&] { first.calibration(); });
  for (std::thread& thread : threads) thread.join();
  Machine second(kept.options);
  EXPECT_TRUE(same(*second.calibration(), *first.calibration()));
  EXPECT_EQ(kept.num_measured, 1);
  EXPECT_TRUE(kept.notes.empty());
}

TEST(Machine, MeasuresAgainWhatIsForeignOrDamaged) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("backends.json");
  Kept kept(file);
  test::Random random(8);
  const std::string foreign = to_json(example(random));
  for (const std::string& text : {foreign, foreign.substr(0, 300), std::string()}) {
    kept.notes.clear();
    kept.num_measured = 0;
    write(file, text);
    Machine machine(kept.options);
    machine.calibration();
    machine.calibration();
    EXPECT_EQ(kept.num_measured, 1);
    ASSERT_EQ(kept.notes.size(), 1u);
    EXPECT_NE(kept.notes[0].find("measured again"), std::string::npos);
    EXPECT_TRUE(same(read_calibration(file), *machine.calibration()));
  }
}

TEST(Machine, GoesOnWhereNothingCanBeWritten) {
  const test::TemporaryFolder folder;
  write(folder.file("file"), "");
  Kept kept(folder.file("file/trivet/backends.json"));
  Machine machine(kept.options);
  EXPECT_EQ(machine.calibration()->sources.size(), 3u);
  ASSERT_EQ(kept.notes.size(), 1u);
  EXPECT_NE(kept.notes[0].find("cannot be kept"), std::string::npos);
}

TEST(Machine, MeasuresAgainWhenAsked) {
  const test::TemporaryFolder folder;
  Kept kept(folder.file("backends.json"));
  Machine machine(kept.options);
  const auto old = machine.calibration();
  EXPECT_NE(machine.recalibrate(old), old);
  machine.recalibrate(old);  // another thread was faster
  EXPECT_EQ(kept.num_measured, 2);
}

}  // namespace
}  // namespace trivet
