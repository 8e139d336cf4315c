// Room on a surface, and the slots of each kind of pattern in it.
#pragma once

#include <string>
#include <vector>

#include "ops/arrange/slots.h"

namespace trivet {

/// Room along an axis from the middle of the surface: to its edge, or to a wall.
struct Room {
  double lower = 0, upper = 0;
  bool wall_below = false, wall_above = false;

  double length() const { return upper - lower; }
  /// Without the gaps to walls.
  Room inside(double gap) const {
    return {lower + (wall_below ? gap : 0), upper - (wall_above ? gap : 0), false, false};
  }
};

class SlotSearch {
 public:
  SlotSearch(const World& world, const Pattern& pattern, std::uint64_t seed);
  Slots run();

 private:
  struct Member {
    size_t thing;
    Rotation rotation;
    Outline outline;  // at position zero
    double width, depth;
  };
  /// A block of facings: room for each of its things, and of the whole.
  struct Facing {
    double cell = 0, row = 0, width = 0, depth = 0;
  };

  bool on_floor() const { return m_pattern.on == kFloorName; }
  void make_members();
  Member member_of(size_t thing, const Vec2& front) const;
  bool choose_surface();
  Room room(const Vec2& axis) const;
  double ray(const Vec2& from, double z, const Vec2& axis) const;
  /// @param pattern  %1: what is needed, %2: what is there, metres.
  void fail(const char* pattern, double needed, double is);
  void add(const Member& member, double along, double across);
  void add_at(const Member& member, const Vec2& centre);
  // slot_patterns.cpp
  void place_row();
  void place_grid();
  void place_circle();
  std::vector<Facing> measured_facings() const;
  void place_facings();
  void place_along();
  void place_round(const std::vector<Vec2>& centres, const std::vector<Vec2>& fronts);

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

}  // namespace trivet
