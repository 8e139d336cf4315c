#include "ops/arrange/distance_bounds.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "ops/arrange/relations.h"

namespace trivet {
namespace {

constexpr double kRounding = 1e-3;       // metres
constexpr double kTouchClearances = 16;  // between what touches, at most
constexpr double kTiltedBy = 0.053;      // sine of kMostTiltDeg, rounded up
constexpr size_t kMostStanding = 64;     // objects whose distances from each other are measured

}  // namespace

DistanceBounds::DistanceBounds(const World& world) : m_world(world), m_touching(kRounding) {
  // Objects that touch are apart by some clearances; chains of them add up.
  if (!world.things().empty())
    m_touching += kTouchClearances * world.clearance(world.things().front());
  add_nodes();
  add_links();
}

const std::string* DistanceBounds::carrier(const std::string& thing) const {
  if (const auto pattern = m_pattern_of.find(thing); pattern != m_pattern_of.end())
    return &pattern->second;
  const int t = m_world.thing_of(thing);
  const Relation* support = t < 0 ? nullptr : m_world.support_of(m_world.things()[t]);
  return support ? &support->b : nullptr;
}

void DistanceBounds::add_nodes() {
  // Nodes come first: things, then all that relations and patterns name.
  for (const Pattern& p : m_world.arrangement().patterns)
    for (const std::string& name : p.things) m_pattern_of[name] = p.on;
  for (const ThingModel& thing : m_world.things()) {
    add_thing(thing);
    m_total_height += m_nodes.back().height;
  }
  for (const Relation& r : m_world.arrangement().relations)
    for (const std::string& name : {r.a, r.b}) add_standing(name);
  for (const Pattern& p : m_world.arrangement().patterns) add_standing(p.on);
  // Carriers get their place before what they carry.
  for (const ThingModel& thing : m_world.things()) {
    std::vector<const ThingModel*> chain{&thing};
    while (const std::string* below = carrier(chain.back()->thing->object)) {
      const int t = m_world.thing_of(*below);
      if (t < 0) break;
      chain.push_back(&m_world.things()[t]);
    }
    for (auto it = chain.rbegin(); it != chain.rend(); ++it)
      set_range(m_nodes[m_node_of.at((*it)->thing->object)], **it);
  }
}

void DistanceBounds::add_standing(const std::string& name) {
  if (name.empty() || name == kFloorName || m_node_of.count(name)) return;
  const Outline outline = m_world.outline(name);
  // An object that stands is as large as its outline.
  Node node{name};
  node.size = node.loose = Vec2(outline.width(Vec2::UnitX()), outline.width(Vec2::UnitY())).norm();
  node.lower = outline.bottom, node.upper = outline.top;
  node.height = node.upper - node.lower;
  m_node_of[name] = m_nodes.size();
  m_nodes.push_back(std::move(node));
}

void DistanceBounds::add_thing(const ThingModel& thing) {
  Node node{thing.thing->object};
  // A thing may lie in any of its poses: the largest counts.
  double edge = 0;
  for (const Rest& rest : thing.rests) {
    const Outline& outline = rest.outline;
    const Vec3 span(outline.width(Vec2::UnitX()), outline.width(Vec2::UnitY()),
                    outline.top - outline.bottom);
    node.size = std::max(node.size, span.norm());
    node.height = std::max(node.height, span.z());
    for (size_t i = 0; i < outline.hull.size(); ++i)
      edge = std::max(edge, (outline.hull[(i + 1) % outline.hull.size()] - outline.hull[i]).norm());
  }
  // A thing whose pose is free may lean anywhere; others tilt by a few degrees at most.
  const bool may_tip = thing.thing->pose.kind == PoseChoice::Kind::Free;
  const double tilted = kTiltedBy * node.size;
  node.loose = may_tip ? node.size : 0.5 * edge + 2 * tilted;
  node.height = may_tip ? node.size : node.height + tilted;
  m_node_of[node.name] = m_nodes.size();
  m_nodes.push_back(std::move(node));
}

// On the floor from there, else at its carrier, or at what lies in that, too.
void DistanceBounds::set_range(Node& node, const ThingModel& thing) {
  const std::string* below = carrier(node.name);
  node.lower = 0, node.upper = node.height;
  if (!below || *below == kFloorName) return;
  const Node& support = m_nodes[m_node_of.at(*below)];
  // It may hang over the edge of its support, and so reach lower than that.
  node.lower = support.lower - node.height;
  node.upper = support.upper + node.height;
  const Relation* relation = m_world.support_of(thing);
  if (!relation || !relation->as<relations::In>()) return;
  // On anything that comes to lie in there.
  for (const ObjectId id : m_world.standing())
    node.upper = std::max(node.upper, m_world.scene().world_box(id).upper.z());
  node.upper += m_total_height;
}

void DistanceBounds::add_link(const std::string& a, const std::string& b, double length,
                              const Sentence& text, const Relation* relation) {
  const size_t i = m_node_of.at(a), j = m_node_of.at(b);
  m_links[i].push_back({j, length, text, relation});
  m_links[j].push_back({i, length, text, relation});
}

// Metres between the outlines of a relation's objects at most.
double DistanceBounds::reach_of(const Relation& r) const {
  const relations::Sizes sizes{m_nodes[m_node_of.at(r.a)].size, m_nodes[m_node_of.at(r.b)].size,
                               m_touching};
  return std::visit([&](const auto& kind) { return kind.most_apart(r, sizes); }, r.kind);
}

void DistanceBounds::add_links() {
  m_links.resize(m_nodes.size());
  // Hard relations to other objects are links of the chain, as far as they bound a distance.
  for (const Relation& r : m_world.arrangement().relations) {
    if (!r.is_hard() || r.b.empty() || r.b == kFloorName) continue;
    const double length = reach_of(r);
    if (length < kInfinity) add_link(r.a, r.b, length, r.text(), &r);
  }
  // Members of a pattern lie on its support.
  for (const Pattern& p : m_world.arrangement().patterns)
    for (const std::string& name : p.things)
      if (p.on != kFloorName) add_link(name, p.on, m_touching, p.text());
  link_standing();
}

void DistanceBounds::link_standing() {
  std::vector<const Node*> standing;
  for (const Node& node : m_nodes)
    if (m_world.thing_of(node.name) < 0) standing.push_back(&node);
  for (size_t i = 0; i < standing.size() && standing.size() <= kMostStanding; ++i)
    for (size_t j = 0; j < i; ++j)
      add_link(standing[i]->name, standing[j]->name,
               distance(m_world.outline(standing[i]->name).hull,
                        m_world.outline(standing[j]->name).hull) +
                   m_touching,
               "");
}

DistanceBounds::Bounds DistanceBounds::from(size_t start, double most) const {
  // [Dijkstra 1959]: the nearest open node is final; links lead on from it.
  Bounds out;
  using Entry = std::pair<double, size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  out[start] = {0, start, nullptr};
  open.emplace(0, start);
  while (!open.empty()) {
    const auto [distance, at] = open.top();
    open.pop();
    if (distance > out.at(at).distance) continue;
    // A chain goes across each object that it passes.
    const double across = at == start ? 0 : m_nodes[at].size;
    for (const Link& link : m_links[at]) {
      const double there = distance + across + link.length;
      if (there > most) continue;
      Bound& bound = out[link.to];
      if (there >= bound.distance) continue;
      bound = {there, at, &link};
      open.emplace(there, link.to);
    }
  }
  return out;
}

bool DistanceBounds::touch(const std::string& a, const std::string& b) const {
  const std::string *under_a = carrier(a), *under_b = carrier(b);
  // Things on each other, or in one container, may come as near as they like.
  if ((under_a && *under_a == b) || (under_b && *under_b == a)) return true;
  const std::vector<std::string> in_a = containers(a), in_b = containers(b);
  return std::any_of(in_a.begin(), in_a.end(),
                     [&](const std::string& container) {
                       return container == b || std::count(in_b.begin(), in_b.end(), container) > 0;
                     }) ||
         std::count(in_b.begin(), in_b.end(), a) > 0;
}

// All that it is to lie in, or that carries it there.
std::vector<std::string> DistanceBounds::containers(const std::string& thing) const {
  std::vector<std::string> out;
  std::string at = thing;
  while (const std::string* below = carrier(at)) {
    const Relation* support = m_world.support_of(m_world.things()[m_world.thing_of(at)]);
    if (support && support->as<relations::In>()) out.push_back(*below);
    at = *below;
  }
  return out;
}

double DistanceBounds::apart(const Node& a, const Node& b, double distance) const {
  // The bound holds for outlines: a surface may lie farther inside each of them, and at another
  // height.
  const double aside = distance + a.loose + b.loose;
  const double up = std::max({0.0, a.upper - b.lower, b.upper - a.lower});
  return std::sqrt(aside * aside + up * up);
}

}  // namespace trivet
