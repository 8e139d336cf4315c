#include "ops/mend/intent.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/logarithm.h"
#include "ops/mend/attitudes.h"
#include "ops/mend/intent_order.h"

namespace trivet {
namespace {

constexpr int kColumns = 28, kFewColumns = 14;
constexpr double kFirstTolerance = 0.02, kLeastTolerance = 0.002, kMostTolerance = 0.06;
constexpr double kGapsToTolerance = 3.5;  // times the median gap
constexpr double kLeastTilt = 2.5, kMostTilt = 18, kSmallTilt = 15, kTiltsToLimit = 5;
constexpr double kNextTilt = 1.6;      // times the tilt before: as near as noise has them
constexpr double kNearShare = 0.35;    // of the tolerance: what is hardly off
constexpr double kLeastShare = 0.12;   // of a support
constexpr double kUnsureScore = 0.25;  // of who lies above: below it is a guess
// Tolerances: an object that hangs so far above all that it meets may be sunk into something.
constexpr double kHangs = 9, kDeeper = 3;

double at_share(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<size_t>(k)];
}

// Tilts that are much larger than the usual ones are meant.
double most_tilt_by_noise(std::vector<double> tilts) {
  if (tilts.empty()) return 3;
  double most = std::clamp(kTiltsToLimit * at_share(tilts, 0.5), kLeastTilt, kMostTilt);
  // Tilts that follow each other closely are of one kind, though chance has many small ones.
  std::sort(tilts.begin(), tilts.end());
  for (size_t k = 1; k < tilts.size(); ++k) {
    if (tilts[k] <= most) continue;
    if (tilts[k] > kNextTilt * tilts[k - 1]) break;
    most = tilts[k];
  }
  return most;
}

class IntentFinder {
 public:
  IntentFinder(const Scene& scene, ShapeFacts& facts, const IsOver& is_over)
      : m_scene(scene), m_facts(facts), m_is_over(is_over) {}

  Intent find(std::optional<double> tolerance) {
    // Attitudes come first: columns are read through levelled objects.
    level_all();
    // Without a given tolerance a coarse look measures the gaps; the noise of the scene is a few
    // times their median.
    if (!tolerance) {
      m_tolerance = kFirstTolerance;
      look(kFewColumns);
      std::vector<double> gaps;
      for (const Looked& l : m_looked)
        if (!l.intent.on.empty()) gaps.push_back(std::abs(l.intent.gap));
      tolerance = gaps.empty() ? 0.01
                               : std::clamp(kGapsToTolerance * at_share(gaps, 0.5), kLeastTolerance,
                                            kMostTolerance);
    }
    m_tolerance = *tolerance;
    look(kColumns);
    look_deeper();
    Intent out;
    out.tolerance = m_tolerance, out.most_tilt_deg = m_most_tilt;
    out.objects = in_order(m_looked);
    return out;
  }

 private:
  void level_all() {
    std::vector<double> small;
    std::map<std::uint32_t, std::vector<Vec3>> downs;
    // Every object joins the scene; those that may move are looked at.
    for (const ObjectId id : m_scene.ids()) {
      const Object& object = m_scene.at(id);
      if (!object.placed) continue;
      if (is_time_over(m_is_over)) break;
      m_all.push_back({id, object.pose});
      if (object.fixed) continue;
      Looked looked;
      looked.intent.id = id;
      downs[id.index] = downs_of(object, m_facts);
      // The tilt is that against the nearest stable pose.
      looked.intent.tilt_deg = nearest_down(downs[id.index], object.pose.rotation).second;
      if (looked.intent.tilt_deg < kSmallTilt) small.push_back(looked.intent.tilt_deg);
      m_looked.push_back(std::move(looked));
    }
    m_most_tilt = most_tilt_by_noise(std::move(small));
    for (Looked& l : m_looked) {
      const Object& object = m_scene.at(l.intent.id);
      l.intent.is_level = l.intent.tilt_deg <= m_most_tilt;
      const std::vector<Vec3>& stable = downs[l.intent.id.index];
      l.intent.upright = stable.empty() ? object.pose : levelled(object, stable);
      l.intent.level = l.intent.is_level ? l.intent.upright : object.pose;
      l.level = {l.intent.id, l.intent.level};
    }
    // All columns see the level attitudes, of supports, too.
    for (Placement& p : m_all)
      for (const Looked& l : m_looked)
        if (l.intent.id == p.id) p.pose = l.intent.level;
  }

  void look(int num) {
    // Each look starts anew, as the tolerance has changed.
    m_index.clear();
    for (size_t i = 0; i < m_looked.size(); ++i) {
      Looked& l = m_looked[i];
      read_columns(l, num, m_tolerance);
      m_index[l.intent.id.index] = i;
    }
    // Containers tell what may carry what, and order tells who lies on whom.
    for (Looked& l : m_looked) l.intent.inside = container_of(m_scene, l);
    for (Looked& l : m_looked) find_below(l);
    for (Looked& l : m_looked) find_supports(l);
  }

