// Patterns in arrangement files; a stack becomes relations.
#include <algorithm>
#include <iterator>

#include "core/base/limits.h"
#include "ops/files/arrange/relation_json.h"

namespace trivet {
namespace {

constexpr int kMaxColumns = 1'000'000;
constexpr double kLeastStretch = 1e-3;  // metres, of a line

Pattern::Align read_align(const JsonPlace& place, const std::vector<std::string>& accepted) {
  std::string list;
  for (size_t i = 0; i < accepted.size(); ++i) {
    if (place.value() == accepted[i]) return static_cast<Pattern::Align>(i);
    list += (list.empty() ? "\"" : ", \"") + accepted[i] + "\"";
  }
  place.refuse(say("one of %1", list));
}

void read_pattern_values(const JsonPlace& place, const ProblemNames& names, Pattern& pattern) {
  const bool on_floor_too =
      pattern.kind == Pattern::Kind::Circle || pattern.kind == Pattern::Kind::Along;
  pattern.on = on_floor_too ? names.one_or_floor(place.at("on")) : names.one(place.at("on"));
  if (const auto level = place.find("level")) pattern.level = read_level(*level, names, pattern.on);
  if (const auto gap = place.find("gap")) pattern.gap = gap->number(0, kMaxLength);
  if (const auto align = place.find("align"))
    pattern.align = read_align(*align, {"left", "centre", "right", "spread"});
  if (const auto across = place.find("across"))
    pattern.across = read_align(*across, {"front", "centre", "back"});
  if (const auto inset = place.find("inset")) pattern.inset = inset->number(0, kMaxLength);
  if (const auto order = place.find("order")) {
    if (order->value() != "listed" && order->value() != "any")
      order->refuse("\"listed\" or \"any\"");
    pattern.shuffled = order->value() == "any";
  }
}

void read_row_or_grid(const JsonPlace& place, bool grid, const ProblemNames& names,
                      Arrangement& out) {
  if (grid)
    place.expect_object({"is", "of", "on"},
                        {"level", "gap", "align", "across", "inset", "order", "columns"});
  else
    place.expect_object({"is", "of", "on"}, {"level", "gap", "align", "across", "inset", "order"});
  Pattern pattern;
  pattern.kind = grid ? Pattern::Kind::Grid : Pattern::Kind::Row;
  pattern.things = names.listed(place.at("of"));
  read_pattern_values(place, names, pattern);
  read_count(place, "columns", 1, kMaxColumns, pattern.columns);
  out.patterns.push_back(std::move(pattern));
}

void read_circle(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  place.expect_object({"is", "of", "on", "radius"},
                      {"level", "gap", "order", "start_deg", "middle", "outwards"});
  Pattern pattern;
  pattern.kind = Pattern::Kind::Circle;
  pattern.things = names.listed(place.at("of"));
  read_pattern_values(place, names, pattern);
  pattern.radius = place.at("radius").number(0, kMaxLength);
  if (const auto start = place.find("start_deg"))
    pattern.start_deg = start->number(-kMaxAngleDeg, kMaxAngleDeg);
  if (const auto middle = place.find("middle")) pattern.middle = read_point(*middle);
  if (const auto outwards = place.find("outwards")) pattern.outwards = outwards->boolean();
  out.patterns.push_back(std::move(pattern));
}

void read_facings(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  place.expect_object({"is", "of", "on"}, {"level", "gap", "align", "inset"});
  Pattern pattern;
  pattern.kind = Pattern::Kind::Facings;
  for (const JsonPlace& item : place.at("of").items()) {
    item.expect_object({"things"}, {"wide"});
    const auto things = names.listed(item.at("things"));
    Pattern::Block block{things.size(), 1};
    read_count(item, "wide", 1, kMaxColumns, block.wide);
    pattern.things.insert(pattern.things.end(), things.begin(), things.end());
    pattern.blocks.push_back(block);
  }
  if (pattern.blocks.empty()) place.at("of").refuse("at least one block {\"things\", \"wide\"}");
  read_pattern_values(place, names, pattern);
  out.patterns.push_back(std::move(pattern));
}

void read_along(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  place.expect_object({"is", "of", "on", "points"}, {"level", "gap", "order", "spacing", "front"});
  Pattern pattern;
  pattern.kind = Pattern::Kind::Along;
  pattern.things = names.listed(place.at("of"));
  read_pattern_values(place, names, pattern);
  for (const JsonPlace& corner : place.at("points").items()) {
    pattern.line.push_back(read_point(corner));
    const size_t n = pattern.line.size();
    if (n > 1 && !((pattern.line[n - 1] - pattern.line[n - 2]).norm() >= kLeastStretch))
      corner.refuse("a point 1 mm or more from the one before it");
  }
  if (pattern.line.size() < 2) place.at("points").refuse("at least two points [x, y]");
  if (const auto spacing = place.find("spacing"))
    pattern.spacing = spacing->number(kLeastStretch, kMaxLength);
  if (const auto front = place.find("front")) {
    constexpr const char* kWays[] = {"right", "left", "onwards", "back"};
    const auto* const found = std::find(std::begin(kWays), std::end(kWays), front->value());
    if (found == std::end(kWays)) front->refuse("\"right\", \"left\", \"onwards\" or \"back\"");
    pattern.front = static_cast<Pattern::Front>(found - std::begin(kWays));
  }
  out.patterns.push_back(std::move(pattern));
}

// Each on the one before, centred on it.
void read_stack(const JsonPlace& place, const ProblemNames& names, Arrangement& out) {
  place.expect_object({"is", "of", "on"}, {"level", "tolerance", "jitter"});
  if (place.find("tolerance") && place.find("jitter"))
    place.fail("accepted: either \"tolerance\" or \"jitter\", which are one");
  Relation on = usual<relations::On>(), centred = usual<relations::Centred>();
  std::optional<int>& level_of = on.as<relations::On>()->level;
  on.b = names.one_or_floor(place.at("on"));
  if (const auto level = place.find("level")) level_of = read_level(*level, names, on.b);
  if (const auto t = place.find("tolerance"))
    centred.tolerance = t->number(kMinTolerance, kMaxLength);
  if (const auto j = place.find("jitter")) centred.tolerance = j->number(kMinTolerance, kMaxLength);
  for (const std::string& name : names.listed(place.at("of"))) {
    const bool is_first = centred.b.empty();
    on.a = centred.a = name;
    out.relations.push_back(on);
    if (!is_first) out.relations.push_back(centred);
    on.b = centred.b = name;
    level_of.reset();
  }
}

}  // namespace

bool read_pattern(const JsonPlace& place, const std::string& is, const ProblemNames& names,
                  Arrangement& out) {
  if (is == "row" || is == "grid")
    read_row_or_grid(place, is == "grid", names, out);
  else if (is == "circle")
    read_circle(place, names, out);
  else if (is == "facings")
    read_facings(place, names, out);
  else if (is == "along")
    read_along(place, names, out);
  else if (is == "stack")
    read_stack(place, names, out);
  else
    return false;
  return true;
}

}  // namespace trivet
