#include "ops/operations/slide_plan.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr double kWallNormalZ = 1e-3;  // below this a contact is a wall
constexpr double kIntoWall = 1e-7;     // level speed into a wall that still counts as none
constexpr double kLeastAlong = 1e-3;   // cosine to the direction that was asked for
constexpr double kSameRise = 1e-9;

double level_speed(const Vec3& normal, const Vec3& direction) {
  return normal.x() * direction.x() + normal.y() * direction.y();
}

// Rise per metre that a contact forces on the object; of a ceiling, the most that it allows.
double rise(const Vec3& normal, const Vec3& direction) {
  return -level_speed(normal, direction) / normal.z();
}

bool is_wall(const Vec3& normal, const Vec3& direction, bool climb) {
  if (std::abs(normal.z()) <= kWallNormalZ) return true;
  return !climb && is_steep(normal, direction);
}

// The largest rise of the contacts that still last a little.
SlidePlan follow(const std::vector<Vec3>& normals, const Vec3& direction,
                 const std::function<double(size_t, const Vec3&)>& ends, double shortest,
                 bool climb) {
  // Contacts under the object force it up; the steepest that lasts decides.
  std::vector<size_t> order;
  for (size_t i = 0; i < normals.size(); ++i)
    if (normals[i].z() > 0 && !is_wall(normals[i], direction, climb)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return rise(normals[a], direction) > rise(normals[b], direction);
  });
  SlidePlan plan;
  for (const size_t i : order) {
    const double here = rise(normals[i], direction);
    // Contacts of the same rise last together: the longest of them counts.
    if (plan.kind == SlidePlan::Kind::Go && here < plan.velocity.z() - kSameRise) break;
    const Vec3 velocity(direction.x(), direction.y(), here);
    const double end = ends(i, velocity);
    // A contact that ends at once carries no farther.
    if (end <= shortest) continue;
    if (plan.kind != SlidePlan::Kind::Go)
      plan.kind = SlidePlan::Kind::Go, plan.velocity = velocity, plan.blocker = i;
    plan.lasts = std::max(plan.lasts, end);
  }
  return plan;
}

}  // namespace

bool is_steep(const Vec3& normal, const Vec3& direction) {
  return normal.z() > 0 && rise(normal, direction) > kSteepRise;
}

SlidePlan plan_slide(const std::vector<Vec3>& normals, const Vec3& direction,
                     const std::function<double(size_t, const Vec3&)>& ends, double shortest,
                     bool climb) {
  // A wall stops a level direction; a ceiling stops the rise.
  SlidePlan plan = follow(normals, direction, ends, shortest, climb);
  for (size_t i = 0; i < normals.size(); ++i) {
    const Vec3& n = normals[i];
    const bool wall = is_wall(n, direction, climb);
    const bool blocks =
        wall ? level_speed(n, direction) < -kIntoWall
             : n.z() < 0 && plan.kind == SlidePlan::Kind::Go && n.dot(plan.velocity) < -kIntoWall;
    if (!blocks) continue;
    plan.kind = SlidePlan::Kind::Blocked;
    plan.blocker = i;
    return plan;
  }
  return plan;
}

std::optional<Vec3> slide_direction(const std::vector<Vec3>& normals, const Vec3& direction,
                                    size_t blocker, bool climb) {
  // Walls are seen from above.
  std::vector<Vec3> walls;  // level, unit
  for (size_t i = 0; i < normals.size(); ++i) {
    const Vec3 level(normals[i].x(), normals[i].y(), 0);
    const double length = level.norm();
    if (length > kWallNormalZ && (i == blocker || is_wall(normals[i], direction, climb)))
      walls.push_back(level / length);
  }
  std::optional<Vec3> best;
  double best_gain = kLeastAlong;
  // Each wall gives a direction along it; the one that leads farthest to the goal, and into no
  // other wall, is taken.
  for (const Vec3& wall : walls) {
    Vec3 along = direction - wall.dot(direction) * wall;
    const double length = along.norm();
    if (length <= kLeastAlong) continue;
    along /= length;
    const bool free = std::all_of(walls.begin(), walls.end(),
                                  [&](const Vec3& w) { return w.dot(along) >= -kIntoWall; });
    if (free && along.dot(direction) > best_gain) best_gain = along.dot(direction), best = along;
  }
  return best;
}

}  // namespace trivet
