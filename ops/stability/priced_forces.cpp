#include "ops/stability/priced_forces.h"

#include <algorithm>
#include <utility>

#include "ops/stability/force_program.h"

namespace trivet {
namespace {

constexpr double kGainThatJoins = 1e-6;                 // of a force that joins; CLP knows 1e-7
constexpr size_t kMostThatJoin = 4;                     // touches of a pair, at a time
constexpr unsigned char kBasic = 1, kAtLowerBound = 3;  // in CLP's terms

}  // namespace

PricedForces::PricedForces(const FreeBodies& part, double clearance, const std::vector<char>& first,
                           const End& start)
    : m_part(part),
      m_clearance(clearance),
      m_carried(carried_weights(part)),
      m_is_joined(first.size(), 0) {
  start_from(start);
  for (size_t k = 0; k < first.size(); ++k)
    if (first[k] && !m_is_joined[k]) join(k);
}

void PricedForces::join(size_t k) {
  m_joined.push_back(k);
  m_is_joined[k] = 1;
}

// CLP makes up by rows for columns that the basis lacks.
void PricedForces::start_from(const End& end) {
  for (const End::OfTouch& of : end.touches) {
    const std::optional<size_t> k = same_place(of.touch);
    if (!k) continue;
    join(*k);
    m_basis.insert(m_basis.end(), of.columns.begin(), of.columns.end());
  }
  m_num_columns = m_basis.size();
  m_basis.insert(m_basis.end(), end.rest.begin(), end.rest.end());
}

// The nearest that has not joined, of those where it was.
std::optional<size_t> PricedForces::same_place(const BodyContact& touch) const {
  std::optional<size_t> out;
  double least = kInfinity;
  for (size_t k = 0; k < m_part.touches.size(); ++k) {
    const BodyContact& t = m_part.touches[k];
    if (m_is_joined[k] || !are_alike(t, touch)) continue;
    const double metres = (t.contact.point - touch.contact.point).norm();
    if (metres < least) least = metres, out = k;
  }
  return out;
}

PricedForces::End PricedForces::end() const {
  End out;
  auto begin = m_basis.begin();
  for (size_t j = 0; j < m_columns_of.size(); ++j) {
    const auto end = begin + static_cast<std::ptrdiff_t>(m_columns_of[j]);
    if (std::find(begin, end, kBasic) != end)
      out.touches.push_back({m_part.touches[m_joined[j]], {begin, end}});
    begin = end;
  }
  out.rest.assign(begin, m_basis.end());
  return out;
}

PartForces PricedForces::find(std::span<const double> prices) {
  const auto priced = [&](size_t k) {
    BodyContact out = m_part.touches[k];
    out.contact.gap = prices[k];
    return out;
  };
  FreeBodies part{m_part.bodies, {}, {}, {}};
  while (true) {
    for (size_t j = part.touches.size(); j < m_joined.size(); ++j)
      part.touches.push_back(priced(m_joined[j]));
    ForceProgram program(part, m_clearance, 1, {}, 1, m_carried);
    program.add_missing(1, kInfinity);
    // Columns that have joined since begin at zero.
    const auto num_columns = static_cast<size_t>(program.num_touch_columns());
    if (!m_basis.empty())
      m_basis.insert(m_basis.begin() + static_cast<std::ptrdiff_t>(m_num_columns),
                     num_columns - m_num_columns, kAtLowerBound);
    m_num_columns = num_columns;
    m_columns_of.clear();
    for (size_t j = 0; j < m_joined.size(); ++j) m_columns_of.push_back(program.num_columns_of(j));
    const LinearProgram::Solution solution = program.solve_from(m_basis);
    if (!solution.optimal) return {};
    std::vector<double> gains(prices.size(), 0.0);
    for (size_t k = 0; k < prices.size(); ++k)
      if (!m_is_joined[k]) gains[k] = program.gain(priced(k), solution);
    // Without a touch that lowers the cost, this is the optimum over all touches.
    if (!join_best(gains)) return of_all_touches(program.forces_of(solution));
  }
}

bool PricedForces::join_best(std::span<const double> gains) {
  const std::vector<size_t> joining = touches_that_join(m_part.touches, gains);
  for (const size_t k : joining) join(k);
  return !joining.empty();
}

PartForces PricedForces::of_all_touches(PartForces forces) const {
  std::vector<Vec3> all(m_is_joined.size(), Vec3::Zero());
  for (size_t j = 0; j < m_joined.size(); ++j) all[m_joined[j]] = forces.forces[j];
  forces.forces = std::move(all);
  return forces;
}

std::vector<size_t> touches_that_join(std::span<const BodyContact> touches,
                                      std::span<const double> gains) {
  std::vector<size_t> out;
  for (size_t first = 0, end = 0; first < gains.size(); first = end) {
    const BodyContact& t = touches[first];
    std::vector<size_t> order;
    for (; end < gains.size() && touches[end].on == t.on && touches[end].partner == t.partner;
         ++end)
      if (gains[end] > kGainThatJoins) order.push_back(end);
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return gains[a] > gains[b]; });
    order.resize(std::min(order.size(), kMostThatJoin));
    out.insert(out.end(), order.begin(), order.end());
  }
  return out;
}

}  // namespace trivet
