#include "ops/mend/close_gaps.h"

#include <algorithm>
#include <cmath>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "core/scene/transaction.h"
#include "ops/mend/choose_contacts.h"
#include "ops/mend/known_contacts.h"
#include "ops/mend/part_by_turns.h"
#include "ops/placement/contacts.h"
#include "ops/stability/contact_forces.h"

namespace trivet {
namespace {

constexpr int kStepsOfClosing = 14, kStepsNearGiven = 5, kCutsOfStep = 3;
constexpr int kMostMissed = 2;              // steps at which nothing holds one alone
constexpr int kMostHarder = 3;              // times that steps which do not pay pull harder
constexpr double kHarder = 2.5;             // times the pull before
constexpr double kStepPays = 0.97;          // of the cost before
constexpr double kLeastReach = 12;          // clearances
constexpr double kReachOfMotion = 2;        // times the farthest of the step before
constexpr double kMostReachInHeap = 0.003;  // metres: wider gaps are known
constexpr double kSoftContacts = 1e-3, kSoftIfAlone = 1e-6;  // see nearest_motions()
constexpr double kGapClosed = 1.9;                           // clearances: enough
constexpr double kGapOpen = 100;              // clearances: coming to rest closes less
constexpr double kLeftByMotions = 10;         // clearances: what motions leave is stuck
constexpr double kStillStep = 0.03;           // clearances
constexpr double kFrictionOfTurn = 0.2;       // of a radian by which noise may have turned a normal
constexpr double kFrictionOfOneAlone = 0.95;  // of all, so that others hold it, too

class GapCloser {
 public:
  GapCloser(Scene& scene, const std::vector<Placement>& given, const GapsToClose& gaps)
      : m_scene(scene),
        m_given(given),
        m_gaps(gaps),
        m_pull(gaps.reach),
        m_known(gaps.reach, gaps.clearance) {
    for (const Placement& p : given) m_ids.push_back(p.id);
    m_missed.assign(m_ids.size(), 0);
  }

  ClosedGaps run() {
    // If all are nearly closed, what is near does.
    double reach =
        m_gaps.near_given ? m_gaps.first_share * m_gaps.reach : kLeastReach * m_gaps.clearance;
    for (int step = 0;; ++step) {
      // Later steps end nearest to where they begin: linear motions converge sooner so.
      m_near_given = m_gaps.near_given && step < kStepsNearGiven;
      choose(reach, step == 0);
      // One alone that nothing within reach holds, again, is hardly ever held later.
      if (is_alone()) m_num_missed += m_choice.num_missing;
      if (m_near_given)
        for (size_t i = 0; i < m_ids.size(); ++i) m_missed[i] |= m_choice.missing[i];
      const bool is_last = step == kStepsOfClosing || m_num_missed >= kMostMissed ||
                           (m_gaps.is_over && m_gaps.is_over());
      if (is_done() || is_last || !pull_harder_if_stuck()) return closed();
      const double gone = go(reach);
      const double most = is_alone() ? m_gaps.reach : std::min(kMostReachInHeap, m_gaps.reach);
      reach = std::clamp(kReachOfMotion * gone, kLeastReach * m_gaps.clearance, most);
    }
  }

 private:
  // Contacts of a heap that are nearly parallel, and whose gaps differ, ask for a large turn.
  double soft() const { return is_alone() ? kSoftIfAlone : kSoftContacts; }
  bool is_alone() const { return m_ids.size() == 1; }
  KnownContacts& known() { return m_gaps.known ? *m_gaps.known : m_known; }

  bool is_done() const { return widest_needed() <= kGapClosed * m_gaps.clearance; }

