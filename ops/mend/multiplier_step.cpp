#include "ops/mend/multiplier_step.h"

#include <algorithm>

#include "ops/stability/block_factor.h"

namespace trivet {
namespace {

constexpr int kRoundsOfStep = 8;

BlockFactor::Rows padded(const SmallMotion& motion) {
  BlockFactor::Rows out = BlockFactor::Rows::Zero();
  out.head<6>() = motion;
  return out;
}

}  // namespace

MultiplierStep::MultiplierStep(const std::vector<MotionRow>& rows, size_t num_bodies, double soft)
    : m_num_bodies(num_bodies), m_soft(soft) {
  std::vector<std::pair<Index, Index>> couplings;
  for (const MotionRow& row : rows)
    if (row.from != BodyContact::kGround) couplings.emplace_back(row.on, row.from);
  m_factor = std::make_unique<BlockFactor>(num_bodies, couplings);
}

MultiplierStep::~MultiplierStep() = default;

std::vector<double> MultiplierStep::changes(const std::vector<MotionRow>& rows,
                                            const std::vector<SmallMotion>& motions) {
  m_is_free.resize(rows.size());
  for (size_t k = 0; k < rows.size(); ++k) m_is_free[k] = rows[k].push > rows[k].least_push;
  const std::vector<double> lacks = lacks_of(rows, motions, {});
  std::vector<double> out(rows.size(), 0.0), first;
  for (int round = 0; round < kRoundsOfStep; ++round) {
    // Multipliers that would fall below their least stop there, and the others are asked again.
    free_changes(rows, round == 0 ? lacks : lacks_of(rows, motions, out), out);
    if (round == 0) first = out;
    bool any = false;
    for (size_t k = 0; k < rows.size(); ++k) {
      const double most = rows[k].least_push - rows[k].push;
      if (!m_is_free[k] || out[k] >= most) continue;
      out[k] = most;
      m_is_free[k] = 0;
      any = true;
    }
    if (!any) break;
  }
  if (growth(rows, lacks, out) < 0) return out;
  // Straight on until the first one stops it is always better.
  double until_first = 1;
  for (size_t k = 0; k < rows.size(); ++k)
    if (const double most = rows[k].least_push - rows[k].push; first[k] < most)
      until_first = std::min(until_first, most / first[k]);
  for (double& change : first) change *= until_first;
  return growth(rows, lacks, first) < 0 ? first : std::vector<double>{};
}

// Metres that free rows lack after these changes of the others.
std::vector<double> MultiplierStep::lacks_of(const std::vector<MotionRow>& rows,
                                             std::vector<SmallMotion> motions,
                                             const std::vector<double>& changes) const {
  for (size_t k = 0; k < changes.size(); ++k) {
    if (changes[k] == 0 || m_is_free[k]) continue;
    motions[rows[k].on] += changes[k] * rows[k].of_on;
    if (rows[k].from != BodyContact::kGround) motions[rows[k].from] += changes[k] * rows[k].of_from;
  }
  std::vector<double> out(rows.size(), 0.0);
  for (size_t k = 0; k < rows.size(); ++k)
    if (rows[k].push > rows[k].least_push)
      out[k] = rows[k].least - rows[k].of(motions) - m_soft * rows[k].push;
  return out;
}

// (G G' + soft) changes = lacks, of free rows, by the matrix G' G + soft of the bodies, which is
// smaller and sparse [Woodbury 1950].
void MultiplierStep::free_changes(const std::vector<MotionRow>& rows,
                                  const std::vector<double>& lacks, std::vector<double>& out) {
  m_factor->set_zero();
  std::vector<BlockFactor::Rows> x(m_num_bodies, BlockFactor::Rows::Zero());
  for (size_t i = 0; i < m_num_bodies; ++i)
    m_factor->add(static_cast<Index>(i), static_cast<Index>(i),
                  m_soft * BlockFactor::Block::Identity());
  for (size_t k = 0; k < rows.size(); ++k) {
    const MotionRow& row = rows[k];
    if (!m_is_free[k]) continue;
    const BlockFactor::Rows on = padded(row.of_on), from = padded(row.of_from);
    m_factor->add(row.on, row.on, on * on.transpose());
    x[row.on] += lacks[k] * on;
    if (row.from == BodyContact::kGround) continue;
    m_factor->add(row.from, row.from, from * from.transpose());
    m_factor->add(row.on, row.from, on * from.transpose());
    x[row.from] += lacks[k] * from;
  }
  m_factor->factorise();
  m_factor->solve(x);
  for (size_t k = 0; k < rows.size(); ++k) {
    const MotionRow& row = rows[k];
    if (!m_is_free[k]) continue;
    double met = row.of_on.dot(x[row.on].head<6>());
    if (row.from != BodyContact::kGround) met += row.of_from.dot(x[row.from].head<6>());
    out[k] = (lacks[k] - met) / m_soft;
  }
}

// The dual's objective grows by half the squared change of motions, less what multipliers gain.
double MultiplierStep::growth(const std::vector<MotionRow>& rows, const std::vector<double>& lacks,
                              const std::vector<double>& changes) const {
  std::vector<SmallMotion> gone(m_num_bodies, SmallMotion::Zero());
  double out = 0;
  for (size_t k = 0; k < rows.size(); ++k) {
    if (changes[k] == 0) continue;
    const MotionRow& row = rows[k];
    out += changes[k] * (0.5 * m_soft * changes[k] - lacks[k]);
    gone[row.on] += changes[k] * row.of_on;
    if (row.from != BodyContact::kGround) gone[row.from] += changes[k] * row.of_from;
  }
  for (const SmallMotion& m : gone) out += 0.5 * m.squaredNorm();
  return out;
}

}  // namespace trivet
