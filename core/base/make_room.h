// Room in vectors, so that what is added later cannot fail.
#pragma once

#include <algorithm>
#include <vector>

namespace trivet {

/// Capacity for `count` items; doubled when it grows, as push_back() does. Strong guarantee.
template <class T>
void make_room(std::vector<T>& items, size_t count) {
  if (items.capacity() < count) items.reserve(std::max(count, 2 * items.capacity()));
}

}  // namespace trivet
