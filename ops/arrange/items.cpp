#include "ops/arrange/items.h"

#include <algorithm>

#include "ops/arrange/slots.h"

namespace trivet {
namespace {

std::vector<Item> all_items(const World& world) {
  std::vector<Item> out;
  std::vector<char> in_pattern(world.things().size(), 0);
  // A pattern is one item: its things come together or not at all.
  for (const Pattern& pattern : world.arrangement().patterns) {
    Item item{things_of(world, pattern), &pattern};
    for (const size_t t : item.things) in_pattern[t] = 1;
    out.push_back(std::move(item));
  }
  for (size_t t = 0; t < world.things().size(); ++t)
    if (!in_pattern[t]) out.push_back({{t}, nullptr, world.things()[t].area});
  // Patterns need large free room, and go first; then the largest things.
  std::stable_sort(out.begin(), out.end(), [](const Item& a, const Item& b) {
    return (a.pattern != nullptr) != (b.pattern != nullptr) ? a.pattern != nullptr
                                                            : a.area > b.area;
  });
  return out;
}

// Things that have to stand before: supports, then those that relations refer to.
std::vector<int> before(const World& world, const std::vector<Item>& items, const Item& item) {
  std::vector<int> out;
  // Supports come before references.
  if (item.pattern) out.push_back(item_of(world, items, item.pattern->on));
  for (const bool supports : {true, false})
    for (const size_t t : item.things)
      for (const size_t r : world.things()[t].relations) {
        const Relation& relation = world.arrangement().relations[r];
        if (relation.a == world.things()[t].thing->object && relation.is_support() == supports)
          out.push_back(item_of(world, items, relation.b));
      }
  return out;
}

}  // namespace

int item_of(const World& world, const std::vector<Item>& items, const std::string& object) {
  const int t = world.thing_of(object);
  for (size_t i = 0; i < items.size() && t >= 0; ++i)
    if (std::count(items[i].things.begin(), items[i].things.end(), static_cast<size_t>(t)))
      return static_cast<int>(i);
  return -1;
}

std::vector<Item> ordered_items(const World& world) {
  const std::vector<Item> items = all_items(world);
  // An explicit stack: chains of references may be long.
  struct Visit {
    size_t item;
    std::vector<int> before;
    size_t next = 0;
  };
  std::vector<Item> out;
  out.reserve(items.size());
  std::vector<char> met(items.size(), 0);
  for (size_t i = 0; i < items.size(); ++i) {
    if (met[i]) continue;
    met[i] = 1;
    std::vector<Visit> open;
    open.push_back({i, before(world, items, items[i])});
    // Depth first: an item is appended when all that has to stand before it is.
    while (!open.empty()) {
      Visit& top = open.back();
      if (top.next == top.before.size()) {
        out.push_back(items[top.item]);
        open.pop_back();
        continue;
      }
      const int b = top.before[top.next++];
      // Things that are met already are on the way or out: cycles of references are cut here.
      if (b < 0 || met[b]) continue;
      met[b] = 1;
      open.push_back({static_cast<size_t>(b), before(world, items, items[b])});
    }
  }
  return out;
}

}  // namespace trivet