  void read_columns(Looked& l, int num, double tolerance) const {
    if (is_time_over(m_is_over)) return;
    const auto at = std::find_if(m_all.begin(), m_all.end(),
                                 [&](const Placement& p) { return p.id == l.intent.id; });
    l.columns = columns_of(m_scene, m_all, static_cast<size_t>(at - m_all.begin()), num, tolerance);
    l.above.clear(), l.unsure.clear();
  }

  // The tolerance is of the scene; single objects are off by more than it.
  void look_deeper() {
    for (Looked& l : m_looked) {
      if (!l.intent.on.empty() && l.intent.gap <= kHangs * m_tolerance) continue;
      Looked deeper = l;
      read_columns(deeper, kColumns, kDeeper * m_tolerance);
      deeper.intent.inside = container_of(m_scene, deeper);
      find_below(deeper);
      find_supports(deeper);
      const bool is_nearer =
          l.intent.on.empty() || std::abs(deeper.intent.gap) < std::abs(l.intent.gap);
      if (!deeper.intent.on.empty() && is_nearer) l = std::move(deeper);
    }
  }

  const Looked* looked(ObjectId id) const {
    const auto it = m_index.find(id.index);
    return it == m_index.end() ? nullptr : &m_looked[it->second];
  }

  static double area(const Looked& l) {
    return std::max<double>(1, static_cast<double>(l.columns.columns.size())) * l.columns.width *
           l.columns.width;
  }

  // Distance of the underside from the other's faces below it, about; nothing: none is below.
  static std::optional<double> distance_to(const Looked& l, ObjectId other) {
    const auto at = std::find(l.columns.others.begin(), l.columns.others.end(), other);
    if (at == l.columns.others.end()) return std::nullopt;
    const auto k = static_cast<size_t>(at - l.columns.others.begin());
    std::vector<double> gaps;
    for (const Column& c : l.columns.columns)
      if (c.others[k].highest_under > kNoHeight) gaps.push_back(c.low - c.others[k].highest_under);
    if (gaps.empty()) return std::nullopt;
    return at_share(gaps, 0.1);
  }

  // Side by side: they overlap in height by more than they overlap seen from above.
  bool is_beside(const Looked& l, size_t k) const {
    // The overlap in height is the median over columns that meet both.
    std::vector<double> over;
    for (const Column& c : l.columns.columns)
      if (c.others[k].high > kNoHeight)
        over.push_back(std::min(c.high, c.others[k].high) - std::max(c.low, c.others[k].low));
    if (over.empty()) return true;
    const double height = at_share(over, 0.5);
    const double share = static_cast<double>(over.size()) /
                         static_cast<double>(std::max<size_t>(l.columns.columns.size(), 1));
    const Aabb mine = m_scene.world_box(l.intent.id),
               other = m_scene.world_box(l.columns.others[k]);
    const Vec2 common =
        (mine.upper.cwiseMin(other.upper) - mine.lower.cwiseMax(other.lower)).head<2>();
    const double least =
        std::min(mine.upper.z() - mine.lower.z(), other.upper.z() - other.lower.z());
    // A stack overlaps little in height and much seen from above; neighbours do the opposite.
    const double across = common.minCoeff();
    return height > 0.3 * least && across < height && (share < 0.6 || across < 0.5 * height);
  }

  void find_below(Looked& l) {
    for (size_t k = 0; k < l.columns.others.size(); ++k) {
      const ObjectId other = l.columns.others[k];
      // Fixed objects, and the container, are below whatever meets them.
      const Looked* const o = looked(other);
      if (!o || l.intent.inside == other) {
        l.above.insert(other.index);
        continue;
      }
      if (o->intent.inside == l.intent.id || is_beside(l, k)) continue;
      // Each one's distance as seen from both decides, and then the larger one is the lower one.
      const auto down = distance_to(l, other), up = distance_to(*o, l.intent.id);
      if (!down) continue;
      const double score =
          ((up ? std::abs(*up) : 4 * m_tolerance) - std::abs(*down)) / m_tolerance +
          natural_logarithm(area(*o) / area(l));
      if (std::abs(score) < kUnsureScore) l.unsure.insert(other.index);
      if (score > 0 || (score == 0 && l.intent.id.index > other.index)) l.above.insert(other.index);
    }
  }

  bool may_carry(const Looked& l, ObjectId other) const {
    if (!l.above.count(other.index)) return false;
    // Inside a container only the container and what is in it may carry.
    if (!l.intent.inside || *l.intent.inside == other) return true;
    const Looked* const o = looked(other);
    return o && o->intent.inside == l.intent.inside;
  }

  // True if `a` lies above `b`.
  bool lies_above(ObjectId a, ObjectId b) const {
    const Looked* const l = looked(a);
    return l && l->above.count(b.index) > 0;
  }

  /// A column's gap and what is below it.
  struct Gap {
    double gap;
    Support on;
  };

