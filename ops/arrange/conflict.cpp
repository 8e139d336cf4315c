#include "ops/arrange/conflict.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/conflict_search.h"
#include "ops/arrange/relation_parts.h"

namespace trivet {
namespace {

constexpr int kBisections = 40;
constexpr size_t kMaxTriples = 40;       // constraints of which all triples are tried
constexpr size_t kMaxPairs = 200;        // and all pairs
constexpr double kAnywhere = 1e6;        // metres
constexpr double kOpposite = -1 + 1e-9;  // cosine of directions that are, or are along an axis

// Leaves out all of [first, last) if the rest leaves nothing without them, else what it can of each
// half, the later first: as one by one from the end, as more constraints never leave more.
void leave_out(std::vector<size_t>& set, size_t first, size_t last,
               const std::function<bool(const std::vector<size_t>&)>& leaves_nothing) {
  if (first == last) return;
  std::vector<size_t> fewer = set;
  fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(first),
              fewer.begin() + static_cast<std::ptrdiff_t>(last));
  if (!fewer.empty() && leaves_nothing(fewer)) {
    set = std::move(fewer);
    return;
  }
  if (last - first == 1) return;
  const size_t middle = first + (last - first) / 2;
  leave_out(set, middle, last, leaves_nothing);
  leave_out(set, first, middle, leaves_nothing);
}

}  // namespace

std::optional<std::vector<size_t>> smallest_empty(
    size_t count, const std::function<bool(const std::vector<size_t>&)>& leaves_nothing) {
  std::vector<size_t> all(count);
  for (size_t i = 0; i < count; ++i) all[i] = i;
  if (!leaves_nothing(all)) return std::nullopt;
  for (size_t i = 0; i < count; ++i)
    if (leaves_nothing({i})) return {{i}};
  for (size_t i = 0; i < count && count <= kMaxPairs; ++i)
    for (size_t j = i + 1; j < count; ++j)
      if (leaves_nothing({i, j})) return {{i, j}};
  for (size_t i = 0; i < count && count <= kMaxTriples; ++i)
    for (size_t j = i + 1; j < count; ++j)
      for (size_t k = j + 1; k < count; ++k)
        if (leaves_nothing({i, j, k})) return {{i, j, k}};
  leave_out(all, 0, all.size(), leaves_nothing);
  return all;
}

Conflict ConflictSearch::run(const std::string& refused) {
  make_poses();
  if (m_poses.empty()) {
    m_out.constraints = {where()};
    note(support());
    m_out.is_certain = is_certain();
    m_out.text = trivet::quoted(m_out.thing) + " has no place " + where() + ": " + m_why_none;
    return std::move(m_out);
  }
  if (!find_in_outlines() && !find_in_masks()) {
    m_out.text = trivet::quoted(m_out.thing) + " comes to rest nowhere as it is asked for" +
                 (refused.empty() ? "" : "; first: " + refused);
    return std::move(m_out);
  }
  write();
  return std::move(m_out);
}

std::string ConflictSearch::where() const {
  const Relation* support = m_world.support_of(m_thing);
  if (!support || support->b == "floor") return "on the floor";
  std::string out = std::string(to_string(support->kind)) + " " + quoted(support->b);
  if (support->level) out += ", level " + std::to_string(*support->level);
  return out;
}

// Not of things that may be turned otherwise than they were tried.
bool ConflictSearch::is_certain() const {
  const auto& relations = m_placer.m_relations;
  return !m_out.as_they_stand && !m_thing.thing->any_yaw &&
         std::none_of(relations.begin(), relations.end(), [](const Relation* r) {
           return r->kind == RelationKind::Facing || r->kind == RelationKind::Away;
         });
}

std::string ConflictSearch::support() const {
  const Relation* support = m_world.support_of(m_thing);
  return support ? support->b : "floor";
}

void ConflictSearch::make_poses() {
  for (const Rest& rest : m_thing.rests) {
    const double height = rest.outline.top - rest.outline.bottom;
    const auto landings = m_world.landings(m_thing, height, m_why_none);
    for (const Rotation& turn : m_placer.turns(rest)) {
      Combination c;
      c.rotation = (turn * rest.rotation).normalized();
      c.outline = m_world.outline(m_thing, rest, turn);
      for (const Landing& landing : landings) {
        c.landing = landing;
        c.region = m_placer.window(landing, c.outline);
        m_poses.push_back(c);
      }
    }
  }
  for (const Relation* r : m_placer.m_relations)
    if (r->is_hard() && !r->is_of_sight()) m_relations.push_back(r);
}

ConvexRegion ConflictSearch::region(const Combination& c, const Set& set,
                                    const Slack& slack) const {
  const Vec2 far = Vec2::Constant(kAnywhere);
  ConvexRegion out = m_anywhere ? ConvexRegion(-far, far) : c.region;
  for (const size_t i : set) {
    const Relation& r = *m_relations[i];
    for (const HalfPlane& h :
         half_planes(r, c.outline, m_placer.partner(r), r.a == m_out.thing, slack(i)))
      out.clip(h);
  }
  return out;
}

