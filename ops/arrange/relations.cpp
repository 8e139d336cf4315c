#include "ops/arrange/relations.h"

namespace trivet {

double relation_cost(const Relation& r, const Outline& a, const Outline* b) {
  return std::visit([&](const auto& kind) { return kind.cost(r, a, b); }, r.kind);
}

std::vector<HalfPlane> half_planes(const Relation& r, const Outline& moving, const Outline* other,
                                   bool moves_a, double more) {
  const relations::Placed both{moving, other, moves_a};
  const double slack = 0.5 * r.tolerance + more;
  return std::visit([&](const auto& kind) { return kind.half_planes(r, both, slack); }, r.kind);
}

bool is_decided_by_planes(const Relation& r) {
  return std::visit([](const auto& kind) { return kind.is_decided_by_planes(); }, r.kind);
}

bool separates(const Relation& r) {
  const bool is_beside = std::visit([](const auto& kind) { return kind.kIsBeside; }, r.kind);
  return is_beside && r.is_hard() && gap_of(r).lower >= 0;
}

bool closes_gap(const Relation& r) { return separates(r) && gap_of(r).upper == 0; }

relations::Gap gap_of(const Relation& r) {
  const relations::Gap* const gap = std::visit([](const auto& kind) { return kind.gap(); }, r.kind);
  return gap ? *gap : relations::Gap();
}

bool has_least_distance(const Relation& r) {
  const bool is_beside = std::visit([](const auto& kind) { return kind.kIsBeside; }, r.kind);
  return is_beside ? separates(r) : gap_of(r).lower > 0;
}

Vec2 direction_of(const Relation& r, const Outline& a, const Outline& b) {
  return std::visit([&](const auto& kind) { return kind.direction(a, b); }, r.kind);
}

std::vector<Rotation> turns_asked_for(const Relation& r, const Outline& moving,
                                      const Outline& other) {
  return std::visit([&](const auto& kind) { return kind.turns(moving, other); }, r.kind);
}

bool turns_only_a(const Relation& r) {
  return std::visit([](const auto& kind) { return kind.kTurnsOnlyA; }, r.kind);
}

Vec2 wanted_front(const Relation& r, const Outline& a, const Outline* b) {
  return std::visit([&](const auto& kind) { return kind.front(a, b); }, r.kind);
}

}  // namespace trivet
