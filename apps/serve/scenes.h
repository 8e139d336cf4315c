// Scenes of a recipe by their number, each made when it is asked for.
#pragma once

#include <cstdint>
#include <string>

#include "apps/farm/workers/work.h"
#include "ops/files/layout/scene_of_layout.h"
#include "ops/session/restore.h"

namespace trivet::serve {

/// Safe to use from many threads.
class RecipeScenes {
 public:
  /// Reads the recipe and all its models.
  /// @throws Error: of the recipe, of models.
  RecipeScenes(const std::string& recipe, std::uint64_t seed, const ImportLimits& import,
               const std::string& version);

  /// Scene k as a batch of this recipe and seed has it, to the byte.
  std::string json(std::uint64_t k) const;
  std::string glb(std::uint64_t k) const;
  /// A session on scene k, whose further models are read from the recipe's folder.
  OpenedSession open(std::uint64_t k) const;

  /// SHA-256 of the recipe and its models.
  const std::string& hash() const { return m_hash; }
  std::uint64_t seed() const { return m_seed; }

 private:
  std::string m_file, m_folder, m_hash;
  std::uint64_t m_seed;
  farm::Work m_work;
  LoadedModels m_models;
};

}  // namespace trivet::serve
