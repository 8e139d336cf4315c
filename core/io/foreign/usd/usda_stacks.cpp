#include "core/io/foreign/usd/usda_stacks.h"

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
#include "core/io/foreign/scene.h"
#include "core/io/foreign/uri.h"

namespace trivet {
namespace {

constexpr size_t kMostUsdaElements = 1'000'000;  // prims and properties, of all layers

}  // namespace

const LayerStack& UsdaStacks::main_stack() {
  const UsdaLayer& layer = load(m_path);
  m_by_path[std::filesystem::absolute(m_path).lexically_normal().string()] = &layer;
  return stack_of(layer);
}

const UsdaLayer& UsdaStacks::load(const std::string& path) {
  XmlLimits left = m_limits;
  left.max_elements = std::min(left.max_elements, kMostUsdaElements);
  for (const auto& layer : m_stage.layers) {
    left.max_bytes -= std::min(left.max_bytes, layer->num_bytes);
    left.max_elements -= std::min(left.max_elements, layer->num_elements);
  }
  m_stage.layers.push_back(std::make_unique<UsdaLayer>(read_usda_layer(path, left)));
  return *m_stage.layers.back();
}

const UsdaLayer* UsdaStacks::named(const std::string& asset, const UsdaLayer& by) {
  try {
    const std::string path = path_of_uri(asset, by.path, m_roots);
    const auto [known, is_new] = m_by_path.emplace(path, nullptr);
    if (is_new) known->second = &load(path);
    return known->second;
  } catch (const Error& error) {
    note_once(m_unread, error.sentence());
    return nullptr;
  }
}

const LayerStack& UsdaStacks::stack_of(const UsdaLayer& layer) {
  const auto known = m_stacks.find(&layer);
  if (known != m_stacks.end()) return *known->second;
  auto stack = std::make_unique<LayerStack>();
  add_sublayers(layer, *stack);
  return *(m_stacks[&layer] = std::move(stack));
}

void UsdaStacks::add_sublayers(const UsdaLayer& layer, LayerStack& out) {
  // A layer counts once: circles end.
  if (std::find(out.begin(), out.end(), &layer) != out.end()) return;
  if (out.size() > kMostUsdaArcs) return note(layer, "has too many layers below it");
  out.push_back(&layer);
  if (const UsdaEntry* const sublayers = find_entry(layer.root.metadata, "subLayers"))
    for (const auto& [kind, asset] : sublayers->value.words)
      if (const UsdaLayer* const below = named(asset, layer)) add_sublayers(*below, out);
}

void UsdaStacks::note(const UsdaLayer& layer, const char* why) {
  note_once(m_unread, say("%1: %2", layer.path, Sentence(why)));
}

std::string UsdaStacks::default_prim(const UsdaLayer& layer) {
  const UsdaEntry* const entry = find_entry(layer.root.metadata, "defaultPrim");
  if (entry && !entry->value.words.empty()) return "/" + entry->value.words[0].second;
  note(layer, "is referred to and has no defaultPrim");
  return "";
}

}  // namespace trivet
