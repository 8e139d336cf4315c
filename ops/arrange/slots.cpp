#include "ops/arrange/slots.h"

#include <algorithm>

#include "core/base/quoted.h"
#include "core/index/ray.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/relations.h"
#include "ops/arrange/slot_search.h"

namespace trivet {
namespace {

constexpr double kLeastGapClearances = 8;
constexpr double kAboveFloorClearances = 5;  // of a start
constexpr double kFar = 1000;                // metres, of the floor's edges

}  // namespace

SlotSearch::SlotSearch(const World& world, const Pattern& pattern, std::uint64_t seed)
    : m_world(world), m_pattern(pattern), m_seed(seed) {
  if (!on_floor()) m_on = world.outline(pattern.on);
}

Slots SlotSearch::run() {
  make_members();
  if (!choose_surface()) return m_out;
  // The gap is never less than some clearances, so that neighbours do not touch.
  const double clearance = m_world.clearance(m_world.things()[m_members.front().thing]);
  m_gap = std::max(m_pattern.gap, kLeastGapClearances * clearance);
  m_along = room(m_on.right()).inside(m_gap);
  m_across = room(-m_on.front).inside(m_gap);
  switch (m_pattern.kind) {
    case Pattern::Kind::Row:
      place_row();
      break;
    case Pattern::Kind::Grid:
      place_grid();
      break;
    case Pattern::Kind::Circle:
      place_circle();
      break;
    case Pattern::Kind::Facings:
      place_facings();
      break;
    case Pattern::Kind::Along:
      place_along();
      break;
  }
  return m_out;
}

void SlotSearch::make_members() {
  std::vector<size_t> order = things_of(m_world, m_pattern);
  // The shuffle is by counters: the same order for the same seed on every machine.
  for (size_t i = order.size(); m_pattern.shuffled && i > 1; --i)
    std::swap(order[i - 1], order[scrambled(m_seed ^ scrambled(i)) % i]);
  m_members.reserve(order.size());
  for (const size_t t : order) {
    m_members.push_back(member_of(t, m_on.front));
    const Outline& outline = m_members.back().outline;
    m_height = std::max(m_height, outline.top - outline.bottom);
  }
}

// With its front there, but for its own yaw.
SlotSearch::Member SlotSearch::member_of(size_t thing, const Vec2& front) const {
  const ThingModel& model = m_world.things()[thing];
  const Rest& rest = model.rests.front();
  const double yaw = model.thing->yaws_deg.empty() ? 0 : model.thing->yaws_deg.front();
  const Rotation turn = turned_about_z(yaw) * relations::turn_between(rest.outline.front, front);
  Member out{thing, (turn * rest.rotation).normalized(), m_world.outline(model, rest, turn), 0, 0};
  out.width = out.outline.width(m_on.right());
  out.depth = out.outline.width(m_on.front);
  return out;
}

bool SlotSearch::choose_surface() {
  const double clearance = m_world.clearance(m_world.things()[m_members.front().thing]);
  // The floor is a surface without levels, and wide enough for any pattern.
  if (on_floor()) {
    m_surface.outline = {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}};
    m_start_z = kAboveFloorClearances * clearance;
    return true;
  }
  const auto& surfaces = m_world.surfaces(m_pattern.on);
  const int level = m_pattern.level.value_or(-1);
  const SupportSurface* surface = surface_at(surfaces, level);
  if (!surface) {
    m_out.why_not = no_such_level(m_pattern.on, surfaces.size(), level);
    return false;
  }
  m_surface = *surface;
  m_id = *m_world.scene().find(m_pattern.on);
  // The highest member decides whether there is head room for all.
  const auto landing = landing_on(m_world.scene(), m_id, surfaces, m_surface, m_height, clearance);
  if (!landing) {
    fail("the highest of them needs %1 m of head room, there is %2 m", m_height,
         m_surface.head_room);
    return false;
  }
  m_start_z = landing->start_z + clearance;
  m_middle = 0.5 * (m_surface.lower + m_surface.upper);
  return true;
}

// Rays at three heights, and beside the middle.
Room SlotSearch::room(const Vec2& axis) const {
  const Vec2 across = quarter_turned(axis);
  // The outline bounds the room along the axis; the floor has nothing else.
  Room out{-extent(m_surface.outline, -axis) - axis.dot(m_middle),
           extent(m_surface.outline, axis) - axis.dot(m_middle)};
  if (on_floor()) return out;
  // Walls and posts of a shelf shorten the room where a ray at a member's height meets them.
  const double aside =
      0.25 * (extent(m_surface.outline, across) + extent(m_surface.outline, -across));
  for (const double height : {0.1, 0.5, 0.9})
    for (const double side : {-aside, 0.0, aside}) {
      const Vec2 from = m_middle + side * across;
      const double z = m_surface.highest + height * m_height;
      if (const double hit = ray(from, z, axis); hit < out.upper)
        out.upper = hit, out.wall_above = true;
      if (const double hit = ray(from, z, -axis); - hit > out.lower)
        out.lower = -hit, out.wall_below = true;
    }
  return out;
}

double SlotSearch::ray(const Vec2& from, double z, const Vec2& axis) const {
  const Object& support = m_world.scene().at(m_id);
  const Ray ray{Vec3(from.x(), from.y(), z), Vec3(axis.x(), axis.y(), 0)};
  const auto hit = first_hit(*support.shape, support.world_from_object(), ray);
  return hit ? hit->time : kInfinity;
}

void SlotSearch::fail(const char* pattern, double needed, double is) {
  m_out.why_not =
      say("%1 does not fit: %2", m_pattern.text(), say(pattern, figure(needed, 9), figure(is, 9)));
  m_out.missing = needed - is;
}

// Position of a member whose outline begins here along both axes, measured from the middle.
void SlotSearch::add(const Member& member, double along, double across) {
  const Vec2 right = m_on.right(), back = -m_on.front;
  // Positions are measured from the surface's middle; an outline's own origin may be anywhere.
  const double x = along + right.dot(m_middle) + extent(member.outline.hull, -right);
  const double y = across + back.dot(m_middle) + extent(member.outline.hull, -back);
  const Vec2 at = x * right + y * back;
  m_out.slots.push_back(
      {member.thing, {member.rotation, Vec3(at.x(), at.y(), m_start_z - member.outline.bottom)}});
}

// With the centre of its outline there.
void SlotSearch::add_at(const Member& member, const Vec2& centre) {
  const Vec2 at = centre - member.outline.centre;
  m_out.slots.push_back(
      {member.thing, {member.rotation, Vec3(at.x(), at.y(), m_start_z - member.outline.bottom)}});
}

std::vector<size_t> things_of(const World& world, const Pattern& pattern) {
  std::vector<size_t> out;
  out.reserve(pattern.things.size());
  for (const std::string& name : pattern.things)
    out.push_back(static_cast<size_t>(world.thing_of(name)));
  return out;
}

Slots slots_of(const World& world, const Pattern& pattern, std::uint64_t seed) {
  return SlotSearch(world, pattern, seed).run();
}

}  // namespace trivet
