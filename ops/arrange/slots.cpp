#include "ops/arrange/slots.h"

#include <algorithm>
#include <cmath>

#include "core/base/quoted.h"
#include "core/index/ray.h"
#include "ops/arrange/convex_region.h"
#include "ops/arrange/noise.h"
#include "ops/arrange/relations.h"

namespace trivet {
namespace {

constexpr double kLeastGapClearances = 8;
constexpr double kMostCells = 10'000;  // along an axis
constexpr double kFits = 1e-9;         // metres by which a length may be short: rounding

// Room along an axis from the middle of the surface: to its edge, or to a wall.
struct Room {
  double lower = 0, upper = 0;
  bool wall_below = false, wall_above = false;

  double length() const { return upper - lower; }
  /// Without the gaps to walls.
  Room inside(double gap) const {
    return {lower + (wall_below ? gap : 0), upper - (wall_above ? gap : 0), false, false};
  }
};

struct Member {
  size_t thing;
  Rotation rotation;
  Outline outline;  // at position zero
  double width, depth;
};

class SlotSearch {
 public:
  SlotSearch(const World& world, const Pattern& pattern, std::uint64_t seed)
      : m_world(world), m_pattern(pattern), m_seed(seed), m_on(world.outline(pattern.on)) {}

  Slots run() {
    make_members();
    if (!choose_surface()) return m_out;
    const double clearance = m_world.clearance(m_world.things()[m_members.front().thing]);
    m_gap = std::max(m_pattern.gap, kLeastGapClearances * clearance);
    m_along = room(m_on.right()).inside(m_gap);
    m_across = room(-m_on.front).inside(m_gap);
    if (m_pattern.kind == Pattern::Kind::Row)
      place_row();
    else
      place_grid();
    return m_out;
  }

 private:
  void make_members() {
    std::vector<size_t> order = things_of(m_world, m_pattern);
    for (size_t i = order.size(); m_pattern.shuffled && i > 1; --i)
      std::swap(order[i - 1], order[scrambled(m_seed ^ scrambled(i)) % i]);
    m_members.reserve(order.size());
    for (const size_t t : order) {
      const ThingModel& model = m_world.things()[t];
      const Outline lying = m_world.outline(model, {model.rests.front(), Vec3::Zero()});
      const double yaw = model.thing->yaws_deg.empty() ? 0 : model.thing->yaws_deg.front();
      const Rotation turn = turned_about_z(yaw) * turn_between(lying.front, m_on.front);
      Member member{t, (turn * model.rests.front()).normalized(), {}, 0, 0};
      member.outline = m_world.outline(model, {member.rotation, Vec3::Zero()});
      member.width = member.outline.width(m_on.right());
      member.depth = member.outline.width(m_on.front);
      m_height = std::max(m_height, member.outline.top - member.outline.bottom);
      m_members.push_back(std::move(member));
    }
  }

  bool choose_surface() {
    const auto surfaces = m_world.surfaces(m_pattern.on);
    const int level = m_pattern.level.value_or(-1);
    const SupportSurface* surface = surface_at(surfaces, level);
    if (!surface) {
      m_out.why_not = quoted(m_pattern.on) + " has " + std::to_string(surfaces.size()) +
                      " surfaces, none of which is " + std::to_string(level);
      return false;
    }
    m_surface = *surface;
    m_id = *m_world.scene().find(m_pattern.on);
    const double clearance = m_world.clearance(m_world.things()[m_members.front().thing]);
    const auto landing = landing_on(m_world.scene(), m_id, m_surface, m_height, clearance);
    if (!landing) {
      fail("the highest of them needs", m_height, "of head room, there is", m_surface.head_room);
      return false;
    }
    m_start_z = landing->start_z + clearance;
    m_middle = 0.5 * (m_surface.lower + m_surface.upper);
    return true;
  }

