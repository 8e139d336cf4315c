// Random changes of a scene, and all that it answers, for comparisons.
#pragma once

#include <string>
#include <vector>

#include "core/scene/transaction.h"
#include "support/random_shapes.h"

namespace trivet::test {

/// Changes by one Random: adds, removals, moves, states, groups, links. What they do depends on the
/// scene and the numbers only.
class RandomChanges {
 public:
  explicit RandomChanges(unsigned seed) : m_random(seed) {}

  Random& random() { return m_random; }
  /// One of them. Throws what the scene throws.
  void apply(Transaction& transaction);

 private:
  Object new_object(const Scene& scene);
  void move(Transaction& transaction, ObjectId id);
  void link(Transaction& transaction, ObjectId id);

  Random m_random;
};

/// Fingerprint, and what all queries answer, as text.
std::string all_answers(const Scene& scene);

/// All queries against a pass over all objects. Empty: they agree.
std::string unlike_brute_force(const Scene& scene, Random& random);

}  // namespace trivet::test
