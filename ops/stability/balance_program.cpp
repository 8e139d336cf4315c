#include "ops/stability/balance_program.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "ops/settle/equilibrium.h"

namespace trivet {
namespace {

constexpr double kPartForFree = 0.9;           // of what may be missing, so that are_proof() agrees
constexpr double kPyramidInCone = 0.92387953;  // cos(22.5 degrees): edges add up to so much more
// A start within a few times of the optimum: factors of ten cost one step or two.
constexpr double kFirstEdge = 0.1, kFirstPushes = 3;      // in parts of what a body carries
constexpr double kFirstMissing = 0.1;                     // weights
constexpr double kFirstSpeed = 0.01, kFirstBound = 1e-3;  // of the fastest body

}  // namespace

BalanceProgram::BalanceProgram(const FreeBodies& part, double clearance, double factor)
    : m_part(part), m_carried(carried_weights(part)) {
  for (const FreeBody& body : part.bodies)
    m_tolerance.push_back(residual_tolerance(body.size, clearance));
  for (const auto* touches : {&part.touches, &part.more})
    for (const BodyContact& t : *touches) add(t, factor);
  m_costs = Vector::Zero(num_columns());
  m_b.assign(num_bodies(), BodyRows::Zero());
  for (size_t i = 0; i < num_bodies(); ++i) {
    // Contacts have to balance the weight and what other bodies press with; what is missing beyond
    // the tolerance costs one a weight, but for what may be.
    const FreeBody& body = part.bodies[i];
    m_costs[local(i) + kBeyond] = 1 / own(i);
    m_b[i][kMissingRow] = kPartForFree * kMayBeMissing * own(i);
    m_b[i].segment<3>(kForceRow) = (Vec3(0, 0, body.weight) - body.load) / m_carried[i];
    m_b[i].segment<3>(kTorqueRow) = -body.load_torque / (m_carried[i] * body.size);
  }
}

void BalanceProgram::add(const BodyContact& t, double factor) {
  const bool on_ground = t.from == BodyContact::kGround;
  const double unit = on_ground ? m_carried[t.on] : std::min(m_carried[t.on], m_carried[t.from]);
  Contact c{t.on, t.from, unit, t.contact.normal, {}};
  const auto pyramid = friction_pyramid(t.contact.normal, factor * t.friction);
  for (int e = 0; e < kEdges; ++e) c.edges.col(e) = pyramid[static_cast<size_t>(e)];
  // The force pushes one body and, reversed, the other.
  c.of_on = entering(t.on, t.contact.point, c, 1);
  if (!on_ground) c.of_from = entering(t.from, t.contact.point, c, -1);
  m_contacts.push_back(c);
}

// The normal's part of each edge is one, so that pushes add up along the normal.
BalanceProgram::Entering BalanceProgram::entering(Index body, const Vec3& point, const Contact& c,
                                                  double sign) const {
  Entering out = Entering::Zero();
  const double part = c.unit / m_carried[body];
  const Vec3 arm = (point - m_part.bodies[body].centre) / m_part.bodies[body].size;
  for (int k = 0; k < 3; ++k) {
    const Vec3 force = sign * part * Vec3::Unit(k);
    out.col(k).segment<3>(kForceRow) = force;
    out.col(k).segment<3>(kTorqueRow) = arm.cross(force);
    out(kPushRow, k) = part * c.normal[k];
  }
  return out;
}

std::vector<std::pair<Index, Index>> BalanceProgram::couplings() const {
  std::vector<std::pair<Index, Index>> out;
  for (const Contact& c : m_contacts)
    if (c.from != BodyContact::kGround) out.emplace_back(c.on, c.from);
  return out;
}

void BalanceProgram::start(Vector& x, Vector& z, Vector& w) const {
  x = z = Vector::Zero(num_columns());
  w = Vector::Zero(static_cast<Eigen::Index>(num_bodies()));
  for (size_t k = 0; k < m_contacts.size(); ++k) {
    const Contact& c = m_contacts[k];
    double lighter = m_part.bodies[c.on].weight;
    if (c.from != BodyContact::kGround) lighter = std::min(lighter, m_part.bodies[c.from].weight);
    x.segment<kEdges>(edges_of(k)).setConstant(kFirstEdge);
    z.segment<kEdges>(edges_of(k)).setConstant(kFirstSpeed * c.unit / lighter);
  }
  for (size_t i = 0; i < num_bodies(); ++i) {
    x.segment<kLocals>(local(i)).setConstant(kFirstMissing * own(i));
    z.segment<kLocals>(local(i)).setConstant(1 / own(i));
    x[pushes(i)] = kFirstPushes;
    z[pushes(i)] = w[static_cast<Eigen::Index>(i)] = kFirstBound / own(i);
  }
}

void BalanceProgram::add_product(const Vector& x, double sign, std::vector<BodyRows>& out) const {
  for (size_t k = 0; k < m_contacts.size(); ++k) {
    const Contact& c = m_contacts[k];
    const Vec3 force = sign * c.force(x, edges_of(k));
    out[c.on] += c.of_on.lazyProduct(force);
    if (c.from != BodyContact::kGround) out[c.from] += c.of_from.lazyProduct(force);
  }
  for (size_t i = 0; i < num_bodies(); ++i) {
    const auto v = x.segment<kLocals>(local(i));
    double missing = v[kLeft] - v[kBeyond] - m_tolerance[i] * v[kPushes];
    for (int k = 0; k < 6; ++k) {
      out[i][kForceRow + k] += sign * (v[2 * k] - v[2 * k + 1]);
      missing += v[2 * k] + v[2 * k + 1];
    }
    out[i][kMissingRow] += sign * missing;
    out[i][kPushRow] -= sign * v[kPushes];
  }
}

BalanceProgram::Vector BalanceProgram::transposed_product(const std::vector<BodyRows>& y) const {
  Vector out(num_columns());
  for (size_t k = 0; k < m_contacts.size(); ++k) {
    const Contact& c = m_contacts[k];
    Vec3 sum = c.of_on.transpose().lazyProduct(y[c.on]);
    if (c.from != BodyContact::kGround) sum += c.of_from.transpose().lazyProduct(y[c.from]);
    out.segment<kEdges>(edges_of(k)) = c.edges.transpose().lazyProduct(sum);
  }
  for (size_t i = 0; i < num_bodies(); ++i) {
    auto v = out.segment<kLocals>(local(i));
    const double missing = y[i][kMissingRow];
    for (int k = 0; k < 6; ++k) {
      v[2 * k] = missing + y[i][kForceRow + k];
      v[2 * k + 1] = missing - y[i][kForceRow + k];
    }
    v[kBeyond] = -missing;
    v[kPushes] = -m_tolerance[i] * missing - y[i][kPushRow];
    v[kLeft] = missing;
  }
  return out;
}

void BalanceProgram::add_normal_matrix(const Vector& d, BlockFactor& to) const {
  using Block = BlockFactor::Block;
  // Blocks are small: products by rows and columns spare the copies that those of matrices make.
  for (size_t k = 0; k < m_contacts.size(); ++k) {
    const Contact& c = m_contacts[k];
    const Eigen::Matrix<double, 3, kEdges> part =
        c.edges * d.segment<kEdges>(edges_of(k)).asDiagonal();
    const Mat3 of_force = part.lazyProduct(c.edges.transpose());
    const Entering on = c.of_on.lazyProduct(of_force);
    to.add(c.on, c.on, Block(on.lazyProduct(c.of_on.transpose())));
    if (c.from == BodyContact::kGround) continue;
    const Entering from = c.of_from.lazyProduct(of_force);
    to.add(c.from, c.on, Block(from.lazyProduct(c.of_on.transpose())));
    to.add(c.from, c.from, Block(from.lazyProduct(c.of_from.transpose())));
  }
  for (size_t i = 0; i < num_bodies(); ++i) {
    const auto body = static_cast<Index>(i);
    to.add(body, body, local_matrix(i, d));
  }
}

BlockFactor::Block BalanceProgram::local_matrix(size_t body, const Vector& all) const {
  const auto d = all.segment<kLocals>(local(body));
  const double tolerance = m_tolerance[body];
  BlockFactor::Block out = BlockFactor::Block::Zero();
  double missing = d[kLeft] + d[kBeyond] + tolerance * tolerance * d[kPushes];
  for (int k = 0; k < 6; ++k) {
    const double plus = d[2 * k], minus = d[2 * k + 1];
    out(kForceRow + k, kForceRow + k) = plus + minus;
    out(kForceRow + k, kMissingRow) = out(kMissingRow, kForceRow + k) = plus - minus;
    missing += plus + minus;
  }
  out(kMissingRow, kMissingRow) = missing;
  out(kPushRow, kPushRow) = d[kPushes];
  out(kPushRow, kMissingRow) = out(kMissingRow, kPushRow) = tolerance * d[kPushes];
  return out;
}

BalanceProgram::Sums BalanceProgram::sums(const Vector& x) const {
  std::vector<BodyRows> left = m_b;
  Sums out{std::vector<double>(num_bodies(), 0.0), std::vector<double>(num_bodies(), 0.0),
           std::vector<double>(num_bodies(), 0.0)};
  const std::vector<Vec3> all = forces(x);
  for (size_t k = 0; k < m_contacts.size(); ++k) {
    const Contact& c = m_contacts[k];
    const Vec3 part = c.force(x, edges_of(k));
    const double push = c.normal.dot(all[k]);
    const double friction = (all[k] - push * c.normal).norm() / kPyramidInCone;
    for (const Index body : {c.on, c.from}) {
      if (body == BodyContact::kGround) continue;
      left[body] -= (body == c.on ? c.of_on : c.of_from) * part;
      out.across[body] += friction / m_carried[body];
      out.pushed[body] += push / m_carried[body];
    }
  }
  for (size_t i = 0; i < num_bodies(); ++i) {
    const double missing = left[i].segment<6>(kForceRow).cwiseAbs().sum();
    out.missing[i] = std::max(0.0, missing - m_tolerance[i] * out.pushed[i]) / own(i);
  }
  return out;
}

bool BalanceProgram::are_proof(const Vector& x) const {
  const Sums of_forces = sums(x);
  const auto all_within = [](const std::vector<double>& values, double limit) {
    return std::all_of(values.begin(), values.end(), [&](double v) { return v <= limit; });
  };
  return all_within(of_forces.missing, kMayBeMissing) && all_within(of_forces.pushed, kPushLimit) &&
         all_within(of_forces.across, kFrictionLimit);
}

std::vector<Vec3> BalanceProgram::forces(const Vector& x) const {
  std::vector<Vec3> out;
  out.reserve(m_contacts.size());
  for (size_t k = 0; k < m_contacts.size(); ++k)
    out.push_back(m_contacts[k].unit * m_contacts[k].force(x, edges_of(k)));
  return out;
}

std::vector<double> BalanceProgram::missing(const Vector& x) const { return sums(x).missing; }

}  // namespace trivet