  // Rays at three heights, and beside the middle.
  Room room(const Vec2& axis) const {
    const Vec2 across = quarter_turned(axis);
    Room out{-extent(m_surface.outline, -axis) - axis.dot(m_middle),
             extent(m_surface.outline, axis) - axis.dot(m_middle)};
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

  double ray(const Vec2& from, double z, const Vec2& axis) const {
    const Object& support = m_world.scene().at(m_id);
    const Ray ray{Vec3(from.x(), from.y(), z), Vec3(axis.x(), axis.y(), 0)};
    const auto hit = first_hit(*support.shape, support.world_from_object(), ray);
    return hit ? hit->time : kInfinity;
  }

  void fail(const std::string& needs, double needed, const std::string& there, double is) {
    char text[256];
    std::snprintf(text, sizeof(text), "%s %.9g m %s %.9g m", needs.c_str(), needed, there.c_str(),
                  is);
    m_out.why_not = m_pattern.text() + " does not fit: " + text;
    m_out.missing = needed - is;
  }

  // Position of a member whose outline begins here along both axes, measured from the middle.
  void add(const Member& member, double along, double across) {
    const Vec2 right = m_on.right(), back = -m_on.front;
    const double x = along + right.dot(m_middle) + extent(member.outline.hull, -right);
    const double y = across + back.dot(m_middle) + extent(member.outline.hull, -back);
    const Vec2 at = x * right + y * back;
    m_out.slots.push_back(
        {member.thing, {member.rotation, Vec3(at.x(), at.y(), m_start_z - member.outline.bottom)}});
  }

  // Start of something of this length in a room. @param inset  from the end it is aligned to.
  static double begin(const Room& room, double length, Pattern::Align align, double inset) {
    switch (align) {
      case Pattern::Align::Left:
        return room.lower + inset;
      case Pattern::Align::Right:
        return room.upper - inset - length;
      default:
        return 0.5 * (room.lower + room.upper - length);
    }
  }

  void place_row() {
    double total = m_gap * double(m_members.size() - 1), depth = 0;
    for (const Member& member : m_members) {
      total += member.width;
      depth = std::max(depth, member.depth);
    }
    if (total > m_along.length() + kFits)
      return fail("with gaps they are", total, "wide, there is room for", m_along.length());
    if (depth > m_across.length() + kFits)
      return fail("the deepest of them is", depth, "deep, there is room for", m_across.length());
    const bool spread = m_pattern.align == Pattern::Align::Spread && m_members.size() > 1;
    const double gap =
        m_gap + (spread ? (m_along.length() - total) / double(m_members.size() - 1) : 0);
    double at = spread ? m_along.lower : begin(m_along, total, m_pattern.align, 0);
    for (const Member& member : m_members) {
      add(member, at, begin(m_across, member.depth, m_pattern.across, m_pattern.inset));
      at += member.width + gap;
    }
  }

  static int count_in(double length, double size, double gap) {
    return static_cast<int>(
        std::min(std::floor((length + gap + kFits) / (size + gap)), kMostCells));
  }

  void place_grid() {
    double width = 0, depth = 0;
    for (const Member& member : m_members) {
      width = std::max(width, member.width);
      depth = std::max(depth, member.depth);
    }
    const int num = static_cast<int>(m_members.size());
    int columns = count_in(m_along.length(), width, m_gap);
    const int rows = count_in(m_across.length(), depth, m_gap);
    if (m_pattern.columns > 0) columns = std::min(columns, m_pattern.columns);
    if (columns * rows < num) {
      char text[256];
      std::snprintf(text, sizeof(text),
                    "there is room for %d by %d of %.9g x %.9g m with gaps of %.9g m, in %.9g x "
                    "%.9g m",
                    columns, rows, width, depth, m_gap, m_along.length(), m_across.length());
      m_out.why_not = m_pattern.text() + " does not fit: " + text;
      return;
    }
    const int used = (num + columns - 1) / columns;
    const double x = begin(m_along, columns * (width + m_gap) - m_gap, m_pattern.align, 0);
    const double y =
        begin(m_across, used * (depth + m_gap) - m_gap, m_pattern.across, m_pattern.inset);
    for (int i = 0; i < num; ++i) {
      const int column = i % columns, row = i / columns;
      add(m_members[i], x + column * (width + m_gap) + 0.5 * (width - m_members[i].width),
          y + row * (depth + m_gap) + 0.5 * (depth - m_members[i].depth));
    }
  }

  const World& m_world;
  const Pattern& m_pattern;
  std::uint64_t m_seed;
  Outline m_on;
  ObjectId m_id;
  SupportSurface m_surface;
  Vec2 m_middle = Vec2::Zero();
  std::vector<Member> m_members;
  double m_height = 0, m_gap = 0, m_start_z = 0;
  Room m_along, m_across;
  Slots m_out;
};

}  // namespace

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
