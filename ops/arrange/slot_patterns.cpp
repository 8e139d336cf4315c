// Rows, grids, circles and facings in the room that a surface leaves.
#include <algorithm>
#include <cmath>

#include "core/base/quoted.h"
#include "ops/arrange/slot_search.h"

namespace trivet {
namespace {

constexpr double kMostCells = 10'000;  // along an axis
constexpr double kFits = 1e-9;         // metres by which a length may be short: rounding

// Start of something of this length in a room. @param inset  from the end it is aligned to.
double begin(const Room& room, double length, Pattern::Align align, double inset) {
  switch (align) {
    case Pattern::Align::Left:
      return room.lower + inset;
    case Pattern::Align::Right:
      return room.upper - inset - length;
    default:
      return 0.5 * (room.lower + room.upper - length);
  }
}

int count_in(double length, double size, double gap) {
  return static_cast<int>(std::min(std::floor((length + gap + kFits) / (size + gap)), kMostCells));
}

}  // namespace

void SlotSearch::place_row() {
  double total = m_gap * double(m_members.size() - 1), depth = 0;
  // Things stand side by side with their gaps: the sum of widths has to fit, and the greatest
  // depth.
  for (const Member& member : m_members) {
    total += member.width;
    depth = std::max(depth, member.depth);
  }
  if (total > m_along.length() + kFits)
    return fail("with gaps they are %1 m wide, there is room for %2 m", total, m_along.length());
  if (depth > m_across.length() + kFits)
    return fail("the deepest of them is %1 m deep, there is room for %2 m", depth,
                m_across.length());
  // Spread shares what is left of the room among the gaps.
  const bool spread = m_pattern.align == Pattern::Align::Spread && m_members.size() > 1;
  const double gap =
      m_gap + (spread ? (m_along.length() - total) / double(m_members.size() - 1) : 0);
  double at = spread ? m_along.lower : begin(m_along, total, m_pattern.align, 0);
  for (const Member& member : m_members) {
    add(member, at, begin(m_across, member.depth, m_pattern.across, m_pattern.inset));
    at += member.width + gap;
  }
}

void SlotSearch::place_grid() {
  // All cells are as large as the largest thing, so that columns line up.
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
    const Sentence room =
        say("there is room for %1 by %2 of %3 x %4 m with gaps of %5 m, in %6 x %7 m", columns,
            rows, figure(width, 9), figure(depth, 9), figure(m_gap, 9), figure(m_along.length(), 9),
            figure(m_across.length(), 9));
    m_out.why_not = say("%1 does not fit: %2", m_pattern.text(), room);
    return;
  }
  // Rows are filled one after the other, from the front.
  const int used = (num + columns - 1) / columns;
  const double x = begin(m_along, columns * (width + m_gap) - m_gap, m_pattern.align, 0);
  const double y =
      begin(m_across, used * (depth + m_gap) - m_gap, m_pattern.across, m_pattern.inset);
  // Each thing stands in the middle of its cell.
  for (int i = 0; i < num; ++i) {
    const int column = i % columns, row = i / columns;
    add(m_members[i], x + column * (width + m_gap) + 0.5 * (width - m_members[i].width),
        y + row * (depth + m_gap) + 0.5 * (depth - m_members[i].depth));
  }
}

