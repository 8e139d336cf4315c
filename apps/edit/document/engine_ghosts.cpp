// Previews on the document's thread, and the detectors that answer.
#include "apps/edit/document/engine.h"

namespace trivet::edit {

GhostWorker::Listener Engine::ghost_listener() {
  GhostWorker::Listener listener;
  listener.ghost = [this](std::uint64_t request, Ghost ghost) {
    tell([request, ghost = std::move(ghost)](EngineNews& shown) {
      shown.show_ghost(request, ghost);
    });
  };
  listener.zlists = [this](std::shared_ptr<const ZListView> view) {
    tell([view = std::move(view)](EngineNews& shown) { shown.show_zlists(view); });
  };
  listener.answering = [this](const Answering& answering) {
    tell([answering](EngineNews& shown) { shown.show_previews_by(answering); });
  };
  listener.measured = [this] { use_measured(); };
  return listener;
}

// --- detection ---------------------------------------------------------------------------------

// A loss is told once, by whichever thread meets it first.
BackendOptions Engine::with_notes(BackendOptions options) {
  options.note = [this](const Sentence& note) {
    tell([note](EngineNews& shown) { shown.show_detection_note(note); });
  };
  options.gpu_notes = once_each(options.note);
  return options;
}

// BVHs answer until the machine is measured.
BackendOptions Engine::until_measured(BackendOptions options) {
  options.machine.reset();
  return options;
}

void Engine::choose_detection(BackendOptions options) {
  options = with_notes(std::move(options));
  {
    const std::lock_guard lock(m_mutex);
    m_chosen = options;
  }
  m_detector.choose(until_measured(options));
  m_layouts.choose(options);
  m_ghosts.choose(std::move(options));
  post({0, "detection", [](Engine&) { return true; }});  // renews it
}

void Engine::use_measured() {
  {
    const std::lock_guard lock(m_mutex);
    m_detector.choose(m_chosen);
  }
  post({0, "detection", [](Engine&) { return true; }});
}

// Between moves, which refer to the detector.
void Engine::renew_detector() {
  if (!m_live) m_detector.renew();
  if (const Answering now = m_detector.answering(); !(now == m_told)) {
    m_told = now;
    tell([now](EngineNews& shown) { shown.show_moves_by(now); });
  }
}

// --- ghost -------------------------------------------------------------------------------------

void Engine::request_ghost(std::uint64_t request, std::vector<Operation> choices,
                           std::shared_ptr<const SceneSnapshot> shown) {
  if (!m_watches) shown = nullptr;
  post({0, "ghost",
        [request, choices = std::move(choices), shown = std::move(shown)](Engine& engine) {
          std::unique_ptr<Scene> scene;
          if (!engine.m_ghosts_know)
            scene = std::make_unique<Scene>(engine.m_opened->session.scene());
          engine.m_ghosts_know = true;
          // The z-lists of a drag are those of its own motion, not of the fall after it.
          engine.m_ghosts.request(request, choices, engine.settle_options(), engine.context(),
                                  std::move(scene), engine.m_live ? nullptr : shown);
          return true;
        }});
}

void Engine::request_ways(ObjectId object) {
  post({0, "ways to lie", [object](Engine& engine) {
          const Scene& scene = engine.m_opened->session.scene();
          if (!scene.contains(object)) return false;
          WaysToLie ways{object, ways_to_lie(scene.at(object))};
          engine.tell([ways](EngineNews& shown) { shown.show_ways(ways); });
          return true;
        }});
}

}  // namespace trivet::edit
