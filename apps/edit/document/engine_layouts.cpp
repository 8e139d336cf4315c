// Arrangements on the document's thread: wishes kept with the scene, previews, problem files.
#include <nlohmann/json.hpp>

#include "apps/edit/document/document.h"
#include "apps/edit/document/engine.h"
#include "apps/edit/document/layout_paths.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "ops/files/arrange/section.h"
#include "ops/files/layout/paths.h"

namespace trivet::edit {

ArrangeWorker::Listener Engine::layout_listener() {
  ArrangeWorker::Listener out;
  out.found = [this](std::uint64_t number, LayoutGhost ghost) {
    tell([number, ghost = std::move(ghost)](EngineNews& shown) {
      shown.show_layout(number, std::make_shared<const LayoutGhost>(ghost));
    });
  };
  out.progressed = [this](std::uint64_t number, const std::string& thing, size_t done,
                          size_t total) {
    tell([number, thing, done, total](EngineNews& shown) {
      shown.show_layout_progress(number, thing, static_cast<int>(done), static_cast<int>(total));
    });
  };
  return out;
}

void Engine::set_wishes(std::uint64_t scene, std::string json) {
  post({0, "wishes", [scene, json = std::move(json)](Engine& engine) {
          if (scene != engine.m_scene) return false;
          engine.m_opened->session.set_arrange(json);
          engine.tell([modified = engine.m_opened->session.is_modified()](EngineNews& shown) {
            shown.show_modified(modified);
          });
          return true;
        }});
}

void Engine::request_layout(std::uint64_t number, std::uint64_t seed, Wishes::Part part,
                            size_t num_entries) {
  post({0, "arrange", [number, seed, part = std::move(part), num_entries](Engine& engine) {
          ArrangeWorker::Request request;
          request.number = number;
          request.seed = seed;
          request.committed = engine.m_published;
          request.part = part;
          request.num_entries = num_entries;
          request.scene = std::make_unique<Scene>(engine.m_opened->session.scene());
          request.settle = engine.settle_options();
          engine.m_layouts.request(std::move(request));
          return true;
        }});
}

bool Engine::accept_layout(const LayoutGhost& layout) {
  if (layout.committed == m_published) return perform(Operation(arrange_operation(layout.problem)));
  tell(Message{Message::Kind::Refused,
               Document::tr("arrange: the scene has changed since the arrangement was found; look "
                            "for another")
                   .toStdString(),
               {},
               {}});
  return false;
}

// A problem for `trivet arrange`: the layout that makes this scene, and the wishes; things are all
// that may move.
bool Engine::save_problem(const std::string& file, const std::string& arrange) {
  Layout layout =
      moved_layout(m_opened->session.layout(), folder_from(file, m_opened->model_folder));
  layout.arrange = arrange;
  write_file_atomically(file, write_layout(layout));
  return true;
}

}  // namespace trivet::edit
