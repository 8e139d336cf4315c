// Shards from the variables of each engine.
#include <gtest/gtest.h>

#include <map>

#include "apps/farm/batch/shard.h"
#include "core/base/error.h"

namespace trivet::farm {
namespace {

using Variables = std::map<std::string, std::string>;

std::string shard_of(const Variables& variables) {
  try {
    const Shard shard = shard_from_environment([&](const char* name) -> std::optional<std::string> {
      const auto it = variables.find(name);
      return it == variables.end() ? std::nullopt : std::optional(it->second);
    });
    return std::to_string(shard.index) + "/" + std::to_string(shard.count);
  } catch (const Error& e) {
    return e.what();
  }
}

std::string shard_of_text(const std::string& text) {
  try {
    const Shard shard = shard_from_text(text);
    return std::to_string(shard.index) + "/" + std::to_string(shard.count);
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(Shard, IsReadFromText) {
  EXPECT_EQ(shard_of_text("0/1"), "0/1");
  EXPECT_EQ(shard_of_text("199/200"), "199/200");
  for (const char* const bad : {"", "1", "/", "1/", "/2", "2/2", "-1/2", "1/2/3", "a/b", "1/2 "})
    EXPECT_NE(shard_of_text(bad).find("accepted"), std::string::npos) << bad;
}

TEST(Shard, ComesFromEngines) {
  EXPECT_EQ(shard_of({}), "0/1");
  EXPECT_EQ(shard_of({{"SLURM_ARRAY_TASK_ID", "5"},
                      {"SLURM_ARRAY_TASK_MIN", "3"},
                      {"SLURM_ARRAY_TASK_MAX", "6"},
                      {"SLURM_ARRAY_TASK_COUNT", "4"}}),
            "2/4");
  // A part of an array, resubmitted: tasks 5 to 6 of 0 to 9.
  EXPECT_EQ(shard_of({{"SLURM_ARRAY_TASK_ID", "5"},
                      {"SLURM_ARRAY_TASK_MIN", "5"},
                      {"SLURM_ARRAY_TASK_COUNT", "2"},
                      {"TRIVET_SHARDS", "10"}}),
            "5/10");
  EXPECT_EQ(shard_of({{"JOB_COMPLETION_INDEX", "7"}, {"TRIVET_SHARDS", "8"}}), "7/8");
  EXPECT_EQ(shard_of({{"AWS_BATCH_JOB_ARRAY_INDEX", "0"}, {"TRIVET_SHARDS", "8"}}), "0/8");
  EXPECT_EQ(shard_of({{"BATCH_TASK_INDEX", "1"}, {"BATCH_TASK_COUNT", "3"}}), "1/3");
  EXPECT_EQ(shard_of({{"CLOUD_RUN_TASK_INDEX", "1"}, {"CLOUD_RUN_TASK_COUNT", "3"}}), "1/3");
  EXPECT_EQ(shard_of({{"SGE_TASK_ID", "3"}, {"SGE_TASK_LAST", "3"}}), "2/3");
  EXPECT_EQ(shard_of({{"SGE_TASK_ID", "undefined"}, {"SGE_TASK_LAST", "undefined"}}), "0/1");
  EXPECT_EQ(shard_of({{"LSB_JOBINDEX", "1"}, {"LSB_JOBINDEX_END", "4"}}), "0/4");
  EXPECT_EQ(shard_of({{"LSB_JOBINDEX", "0"}}), "0/1");
  EXPECT_EQ(shard_of({{"PBS_ARRAY_INDEX", "2"}, {"TRIVET_SHARDS", "4"}}), "2/4");
  EXPECT_EQ(shard_of({{"PARALLEL_SEQ", "4"}, {"TRIVET_SHARDS", "4"}}), "3/4");
  EXPECT_EQ(shard_of({{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "2"}}), "1/2");
}

TEST(Shard, RefusesWhatDoesNotFit) {
  EXPECT_NE(shard_of({{"JOB_COMPLETION_INDEX", "7"}}).find("TRIVET_SHARDS=N"), std::string::npos);
  EXPECT_NE(shard_of({{"JOB_COMPLETION_INDEX", "8"}, {"TRIVET_SHARDS", "8"}}).find("accepted"),
            std::string::npos);
  EXPECT_NE(shard_of({{"JOB_COMPLETION_INDEX", "x"}, {"TRIVET_SHARDS", "8"}})
                .find("JOB_COMPLETION_INDEX: \"x\" is not accepted"),
            std::string::npos);
  EXPECT_NE(shard_of({{"JOB_COMPLETION_INDEX", "1"}, {"TRIVET_SHARDS", "many"}})
                .find("TRIVET_SHARDS: \"many\" is not accepted"),
            std::string::npos);
}

}  // namespace
}  // namespace trivet::farm
