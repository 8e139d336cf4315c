#include "ops/stability/contact_forces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "ops/settle/linear_program.h"

namespace trivet {
namespace {

constexpr double kFrictionLimit = 10;  // at one body, in weights that it carries
constexpr double kMoves = 1e-6;        // virtual velocities, at most 1: rounding below this

using Entry = LinearProgram::Entry;

// Rows of a body: force x y z, torque x y z, friction. All in parts of what it carries.
constexpr int kRowsPerBody = 7;

class ForceProgram {
 public:
  explicit ForceProgram(const FreeBodies& part, double factor = 1)
      : m_part(part), m_factor(factor), m_carried(carried_weights(part)) {
    add_rows();
    for (const BodyContact& t : m_part.touches) add_touch(t);
    m_first_missing = m_num_columns;
  }

  // Every force and torque that may be missing, each at `cost`, and all together in a row.
  void add_missing(double cost, double limit) {
    const int sum = m_program.add_row(0, limit);
    for (size_t i = 0; i < m_part.bodies.size(); ++i)
      for (int row = 0; row < 6; ++row)
        for (const double sign : {1.0, -1.0}) {
          const Entry entries[] = {{row_of(i) + row, sign}, {sum, 1}};
          add_column(entries, cost);
        }
  }

  // All weights shifted along `d` by a length that is worth -1 a metre.
  void add_shift(const Vec3& d, double largest) {
    std::vector<Entry> entries;
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      const FreeBody& body = m_part.bodies[i];
      const Vec3 torque = d.cross(Vec3(0, 0, -body.weight)) / (m_carried[i] * body.size);
      for (int k = 0; k < 3; ++k) entries.push_back({row_of(i) + 3 + k, largest * torque[k]});
    }
    add_column(entries, -1, 1);
  }

  LinearProgram::Solution solve() const { return m_program.solve(true); }

  PartForces forces_of(const LinearProgram::Solution& solution) const {
    PartForces out;
    out.solved = true;
    out.residual = solution.objective;
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      double missing = 0, motion = 0;
      for (int k = 0; k < 12; ++k) missing += solution.x[m_first_missing + 12 * i + k];
      for (int k = 0; k < 6; ++k)
        motion = std::max(motion, std::abs(solution.prices[row_of(i) + k]));
      out.missing.push_back(missing);
      out.moves.push_back(motion > kMoves);
    }
    out.motions = motions_of(solution);
    for (const Spanned& s : m_spanned) {
      Vec3 force = Vec3::Zero();
      for (size_t k = 0; k < s.edges.size(); ++k)
        force += solution.x[s.first_column + k] * s.unit * s.edges[k];
      out.forces.push_back(force);
    }
    return out;
  }

 private:
  // Prices are virtual velocities against all contact forces, so that bodies go the other way; they
  // belong to rows that are scaled by what a body carries, and by its size.
  std::vector<VirtualMotion> motions_of(const LinearProgram::Solution& solution) const {
    std::vector<VirtualMotion> out(m_part.bodies.size());
    double fastest = 0, power = 0;
    for (size_t i = 0; i < out.size(); ++i) {
      const FreeBody& body = m_part.bodies[i];
      for (int k = 0; k < 3; ++k) {
        out[i].velocity[k] = -solution.prices[row_of(i) + k] / m_carried[i];
        out[i].spin[k] = -solution.prices[row_of(i) + 3 + k] / (m_carried[i] * body.size);
      }
      fastest = std::max(fastest, out[i].velocity.norm() + out[i].spin.norm() * body.size / 2);
      power -= body.weight * out[i].velocity.z();
    }
    const double scale = fastest > 0 ? (power < 0 ? -1 : 1) / fastest : 0;  // gravity drives it
    for (VirtualMotion& m : out) {
      m.velocity *= scale;
      m.spin *= scale;
    }
    return out;
  }

  // A touch's forces are sums of these edges, in `unit` newtons.
  struct Spanned {
    int first_column;
    double unit;
    std::vector<Vec3> edges;
  };

  static int row_of(size_t body) { return static_cast<int>(body) * kRowsPerBody; }

