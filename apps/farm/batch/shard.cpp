#include "apps/farm/batch/shard.h"

#include <charconv>
#include <cstdlib>

#include "core/base/bad_input.h"

namespace trivet::farm {
namespace {

/// Variables by which an engine tells its tasks which they are. Counts are of tasks; nullptr: it
/// has none.
struct Engine {
  const char* index;
  const char* first;   // variable with the least index
  std::uint64_t base;  // the least index where there is none
  const char* count;
};
constexpr Engine kEngines[] = {
    {"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", 0, "SLURM_ARRAY_TASK_COUNT"},
    {"JOB_COMPLETION_INDEX", nullptr, 0, nullptr},  // Kubernetes, indexed job
    {"AWS_BATCH_JOB_ARRAY_INDEX", nullptr, 0, nullptr},
    {"BATCH_TASK_INDEX", nullptr, 0, "BATCH_TASK_COUNT"},          // Google Batch
    {"CLOUD_RUN_TASK_INDEX", nullptr, 0, "CLOUD_RUN_TASK_COUNT"},  // Google Cloud Run
    {"SGE_TASK_ID", nullptr, 1, "SGE_TASK_LAST"},                  // Grid Engine
    {"LSB_JOBINDEX", nullptr, 1, "LSB_JOBINDEX_END"},              // LSF; 0 outside of arrays
    {"PBS_ARRAY_INDEX", nullptr, 0, nullptr},
    {"PARALLEL_SEQ", nullptr, 1, nullptr},  // GNU parallel
    {"OMPI_COMM_WORLD_RANK", nullptr, 0, "OMPI_COMM_WORLD_SIZE"},
};

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end || text.empty()) return std::nullopt;
  return value;
}

std::uint64_t number_of_variable(const char* name, const std::string& text) {
  if (const auto number = whole_number(text)) return *number;
  bad_input("%1: \"%2\" is not accepted; accepted: a whole number", name, text);
}

std::uint64_t count_of(const Engine& engine, const Environment& environment) {
  if (const auto shards = shards_from_environment(environment)) return *shards;
  if (engine.count)
    if (const auto count = environment(engine.count))
      if (*count != "undefined") return number_of_variable(engine.count, *count);
  bad_input("%1 is set, but not how many there are; accepted: TRIVET_SHARDS=N, or --shard I/N",
            engine.index);
}

Shard checked(const Shard& shard, const std::string& what) {
  if (shard.index < shard.count) return shard;
  bad_input("%1: shard %2 of %3 is not accepted; accepted: 0 to one less than their number", what,
            shard.index, shard.count);
}

bool is_array_task(const Engine& engine, const std::string& index) {
  // Grid Engine says "undefined", LSF 0 to jobs that are no arrays.
  return index != "undefined" && !(index == "0" && engine.base == 1);
}

}  // namespace

Shard shard_from_text(const std::string& text) {
  const size_t slash = text.find('/');
  const auto index = whole_number(text.substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : whole_number(text.substr(slash + 1));
  if (!index || !count)
    bad_input("--shard: \"%1\" is not accepted; accepted: I/N with 0 <= I < N", text);
  return checked({*index, *count, ""}, "--shard");
}

Environment process_environment() {
  return [](const char* name) -> std::optional<std::string> {
    const char* const value = std::getenv(name);
    return value ? std::optional<std::string>(value) : std::nullopt;
  };
}

std::optional<std::uint64_t> shards_from_environment(const Environment& environment) {
  const auto shards = environment("TRIVET_SHARDS");
  if (!shards) return std::nullopt;
  return number_of_variable("TRIVET_SHARDS", *shards);
}

Shard shard_from_environment(const Environment& environment) {
  for (const Engine& engine : kEngines) {
    const auto index = environment(engine.index);
    if (!index || !is_array_task(engine, *index)) continue;
    Shard shard{number_of_variable(engine.index, *index), count_of(engine, environment),
                engine.index};
    std::uint64_t base = engine.base;
    // A resubmitted part of an array has another least index: with TRIVET_SHARDS tasks count from
    // `base`, whatever part it is.
    if (engine.first && !environment("TRIVET_SHARDS"))
      if (const auto first = environment(engine.first))
        base = number_of_variable(engine.first, *first);
    if (shard.index < base)
      bad_input("%1: %2 is not accepted; accepted: from %3", engine.index, *index, base);
    shard.index -= base;
    return checked(shard, engine.index);
  }
  return {};
}

}  // namespace trivet::farm
