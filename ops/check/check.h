// The whole scene judged again from its poses alone: exact interpenetration in double and in the
// exported float32, gaps, rest.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/base/deadline.h"
#include "ops/base/options.h"

namespace trivet {

struct SceneCheck {
  struct PairFinding {
    std::string a, b;  // names; "floor"
    std::int64_t count = 0;
    double depth = 0;           // metres that one has to be moved to be free; 0: they touch
    Vec3 point = Vec3::Zero();  // world, where they meet
  };
  std::vector<PairFinding> crossings;          // pairs of faces, on the doubles
  std::vector<PairFinding> float32_crossings;  // on the exported positions
  std::vector<PairFinding> contained;          // components of a inside b
  std::vector<std::string> not_at_rest;        // names of free objects without equilibrium
  struct Hovering {
    std::string name, above;  // of what it would fall onto: "floor", an object; empty: nothing
    double height = 0;        // metres that it would fall; infinity over nothing
  };
  std::vector<Hovering> hovering;  // those of not_at_rest that nothing touches from below
  /// Pairs that interpenetrate by at most kTouchingDepth clearances, as flush walls do: counted as
  /// crossings, too, but no failure.
  std::vector<PairFinding> touching;
  double smallest_gap = kInfinity;  // metres, over all contacts; infinity: no contact
  /// Left when the time was over: pairs that may interpenetrate, and names of objects whose rest is
  /// not known.
  size_t num_pairs_not_judged = 0;
  std::vector<std::string> not_judged;

  std::int64_t interpenetrating_pairs() const;
  bool whole() const { return num_pairs_not_judged == 0 && not_judged.empty(); }
  bool ok() const;  // and whole
};

inline constexpr double kTouchingDepth = 0.5;

/// @param num_threads  0: all cores. The result does not depend on it.
/// @param settled_by  the rules by which the scene was settled: they say what counts as rest; its
///   clearance is not used.
/// @param is_over  asked before each pair, and then before each object.
SceneCheck check_scene(const Scene& scene, int num_threads = 0, double clearance = 0,
                       const SettleOptions& settled_by = {}, const IsOver& is_over = {});

/// Files of others do not say by which clearance they were settled, and their scene may have been
/// larger then: so many times the default is contact where everything then rests.
inline constexpr double kOldClearances = 8;

/// True if each object of check.not_at_rest rests by another clearance: the check of the scene may
/// then find all at rest. Costs these objects alone, and ends at the first that does not.
bool may_rest_by(const Scene& scene, const SceneCheck& check, double clearance,
                 const SettleOptions& settled_by = {});

/// Fills links, state, margin and least friction of every placed object from the poses.
/// @param clearance  metres; 0: default_clearance() of the scene.
/// @param settled_by  the friction by which the scene was settled; its clearance is not used.
/// @param is_over  asked before each object: the others keep what they have.
void update_contacts(Scene& scene, double clearance = 0, const SettleOptions& settled_by = {},
                     const IsOver& is_over = {});
/// The same of those of these objects that are placed. @param ids  in the scene's list.
void update_contacts(Transaction& transaction, const std::vector<ObjectId>& ids, double clearance,
                     const SettleOptions& settled_by, const IsOver& is_over = {});

}  // namespace trivet