// With their centres and fronts there, if there is the gap between any two.
void SlotSearch::place_round(const std::vector<Vec2>& centres, const std::vector<Vec2>& fronts) {
  std::vector<std::vector<Vec2>> hulls;
  hulls.reserve(m_members.size());
  for (size_t i = 0; i < m_members.size(); ++i) {
    const Member member = member_of(m_members[i].thing, fronts[i]);
    // Each thing is turned by its own front, and measured then.
    add_at(member, centres[i]);
    hulls.push_back(moved(member.outline, centres[i] - member.outline.centre).hull);
  }
  // Outlines, not circles, tell whether neighbours have their gap.
  for (size_t i = 0; i < hulls.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (const double apart = distance(hulls[i], hulls[j]); apart < m_gap)
        return fail("neighbours need %1 m between them, there is %2 m", m_gap, apart);
}

// Around the middle, counter-clockwise, at equal angles.
void SlotSearch::place_circle() {
  const Vec2 middle = m_pattern.middle.value_or(m_middle);
  const double step = 360.0 / double(m_members.size());
  std::vector<Vec2> centres, fronts;
  for (size_t i = 0; i < m_members.size(); ++i) {
    const Mat3 turn = turned_about_z(m_pattern.start_deg + step * double(i)).matrix();
    const Vec2 out = turn.topLeftCorner<2, 2>() * m_on.right();
    centres.push_back(middle + m_pattern.radius * out);
    fronts.push_back(m_pattern.outwards ? out : Vec2(-out));
  }
  place_round(centres, fronts);
}

// At equal distances along the line, from its beginning.
void SlotSearch::place_along() {
  const std::vector<Vec2>& line = m_pattern.line;
  // Without a spacing the things share the whole line.
  double length = 0;
  for (size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  const double count = double(m_members.size() - 1);
  const double spacing = m_pattern.spacing > 0 ? m_pattern.spacing : length / std::max(1.0, count);
  if (spacing * count > length + kFits)
    return fail("along the line they take %1 m it is long by %2 m", spacing * count, length);
  std::vector<Vec2> centres, fronts;
  size_t k = 1;
  double passed = 0;  // of the line, up to corner k - 1
  for (size_t i = 0; i < m_members.size(); ++i) {
    const double at = std::min(spacing * double(i), length);
    // The walk goes on to the segment in which this length ends.
    while (k + 1 < line.size() && passed + (line[k] - line[k - 1]).norm() < at)
      passed += (line[k] - line[k - 1]).norm(), ++k;
    const Vec2 onwards = (line[k] - line[k - 1]).normalized();
    centres.push_back(line[k - 1] + (at - passed) * onwards);
    // Fronts are told as seen by one who walks along the line.
    const Vec2 left = quarter_turned(onwards);
    const Vec2 choices[] = {-left, left, onwards, -onwards};
    fronts.push_back(choices[static_cast<int>(m_pattern.front)]);
  }
  place_round(centres, fronts);
}

std::vector<SlotSearch::Facing> SlotSearch::measured_facings() const {
  std::vector<Facing> out;
  out.reserve(m_pattern.blocks.size());
  size_t first = 0;
  for (const Pattern::Block& given : m_pattern.blocks) {
    Facing block;
    // All cells of a block are as large as its largest member, so that rows and columns are
    // straight.
    for (size_t i = first; i < first + given.count; ++i) {
      block.cell = std::max(block.cell, m_members[i].width);
      block.row = std::max(block.row, m_members[i].depth);
    }
    first += given.count;
    const auto wide = static_cast<size_t>(given.wide);
    const size_t rows = (given.count + wide - 1) / wide;
    // Gaps lie between cells alone: one fewer than cells.
    block.width = double(std::min(wide, given.count)) * (block.cell + m_gap) - m_gap;
    block.depth = double(rows) * (block.row + m_gap) - m_gap;
    out.push_back(block);
  }
  return out;
}

// A block beside the other; in each the first things are in front, in columns.
void SlotSearch::place_facings() {
  const std::vector<Facing> blocks = measured_facings();
  const double room = m_across.length() - m_pattern.inset;
  double total = -m_gap;
  for (const Facing& block : blocks) {
    if (block.depth > room + kFits)
      return fail("a block is %1 m deep, there is room for %2 m", block.depth, room);
    total += block.width + m_gap;
  }
  if (total > m_along.length() + kFits)
    return fail("with gaps they are %1 m wide, there is room for %2 m", total, m_along.length());
  const bool spread = m_pattern.align == Pattern::Align::Spread && blocks.size() > 1;
  const double between =
      m_gap + (spread ? (m_along.length() - total) / double(blocks.size() - 1) : 0);
  // Blocks stand side by side as things do in a row.
  double at = spread ? m_along.lower : begin(m_along, total, m_pattern.align, 0);
  size_t next = 0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    const auto wide = static_cast<size_t>(m_pattern.blocks[b].wide);
    for (size_t i = 0; i < m_pattern.blocks[b].count; ++i, ++next) {
      const Member& member = m_members[next];
      const size_t column = i % wide, row = i / wide;
      const double x = at + double(column) * (blocks[b].cell + m_gap);
      const double y = m_across.lower + m_pattern.inset + double(row) * (blocks[b].row + m_gap);
      add(member, x + 0.5 * (blocks[b].cell - member.width), y);
    }
    at += blocks[b].width + between;
  }
}

}  // namespace trivet
