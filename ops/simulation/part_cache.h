// Convex parts of models that many scenes share.
#pragma once

#include <list>
#include <memory>

#include "core/convex/hull_memo.h"
#include "core/scene/object.h"

namespace trivet {

/// Hulls of models, kept from scene to scene: results do not depend on it. Those that were used
/// last stay. One thread at a time.
class PartCache {
 public:
  /// The memory for the shape of this object, whatever its scale, however it lies.
  std::shared_ptr<HullMemo> of(const Object& object);

 private:
  static constexpr std::size_t kMostModels = 64;

  struct Entry {
    std::shared_ptr<const ShapeIndex> shape;  // alive as long as its address is a key
    const Model* model;
    UpAxis up;
    std::shared_ptr<HullMemo> memo;
  };
  std::list<Entry> m_entries;  // used last first
};

}  // namespace trivet