  // Each body's weight with all that lies on it, directly or not.
  static std::vector<double> carried_weights(const FreeBodies& part) {
    const size_t n = part.bodies.size();
    std::vector<std::vector<Index>> loads(n);
    for (const BodyContact& t : part.touches) {
      if (t.from == BodyContact::kGround) continue;
      if (t.contact.normal.z() > kSupportNormalZ) loads[t.from].push_back(t.on);
      if (t.contact.normal.z() < -kSupportNormalZ) loads[t.on].push_back(t.from);
    }
    std::vector<double> out(n, 0.0);
    for (size_t i = 0; i < n; ++i) {
      std::vector<char> seen(n, 0);
      std::vector<Index> open{static_cast<Index>(i)};
      seen[i] = 1;
      while (!open.empty()) {
        const Index body = open.back();
        open.pop_back();
        out[i] += part.bodies[body].weight;
        for (const Index load : loads[body])
          if (!std::exchange(seen[load], 1)) open.push_back(load);
      }
    }
    return out;
  }

  void add_rows() {
    for (size_t i = 0; i < m_part.bodies.size(); ++i) {
      const double weight = m_part.bodies[i].weight / m_carried[i];
      for (const double balance : {0.0, 0.0, weight, 0.0, 0.0, 0.0})
        m_program.add_row(balance, balance);
      m_program.add_row(0, kFrictionLimit);
    }
  }

  void add_touch(const BodyContact& t) {
    const bool ground = t.from == BodyContact::kGround;
    const double unit = ground ? m_carried[t.on] : std::min(m_carried[t.on], m_carried[t.from]);
    const double friction = m_factor * t.friction;
    Spanned spanned{m_num_columns, unit, {t.contact.normal}};
    if (friction > 0)
      for (const Vec3& edge : friction_pyramid(t.contact.normal, friction))
        spanned.edges.push_back(edge);
    for (size_t k = 0; k < spanned.edges.size(); ++k) {
      std::vector<Entry> entries;
      const double part = k == 0 ? 0 : friction;
      append_force(t.on, t.contact.point, unit * spanned.edges[k], unit * part, entries);
      if (!ground)
        append_force(t.from, t.contact.point, -unit * spanned.edges[k], unit * part, entries);
      add_column(entries, 0);
    }
    m_spanned.push_back(std::move(spanned));
  }

  void append_force(Index i, const Vec3& point, const Vec3& force, double across,
                    std::vector<Entry>& entries) const {
    const FreeBody& body = m_part.bodies[i];
    const Vec3 f = force / m_carried[i];
    const Vec3 torque = (point - body.centre).cross(f) / body.size;
    for (int k = 0; k < 3; ++k) entries.push_back({row_of(i) + k, f[k]});
    for (int k = 0; k < 3; ++k) entries.push_back({row_of(i) + 3 + k, torque[k]});
    entries.push_back({row_of(i) + 6, across / m_carried[i]});
  }

  void add_column(std::span<const Entry> entries, double cost, double upper = kInfinity) {
    m_program.add_column(entries, cost, upper);
    ++m_num_columns;
  }

  const FreeBodies& m_part;
  const double m_factor;
  const std::vector<double> m_carried;
  LinearProgram m_program;
  std::vector<Spanned> m_spanned;
  int m_num_columns = 0, m_first_missing = 0;
};

}  // namespace

PartForces contact_forces(const FreeBodies& part, double factor) {
  ForceProgram program(part, factor);
  program.add_missing(1, kInfinity);
  const LinearProgram::Solution solution = program.solve();
  return solution.optimal ? program.forces_of(solution) : PartForces{};
}

double shift_margin(const FreeBodies& part, double tolerance) {
  constexpr double d = 0.70710678118654752;
  double largest = 0, margin = kInfinity;
  for (const FreeBody& body : part.bodies) largest = std::max(largest, body.size);
  for (const Vec2& way : {Vec2(1, 0), Vec2(d, d), Vec2(0, 1), Vec2(-d, d), Vec2(-1, 0),
                          Vec2(-d, -d), Vec2(0, -1), Vec2(d, -d)}) {
    ForceProgram program(part);
    program.add_missing(0, tolerance);
    program.add_shift(Vec3(way.x(), way.y(), 0), largest);
    const LinearProgram::Solution solution = program.solve();
    if (!solution.optimal) return -kInfinity;
    margin = std::min(margin, -solution.objective * largest);
  }
  return margin;
}

}  // namespace trivet
