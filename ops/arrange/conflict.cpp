#include "ops/arrange/conflict.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "ops/arrange/conflict_search.h"
#include "ops/arrange/relations.h"

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
  // A half that can go as a whole spares one question for each of its members.
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

Sentence no_place(const Conflict& conflict) {
  const bool several = conflict.constraints.size() > 1;
  const char* const pattern =
      conflict.as_they_stand
          ? several
                ? TRIVET_SENTENCE("%1 has no place: these leave none together, as things stand: %2")
                : TRIVET_SENTENCE("%1 has no place: this leaves none, as things stand: %2")
      : several ? TRIVET_SENTENCE("%1 has no place: these leave none together: %2")
                : TRIVET_SENTENCE("%1 has no place: this leaves none: %2");
  return say(pattern, quoted(conflict.thing), listed(conflict.constraints));
}

}  // namespace

std::optional<std::vector<size_t>> smallest_empty(
    size_t count, const std::function<bool(const std::vector<size_t>&)>& leaves_nothing) {
  std::vector<size_t> all(count);
  for (size_t i = 0; i < count; ++i) all[i] = i;
  // A relation that leaves nothing alone is the shortest answer.
  if (!leaves_nothing(all)) return std::nullopt;
  for (size_t i = 0; i < count; ++i)
    if (leaves_nothing({i})) return {{i}};
  // Pairs and triples are tried while they are few enough.
  for (size_t i = 0; i < count && count <= kMaxPairs; ++i)
    for (size_t j = i + 1; j < count; ++j)
      if (leaves_nothing({i, j})) return {{i, j}};
  for (size_t i = 0; i < count && count <= kMaxTriples; ++i)
    for (size_t j = i + 1; j < count; ++j)
      for (size_t k = j + 1; k < count; ++k)
        if (leaves_nothing({i, j, k})) return {{i, j, k}};
  // Beyond that, leaving out halves finds a set of which none can be spared, if not the smallest.
  leave_out(all, 0, all.size(), leaves_nothing);
  return all;
}

Conflict ConflictSearch::run(const Sentence& refused) {
  make_poses();
  // A thing without any pose has no surface to stand on: its support alone is the conflict.
  if (m_poses.empty()) {
    m_out.constraints = {where()};
    note(support());
    m_out.is_certain = is_certain();
    m_out.text = say("%1 has no place %2: %3", trivet::quoted(m_out.thing), where(), m_why_none);
    return std::move(m_out);
  }
  // Outlines are looked at first, as they need no places; masks over places tell the rest.
  if (!find_in_outlines() && !find_in_masks()) {
    const std::string thing = trivet::quoted(m_out.thing);
    m_out.text = refused.empty() ? say("%1 comes to rest nowhere as it is asked for", thing)
                                 : say("%1 comes to rest nowhere as it is asked for; first: %2",
                                       thing, refused);
    return std::move(m_out);
  }
  write();
  return std::move(m_out);
}

Sentence ConflictSearch::where() const {
  const Relation* support = m_world.support_of(m_thing);
  if (!support || support->b == "floor") return "on the floor";
  const Sentence out =
      say(support->as<relations::In>() ? TRIVET_SENTENCE("in %1") : TRIVET_SENTENCE("on %1"),
          quoted(support->b));
  const auto* const on = support->as<relations::On>();
  return on && on->level ? say("%1, level %2", out, *on->level) : out;
}

// Not of things that may be turned otherwise than they were tried.
bool ConflictSearch::is_certain() const {
  const auto& relations = m_placer.m_relations;
  return !m_out.as_they_stand && !m_thing.thing->any_yaw &&
         std::none_of(relations.begin(), relations.end(),
                      [](const Relation* r) { return r->faces(); });
}

std::string ConflictSearch::support() const {
  const Relation* support = m_world.support_of(m_thing);
  return support ? support->b : "floor";
}

void ConflictSearch::make_poses() {
  // Poses are all rests, turns and ways down, as placing tries them.
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
  // Sights are judged by rays at places, not by outlines.
  for (const Relation* r : m_placer.m_relations)
    if (r->is_hard() && !r->is_of_sight()) m_relations.push_back(r);
}

ConvexRegion ConflictSearch::region(const Combination& c, const Set& set,
                                    const Slack& slack) const {
  const Vec2 far = Vec2::Constant(kAnywhere);
  // A pose leaves a place if all half planes of the set have a point in common.
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
  // Doubling finds a slack that is enough, halving the least one.
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
  // Each of two misses the other; their windows reach half a tolerance beyond them.
  const double parts = set->size() > 1 ? 2 : 1;
  // The length that is missing is what all of them have to give together; the cheapest relation is
  // the one that alone has to give least.
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

// For a thing that is to be beside one object and, on its other side, beside another: the lengths
// in the pose in which it misses the least.
Sentence ConflictSearch::between(const Set& set) const {
  const auto is_beside = [&](size_t i) {
    return separates(*m_relations[i]) && m_relations[i]->a == m_out.thing;
  };
  // The sentence is for the simplest case: two relations of the thing, one on each side.
  if (set.size() != 2 || !is_beside(set[0]) || !is_beside(set[1])) return {};
  const Relation &r = *m_relations[set[0]], &s = *m_relations[set[1]];
  double least = kInfinity, left = 0, needed = 0;
  Vec2 along = Vec2::Zero();
  // Both partners bound the room along one line, in opposite directions.
  for (const Combination& c : m_poses) {
    const Outline &first = *m_placer.partner(r), &second = *m_placer.partner(s);
    const Vec2 d = direction_of(r, c.outline, first), e = direction_of(s, c.outline, second);
    const double room = -extent(second.hull, e) - extent(first.hull, d);
    const double need = c.outline.width(d) + gap_of(r).lower + gap_of(s).lower;
    if (d.dot(e) > kOpposite || room < 0 || need - room >= least) continue;
    least = need - room, left = room, needed = need, along = d;
  }
  if (!(least < kInfinity) || !(least > 0)) return {};
  const char* const axis = std::abs(along.x()) > -kOpposite   ? TRIVET_SENTENCE("%1 m along x")
                           : std::abs(along.y()) > -kOpposite ? TRIVET_SENTENCE("%1 m along y")
                                                              : "%1 m";
  return say(
      m_out.as_they_stand
          ? TRIVET_SENTENCE("%1 does not fit between %2 and %3, as things stand: they leave "
                            "%4, it needs %5 m")
          : TRIVET_SENTENCE("%1 does not fit between %2 and %3: they leave %4, it needs %5 m"),
      trivet::quoted(m_out.thing), trivet::quoted(r.b), trivet::quoted(s.b),
      say(axis, figure(left, 4)), figure(needed, 4));
}

void ConflictSearch::note(const std::string& object) {
  // A conflict with things that may move holds only as they stand.
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
  m_out.text = m_between.empty() ? no_place(m_out) : m_between;
  if (m_out.missing && m_between.empty())
    m_out.text = say("%1; %2 m are missing", m_out.text, figure(*m_out.missing, 4));
  if (m_out.cheapest)
    m_out.text = say("%1; the cheapest to drop: %2", m_out.text,
                     m_world.arrangement().relations[*m_out.cheapest].text());
}

Conflict find_conflict(World& world, size_t thing, const Sentence& refused) {
  return ConflictSearch(world, thing).run(refused);
}

}  // namespace trivet
