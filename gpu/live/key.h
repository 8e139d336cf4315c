// Private to gpu: text keys of cached pictures, to detect changes.
#pragma once

#include <string>

#include "gpu/live/scene.h"

namespace trivet {

template <typename T>
void append_key(std::string& key, const T& value) {
  key.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline void append_key(std::string& key, const LiveObject& object) {
  append_key(key, object.model.get());
  for (int i = 0; i < 9; ++i) append_key(key, object.world_from_object.linear.data()[i]);
  for (int i = 0; i < 3; ++i) append_key(key, object.world_from_object.translation[i]);
  append_key(key, object.opacity);
}

}  // namespace trivet
