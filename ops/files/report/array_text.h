// Arrays of numbers in JSON: their bytes as base64.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "core/io/base64.h"
#include "ops/files/json/text.h"

namespace trivet {

template <class T>
std::string text_of(const std::vector<T>& items) {
  return base64({reinterpret_cast<const char*>(items.data()), sizeof(T) * items.size()});
}

/// @throws Error (BadInput) naming the place.
template <class T>
std::vector<T> items_of(const JsonPlace& place) {
  const std::string bytes = decoded_base64(place.text());
  if (bytes.size() % sizeof(T) != 0)
    place.fail(say("is no array in base64 of items of %1 bytes", sizeof(T)));
  std::vector<T> items(bytes.size() / sizeof(T));
  std::memcpy(static_cast<void*>(items.data()), bytes.data(), bytes.size());
  return items;
}

}  // namespace trivet
