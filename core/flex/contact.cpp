#include "core/flex/contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <tuple>

#include "core/base/in_parallel.h"
#include "core/flex/barrier.h"

namespace trivet::flex {
namespace {

constexpr double kNearlyParallel =
    1e-3;  // squared sine of the angle from which edges count as parallel
// Force at half the layer over stiffness x layer: 1 / (2 ln 2 + 1 / 2) of Barrier::first / 2.
constexpr double kHalfway = 1.19;
// Near pairs are searched again when a vertex has gone so far.
constexpr double kSlackLayers = 2, kSlackCells = 0.05;
constexpr size_t kPairsTogether = 1024;  // of which one thread finds the distances
constexpr double kRaised = 0.3;  // of a kept pair's layer: the gap that is left when it is raised

std::tuple<PairKind, int, int> key(const NearPair& pair) { return {pair.kind, pair.a, pair.b}; }

}  // namespace

double ContactPair::force() const {
  return -stiffness * mollifier.value * Barrier(gap, layer).first;
}

Contact::Contact(Surroundings& surroundings, const ContactOptions& options)
    : m_surroundings(surroundings),
      m_options(options),
      m_stiffness(options.pressure * surroundings.body().pressure() / (kHalfway * options.layer)),
      m_list(surroundings, distance_outside() + options.layer,
             surroundings.body().material.thickness + options.layer,
             std::max(kSlackLayers * options.layer, kSlackCells * surroundings.body().cell)) {}

// Obstacles are met at half the thickness, the body itself at the whole one.
double Contact::full_offset(const NearPair& pair) const {
  return pair.is_own() ? m_surroundings.body().material.thickness : distance_outside();
}

double Contact::offset(const NearPair& pair) const {
  if (!pair.is_own() || m_kept.empty()) return full_offset(pair);
  const auto it = std::lower_bound(
      m_kept.begin(), m_kept.end(), pair,
      [](const Kept& kept, const NearPair& wanted) { return key(kept.pair) < key(wanted); });
  const bool is_kept = it != m_kept.end() && key(it->pair) == key(pair);
  return is_kept ? it->distance : full_offset(pair);
}

void Contact::keep_distances_of(const Points& x) {
  // Pairs that begin nearer than the thickness would have no gap, and could never move: they keep
  // half of their distance.
  const double reach = 1.01 * m_surroundings.body().material.thickness;
  std::vector<Aabb> boxes(x.size());
  for (size_t v = 0; v < x.size(); ++v) boxes[v].extend(x[v]);
  std::vector<NearPair> near;
  m_surroundings.find(boxes, 0, reach, near);
  m_kept.clear();
  for (const NearPair& pair : near) {
    if (!pair.is_own()) continue;
    const double distance = m_surroundings.points(pair, x).distance;
    if (distance < reach) m_kept.push_back({pair, distance / 2});
  }
  std::sort(m_kept.begin(), m_kept.end(),
            [](const Kept& a, const Kept& b) { return key(a.pair) < key(b.pair); });
}

bool Contact::raise_kept(const Points& x) {
  bool any = false;
  std::erase_if(m_kept, [&](Kept& kept) {
    // A part of its layer stays free, which pushes it on: at rest it would never get farther.
    const double full = full_offset(kept.pair), reach = full + m_options.layer;
    const double distance = m_surroundings.points(kept.pair, x).distance;
    const double raised = (distance - kRaised * reach) / (1 - kRaised);
    if (raised <= kept.distance) return false;
    any = true;
    kept.distance = raised;
    return raised >= full;
  });
  return any;
}

// Always of the flexible side: fine faces of obstacles must not weaken it.
double Contact::area(const NearPair& pair) const {
  const Body& body = m_surroundings.body();
  switch (pair.kind) {
    case PairKind::VertexFace:
      return body.vertex_area[pair.a];
    case PairKind::EdgeEdge:
      return body.edge_area[pair.a];
    case PairKind::FaceVertex:
      return body.face_area[pair.a] / 3;
    case PairKind::OwnVertexFace:
      return std::min(body.vertex_area[pair.a], body.face_area[pair.b]);
    case PairKind::OwnEdgeEdge:
      break;
  }
  return std::min(body.edge_area[pair.a], body.edge_area[pair.b]);
}

Mollifier Contact::mollifier(const ContactPair& of) const {
  if (of.pair.kind != PairKind::EdgeEdge && of.pair.kind != PairKind::OwnEdgeEdge) return {};
  const Vec3 &a = of.points.edge_a, &b = of.points.edge_b;
  const double cell = m_surroundings.body().cell, squared_cell = cell * cell;
  // An obstacle's own edge may be of any length; the body's edges are about a cell long.
  const double of_other = of.pair.is_own() ? squared_cell : b.squaredNorm();
  const double c = a.cross(b).squaredNorm(), limit = kNearlyParallel * squared_cell * of_other;
  // The polynomial rises from zero at parallel edges to one with a flat end.
  if (c >= limit) return {};
  return {c / limit * (2 - c / limit), 2 / limit * (1 - c / limit), -2 / (limit * limit)};
}

// @return false if its gap is gone: the step was not safe.
bool Contact::add_pair(const Points& x, const NearPair& near, std::vector<ContactPair>& out) const {
  ContactPair pair{near, m_surroundings.points(near, x), {}};
  pair.offset = offset(near);
  pair.gap = pair.points.distance - pair.offset;
  if (!(pair.gap > 0)) return false;
  pair.layer = m_options.layer + (full_offset(near) - pair.offset);
  if (pair.gap >= pair.layer) return true;
  pair.stiffness = m_stiffness * area(near);
  pair.mollifier = mollifier(pair);
  if (pair.mollifier.value > 0) out.push_back(pair);
  return true;
}

bool Contact::find(const Points& x, std::vector<ContactPair>& out) {
  std::vector<Aabb> boxes(x.size());
  for (size_t v = 0; v < x.size(); ++v) boxes[v].extend(x[v]);
  out.clear();
  // A hostile mesh may have all pairs near; the caller then gives up.
  const std::vector<NearPair>* const pairs = near(x, boxes);
  if (!pairs) return false;
  // Each piece has a list of its own; they are joined in order.
  const size_t pieces = (pairs->size() + kPairsTogether - 1) / kPairsTogether;
  std::vector<std::vector<ContactPair>> found(pieces);
  std::atomic<bool> is_clear = true;
  in_parallel(pieces, [&](size_t piece) {
    const size_t first = piece * kPairsTogether;
    for (size_t i = first; i < std::min(first + kPairsTogether, pairs->size()) && is_clear; ++i)
      if (!add_pair(x, (*pairs)[i], found[piece])) is_clear = false;
  });
  if (!is_clear) return false;
  for (auto& piece : found) {
    out.insert(out.end(), piece.begin(), piece.end());
    std::vector<ContactPair>().swap(piece);  // so that few are there twice
  }
  return true;
}

}  // namespace trivet::flex
