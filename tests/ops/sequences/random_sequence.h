// Random sequences of operations, each determined by its seed.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ops/session/session.h"
#include "support/settle_options.h"

namespace trivet::test {

inline constexpr double kSequenceClearance = 2e-6;
inline constexpr int kOperations = 20;

enum class ModelKind { OfTheProject, Real };

/// Detector and number of threads.
struct Worker {
  Detector* detector = nullptr;  // null: BVHs
  int num_threads = 1;
};

struct SequenceOptions {
  SettleOptions settle = perfect_friction();  // its clearance is kSequenceClearance
  std::vector<Worker> workers = {{}};         // take turns, one operation each
  /// Called after every completed operation; null: no check. The sequence ends when it returns
  /// false.
  std::function<bool(const Scene&)> holds;
  bool tell = false;  // print every operation
};

struct Outcome {
  std::uint64_t hash = 0;  // of the scenes after every operation
  int num_done = 0;        // operations not refused
  double seconds = 0;      // of all operations
};

/// Performs the sequence, undoes and redoes it; every state is bitwise the same.
Outcome run_sequence(unsigned seed, ModelKind kind, const SequenceOptions& options);

/// 0 to `count` - 1, or from the environment: TRIVET_SEQUENCE=76 or TRIVET_SEQUENCE=100-199.
std::vector<unsigned> chosen_seeds(int count);
/// True if the environment selects a single sequence.
bool is_one_seed();

}  // namespace trivet::test
