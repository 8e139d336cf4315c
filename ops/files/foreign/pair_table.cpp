#include "ops/files/foreign/pair_table.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/base/limits.h"

namespace trivet {
namespace {

/// All bodies of a kind have this in common.
struct KindOfBody {
  bool fixed = false;
  std::vector<ContactBits> bits;  // sorted, each once
  int number = -1;                // of a body that has rules of its own; -1: none has
  friend auto operator<=>(const KindOfBody&, const KindOfBody&) = default;
};

std::vector<ContactBits> bits_of(const ForeignBody& body) {
  std::set<ContactBits> bits;
  for (const ForeignCollider& c : body.colliders) bits.insert(c.bits);
  return {bits.begin(), bits.end()};
}

/// Pairs that never collide for other reasons than their bits: by index, the smaller first.
std::set<std::pair<size_t, size_t>> kept_apart(const ForeignScene& scene) {
  std::set<std::pair<size_t, size_t>> out;
  std::map<std::string, size_t> index_of;
  std::map<int, std::vector<size_t>> of_weld;
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    index_of[scene.bodies[i].name] = i;
    of_weld[scene.bodies[i].weld].push_back(i);
  }
  const auto add = [&](size_t a, size_t b) {
    if (a != b) out.insert(std::minmax(a, b));
  };
  for (const auto& [a, b] : scene.excluded)
    if (index_of.count(a) && index_of.count(b)) add(index_of[a], index_of[b]);
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const ForeignBody& body = scene.bodies[i];
    const auto family = of_weld.find(body.parent_weld);
    if (body.parent_weld >= 0 && family != of_weld.end())
      for (const size_t j : family->second) add(i, j);
  }
  for (const ForeignJoint& joint : scene.joints)
    for (const std::string& frame : joint.frames)
      if (index_of.count(frame)) add(index_of.at(joint.moves[0]), index_of.at(frame));
  return out;
}

PairRule rule_between(const KindOfBody& a, const KindOfBody& b, FrictionRule friction,
                      bool fixed_pass) {
  PairRule out;
  std::optional<double> least;
  for (const ContactBits& x : a.bits)
    for (const ContactBits& y : b.bits)
      if (collide(x, y)) least = std::min(least.value_or(kInfinity), pair_friction(x, y, friction));
  out.may_pass = !least || (fixed_pass && a.fixed && b.fixed);
  if (least) out.friction = std::clamp(*least, kMinFriction, kMaxFriction);
  return out;
}

}  // namespace

bool collide(const ContactBits& a, const ContactBits& b) {
  return (a.type & b.affinity) != 0 || (b.type & a.affinity) != 0;
}

double pair_friction(const ContactBits& a, const ContactBits& b, FrictionRule rule) {
  if (a.priority != b.priority) return a.priority > b.priority ? a.friction : b.friction;
  switch (rule) {
    case FrictionRule::Larger:
      return std::max(a.friction, b.friction);
    case FrictionRule::Smaller:
      return std::min(a.friction, b.friction);
    case FrictionRule::Mean:
      return (a.friction + b.friction) / 2;
    case FrictionRule::Product:
      break;
  }
  return a.friction * b.friction;
}

PairTable pair_table(const ForeignScene& scene, const ForeignCollider* floor, bool links_move) {
  const std::set<std::pair<size_t, size_t>> apart = kept_apart(scene);
  std::set<size_t> special;
  for (const auto& [a, b] : apart)
    if (links_move || !scene.bodies[a].fixed || !scene.bodies[b].fixed) special.insert({a, b});
  PairTable out;
  std::map<KindOfBody, PairKind> kind_of;
  const auto kind = [&](KindOfBody body) {
    return kind_of.emplace(std::move(body), static_cast<PairKind>(kind_of.size()) + 1)
        .first->second;
  };
  for (size_t i = 0; i < scene.bodies.size(); ++i) {
    const ForeignBody& body = scene.bodies[i];
    out.kinds.push_back(
        kind({body.fixed, bits_of(body), special.count(i) ? static_cast<int>(i) : -1}));
  }
  if (floor) out.floor_kind = kind({true, {floor->bits}, -1});
  auto rules = std::make_shared<PairRules>();
  for (const auto& [a, kind_a] : kind_of)
    for (const auto& [b, kind_b] : kind_of)
      if (kind_a <= kind_b)
        rules->set(kind_a, kind_b, rule_between(a, b, scene.friction_rule, !links_move));
  for (const auto& [a, b] : apart)
    if (special.count(a) && special.count(b)) rules->set(out.kinds[a], out.kinds[b], {true, {}});
  out.rules = std::move(rules);
  return out;
}

}  // namespace trivet
