#include "core/flex/step_limits.h"

#include <algorithm>

namespace trivet::flex {
namespace {

constexpr double kKeep = 0.9;        // of a distance that a step may use
constexpr double kAround = 0.2;      // of a step's length around it: room for its projection
constexpr double kReach = 1.6;       // of a step's length: what is farther cannot be met
constexpr int kSweeps = 8;           // over the half-spaces of a vertex
constexpr double kHit = 0.1;         // of the layer
constexpr double kRoundOff = 1e-15;  // m

// Onto the half-spaces one after another, again and again.
void project(const std::vector<HalfSpace>& half_spaces, Vec3& step) {
  // Each sweep moves the step to the borders that it has left; a few sweeps are near enough, as it
  // is cut afterwards.
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    bool is_inside = true;
    for (const HalfSpace& h : half_spaces) {
      const double beyond = h.normal.dot(step) + h.room;
      if (beyond >= -kRoundOff) continue;
      step -= beyond * h.normal;
      is_inside = false;
    }
    if (is_inside) return;
  }
}

// The part of the step that stays in the box and in all half-spaces.
double allowed_part(const std::vector<HalfSpace>& half_spaces, const Aabb& room, const Vec3& step) {
  // The step was searched within its box: beyond it, unknown pairs could be met.
  double part = 1;
  for (int k = 0; k < 3; ++k) {
    if (step[k] > room.upper[k]) part = std::min(part, room.upper[k] / step[k]);
    if (step[k] < room.lower[k]) part = std::min(part, room.lower[k] / step[k]);
  }
  for (const HalfSpace& h : half_spaces) {
    const double down = -h.normal.dot(step);
    if (down > h.room) part = std::min(part, h.room / down);
  }
  return part;
}

}  // namespace

StepLimits::StepLimits(const Surroundings& surroundings, Contact& contact)
    : m_surroundings(surroundings), m_contact(contact) {}

// Only where it cuts the vertex's room.
void StepLimits::add(int vertex, const Vec3& normal, double distance) {
  // The vertex keeps a tenth of its distance, so that it never reaches the plane.
  const double room = kKeep * std::max(0.0, distance);
  const Aabb& box = m_room[vertex];
  const double lowest = normal.cwiseMax(0).dot(box.lower) + normal.cwiseMin(0).dot(box.upper);
  if (lowest < -room) m_half_spaces[vertex].push_back({vertex, normal, room});
}

void StepLimits::add_pair(const Points& x, const NearPair& pair) {
  // The plane between the closest points separates the two elements as they are.
  const PairPoints points = m_surroundings.points(pair, x);
  const double offset = m_contact.offset(pair);
  double first = 0, second = 0;  // longest steps of the sides
  for (int i = 0; i < points.count; ++i) {
    double& longest = i < points.first ? first : second;
    longest = std::max(longest, m_length[points.vertices[i]]);
  }
  // Elements that are farther apart than both can go need no plane.
  if (points.distance - offset >= kReach * (first + second)) return;
  const Vec3 normal = points.direction();
  const auto height = [&](int i) { return normal.dot(x[points.vertices[i]]); };
  double below = -kInfinity, above = kInfinity;  // extents of the sides along the normal
  for (int i = 0; i < points.num_fixed; ++i)
    below = std::max(below, normal.dot(m_surroundings.obstacles().vertices()[points.fixed[i]]));
  for (int i = points.first; i < points.count; ++i) below = std::max(below, height(i));
  for (int i = 0; i < points.first; ++i) above = std::min(above, height(i));
  // The obstacle's side stays, so that all room is the body's; else each has half.
  const double plane = pair.is_own() ? (below + above) / 2 : below;
  const double margin = pair.is_own() ? offset / 2 : offset;
  for (int i = 0; i < points.count; ++i)
    if (i < points.first)
      add(points.vertices[i], normal, height(i) - plane - margin);
    else
      add(points.vertices[i], -normal, plane - height(i) - margin);
}

bool StepLimits::find_half_spaces(const Points& x, const Points& step) {
  m_half_spaces.assign(x.size(), {});
  m_room.assign(x.size(), {});
  m_length.resize(x.size());
  std::vector<Aabb> reached(x.size());
  // The box holds the step and some room around it, within which it may be turned aside.
  for (size_t v = 0; v < x.size(); ++v) {
    m_length[v] = step[v].norm();
    for (const Vec3& end : {Vec3(Vec3::Zero()), step[v]}) {
      Aabb around{end, end};
      grow(around, kAround * m_length[v]);
      m_room[v].extend(around);
    }
    reached[v] = {x[v] + m_room[v].lower, x[v] + m_room[v].upper};
  }
  // All pairs whose boxes meet are found, so that no pair without a plane can meet.
  const std::vector<NearPair>* const near = m_contact.near(x, reached);
  if (!near) return false;
  for (const NearPair& pair : *near) add_pair(x, pair);
  return true;
}

std::vector<HalfSpace> StepLimits::limit(const Points& x, Points& step) {
  // Without all pairs no step is safe.
  if (!find_half_spaces(x, step)) {
    step.assign(x.size(), Vec3::Zero());
    return {};
  }
  std::vector<HalfSpace> hits;
  // A vertex without planes is free to go its whole step.
  for (size_t v = 0; v < x.size(); ++v) {
    const auto& own = m_half_spaces[v];
    if (own.empty()) continue;
    const Vec3 wanted = step[v];
    project(own, step[v]);
    // Hits of the wanted step are told, so that the next model knows of them.
    const Vec3 turned = step[v] - wanted;
    const double size = turned.norm();
    if (size > kHit * m_contact.layer()) {
      const Vec3 normal = turned / size;
      hits.push_back({static_cast<int>(v), normal, -normal.dot(step[v])});
    }
    const double part = allowed_part(own, m_room[v], step[v]);
    if (part < 1) step[v] *= part;
  }
  m_half_spaces = {};  // long steps have many, and the next factorisation needs the memory
  return hits;
}

}  // namespace trivet::flex
