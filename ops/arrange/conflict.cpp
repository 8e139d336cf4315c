#include "ops/arrange/conflict.h"

#include <algorithm>
#include <cstdint>
#include <functional>

#include "core/base/quoted.h"

namespace trivet {
namespace {

constexpr int kBisections = 40;
constexpr size_t kMaxTriples = 40;  // constraints of which all triples are tried
constexpr size_t kMaxPairs = 200;   // and all pairs
constexpr double kAnywhere = 1e6;   // metres

using Mask = std::vector<std::uint64_t>;  // places that a constraint leaves

// Smallest set whose masks leave nothing in common: sizes 1 to 3, then by deletion from all.
// nullopt: all together leave a place.
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
  for (size_t i = all.size(); i-- > 0;) {
    std::vector<size_t> fewer = all;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!fewer.empty() && leaves_nothing(fewer)) all = std::move(fewer);
  }
  return all;
}

}  // namespace

class ConflictSearch {
 public:
  ConflictSearch(World& world, size_t thing)
      : m_world(world), m_placer(world, thing, 0), m_thing(world.things()[thing]) {
    m_out.thing = m_thing.thing->object;
  }

  Conflict run(const std::string& refused) {
    make_poses();
    if (m_poses.empty()) {
      m_out.constraints = {where()};
      note(support());
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

 private:
  // A rotation and a way down, without any relation.
  std::string where() const {
    const Relation* support = m_world.support_of(m_thing);
    if (!support || support->b == "floor") return "on the floor";
    std::string out = std::string(to_string(support->kind)) + " " + quoted(support->b);
    if (support->level) out += ", level " + std::to_string(*support->level);
    return out;
  }

  std::string support() const {
    const Relation* support = m_world.support_of(m_thing);
    return support ? support->b : "floor";
  }

  void make_poses() {
    for (const Rotation& rest : m_thing.rests) {
      const Outline lying = m_world.outline(m_thing, {rest, Vec3::Zero()});
      const auto landings = m_world.landings(m_thing, lying.top - lying.bottom, m_why_none);
      for (const Rotation& turn : m_placer.turns(rest)) {
        Combination c;
        c.rotation = (turn * rest).normalized();
        c.outline = m_world.outline(m_thing, {c.rotation, Vec3::Zero()});
        for (const Landing& landing : landings) {
          c.landing = landing;
          c.region = m_placer.window(landing, c.outline);
          m_poses.push_back(c);
        }
      }
    }
    for (const Relation* r : m_placer.m_relations)
      if (r->is_hard()) m_relations.push_back(r);
  }

  ConvexRegion region(const Combination& c, const std::vector<size_t>& set, double more) const {
    const Vec2 far = Vec2::Constant(kAnywhere);
    ConvexRegion out = m_anywhere ? ConvexRegion(-far, far) : c.region;
    for (const size_t i : set) {
      const Relation& r = *m_relations[i];
      for (const HalfPlane& h :
           half_planes(r, c.outline, m_placer.partner(r), r.a == m_out.thing, more))
        out.clip(h);
    }
    return out;
  }

  bool leaves_nothing(const std::vector<size_t>& set, double more) const {
    return std::all_of(m_poses.begin(), m_poses.end(),
                       [&](const Combination& c) { return region(c, set, more).empty(); });
  }

  // Relations that contradict each other wherever the support is, then those that it leaves
  // nothing.
  bool find_in_outlines() {
    m_anywhere = true;
    if (find_set()) return true;
    m_anywhere = false;
    return find_set();
  }

  bool find_set() {
    const auto set = smallest_empty(
        m_relations.size(), [&](const std::vector<size_t>& s) { return leaves_nothing(s, 0); });
    if (!set) return false;
    for (const size_t i : *set) add(*m_relations[i]);
    if (!m_anywhere) {
      m_out.constraints.push_back(where());
      note(support());
    }
    double enough = 1e-3;
    while (enough < 1e6 && leaves_nothing(*set, enough)) enough *= 2;
    double least = 0;
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (least + enough);
      (leaves_nothing(*set, middle) ? least : enough) = middle;
    }
    // Of two, what one misses the other by; their windows reach half a tolerance beyond them.
    const double parts = set->size() > 1 ? 2 : 1;
    m_out.missing = parts * enough;
    for (size_t k = 0; k < set->size() && k < 2; ++k)
      *m_out.missing += 0.5 * m_relations[(*set)[k]]->tolerance;
    return true;
  }

  // Constraints over all places of all poses.
  struct Constraint {
    std::string text;
    std::string object;  // that it names; may be empty
    Mask mask;
  };

  static void append(Mask& mask, size_t& count, const std::vector<char>& places) {
    for (size_t i = 0; i < places.size(); ++i) {
      const size_t bit = count + i;
      if (bit / 64 >= mask.size()) mask.resize(bit / 64 + 1, 0);
      if (places[i]) mask[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
  }

  void fill_masks() {
    m_constraints.push_back({where(), support(), {}});
    for (const Relation* r : m_relations) m_constraints.push_back({r->text(), other_of(*r), {}});
    std::vector<ObjectId> others;
    for (const ObjectId id : m_placer.obstacles(m_poses.front(), Obstacles::All)) {
      const std::string& name = m_world.scene().at(id).name;
      others.push_back(id);
      m_constraints.push_back({"clear of " + quoted(name), name, {}});
    }
    std::vector<ObjectId> with_zones;
    for (const ObjectId id : m_placer.has_zones() ? m_world.standing() : std::vector<ObjectId>()) {
      const std::string text = zones_text(m_world.scene().at(id).name);
      if (text.empty()) continue;
      with_zones.push_back(id);
      m_constraints.push_back({text, m_world.scene().at(id).name, {}});
    }
    size_t count = 0;
    for (const Combination& c : m_poses) {
      const PlaceField field = m_placer.field(c);
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
    for (Constraint& constraint : m_constraints) constraint.mask.resize(count / 64 + 1, 0);
  }

  // Zones to be kept free, of the thing and another object; empty: neither has one.
  std::string zones_text(const std::string& other) const {
    std::string out;
    const auto add = [&](const std::string& text) {
      out.append(out.empty() ? "" : ", ").append(text);
    };
    for (const Zone& zone : m_world.arrangement().zones) {
      if (zone.object == other) add("out of the " + zone.text());
      if (zone.object == m_out.thing) add(zone.text() + " clear of " + trivet::quoted(other));
    }
    return out;
  }

  // Relations need not hold to the last bit on the grid.
  bool nearly_holds(const Relation& r, const Outline& outline, double pixel) const {
    const double slack_deg = 360.0 / 64;
    const bool of_angles = r.kind == RelationKind::Facing || r.kind == RelationKind::Away ||
                           r.kind == RelationKind::Aligned || r.kind == RelationKind::Parallel ||
                           r.kind == RelationKind::Same;
    return m_placer.cost(r, outline) <= 1 + (of_angles ? slack_deg : pixel) / r.tolerance;
  }

  bool find_in_masks() {
    fill_masks();
    const auto set = smallest_empty(m_constraints.size(), [&](const std::vector<size_t>& s) {
      for (size_t word = 0; word < m_constraints[0].mask.size(); ++word) {
        std::uint64_t left = ~std::uint64_t{0};
        for (const size_t i : s) left &= m_constraints[i].mask[word];
        if (left) return false;
      }
      return true;
    });
    if (!set) return false;
    for (const size_t i : *set) {
      m_out.constraints.push_back(m_constraints[i].text);
      note(m_constraints[i].object);
    }
    return true;
  }

  const std::string& other_of(const Relation& r) const { return r.a == m_out.thing ? r.b : r.a; }

  void note(const std::string& object) {
    if (object.empty()) return;
    m_out.as_they_stand |= m_world.thing_of(object) >= 0;
    if (!std::count(m_out.objects.begin(), m_out.objects.end(), object))
      m_out.objects.push_back(object);
  }

  void add(const Relation& r) {
    m_out.constraints.push_back(r.text());
    note(other_of(r));
  }

  void write() {
    std::string list;
    for (const std::string& c : m_out.constraints) list += (list.empty() ? "" : "; ") + c;
    m_out.text = trivet::quoted(m_out.thing) + " has no place: " +
                 (m_out.constraints.size() > 1 ? "these leave none together" : "this leaves none");
    if (m_out.as_they_stand) m_out.text += ", as things stand";
    m_out.text += ": " + list;
    if (m_out.missing) {
      char text[64];
      std::snprintf(text, sizeof(text), "; %.4g m are missing", *m_out.missing);
      m_out.text += text;
    }
  }

  World& m_world;
  Placer m_placer;
  const ThingModel& m_thing;
  std::vector<Combination> m_poses;
  std::vector<const Relation*> m_relations;  // hard
  std::vector<Constraint> m_constraints;
  std::string m_why_none;
  bool m_anywhere = false;  // relations alone, without what the support leaves
  Conflict m_out;
};

Conflict find_conflict(World& world, size_t thing, const std::string& refused) {
  return ConflictSearch(world, thing).run(refused);
}

}  // namespace trivet
