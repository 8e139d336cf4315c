// Values that the result of an operation depends on; journals keep them.
#pragma once

#include <optional>

namespace trivet {

/// Clearance of motions and end of settling. Lengths in metres.
struct SettleOptions {
  /// Clearance at which motions stop; 0: 2^-20 of the size of what is near.
  double clearance = 0;
  /// The paper's three cases literally, for comparison, instead of the enumerated Gauss principle.
  bool literal_paper_rules = false;
  /// Settle with (nearly) perfect friction, each object alone, as the paper does; otherwise with
  /// the friction of the materials, 0.5 where none is given.
  bool perfect_friction = false;
  /// Judge the connected part of the scene as a whole after an operation: what does not stand gives
  /// way, or the operation is refused. Otherwise each object is at rest on what stands still.
  bool whole_at_rest = true;
  /// Refuse an operation that needs more motions.
  int max_motions = 5000;
  /// Accept an object that can neither move nor be shown to be supported, as ObjectState::Wedged;
  /// otherwise the operation is refused.
  bool accept_wedged = false;
  /// Rest with a reserve, for scenes that are to stay in simulators: only kRobustFriction of all
  /// friction counts, when things settle and when they are judged. Perfect friction has none.
  bool robust = false;
};

/// Part of the coefficients of friction that robust rest may need.
inline constexpr double kRobustFriction = 0.7;

/// Options that say what counts as rest, as far as a file or a user states them.
struct SettleRules {
  std::optional<bool> perfect_friction, whole_at_rest, literal_paper_rules, robust;
};

/// Rules of journals and scene files that state none: they are of the time before there was a
/// choice.
constexpr SettleRules kRulesBefore{true, false, false, false};

inline SettleOptions with_rules(SettleOptions options, const SettleRules& rules) {
  options.perfect_friction = rules.perfect_friction.value_or(options.perfect_friction);
  options.whole_at_rest = rules.whole_at_rest.value_or(options.whole_at_rest);
  options.literal_paper_rules = rules.literal_paper_rules.value_or(options.literal_paper_rules);
  options.robust = rules.robust.value_or(options.robust);
  return options;
}

inline SettleRules rules_of(const SettleOptions& options) {
  return {options.perfect_friction, options.whole_at_rest, options.literal_paper_rules,
          options.robust};
}

/// The paper's rules know perfect friction only.
inline bool has_finite_friction(const SettleOptions& options) {
  return !options.perfect_friction && !options.literal_paper_rules;
}

/// True if operations keep the whole at rest; with perfect friction each object is judged alone.
inline bool keeps_whole_at_rest(const SettleOptions& options) {
  return options.whole_at_rest && has_finite_friction(options);
}

/// Part of all friction that rest may need.
inline double friction_share(const SettleOptions& options) {
  return options.robust ? kRobustFriction : 1;
}

}  // namespace trivet
