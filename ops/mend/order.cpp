#include "ops/mend/order.h"

#include <algorithm>
#include <set>

namespace trivet {
namespace {

class SupportOrder {
 public:
  explicit SupportOrder(std::vector<OpenIntent> objects) : m_open(std::move(objects)) {
    for (const OpenIntent& o : m_open) m_waiting.insert(o.intent.id.index);
  }

  std::vector<ObjectIntent> run() {
    // Each round takes all whose supports are placed; a circle of supports is cut at its weakest.
    while (!m_open.empty()) {
      std::vector<OpenIntent> ready;
      for (const OpenIntent& o : m_open)
        if (is_ready(o.intent)) ready.push_back(o);
      if (ready.empty())
        cut_weakest();
      else
        take(std::move(ready));
    }
    return std::move(m_out);
  }

 private:
  bool waits_for(const Support& s) const {
    return s.is_object() && m_waiting.count(s.object().index) > 0;
  }

  bool is_ready(const ObjectIntent& o) const {
    return !(o.inside && waits_for(*o.inside)) &&
           std::none_of(o.on.begin(), o.on.end(),
                        [&](const IntendedSupport& s) { return waits_for(s.on); });
  }

  void take(std::vector<OpenIntent> ready) {
    // Leaning objects come after standing ones.
    std::stable_sort(ready.begin(), ready.end(), [](const OpenIntent& a, const OpenIntent& b) {
      if (a.intent.is_level != b.intent.is_level) return a.intent.is_level;
      return a.lowest < b.lowest;
    });
    for (OpenIntent& o : ready) {
      m_waiting.erase(o.intent.id.index);
      std::erase_if(m_open,
                    [&](const OpenIntent& other) { return other.intent.id == o.intent.id; });
      m_out.push_back(std::move(o.intent));
    }
  }

  void cut_weakest() {
    ObjectIntent* from = nullptr;
    size_t which = 0;
    double least = kInfinity;
    for (OpenIntent& o : m_open)
      for (size_t i = 0; i < o.intent.on.size(); ++i)
        if (waits_for(o.intent.on[i].on) && o.intent.on[i].share < least)
          from = &o.intent, which = i, least = o.intent.on[i].share;
    if (from)
      from->on.erase(from->on.begin() + static_cast<std::ptrdiff_t>(which));
    else
      for (OpenIntent& o : m_open) o.intent.inside.reset();
  }

  std::vector<OpenIntent> m_open;
  std::set<std::uint32_t> m_waiting;  // slots of these
  std::vector<ObjectIntent> m_out;
};

}  // namespace

std::vector<ObjectIntent> lower_first(std::vector<OpenIntent> objects) {
  return SupportOrder(std::move(objects)).run();
}

}  // namespace trivet
