#include "apps/edit/document/looks.h"

namespace trivet::edit {

Look Looks::of(ObjectId id) const {
  const auto found = m_looks.find({id.index, id.generation});
  return found == m_looks.end() ? Look() : found->second;
}

void Looks::change(ObjectId id, const Look& look) {
  if (look == Look())
    m_looks.erase({id.index, id.generation});
  else
    m_looks[{id.index, id.generation}] = look;
}

std::vector<ObjectId> Looks::hidden() const {
  std::vector<ObjectId> out;
  for (const auto& [key, look] : m_looks)
    if (look.hidden) out.push_back({key.first, key.second});
  return out;
}

std::vector<ObjectId> Looks::not_selectable() const {
  std::vector<ObjectId> out;
  for (const auto& [key, look] : m_looks)
    if (look.hidden || look.not_selectable) out.push_back({key.first, key.second});
  return out;
}

}  // namespace trivet::edit
