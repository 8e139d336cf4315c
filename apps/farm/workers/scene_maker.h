// Scenes and pictures as a worker makes them, request by request. Private.
#pragma once

#include <mutex>
#include <optional>

#include "apps/farm/workers/reply.h"
#include "apps/farm/workers/zygote.h"

namespace trivet::farm {

/// Makes scenes, or pictures or exports of scenes that are there. Scenes in several threads at a
/// time, all else in one.
class SceneMaker {
 public:
  /// @param worker  number of the process.
  SceneMaker(const Work& work, const LoadedModels& models, const WorkLimits& limits,
             std::uint64_t worker);

  WorkerReply make(const SceneRequest& request);

 private:
  SceneMembers members(std::uint64_t k, Detector* detector);
  DetectorGroup* detectors();
  std::vector<std::string> take_notes();

  const Work& m_work;
  const LoadedModels& m_models;
  const WorkLimits& m_limits;
  std::uint64_t m_worker;
  std::mutex m_mutex;  // guards all below
  std::vector<std::string> m_notes;
  std::unique_ptr<DetectorGroup> m_detectors;  // made when first needed
  std::optional<SceneReader> m_scenes;
  DrawPicture m_opengl;
};

}  // namespace trivet::farm
