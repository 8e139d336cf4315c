// Scenes of a recipe by their number, each made when it is asked for.
#pragma once

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "apps/farm/workers/work.h"
#include "ops/files/layout/scene_of_layout.h"
#include "ops/session/restore.h"

namespace trivet::serve {

/// Thrown instead of a scene: it took too long, or the server ends.
struct NoScene : std::runtime_error {
  NoScene(bool was_cancelled, const std::string& why)
      : std::runtime_error(why), cancelled(was_cancelled) {}
  bool cancelled;
};

/// Safe to use from many threads.
class RecipeScenes {
 public:
  /// Reads the recipe and all its models.
  /// @param scene_seconds  that a scene may take; 0: unlimited.
  /// @throws Error: of the recipe, of models.
  RecipeScenes(const std::string& recipe, std::uint64_t seed, const ImportLimits& import,
               const std::string& version, double scene_seconds);

  // Each of these three throws NoScene.

  /// Scene k as a batch of this recipe and seed has it, to the byte.
  std::string json(std::uint64_t k) const;
  std::string glb(std::uint64_t k) const;
  /// A session on scene k, whose further models are read from the recipe's folder.
  OpenedSession open(std::uint64_t k) const;

  /// Cancels scenes that are being made, and all that are asked for later.
  void end() { m_ended = true; }

  /// SHA-256 of the recipe and its models.
  const std::string& hash() const { return m_hash; }
  std::uint64_t seed() const { return m_seed; }

 private:
  farm::MadeScene make(std::uint64_t k) const;

  std::string m_file, m_folder, m_hash;
  std::uint64_t m_seed;
  double m_scene_seconds;
  std::atomic<bool> m_ended = false;
  farm::Work m_work;
  LoadedModels m_models;
};

}  // namespace trivet::serve
