#include "core/flex/step_limits.h"

#include <algorithm>
#include <cstdint>

#include "core/base/in_parallel.h"

namespace trivet::flex {
namespace {

constexpr double kKeep = 0.9;        // of a distance that a step may use
constexpr double kAround = 0.2;      // of a step's length around it: room for its projection
constexpr double kReach = 1.6;       // of a step's length: what is farther cannot be met
constexpr int kSweeps = 8;           // over the half-spaces of a vertex
constexpr double kHit = 0.1;         // of the layer
constexpr double kRoundOff = 1e-15;  // m
constexpr int kVerticesOfShare = 700, kMostOfShares = 16;

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

struct StepLimits::Share {
  int first = 0, last = 0;                          // vertices: the last is not one of them
  std::vector<std::uint32_t> pairs;                 // near ones that have any of them
  std::vector<std::vector<HalfSpace>> half_spaces;  // by vertices
  std::vector<HalfSpace> hits;

  bool has(int vertex) const { return vertex >= first && vertex < last; }
};

StepLimits::StepLimits(const Surroundings& surroundings, Contact& contact)
    : m_surroundings(surroundings), m_contact(contact) {}

// Only where it cuts the vertex's room.
void StepLimits::add(int vertex, const Vec3& normal, double distance, Share& share) const {
  if (!share.has(vertex)) return;
  // The vertex keeps a tenth of its distance, so that it never reaches the plane.
  const double room = kKeep * std::max(0.0, distance);
  const Aabb& box = m_room[vertex];
  const double lowest = normal.cwiseMax(0).dot(box.lower) + normal.cwiseMin(0).dot(box.upper);
  if (lowest < -room) share.half_spaces[vertex - share.first].push_back({vertex, normal, room});
}

void StepLimits::add_pair(const Points& x, const NearPair& pair, Share& share) const {
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
      add(points.vertices[i], normal, height(i) - plane - margin, share);
    else
      add(points.vertices[i], -normal, plane - height(i) - margin, share);
}

const std::vector<NearPair>* StepLimits::find_near(const Points& x, const Points& step) {
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
  return m_contact.near(x, reached);
}

std::vector<StepLimits::Share> StepLimits::shares(const std::vector<NearPair>& near,
                                                  int num_vertices) const {
  std::vector<Share> out(std::clamp(num_vertices / kVerticesOfShare, 1, kMostOfShares));
  const int count = static_cast<int>(out.size());
  for (int i = 0; i < count; ++i) {
    const auto border = [&](int share) {
      return static_cast<int>(std::int64_t{num_vertices} * share / count);
    };
    out[i].first = border(i), out[i].last = border(i + 1);
  }
  // A pair with vertices of several shares is computed for each of them.
  for (size_t i = 0; i < near.size(); ++i) {
    const BodyVertices vertices = m_surroundings.body_vertices(near[i]);
    for (Share& share : out)
      if (std::any_of(vertices.begin(), vertices.end(), [&](int v) { return share.has(v); }))
        share.pairs.push_back(static_cast<std::uint32_t>(i));
  }
  return out;
}

void StepLimits::limit_share(const Points& x, const std::vector<NearPair>& near, Share& share,
                             Points& step) const {
  share.half_spaces.assign(share.last - share.first, {});
  for (const std::uint32_t i : share.pairs) add_pair(x, near[i], share);
  // A vertex without planes is free to go its whole step.
  for (int v = share.first; v < share.last; ++v) {
    const auto& own = share.half_spaces[v - share.first];
    if (own.empty()) continue;
    const Vec3 wanted = step[v];
    project(own, step[v]);
    // Hits of the wanted step are told, so that the next model knows of them.
    const Vec3 turned = step[v] - wanted;
    const double size = turned.norm();
    if (size > kHit * m_contact.layer()) {
      const Vec3 normal = turned / size;
      share.hits.push_back({v, normal, -normal.dot(step[v])});
    }
    const double part = allowed_part(own, m_room[v], step[v]);
    if (part < 1) step[v] *= part;
  }
  std::vector<std::vector<HalfSpace>>().swap(share.half_spaces);
}

std::vector<HalfSpace> StepLimits::limit(const Points& x, Points& step) {
  const std::vector<NearPair>* const near = find_near(x, step);
  // Without all pairs no step is safe.
  if (!near) {
    step.assign(x.size(), Vec3::Zero());
    return {};
  }
  std::vector<Share> all = shares(*near, static_cast<int>(x.size()));
  in_parallel(all.size(), [&](size_t i) { limit_share(x, *near, all[i], step); });
  std::vector<HalfSpace> hits;
  for (const Share& share : all) hits.insert(hits.end(), share.hits.begin(), share.hits.end());
  return hits;
}

}  // namespace trivet::flex
