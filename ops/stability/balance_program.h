// The linear program of contact forces in the form of interior-point methods. Private to
// interior_point.cpp.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "ops/stability/block_factor.h"
#include "ops/stability/contact_forces.h"

namespace trivet {

/// Least costs . x over x >= 0 with A x = b, and all pushes at a body up to kPushLimit. It is
/// ForceProgram's, without its limit of friction, which are_proof() asks. All is in parts of what a
/// body carries, as there.
///   Rows of a body: what is missing, force, torque, pushes.
///   Columns: 8 edges of each contact's pyramid; then of each body missing force and torque, both
///   signs after each other, what is missing beyond the tolerance, all pushes, and what the
///   tolerance leaves.
class BalanceProgram {
 public:
  using Vector = Eigen::VectorXd;
  using BodyRows = BlockFactor::Rows;
  static constexpr int kMissingRow = 0, kForceRow = 1, kTorqueRow = 4, kPushRow = 7;

  BalanceProgram(const FreeBodies& part, double clearance, double factor);

  size_t num_bodies() const { return m_part.bodies.size(); }
  Eigen::Index num_columns() const { return local(num_bodies()); }
  const Vector& costs() const { return m_costs; }
  const std::vector<BodyRows>& b() const { return m_b; }
  double carried(size_t body) const { return m_carried[body]; }
  /// The column of all pushes at a body.
  Eigen::Index pushes(size_t body) const { return local(body) + kPushes; }
  /// Pairs of bodies that touch.
  std::vector<std::pair<Index, Index>> couplings() const;

  /// Sets a start: forces of a weight, prices of a virtual velocity.
  /// @param w  prices of the limits of pushes.
  void start(Vector& x, Vector& z, Vector& w) const;
  /// out += sign A x
  void add_product(const Vector& x, double sign, std::vector<BodyRows>& out) const;
  /// A^T y
  Vector transposed_product(const std::vector<BodyRows>& y) const;
  /// Adds A D A^T, D diagonal.
  void add_normal_matrix(const Vector& d, BlockFactor& to) const;

  /// True if the forces of x alone keep all limits, and leave no more missing than may be.
  bool are_proof(const Vector& x) const;
  /// Newtons, of each contact, on its body `on`.
  std::vector<Vec3> forces(const Vector& x) const;
  /// Missing force and torque of each body beyond the tolerance, in its weights.
  std::vector<double> missing(const Vector& x) const;

 private:
  static constexpr int kEdges = 8, kLocals = 15;
  static constexpr int kBeyond = 12, kPushes = 13, kLeft = 14;
  using Edges = Eigen::Matrix<double, kEdges, 1>;
  /// What a force enters in a body's rows. All edges of a contact share it, so that products cost
  /// less than by a block of rows x edges.
  using Entering = Eigen::Matrix<double, BlockFactor::kRows, 3>;

  struct Contact {
    Index on, from;
    double unit;  // newtons
    Vec3 normal;
    Eigen::Matrix<double, 3, kEdges> edges;
    Entering of_on = Entering::Zero(), of_from = of_on;

    /// In units.
    Vec3 force(const Vector& x, Eigen::Index first) const {
      return edges.lazyProduct(x.segment<kEdges>(first));
    }
  };

  Eigen::Index local(size_t body) const {
    return static_cast<Eigen::Index>(kEdges * m_contacts.size() + kLocals * body);
  }
  static Eigen::Index edges_of(size_t contact) {
    return static_cast<Eigen::Index>(kEdges * contact);
  }
  /// Sums of the forces at each body: missing as missing() has it, the others in parts of what it
  /// carries.
  struct Sums {
    std::vector<double> missing, pushed, across;
  };
  Sums sums(const Vector& x) const;
  double own(size_t body) const { return m_part.bodies[body].weight / m_carried[body]; }
  void add(const BodyContact& t, double factor);
  Entering entering(Index body, const Vec3& point, const Contact& c, double sign) const;
  BlockFactor::Block local_matrix(size_t body, const Vector& all) const;

  const FreeBodies& m_part;
  const std::vector<double> m_carried;  // newtons
  std::vector<double> m_tolerance;      // of each body, of its pushes
  std::vector<Contact> m_contacts;
  Vector m_costs;
  std::vector<BodyRows> m_b;
};

}  // namespace trivet
