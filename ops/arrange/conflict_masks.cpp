// Constraints as masks over all places of all poses of a thing.
#include <algorithm>
#include <bit>

#include "core/base/in_parallel.h"
#include "core/base/quoted.h"
#include "ops/arrange/conflict_search.h"

namespace trivet {
namespace {

constexpr size_t kMaxSightPlaces = 4000;     // at which lines of sight are looked at first
constexpr size_t kMostSightPlaces = 100000;  // of a relation that is to be named
constexpr size_t kSightsAtOnce = 4096;       // between two looks whether that refutes the set
constexpr size_t kSightsOfPart = 128;        // of a thread's part of the work

bool has(const std::vector<std::uint64_t>& mask, size_t place) {
  return mask[place / 64] >> (place % 64) & 1;
}

void set_place(std::vector<std::uint64_t>& mask, size_t place, bool holds) {
  const std::uint64_t bit = std::uint64_t{1} << (place % 64);
  mask[place / 64] = holds ? mask[place / 64] | bit : mask[place / 64] & ~bit;
}

void append(std::vector<std::uint64_t>& mask, size_t& count, const std::vector<char>& places) {
  for (size_t i = 0; i < places.size(); ++i) {
    // Masks grow by words of 64 places.
    const size_t bit = count + i;
    if (bit / 64 >= mask.size()) mask.resize(bit / 64 + 1, 0);
    if (places[i]) mask[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
}

}  // namespace

void ConflictSearch::fill_masks() {
  // Each constraint has a mask over all places: support, relations, clearances, zones, lines of
  // sight.
  m_constraints.push_back({where(), support()});
  for (const Relation* r : m_relations) m_constraints.push_back({r->text(), other_of(*r), r});
  std::vector<ObjectId> others;
  for (const ObjectId id : m_placer.obstacles(m_poses.front(), Obstacles::All)) {
    const std::string& name = m_world.scene().at(id).name;
    others.push_back(id);
    const double keep = m_world.keep(m_out.thing, name);
    m_constraints.push_back({keep > 0 ? say("clear of %1 by %2 m", quoted(name), figure(keep, 4))
                                      : say("clear of %1", quoted(name)),
                             name});
  }
  std::vector<ObjectId> with_zones;
  for (const ObjectId id : m_placer.has_zones() ? m_world.standing() : std::vector<ObjectId>()) {
    const Sentence text = zones_text(m_world.scene().at(id).name);
    if (text.empty()) continue;
    with_zones.push_back(id);
    m_constraints.push_back({text, m_world.scene().at(id).name});
  }
  size_t count = 0;
  // Places of all poses are numbered in one row, and so are the bits of the masks.
  for (size_t p = 0; p < m_poses.size(); ++p) {
    m_world.check_interrupt();
    const Combination& c = m_poses[p];
    const PlaceField field = m_placer.field(c);
    for (size_t i = 0; i < field.size(); ++i) m_places.push_back({p, field.at(i), field.met_at(i)});
    std::vector<std::vector<char>> masks(m_constraints.size());
    for (size_t i = 0; i < field.size(); ++i) masks[0].push_back(field.is_over_support(i));
    for (size_t r = 0; r < m_relations.size(); ++r)
      for (size_t i = 0; i < field.size(); ++i)
        masks[1 + r].push_back(
            nearly_holds(*m_relations[r], moved(c.outline, field.at(i)), field.pixel()));
    for (size_t k = 0; k < others.size(); ++k)
      masks[1 + m_relations.size() + k] = field.clear_of(
          {&others[k], 1}, m_world.keep(m_out.thing, m_world.scene().at(others[k]).name));
    for (size_t k = 0; k < with_zones.size(); ++k)
      masks[1 + m_relations.size() + others.size() + k] =
          m_placer.zones_clear_of(field, c, with_zones[k]);
    for (size_t k = 0; k < masks.size(); ++k) append(m_constraints[k].mask, count, masks[k]);
    count += field.size();
  }
  // A mask whose last places are all 0 would be too short.
  for (Constraint& constraint : m_constraints) constraint.mask.resize(count / 64 + 1, 0);
  fill_sights();
}

bool ConflictSearch::all_but_sights_hold(size_t place) const {
  return std::all_of(m_constraints.begin(), m_constraints.end(), [&](const Constraint& c) {
    return (c.relation && c.relation->is_of_sight()) || has(c.mask, place);
  });
}

// Judges each place; in parallel, with the same answers.
std::vector<char> ConflictSearch::sight_holds(const Relation& r,
                                              std::span<const size_t> places) const {
  m_world.check_interrupt();
  std::vector<char> out(places.size());
  const size_t num_parts = (places.size() + kSightsOfPart - 1) / kSightsOfPart;
  in_parallel(num_parts, [&](size_t part) {
    // A judge keeps what it has found about obstacles, so each part of the work has its own.
    SightJudge judge({m_world, m_world.thing_of(m_out.thing), {}, false}, r);
    const size_t end = std::min(places.size(), (part + 1) * kSightsOfPart);
    for (size_t k = part * kSightsOfPart; k < end; ++k) {
      const Judged& at = m_places[places[k]];
      out[k] = static_cast<char>(
          judge.holds_at({m_poses[at.pose].rotation, Vec3(at.at.x(), at.at.y(), at.start_z)}));
    }
  });
  return out;
}

// Relations of sight at the places that all else leaves; of many only at some, which speak for
// those that follow them until a set is to be named: see is_refuted().
void ConflictSearch::fill_sights() {
  if (m_placer.m_sights.empty()) return;
  std::vector<size_t> left, some;
  // Sight matters only where all else holds; there are few such places.
  for (size_t place = 0; place < m_places.size(); ++place)
    if (all_but_sights_hold(place)) left.push_back(place);
  const size_t stride = left.size() / kMaxSightPlaces + 1;
  some.reserve(left.size() / stride + 1);
  for (size_t k = 0; k < left.size(); k += stride) some.push_back(left[k]);
  for (const Relation* r : m_placer.m_sights) {
    const bool is_own = r->a == m_out.thing || r->b == m_out.thing;
    Constraint sight{r->text(), is_own ? other_of(*r) : r->a, r,
                     Mask(m_places.size() / 64 + 1, ~std::uint64_t{0})};
    // A sample speaks for the places after it; a set that it leaves empty is looked at closely
    // later.
    const std::vector<char> holds = sight_holds(*r, some);
    for (size_t k = 0; k < some.size(); ++k)
      for (size_t i = k * stride; !holds[k] && i < std::min(left.size(), (k + 1) * stride); ++i)
        set_place(sight.mask, left[i], false);
    // Between those that were looked at: in the middle first.
    for (size_t step = std::bit_floor(stride); step > 0; step /= 2)
      for (size_t k = 0; k < some.size(); ++k)
        for (size_t i = step; !holds[k] && i < stride; i += step)
          if (i / step % 2 == 1 && k * stride + i < left.size())
            sight.unseen.push_back(left[k * stride + i]);
    m_constraints.push_back(std::move(sight));
  }
}

// Looks at the places for which others spoke, until the set leaves one of them. Of too many the
// last count as met.
bool ConflictSearch::is_refuted(const Set& set, Constraint& sight) {
  if (sight.unseen.size() > kMostSightPlaces) {
    for (size_t k = kMostSightPlaces; k < sight.unseen.size(); ++k)
      set_place(sight.mask, sight.unseen[k], true);
    sight.unseen.resize(kMostSightPlaces);
  }
  // A batch at a time is looked at, as one place that holds is enough.
  while (leaves_no_place(set)) {
    if (sight.unseen.empty()) return false;
    const size_t count = std::min(kSightsAtOnce, sight.unseen.size());
    const std::vector<char> holds = sight_holds(*sight.relation, {sight.unseen.data(), count});
    for (size_t k = 0; k < count; ++k)
      if (holds[k]) set_place(sight.mask, sight.unseen[k], true);
    sight.unseen.erase(sight.unseen.begin(),
                       sight.unseen.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return true;
}

// No set is called empty that is not.
bool ConflictSearch::surely_leaves_no_place(const Set& set) {
  if (!leaves_no_place(set)) return false;
  return std::none_of(set.begin(), set.end(),
                      [&](size_t i) { return is_refuted(set, m_constraints[i]); });
}

bool ConflictSearch::leaves_no_place(const Set& set) const {
  m_world.check_interrupt();
  // The masks of the set are joined 64 places at a time.
  for (size_t place = 0; place < m_places.size(); place += 64) {
    const size_t left = m_places.size() - place;
    std::uint64_t word = left >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << left) - 1;
    for (const size_t i : set) word &= m_constraints[i].mask[place / 64];
    if (word) return false;
  }
  return true;
}

// Among the set's relations that outlines judge, finds the one that is nearest to being met where
// all others of the set are.
void ConflictSearch::find_cheapest(const Set& set) {
  // The relation that costs least where all others hold is the one to give up.
  double least = kInfinity;
  for (const size_t i : set) {
    const Relation* r = m_constraints[i].relation;
    if (!r || r->is_of_sight()) continue;
    for (size_t place = 0; place < m_places.size(); ++place) {
      const bool others_hold = std::all_of(set.begin(), set.end(), [&](size_t k) {
        return k == i || has(m_constraints[k].mask, place);
      });
      if (!others_hold) continue;
      const Judged& at = m_places[place];
      const double cost = m_placer.cost(*r, moved(m_poses[at.pose].outline, at.at));
      if (cost < least) least = cost, m_out.cheapest = index_of(*r);
    }
  }
}

// Zones to be kept free, of the thing and another object; empty: neither has one.
Sentence ConflictSearch::zones_text(const std::string& other) const {
  Sentence out;
  const auto add = [&](const Sentence& text) {
    out = out.empty() ? text : say("%1, %2", out, text);
  };
  for (const Zone& zone : m_world.arrangement().zones) {
    if (zone.object == other) add(say("out of the %1", zone.text()));
    if (zone.object == m_out.thing) add(say("%1 clear of %2", zone.text(), trivet::quoted(other)));
  }
  return out;
}

// Relations need not hold to the last bit on the grid.
bool ConflictSearch::nearly_holds(const Relation& r, const Outline& outline, double pixel) const {
  // A place of the grid stands for a pixel around it, and for half a step of the turns.
  const double slack_deg = 360.0 / 64;
  return m_placer.cost(r, outline) <= 1 + (r.is_in_degrees() ? slack_deg : pixel) / r.tolerance;
}

bool ConflictSearch::find_in_masks() {
  fill_masks();
  const auto set =
      smallest_empty(m_constraints.size(), [&](const Set& s) { return surely_leaves_no_place(s); });
  if (!set) return false;
  for (const size_t i : *set) {
    m_out.constraints.push_back(m_constraints[i].text);
    note(m_constraints[i].object);
    if (m_constraints[i].relation) m_out.relations.push_back(index_of(*m_constraints[i].relation));
  }
  find_cheapest(*set);
  return true;
}

}  // namespace trivet
