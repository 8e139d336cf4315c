// A scene behind the interface: a session, and the rules it goes by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/library/internals.h"
#include "ops/detect/detector.h"
#include "ops/session/restore.h"
#include "trivet/operations.h"
#include "trivet/scene.h"

namespace trivet::v0 {

class Scene::Internal {
 public:
  explicit Internal(OpenedSession opened) : m_opened(std::move(opened)) {}

  Rules rules;
  std::unique_ptr<Detector> detector;  // null: BVHs

  const trivet::Scene& scene() const { return m_opened.session.scene(); }
  Session& session() { return m_opened.session; }
  const Session& session() const { return m_opened.session; }
  const OpenedSession& opened() const { return m_opened; }
  SettleOptions settle() const;

  /// @throws trivet::Error (BadInput) when it is gone.
  const Object& at(ObjectId id) const;
  const std::string& name(ObjectId id) const { return at(id).name; }

  /// As one step.
  Result perform(const std::vector<Operation>& operations, const Run& run = {});

 private:
  OpenedSession m_opened;
};

inline trivet::ObjectId inner(ObjectId id) { return {id.index, id.generation}; }
inline ObjectId outer(trivet::ObjectId id) { return {id.index, id.generation}; }
PhysicsMaterial inner(const Material& material);
Material outer(const PhysicsMaterial& material);
std::string name_of(const trivet::Scene& scene, const Support& support);

/// z-lists by OpenGL. @throws trivet::Error (Environment) where there is none.
std::unique_ptr<CandidateFinder> gpu_stage();

/// Limits of models that a file names: the importer that is found.
ImportLimits usual_limits();
/// A scene by the rules that its file states.
Scene scene_of(OpenedSession opened, Rules rules = {});

}  // namespace trivet::v0
