// Layers that a stage is made of, each read once, with the sublayers below them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/io/foreign/scene_roots.h"
#include "core/io/foreign/usd/usda_stage.h"

namespace trivet {

/// A layer with its sublayers, the strongest first.
using LayerStack = std::vector<const UsdaLayer*>;

/// Sublayers of sublayers, references of references.
inline constexpr int kMostUsdaArcs = 32;

/// Reads layers into a stage as others name them.
class UsdaStacks {
 public:
  /// All must outlive it. @param path  of the main layer. @param roots  folders that files may be
  ///   in. @param unread  gets what was not read, and why.
  UsdaStacks(UsdaStage& stage, const std::string& path, const XmlLimits& limits,
             const std::vector<std::string>& roots, std::vector<Sentence>& unread)
      : m_stage(stage), m_path(path), m_limits(limits), m_roots(path, roots), m_unread(unread) {}

  /// @throws Error (BadInput): it cannot be read.
  const LayerStack& main_stack();
  /// A layer that another one names; null: it was not read, and the reason is told. Each is tried
  /// once.
  const UsdaLayer* named(const std::string& asset, const UsdaLayer& by);
  const LayerStack& stack_of(const UsdaLayer& layer);
  /// Its path; empty, and told: it has none.
  std::string default_prim(const UsdaLayer& layer);
  /// Tells what of a layer is not composed.
  void note(const UsdaLayer& layer, const char* why);

 private:
  const UsdaLayer& load(const std::string& path);
  void add_sublayers(const UsdaLayer& layer, LayerStack& out);

  UsdaStage& m_stage;
  const std::string& m_path;
  XmlLimits m_limits;
  SceneRoots m_roots;
  std::vector<Sentence>& m_unread;
  std::map<std::string, const UsdaLayer*> m_by_path;
  std::map<const UsdaLayer*, std::unique_ptr<LayerStack>> m_stacks;
};

}  // namespace trivet
