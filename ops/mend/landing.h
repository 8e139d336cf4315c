// The search for an object's place: what is tried, and when it ends. Private.
#pragma once

#include <set>
#include <vector>

#include "core/base/types.h"
#include "ops/mend/intent.h"
#include "ops/mend/rearrange.h"
#include "ops/mend/starts.h"

namespace trivet {

/// A place where an object rested, and what that costs.
struct Landing {
  double cost = kInfinity;
  Pose start;
  bool as_meant = false;  // supports and attitude
  bool nearly = false;    // but for supports that are too many
  int tries = 1;          // of the PUT
  Rearrangement::Trial trial;
  Vec2 off = Vec2::Zero();  // metres from the nominal place
};

/// An object's place as it was meant.
struct MeantPlace {
  const ObjectIntent& object;
  Pose nominal;
  double tolerance, most_tilt_deg;   // of the scene's intent
  std::set<std::uint32_t> leans_on;  // slots of those that may carry it, too
};

/// The cost of being `there`, put from `start`: the way from the nominal place, and parts of the
/// object's size for supports, attitude or height that were not meant.
Landing landing_at(const MeantPlace& meant, const Object& there, const Pose& start);

/// True if its main support carries it.
bool carried_as_meant(const ObjectIntent& meant, const Object& there);

inline constexpr double kAimed = 0.1;  // tolerances: near enough

/// The cheapest landing so far. It ends when that is as meant, and near enough or cheaper than what
/// is left; or after tries without a cheaper one.
class LandingSearch {
 public:
  /// @param near  metres: near enough. @param most_tries  in all.
  LandingSearch(double near, int most_tries) : m_near(near), m_most_tries(most_tries) {}

  bool ends_before(const Start& start) const {
    if (m_tries >= m_most_tries) return true;
    if (m_best.cost == kInfinity) return false;
    const bool is_dearer = start.cost > m_best.cost;
    if (m_best.as_meant && (is_near_enough() || is_dearer || m_tries > kTriesAsMeant)) return true;
    // The search goes on longer while no place is as meant, as any start may find one.
    if (is_dearer && m_tries > m_most_tries / 2) return true;
    return m_tries - m_tries_of_best > (m_best.nearly ? kPatienceIfNearly : kPatience);
  }
  bool is_known(const Start& start) const { return falls_as_another(start.pose, m_tried); }

  void note_try(const Start& start) {
    ++m_tries;
    m_tried.push_back(start.pose);
  }
  void note(const Landing& landing) {
    if (landing.cost < kClearlyCheaper * m_best.cost) m_tries_of_best = m_tries;
    if (landing.cost < m_best.cost) m_best = landing;
  }
  bool is_near_enough() const { return m_best.as_meant && m_best.cost < m_near; }
  const Landing& best() const { return m_best; }

 private:
  static constexpr int kTriesAsMeant = 5;      // that look for a nearer place
  static constexpr int kPatience = 12;         // tries without a cheaper place
  static constexpr int kPatienceIfNearly = 4;  // the same, where only a support is too many
  static constexpr double kClearlyCheaper = 0.9;

  double m_near;
  int m_most_tries, m_tries = 0, m_tries_of_best = 0;
  std::vector<Pose> m_tried;
  Landing m_best;
};

}  // namespace trivet
