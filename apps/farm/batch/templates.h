// Job files for engines that distribute shards.
#pragma once

#include <cstdint>
#include <string>

namespace trivet::farm {

/// "slurm", "kubernetes", "aws-batch" or "parallel": a job file that makes `count` scenes of the
/// recipe. Names in capitals are to be replaced.
std::string engine_template(const std::string& engine, const std::string& recipe,
                            std::uint64_t count, std::uint64_t seed, std::uint64_t per_unit);

}  // namespace trivet::farm