bool ConflictSearch::leaves_nothing(const Set& set, const Slack& slack) const {
  m_world.check_interrupt();
  return std::all_of(m_poses.begin(), m_poses.end(),
                     [&](const Combination& c) { return region(c, set, slack).empty(); });
}

// Relations that contradict each other wherever the support is, then those that it leaves
// nothing.
bool ConflictSearch::find_in_outlines() {
  m_anywhere = true;
  if (find_set()) return true;
  m_anywhere = false;
  return find_set();
}

// Metres by which planes have to give way until the set leaves a place.
double ConflictSearch::least_slack(const Set& set, const std::function<bool(size_t)>& gives) const {
  const auto none_left = [&](double more) {
    return leaves_nothing(set, [&](size_t i) { return gives(i) ? more : 0; });
  };
  double enough = 1e-3;
  while (enough < kAnywhere && none_left(enough)) enough *= 2;
  double least = 0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (least + enough);
    (none_left(middle) ? least : enough) = middle;
  }
  return enough;
}

bool ConflictSearch::find_set() {
  const auto set = smallest_empty(m_relations.size(), [&](const Set& s) {
    return leaves_nothing(s, [](size_t) { return 0; });
  });
  if (!set) return false;
  for (const size_t i : *set) add(*m_relations[i]);
  if (!m_anywhere) {
    m_out.constraints.push_back(where());
    note(support());
  }
  // Of two, what one misses the other by; their windows reach half a tolerance beyond them.
  const double parts = set->size() > 1 ? 2 : 1;
  m_out.missing = parts * least_slack(*set, [](size_t) { return true; });
  for (size_t k = 0; k < set->size() && k < 2; ++k)
    *m_out.missing += 0.5 * m_relations[(*set)[k]]->tolerance;
  double least = kInfinity;
  for (const size_t i : *set) {
    const double alone = least_slack(*set, [i](size_t other) { return other == i; });
    if (alone < least) least = alone, m_out.cheapest = index_of(*m_relations[i]);
  }
  m_out.is_certain = is_certain();
  m_between = between(*set);
  return true;
}

// Of a thing that is to be beside one object and, on its other side, beside another: the lengths in
// the pose in which it misses the least.
std::string ConflictSearch::between(const Set& set) const {
  const auto is_beside = [&](size_t i) {
    return separates(*m_relations[i]) && m_relations[i]->a == m_out.thing;
  };
  if (set.size() != 2 || !is_beside(set[0]) || !is_beside(set[1])) return "";
  const Relation &r = *m_relations[set[0]], &s = *m_relations[set[1]];
  double least = kInfinity, left = 0, needed = 0;
  Vec2 along = Vec2::Zero();
  for (const Combination& c : m_poses) {
    const Outline &first = *m_placer.partner(r), &second = *m_placer.partner(s);
    const Vec2 d = direction_of(r, c.outline, first), e = direction_of(s, c.outline, second);
    const double room = -extent(second.hull, e) - extent(first.hull, d);
    const double need = c.outline.width(d) + r.lower + s.lower;
    if (d.dot(e) > kOpposite || room < 0 || need - room >= least) continue;
    least = need - room, left = room, needed = need, along = d;
  }
  if (!(least < kInfinity) || !(least > 0)) return "";
  const char* const axis = std::abs(along.x()) > -kOpposite   ? " along x"
                           : std::abs(along.y()) > -kOpposite ? " along y"
                                                              : "";
  char text[128];
  std::snprintf(text, sizeof(text), ": they leave %.4g m%s, it needs %.4g m", left, axis, needed);
  return " does not fit between " + trivet::quoted(r.b) + " and " + trivet::quoted(s.b) +
         (m_out.as_they_stand ? ", as things stand" : "") + text;
}

void ConflictSearch::note(const std::string& object) {
  if (object.empty()) return;
  m_out.as_they_stand |= m_world.thing_of(object) >= 0;
  if (!std::count(m_out.objects.begin(), m_out.objects.end(), object))
    m_out.objects.push_back(object);
}

void ConflictSearch::add(const Relation& r) {
  m_out.constraints.push_back(r.text());
  m_out.relations.push_back(index_of(r));
  note(other_of(r));
}

void ConflictSearch::write() {
  std::string list;
  for (const std::string& c : m_out.constraints) list += (list.empty() ? "" : "; ") + c;
  m_out.text = trivet::quoted(m_out.thing) + " has no place: " +
               (m_out.constraints.size() > 1 ? "these leave none together" : "this leaves none");
  if (m_out.as_they_stand) m_out.text += ", as things stand";
  m_out.text += ": " + list;
  if (!m_between.empty()) m_out.text = trivet::quoted(m_out.thing) + m_between;
  if (m_out.missing && m_between.empty()) {
    char text[64];
    std::snprintf(text, sizeof(text), "; %.4g m are missing", *m_out.missing);
    m_out.text += text;
  }
  if (m_out.cheapest)
    m_out.text +=
        "; the cheapest to drop: " + m_world.arrangement().relations[*m_out.cheapest].text();
}

Conflict find_conflict(World& world, size_t thing, const std::string& refused) {
  return ConflictSearch(world, thing).run(refused);
}

}  // namespace trivet
