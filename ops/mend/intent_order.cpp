#include "ops/mend/intent_order.h"

#include <algorithm>

namespace trivet {
namespace {

template <class Waits>
void cut_weakest(const std::vector<Looked*>& left, const Waits& waits_for) {
  Looked* from = nullptr;
  size_t which = 0;
  double least = kInfinity;
  for (Looked* l : left)
    for (size_t i = 0; i < l->intent.on.size(); ++i)
      if (waits_for(l->intent.on[i].on) && l->intent.on[i].share < least)
        from = l, which = i, least = l->intent.on[i].share;
  if (from)
    from->intent.on.erase(from->intent.on.begin() + static_cast<std::ptrdiff_t>(which));
  else
    for (Looked* l : left) l->intent.inside.reset();
}

}  // namespace

double lowest(const Looked& l) {
  double low = kInfinity;
  for (const Column& c : l.columns.columns) low = std::min(low, c.low);
  return low;
}

std::vector<ObjectIntent> in_order(std::vector<Looked>& looked) {
  std::vector<ObjectIntent> out;
  std::set<std::uint32_t> slots, done;
  std::vector<Looked*> left;
  for (Looked& l : looked) {
    left.push_back(&l);
    slots.insert(l.intent.id.index);
  }
  const auto waits_for = [&](const Support& s) {
    return s.is_object() && slots.count(s.object().index) && !done.count(s.object().index);
  };
  // Each round takes all whose supports are placed; a circle of supports is cut at its weakest.
  while (!left.empty()) {
    std::vector<Looked*> ready;
    for (Looked* l : left)
      if (std::none_of(l->intent.on.begin(), l->intent.on.end(),
                       [&](const IntendedSupport& s) { return waits_for(s.on); }) &&
          !(l->intent.inside && waits_for(*l->intent.inside)))
        ready.push_back(l);
    if (ready.empty()) {
      cut_weakest(left, waits_for);
      continue;
    }
    // Leaning objects come after standing ones.
    std::stable_sort(ready.begin(), ready.end(), [&](const Looked* a, const Looked* b) {
      if (a->intent.is_level != b->intent.is_level) return a->intent.is_level;
      return lowest(*a) < lowest(*b);
    });
    for (Looked* l : ready) {
      out.push_back(l->intent);
      done.insert(l->intent.id.index);
      std::erase(left, l);
    }
  }
  return out;
}

}  // namespace trivet
