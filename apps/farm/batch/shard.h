// The share of a batch that a process does: unit t belongs to shard t mod N.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace trivet::farm {

struct Shard {
  std::uint64_t index = 0, count = 1;
  std::string from;  // variable of the engine; empty: as it was given, or all
};

/// "I/N". @throws Error (BadInput) unless 0 <= I < N.
Shard shard_from_text(const std::string& text);

/// Value of an environment variable, or nullopt.
using Environment = std::function<std::optional<std::string>(const char* name)>;
Environment process_environment();

/// TRIVET_SHARDS. @throws Error (BadInput) when it is no number.
std::optional<std::uint64_t> shards_from_environment(const Environment& environment);

/// From the variables of Slurm, Kubernetes, AWS Batch, Google Batch and Cloud Run, GNU parallel,
/// Grid Engine, LSF, PBS and Open MPI; all of it where there are none. TRIVET_SHARDS says how many
/// where the engine does not, and before it where it does.
/// @throws Error (BadInput) when an index is there but no count, or they do not fit.
Shard shard_from_environment(const Environment& environment);

}  // namespace trivet::farm
