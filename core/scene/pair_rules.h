// Rules for pairs of objects: pairs that do not collide, and friction that belongs to a pair.
#pragma once

#include <map>
#include <optional>
#include <utility>

namespace trivet {

/// Objects of one kind follow the same rules. Kind 0, of objects without any: no rule.
using PairKind = int;

struct PairRule {
  bool may_pass = false;           // through each other: they never collide
  std::optional<double> friction;  // Coulomb's coefficient; nothing: of the materials

  friend bool operator==(const PairRule&, const PairRule&) = default;
};

/// Rules by two kinds, in either order.
class PairRules {
 public:
  void set(PairKind a, PairKind b, const PairRule& rule) { m_rules[sorted(a, b)] = rule; }
  /// Null: none.
  const PairRule* find(PairKind a, PairKind b) const {
    const auto it = m_rules.find(sorted(a, b));
    return it == m_rules.end() ? nullptr : &it->second;
  }
  const std::map<std::pair<PairKind, PairKind>, PairRule>& all() const { return m_rules; }

 private:
  static std::pair<PairKind, PairKind> sorted(PairKind a, PairKind b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
  }
  std::map<std::pair<PairKind, PairKind>, PairRule> m_rules;  // smaller kind first
};

}  // namespace trivet