  // One alone: by near contacts, or by all where these do not do. A heap knows them all.
  void choose(double& reach, bool is_first) {
    while (true) {
      find_contacts(reach);
      m_choice = choose_contacts(
          m_part, aims(),
          {m_gaps.clearance, m_gaps.reach, m_pull, soft(), is_first, m_kept, m_stuck, &m_forces});
      if (m_choice.num_missing == 0 || !is_alone() || reach >= m_gaps.reach) break;
      reach = m_gaps.reach;
    }
    m_kept.clear();
    for (size_t k = 0; k < m_part.touches.size(); ++k)
      if (m_choice.needed[k]) m_kept.push_back(m_part.touches[k]);
  }

  void find_contacts(double reach) {
    m_part = linked_bodies(m_scene, m_ids, {});
    // One alone has few contacts, and is nearer where it sees them as they are.
    KnownContacts now(reach, m_gaps.clearance);
    m_part.touches = (is_alone() ? now : known()).find(m_scene, m_part.bodies, reach);
    for (BodyContact& t : m_part.touches) t.friction = friction_of(t);
  }

  // At the given poses what friction barely holds seems to slide where noise has made a contact
  // steeper. Contacts far off would be closed to hold it.
  double friction_of(const BodyContact& t) const {
    if (is_alone()) return kFrictionOfOneAlone * t.friction;
    if (!m_near_given) return t.friction;
    double turn = m_gaps.reach / m_part.bodies[t.on].size;
    if (t.from != BodyContact::kGround) turn += m_gaps.reach / m_part.bodies[t.from].size;
    return t.friction + kFrictionOfTurn * turn;
  }

  std::vector<SmallMotion> aims() const {
    std::vector<SmallMotion> out(m_ids.size(), SmallMotion::Zero());
    for (size_t i = 0; m_near_given && i < m_ids.size(); ++i)
      out[i] = motion_to(m_part.bodies[i], m_scene.at(m_ids[i]).pose, m_given[i].pose);
    return out;
  }

  double widest_needed() const {
    double out = 0;
    for (size_t k = 0; k < m_part.touches.size(); ++k)
      if (m_choice.needed[k]) out = std::max(out, m_part.touches[k].contact.gap);
    return out;
  }

  double left_open(size_t k) const {
    return m_choice.rows[k].of(m_choice.motions) - m_choice.rows[k].least;
  }

  // @return false: nothing helped.
  bool pull_harder_if_stuck() {
    const double cost = m_choice.cost + static_cast<double>(m_choice.num_missing);
    if (cost < kStepPays * m_least_cost) {
      m_least_cost = cost;
      return true;
    }
    if (++m_num_harder > kMostHarder) return false;
    m_least_cost = kInfinity;
    const double most = kLeftByMotions * m_gaps.clearance;
    if (m_choice.widest <= most) return true;
    m_pull *= kHarder;
    // No pull closes contacts that block each other, so others are looked for.
    for (size_t k = 0; k < m_part.touches.size(); ++k)
      if (m_choice.needed[k] && left_open(k) > most) m_stuck.push_back(m_part.touches[k]);
    return true;
  }

  // No farther than contacts are known and linear motions hold. @return metres, the farthest.
  double go(double reach) {
    const double air = kGapLeft * m_gaps.clearance;
    const std::vector<SmallMotion> to = aims();
    std::vector<SmallMotion> motions = m_choice.motions;
    for (const ObjectId id : m_ids) edit_object(m_scene, id, [](Object& o) { o.placed = false; });
    std::vector<Placement> there;
    double farthest = 0;
    bool free = false;
    for (int cut = 0; cut < kCutsOfStep && !free; ++cut) {
      if (cut > 0) {
        const double still = kStillStep * m_gaps.clearance;
        motions = nearest_motions(m_choice.rows, to, still, soft());
      }
      farthest = shorten(motions, reach);
      there = moved(motions);
      const std::vector<MemberCrossing> found = crossings_of(m_scene, there, may_meet());
      free = found.empty();
      // Each crossing that is left there is another condition.
      for (const MemberCrossing& x : found)
        m_choice.rows.push_back(row_out_of(x, m_part.bodies, motions, air));
    }
    if (!free) there = part_together(m_scene, std::move(there), air, m_gaps.is_over);
    for (const Placement& p : there)
      edit_object(m_scene, p.id, [&](Object& o) {
        o.pose = p.pose;
        o.placed = true;
      });
    return farthest;
  }

