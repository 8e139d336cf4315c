// Job files for engines that distribute shards.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trivet::farm {

/// Arguments of the `trivet batch` of every task.
struct BatchJob {
  std::string recipe;
  std::uint64_t count = 0, seed = 0, per_unit = 20;
  std::string out = "out";
  int jobs = 1;
  std::uint64_t shards = 0;       // 0: one per 1,000 scenes, 1 to 200
  std::vector<std::string> more;  // further options, as they are given
};

/// "slurm", "kubernetes", "aws-batch" or "parallel": a job file. Names in capitals are to be
/// replaced. In containers the recipe's folder is /in, and `out` is /out.
std::string engine_template(const std::string& engine, const BatchJob& job);

}  // namespace trivet::farm
