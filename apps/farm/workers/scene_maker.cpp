#include "apps/farm/workers/scene_maker.h"

#include <new>
#include <utility>

namespace trivet::farm {
namespace {

SceneWork work_of(const Detector& detector) {
  const DetectionWork& work = detector.work();
  return {work.num_queries, work.early, work.zlist.draws, work.zlist.read_backs};
}

SceneWork since(const SceneWork& before, const SceneWork& now) {
  return {now.queries - before.queries, now.early - before.early, now.draws - before.draws,
          now.read_backs - before.read_backs};
}

}  // namespace

SceneMaker::SceneMaker(const Work& work, const LoadedModels& models, const WorkLimits& limits,
                       std::uint64_t worker)
    : m_work(work), m_models(models), m_limits(limits), m_worker(worker) {
  if (const PictureWork* const pictures = work.pictures.get())
    m_scenes.emplace(pictures->folder, pictures->scenes.format);
  if (const ExportWork* const exports = work.exports.get())
    m_scenes.emplace(exports->folder, exports->scenes.format);
}

// Null: BVHs.
DetectorGroup* SceneMaker::detectors() {
  if (!m_work.detection.make || m_scenes) return nullptr;
  const std::lock_guard lock(m_mutex);
  if (!m_detectors) {
    const auto keep = [this](const Sentence& text) { m_notes.push_back(in_english(text)); };
    m_detectors = m_work.detection.make(m_worker, once_each(keep));
  }
  return m_detectors.get();
}

SceneMembers SceneMaker::members(std::uint64_t k, Detector* detector) {
  if (!m_scenes) return make_members(m_work, m_models, k, detector);
  if (m_work.exports) return make_exports(*m_work.exports, *m_scenes, m_work.recipe, m_models, k);
  const PictureWork& pictures = *m_work.pictures;
  if (pictures.make_opengl && !m_opengl) m_opengl = pictures.make_opengl(m_worker);
  return make_pictures(pictures, *m_scenes, m_work.recipe, m_models, m_work.key, k, m_opengl);
}

std::vector<std::string> SceneMaker::take_notes() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_notes, {});
}

WorkerReply SceneMaker::make(const SceneRequest& request) {
  WorkerReply reply;
  reply.k = request.k;
  try {
    std::optional<DetectorGroup::Part> part;
    if (DetectorGroup* const group = request.alone ? nullptr : detectors()) part.emplace(*group);
    Detector* const detector = part ? part->get() : nullptr;
    const SceneWork before = detector ? work_of(*detector) : SceneWork{};
    reply.members = members(request.k, detector);
    if (detector) reply.work = since(before, work_of(*detector));
  } catch (const std::bad_alloc&) {
    reply.error = "needs more than " + std::to_string(m_limits.memory_mb) + " MB";
    reply.is_fatal = true;
  } catch (const std::exception& e) {
    reply.error = e.what();
  }
  reply.notes = take_notes();
  return reply;
}

}  // namespace trivet::farm