  MayMeet may_meet() {
    if (is_alone()) return {};
    return [this](const Placement& a, const Placement& b) {
      return known().may_meet(a.id, a.pose, b.id, b.pose);
    };
  }

  double shorten(std::vector<SmallMotion>& motions, double reach) {
    const double most = std::min(reach, m_gaps.most_step);
    double farthest = 0;
    for (const SmallMotion& m : motions)
      farthest = std::max(farthest, m.head<3>().norm() + m.tail<3>().norm());
    m_longest = std::max(m_longest, std::min(farthest, reach));
    if (farthest <= most) return farthest;
    for (SmallMotion& m : motions) m *= most / farthest;
    return most;
  }

  std::vector<Placement> moved(const std::vector<SmallMotion>& motions) const {
    std::vector<Placement> out;
    out.reserve(m_ids.size());
    for (size_t i = 0; i < m_ids.size(); ++i)
      out.push_back({m_ids[i], moved_by(m_part.bodies[i], m_scene.at(m_ids[i]).pose, motions[i])});
    return out;
  }

  ClosedGaps closed() const {
    ClosedGaps out{not_held(), {}, missed(), m_longest};
    for (const ObjectId id : out.not_held) out.falls.push_back(fall_of(id));
    return out;
  }

  SmallMotion fall_of(ObjectId id) const {
    const auto at = static_cast<size_t>(std::find(m_ids.begin(), m_ids.end(), id) - m_ids.begin());
    SmallMotion out = SmallMotion::Zero();
    if (at < m_choice.falls.size())
      out << m_choice.falls[at].velocity, 0.5 * m_part.bodies[at].size * m_choice.falls[at].spin;
    return out;
  }

  // Across a gap that stays open the one that carries less is not held.
  std::vector<ObjectId> not_held() const {
    std::vector<char> missing = m_choice.missing;
    const std::vector<double> carried = carried_weights(m_part);
    for (size_t k = 0; k < m_part.touches.size(); ++k) {
      const BodyContact& t = m_part.touches[k];
      if (!m_choice.needed[k] || t.contact.gap <= kGapOpen * m_gaps.clearance) continue;
      const bool is_from = t.from != BodyContact::kGround && carried[t.from] < carried[t.on];
      missing[is_from ? t.from : t.on] = 1;
    }
    std::vector<ObjectId> out;
    for (size_t i = 0; i < m_ids.size(); ++i)
      if (missing[i]) out.push_back(m_ids[i]);
    return out;
  }

  std::vector<ObjectId> missed() const {
    std::vector<ObjectId> out;
    for (size_t i = 0; i < m_ids.size(); ++i)
      if (m_missed[i]) out.push_back(m_ids[i]);
    return out;
  }

  Scene& m_scene;
  const std::vector<Placement>& m_given;
  const GapsToClose& m_gaps;
  std::vector<ObjectId> m_ids;
  std::vector<char> m_missed;  // each: by a step that aims at the given poses
  double m_pull, m_least_cost = kInfinity;
  double m_longest = 0;  // metres, that a step would have gone without a bound
  int m_num_harder = 0, m_num_missed = 0;
  bool m_near_given = true;
  FreeBodies m_part;  // all contacts within reach are touches
  KnownContacts m_known;
  ChosenContacts m_choice;
  std::vector<BodyContact> m_kept, m_stuck;  // needed in the step before; that do not close
  PricedForces::End m_forces;                // of the step before
};

}  // namespace

ClosedGaps close_gaps(Scene& scene, const std::vector<Placement>& given, const GapsToClose& gaps) {
  return GapCloser(scene, given, gaps).run();
}

}  // namespace trivet
