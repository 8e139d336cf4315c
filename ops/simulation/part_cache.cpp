#include "ops/simulation/part_cache.h"

#include <algorithm>

namespace trivet {

std::shared_ptr<HullMemo> PartCache::of(const Object& object) {
  const auto is_same = [&](const Entry& entry) {
    return entry.shape == object.shape->index && entry.model == object.model.get() &&
           entry.up == object.up;
  };
  const auto found = std::find_if(m_entries.begin(), m_entries.end(), is_same);
  if (found != m_entries.end()) {
    m_entries.splice(m_entries.begin(), m_entries, found);
  } else {
    if (m_entries.size() >= kMostModels) m_entries.pop_back();
    m_entries.push_front(
        {object.shape->index, object.model.get(), object.up, std::make_shared<HullMemo>()});
  }
  return m_entries.front().memo;
}

}  // namespace trivet