  std::vector<Gap> gaps_of(const Looked& l) const {
    std::vector<Gap> out;
    for (const Column& c : l.columns.columns)
      if (const auto owner = owner_of(l, c)) out.push_back(*owner);
    return out;
  }

  // The smallest gaps tell where the object touches; a few of the least are noise.
  static double first_of(const std::vector<Gap>& gaps) {
    std::vector<double> values;
    values.reserve(gaps.size());
    for (const Gap& g : gaps) values.push_back(g.gap);
    return at_share(values, 0.03);
  }
  // Columns nearly as near share the weight.
  double near_to(double first) const { return first + std::max(kNearShare * m_tolerance, 0.0015); }

  void find_supports(Looked& l) const {
    const std::vector<Gap> gaps = gaps_of(l);
    l.intent.on.clear();
    if (gaps.empty()) return;
    const double first = first_of(gaps);
    l.intent.gap = std::min(first, gap_of_feet(l).value_or(first));
    double total = 0;
    for (const Gap& g : gaps) {
      if (g.gap > near_to(first)) continue;
      total += 1;
      const auto known = std::find_if(l.intent.on.begin(), l.intent.on.end(),
                                      [&](const IntendedSupport& s) { return s.on == g.on; });
      if (known == l.intent.on.end())
        l.intent.on.push_back(
            {g.on, 1, !g.on.is_floor() && l.unsure.count(g.on.object().index) > 0});
      else
        known->share += 1;
    }
    for (IntendedSupport& s : l.intent.on) s.share /= total;
    std::stable_sort(l.intent.on.begin(), l.intent.on.end(),
                     [](const auto& a, const auto& b) { return a.share > b.share; });
    // Supports with a small share are neighbours that noise has moved under the edge.
    while (l.intent.on.size() > 1 && l.intent.on.back().share < kLeastShare) l.intent.on.pop_back();
  }

  // The highest face below; of two that lie on each other the upper one, though noise has it lower.
  std::optional<Gap> owner_of(const Looked& l, const Column& c) const {
    std::optional<ObjectId> owner;
    double top = kNoHeight;
    for (size_t k = 0; k < l.columns.others.size(); ++k) {
      const ObjectId other = l.columns.others[k];
      const double z = c.others[k].highest_under;
      // Order wins over height within the tolerance.
      if (z == kNoHeight || !may_carry(l, other)) continue;
      const bool over = owner && lies_above(other, *owner),
                 under = owner && lies_above(*owner, other);
      if (owner && z < top + (under ? m_tolerance : over ? -m_tolerance : 0)) continue;
      owner = other, top = z;
    }
    // A column without an object below, or with one below the floor's height, stands on the floor.
    if (!owner || (top < 0 && m_scene.floor && !l.intent.inside)) {
      if (!m_scene.floor || l.intent.inside || c.low < -3 * m_tolerance - 0.05) {
        if (!owner) return std::nullopt;
      } else {
        return Gap{c.low, Support::floor()};
      }
    }
    return Gap{c.low - top, *owner};
  }

  // Feet, and covers of books, may be thinner than a column: vertices below all columns, over what
  // the nearest column finds.
  std::optional<double> gap_of_feet(const Looked& l) const {
    const double low = lowest(l);
    const Body body = body_of(m_scene.at(l.intent.id), l.intent.level);
    std::optional<double> out;
    for (Index v = 0; v < static_cast<Index>(body.shape->mesh.vertices.size()); ++v) {
      const Vec3 foot = body.vertex(v);
      if (foot.z() >= low) continue;
      const auto top = top_near(l, foot.head<2>());
      if (top && *top <= foot.z() + m_tolerance)
        out = std::min(out.value_or(kInfinity), foot.z() - *top);
    }
    return out;
  }

  std::optional<double> top_near(const Looked& l, const Vec2& at) const {
    std::optional<double> out;
    double nearest = kInfinity;
    for (const Column& c : l.columns.columns) {
      const double apart = (c.at - at).squaredNorm();
      if (apart >= nearest) continue;
      if (const auto owner = owner_of(l, c)) nearest = apart, out = c.low - owner->gap;
    }
    return out;
  }

  const Scene& m_scene;
  ShapeFacts& m_facts;
  const IsOver& m_is_over;
  PosedObjects m_all;  // level
  std::vector<Looked> m_looked;
  std::map<std::uint32_t, size_t> m_index;  // of m_looked, by slot
  double m_tolerance = 0, m_most_tilt = 0;
};

}  // namespace

const ObjectIntent* Intent::find(ObjectId id) const {
  for (const ObjectIntent& o : objects)
    if (o.id == id) return &o;
  return nullptr;
}

Intent infer_intent(const Scene& scene, std::optional<double> tolerance) {
  ShapeFacts facts;
  return infer_intent(scene, tolerance, facts);
}

Intent infer_intent(const Scene& scene, std::optional<double> tolerance, ShapeFacts& facts,
                    const IsOver& is_over) {
  return IntentFinder(scene, facts, is_over).find(tolerance);
}

}  // namespace trivet
