// Prims of a stage, composed from layers: sublayers, inherits, variants, references, payloads.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/foreign/scene_roots.h"
#include "core/io/foreign/usd/usda_layer.h"

namespace trivet {

/// A path in the layers of a reference, and the path of the prim that it became.
struct UsdaMapping {
  std::string from, to;  // both empty: the stage's own layers

  /// Empty: it is outside of what was referenced.
  std::string mapped(const std::string& path) const;
};

struct UsdaOpinion {
  const UsdaSpec* spec = nullptr;
  std::shared_ptr<const UsdaMapping> mapping;
};

struct UsdaPrim {
  std::string path, name, type;
  std::vector<UsdaOpinion> opinions;  // the strongest first
  std::vector<UsdaPrim> children;
  bool is_asset = false;     // it comes from a reference of its own
  bool in_instance = false;  // overs do not reach it

  /// The strongest value; null: there is none.
  const UsdaEntry* find(std::string_view property) const;
  const UsdaEntry* metadata(std::string_view name) const;
  bool has_api(std::string_view schema) const;
  /// Paths of prims of a relationship, as the stage has them.
  std::vector<std::string> targets(std::string_view relationship) const;
};

/// A composed scene and the layers that it refers to: the main one first, whose units hold for all.
struct UsdaStage {
  std::vector<std::unique_ptr<UsdaLayer>> layers;
  std::vector<UsdaPrim> prims;
};

/// @param unread  gets what was not composed, and why.
/// @throws Error (BadInput): the layer itself cannot be read, or more prims than accepted.
UsdaStage compose_usda(const std::string& path, const XmlLimits& limits,
                       const std::vector<std::string>& roots, std::vector<Sentence>& unread);

}  // namespace trivet
