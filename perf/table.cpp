// trivet_perf: all measurements in one run, printed as one table.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/io/atomic_file.h"
#include "ops/base/stopwatch.h"
#include "ops/detect/calibration.h"
#include "perf/fcl_baseline.h"
#include "perf/rows.h"
#include "perf/settling.h"

namespace trivet::perf {
namespace {

constexpr const char* kUsage =
    "usage: trivet_perf [--out FOLDER] [--only PART,...]\n"
    "Parts: first-contact, put, push, table1, scale, zlists, places, confirm, together, draws,\n"
    "settling, shapes.\n"
    "Prints the table; with --out also writes FOLDER/<date>-<n>core.md (with --only PART:\n"
    "-<n>core-PART.md), and of z-lists a .csv beside it, for plot_zlists.py.\n";

struct Part {
  const char* name;
  void (*rows)(Report&);
};
constexpr Part kParts[] = {{"first-contact", first_contact_rows},
                           {"put", put_rows},
                           {"push", push_rows},
                           {"table1", table1_rows},
                           {"scale", scale_rows},
                           {"zlists", zlist_rows},
                           {"places", place_rows},
                           {"confirm", confirm_rows},
#ifdef TRIVET_PERF_GPU
                           {"together", together_rows},
                           {"draws", draw_rows},
#endif
                           {"settling", settling_rows},
                           {"shapes", shape_rows}};

struct Arguments {
  std::string folder;
  std::vector<std::string> only;  // empty: all
};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> out;
  std::istringstream in(list);
  for (std::string part; std::getline(in, part, ',');) {
    const auto is_it = [&](const Part& p) { return part == p.name; };
    if (std::none_of(std::begin(kParts), std::end(kParts), is_it))
      throw std::invalid_argument("no part '" + part + "'\n" + kUsage);
    out.push_back(part);
  }
  return out;
}

Arguments parse(int argc, char** argv) {
  Arguments out;
  for (int i = 1; i < argc; ++i) {
    const bool has_value = i + 1 < argc;
    if (has_value && !std::strcmp(argv[i], "--out"))
      out.folder = argv[++i];
    else if (has_value && !std::strcmp(argv[i], "--only"))
      out.only = split(argv[++i]);
    else
      throw std::invalid_argument(std::string("not accepted: ") + argv[i] + "\n" + kUsage);
  }
  return out;
}

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : -1;
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  return text("%04d-%02d-%02d", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday);
}

unsigned num_cores() { return std::max(1u, std::thread::hardware_concurrency()); }

#ifdef NDEBUG
constexpr bool kAsserts = false;
#else
constexpr bool kAsserts = true;
#endif

std::string heading(double load_before, double minutes, const Report& report) {
  return "# Measurements of " + date() + "\n\n" +
         text("%s; gcc %s%s. Load before %.1f, after %.1f; the run took %.1f minutes.\n",
              processor_name().c_str(), __VERSION__, kAsserts ? ", assertions on" : "", load_before,
              load_average(), minutes) +
         "All on one core, in one thread, unless a row says all cores; models, BVHs "
         "and\nsimulators' tasks are prepared beforehand and not timed. FCL " +
         fcl_version() + ". Bullet " + bullet_version() + ". MuJoCo " + mujoco_version() +
         ".\nFor comparison: one movement took [Shinya 1995] 410 ms in SPOON-SAUCER "
         "(0.9K triangles)\nand 2,000 ms in BREAKFAST (15K), on an IRIS 4D/310 VGX.\n" +
         (report.hash() ? text("Hash of all of Trivet's results in this run: %016llx.\n\n",
                               static_cast<unsigned long long>(*report.hash()))
                        : "\n");
}

int run(const Arguments& arguments) {
  const double load_before = load_average();
  Report report;
  const Stopwatch stopwatch;
  const std::vector<std::string>& only = arguments.only;
  for (const Part& part : kParts)
    if (only.empty() || std::find(only.begin(), only.end(), part.name) != only.end())
      part.rows(report);
  const double minutes = stopwatch.elapsed().wall_ms / 60'000;
  const std::string page = heading(load_before, minutes, report) + report.markdown();
  std::fputs(page.c_str(), stdout);
  if (!arguments.folder.empty()) {
    std::filesystem::create_directories(arguments.folder);
    std::string name = arguments.folder + text("/%s-%ucore", date().c_str(), num_cores());
    for (const std::string& part : only) name += "-" + part;
    write_file_atomically(name + ".md", page);
    if (!report.data().empty()) write_file_atomically(name + ".csv", report.data());
  }
  return 0;
}

}  // namespace
}  // namespace trivet::perf

int main(int argc, char** argv) {
  try {
    return trivet::perf::run(trivet::perf::parse(argc, argv));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trivet_perf: %s\n", e.what());
    return 2;
  }
}
