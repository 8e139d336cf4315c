// Settling of one object on another by simulation: the task, and the judgement of the result.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "perf/timing.h"

namespace trivet::perf {

/// Corners of a convex piece of a mesh.
using Piece = std::vector<Vec3>;

/// Simulation input of the two objects. Metres and kilograms. The body frame has its origin in the
/// centre of mass and its axes along the principal axes of inertia.
struct SettleTask {
  Mesh moving;                                     // body frame
  Mesh fixed;                                      // world
  std::vector<Piece> moving_pieces, fixed_pieces;  // the same, cut into pieces for hulls
  double mass = 0;
  Vec3 inertia = Vec3::Zero();  // about the body frame's axes
  Pose object_from_body;        // of the upright object (pose x body frame)

  Pose body_pose(const Pose& object) const;
  Pose object_pose(const Pose& body) const;
};

/// @param density  kg per cubic metre. @param cell  metres, of the pieces.
SettleTask make_task(const Object& moving, const Object& fixed, double density, double cell);

/// Rules for both simulators, unless stated otherwise.
struct SimulationRules {
  double gravity = 9.81;       // m/s^2
  double friction = 1;         // Coulomb; Trivet: unlimited
  double rest_speed = 1e-3;    // m/s, and
  double rest_spin = 2e-2;     // rad/s: at rest when below both
  double rest_duration = 0.1;  // for this long (s, simulated)
  double longest = 5;          // s, simulated; then given up
};

struct Settled {
  bool at_rest = false;
  Pose pose;  // of the object
  double simulated_s = 0, speed = 0, spin = 0;
};

/// A simulator with the task loaded; settle() restarts it.
class Simulator {
 public:
  virtual ~Simulator() = default;
  virtual std::string name() const = 0;
  virtual Settled settle(const Pose& start) = 0;
};

/// Measures how long a body has been slow.
class RestClock {
 public:
  explicit RestClock(const SimulationRules& rules) : m_rules(rules) {}
  /// Advances by `dt`; returns whether the body is at rest by now.
  bool step(double dt, double speed, double spin) {
    m_slow_for = speed < m_rules.rest_speed && spin < m_rules.rest_spin ? m_slow_for + dt : 0;
    return m_slow_for >= m_rules.rest_duration;
  }

 private:
  SimulationRules m_rules;
  double m_slow_for = 0;
};

/// Empty in a build without the library.
std::vector<std::unique_ptr<Simulator>> bullet_simulators(const SettleTask& task,
                                                          const SimulationRules& rules);
std::vector<std::unique_ptr<Simulator>> mujoco_simulators(const SettleTask& task,
                                                          const SimulationRules& rules);
std::string bullet_version();  // with settings, or a note that it was left out
std::string mujoco_version();

/// Interpenetration of the true meshes.
struct Remains {
  std::int64_t crossings = 0;  // pairs of faces, exact
  double depth =
      0;  // metres: largest, of sample points of either inside the other or below the floor
  double gap = 0;  // metres between the surfaces (or to the floor); 0 if they cross
};
Remains judge(const Object& moving, const Pose& pose, const Object& fixed);

}  // namespace trivet::perf
