#include "ops/mend/choose_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ops/stability/priced_forces.h"

namespace trivet {
namespace {

constexpr double kPriceOfReach = 1;         // of a push as heavy as what a body carries, across it
constexpr double kMostPrice = 4;            // of that
constexpr double kKeptShare = 0.1;          // of its gap, that a contact costs that was needed
constexpr double kPriceOfStuck = 30;        // times the usual one
constexpr double kMissingWeight = 1e-4;     // of what a body weighs: more than rounding
constexpr double kForceThatMatters = 1e-3;  // of a body's weight
constexpr double kWeakPull = 0.02;          // of the reach
constexpr double kStrongerPull = 2.5;       // times the one before
constexpr int kRoundsAtFullPull = 2;
constexpr double kClearlyBetter = 0.97;   // of a cost
constexpr double kStillChoice = 0.03;     // clearances
constexpr double kClosedByMotions = 0.1;  // clearances

bool is_among(std::span<const BodyContact> contacts, const BodyContact& t) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const BodyContact& k) { return are_alike(k, t); });
}

class ContactChoice {
 public:
  ContactChoice(const FreeBodies& part, const std::vector<SmallMotion>& aims,
                const ChoiceOfContacts& options)
      : m_part(part),
        m_aims(aims),
        m_options(options),
        m_forces(part, options.clearance, first_touches(),
                 options.forces ? *options.forces : PricedForces::End{}) {
    for (const BodyContact& t : part.touches) {
      m_factors.push_back(is_among(options.stuck, t) ? kPriceOfStuck : 1);
      const double gap = std::max(0.0, t.contact.gap - kGapLeft * options.clearance);
      m_prices.push_back(
          price(m_factors.size() - 1, is_among(options.kept, t) ? kKeptShare * gap : gap));
      m_now.rows.push_back(row_of(t));
    }
  }

  ChosenContacts run() {
    ChosenContacts best;
    const double first = m_options.from_weak_pulls ? kWeakPull * m_options.reach : kInfinity;
    double pull = std::min(first, m_options.pull);
    for (int rounds = 0;; pull = std::min(m_options.pull, kStrongerPull * pull)) {
      find_forces();
      find_motions(pull);
      if (pull == m_options.pull) {
        if (!m_now.is_better_than(best)) return best;
        best = m_now;
        const bool closed = best.widest < kClosedByMotions * m_options.clearance;
        if (closed || ++rounds == kRoundsAtFullPull) return best;
      }
      // Contacts that are closed by now cost nothing.
      for (size_t k = 0; k < m_prices.size(); ++k)
        m_prices[k] = price(k, left_open(k) / std::sqrt(m_now.rows[k].squared_norm()));
    }
  }

  PricedForces::End end_of_forces() const { return m_forces.end(); }

 private:
  // Metres: squared gaps count, so that many small ones are preferred to a wide one.
  double price(size_t k, double gap) const {
    return m_factors[k] * std::min(gap * gap / m_options.reach, kMostPrice * m_options.reach);
  }

  // At the very first, the nearest of each pair; then the ones that were needed before.
  std::vector<char> first_touches() const {
    std::vector<char> out(m_part.touches.size(), 0);
    const bool is_first = !m_options.forces || m_options.forces->rest.empty();
    for (size_t k = 0; k < out.size(); ++k) {
      const BodyContact &t = m_part.touches[k], &last = m_part.touches[k > 0 ? k - 1 : 0];
      const bool is_nearest = k == 0 || t.on != last.on || t.partner != last.partner;
      out[k] = (is_first && is_nearest) || is_among(m_options.kept, t);
    }
    return out;
  }

  MotionRow row_of(const BodyContact& t) const {
    MotionRow out =
        MotionRow::apart(m_part.bodies, t.on, t.from, t.contact.point, t.contact.normal);
    out.least = kGapLeft * m_options.clearance - t.contact.gap;
    return out;
  }

  double left_open(size_t k) const {
    return std::max(0.0, m_now.rows[k].of(m_now.motions) - m_now.rows[k].least);
  }

  void find_forces() {
    std::vector<double> prices = m_prices;
    for (double& p : prices) p *= kPriceOfReach / m_options.reach;
    PartForces forces = m_forces.find(prices);
    m_now.falls = std::move(forces.motions);
    m_now.num_missing = 0;
    m_now.missing.assign(m_part.bodies.size(), 1);
    for (size_t i = 0; i < m_part.bodies.size(); ++i)
      m_now.num_missing += m_now.missing[i] = !forces.solved || forces.missing[i] > kMissingWeight;
    m_now.needed.assign(m_prices.size(), 0);
    for (size_t k = 0; k < forces.forces.size(); ++k) {
      const double weight = m_part.bodies[m_part.touches[k].on].weight;
      m_now.needed[k] = forces.forces[k].norm() > kForceThatMatters * weight;
    }
  }

  void find_motions(double pull) {
    for (size_t k = 0; k < m_prices.size(); ++k)
      m_now.rows[k].least_push = m_now.needed[k] ? -pull : 0;
    m_now.motions =
        nearest_motions(m_now.rows, m_aims, kStillChoice * m_options.clearance, m_options.soft);
    m_now.open = m_now.widest = 0;
    for (size_t k = 0; k < m_prices.size(); ++k) {
      if (!m_now.needed[k]) continue;
      m_now.open += left_open(k);
      m_now.widest = std::max(m_now.widest, left_open(k));
    }
    m_now.cost = pull * m_now.open;
    for (size_t i = 0; i < m_aims.size(); ++i)
      m_now.cost += 0.5 * (m_now.motions[i] - m_aims[i]).squaredNorm();
  }

  const FreeBodies& m_part;
  const std::vector<SmallMotion>& m_aims;
  const ChoiceOfContacts& m_options;
  PricedForces m_forces;
  std::vector<double> m_factors, m_prices;  // of each touch; prices in metres
  ChosenContacts m_now;
};

}  // namespace

bool ChosenContacts::is_better_than(const ChosenContacts& other) const {
  return num_missing != other.num_missing && other.cost < kInfinity
             ? num_missing < other.num_missing
             : cost < kClearlyBetter * other.cost;
}

ChosenContacts choose_contacts(const FreeBodies& part, const std::vector<SmallMotion>& aims,
                               const ChoiceOfContacts& options) {
  ContactChoice choice(part, aims, options);
  ChosenContacts out = choice.run();
  if (options.forces) *options.forces = choice.end_of_forces();
  return out;
}

}  // namespace trivet
