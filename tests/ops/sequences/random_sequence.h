// Random sequences of operations, each from its seed alone.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ops/session/session.h"

namespace trivet::test {

inline constexpr double kSequenceClearance = 2e-6;
inline constexpr int kOperations = 20;

enum class ModelKind { OfTheProject, Real };

/// What answers, with how many threads.
struct Worker {
  Detector* detector = nullptr;  // null: box trees
  int num_threads = 1;
};

struct SequenceOptions {
  std::vector<Worker> workers = {{}};  // who take turns, an operation each
  /// Asked after every operation that was done; null: nothing is. The sequence ends when it is
  /// false.
  std::function<bool(const Scene&)> holds;
  bool tell = false;  // what is done
};

struct Outcome {
  std::uint64_t hash = 0;  // of the scenes after every operation
  int num_done = 0;        // operations that were not refused
  double seconds = 0;      // of all operations
};

/// Performs it, undoes all of it and does it again; every state is the same to the bit.
Outcome run_sequence(unsigned seed, ModelKind kind, const SequenceOptions& options);

/// 0 to `count` - 1, or what the environment says: TRIVET_SEQUENCE=76 or TRIVET_SEQUENCE=100-199.
std::vector<unsigned> chosen_seeds(int count);
/// Whether the environment names one sequence alone.
bool is_one_seed();

}  // namespace trivet::test
