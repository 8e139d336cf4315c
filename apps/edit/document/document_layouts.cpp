// Wishes and arrangements, on the side of the windows.
#include <nlohmann/json.hpp>

#include "apps/edit/document/document.h"
#include "apps/edit/document/engine.h"
#include "apps/edit/document/words.h"
#include "core/base/error.h"
#include "ops/files/arrange/marks_json.h"
#include "ops/files/arrange/section.h"
#include "ops/files/json/input_text.h"
#include "ops/files/json/text.h"

namespace trivet::edit {
namespace {

constexpr std::uintmax_t kMostProblemBytes = std::uintmax_t{1} << 28;

// Moved along with an object: what lies on it, and its group, as far as it is placed.
void append_companions(const SceneSnapshot& scene, const ObjectSnapshot& object,
                       std::vector<ObjectId>& out) {
  if (!object->placed) return;
  for (const LoadSupport::Entry& entry : scene.support->entries)
    if (entry.object == object.id) out.insert(out.end(), entry.loads.begin(), entry.loads.end());
  if (object->group.empty()) return;
  for (const ObjectSnapshot& other : scene.objects)
    if (other->placed && other->group == object->group) out.push_back(other.id);
}

// The selected objects that may move, or all that may, and what moves along with them.
std::set<std::string> things_of(const SceneSnapshot& scene, const std::vector<ObjectId>& selected) {
  std::set<std::string> out;
  std::vector<ObjectId> open = selected;
  if (selected.empty())
    for (const ObjectSnapshot& object : scene.objects) open.push_back(object.id);
  while (!open.empty()) {
    const ObjectSnapshot* const object = scene.find(open.back());
    open.pop_back();
    if (!object || (*object)->fixed || (*object)->locked || !out.insert((*object)->name).second)
      continue;
    append_companions(scene, *object, open);
  }
  return out;
}

// The first of several supports.
std::map<std::string, std::string> carriers_of(const SceneSnapshot& scene) {
  std::map<std::string, std::string> out;
  for (const LoadSupport::Entry& entry : scene.support->entries) {
    const ObjectSnapshot* const object = scene.find(entry.object);
    if (!object || entry.on_floor || entry.supports.empty()) continue;
    if (const ObjectSnapshot* const below = scene.find(entry.supports.front()))
      out[(*object)->name] = (*below)->name;
  }
  return out;
}

Wishes::Scope scope_of(const SceneSnapshot& scene, const std::vector<ObjectId>& selected) {
  Wishes::Scope out{things_of(scene, selected), {}, carriers_of(scene)};
  out.names.reserve(scene.objects.size());
  for (const ObjectSnapshot& object : scene.objects) out.names.push_back(object->name);
  return out;
}

}  // namespace

void Document::set_wishes(Wishes wishes) {
  if (wishes.json() == m_wishes.json()) return;
  try {
    if (!wishes.json().empty()) arrange_operation(wishes.json());
  } catch (const Error& e) {
    Q_EMIT message(Message{Message::Kind::Refused, in_words(e), {}, {}});
    return;
  }
  m_wishes = std::move(wishes);
  m_engine->set_wishes(m_scene, m_wishes.json());
  clear_layout();
  Q_EMIT wishes_changed();
}

void Document::show_wishes(const std::string& json) {
  try {
    if (!json.empty()) arrange_operation(json);  // refuses what it cannot be
    m_wishes = Wishes(json);
  } catch (const Error& e) {
    m_wishes = {};
    Q_EMIT message(Message{Message::Kind::Error, in_words(e), {}, {}});
  }
  Q_EMIT wishes_changed();
}

bool Document::request_layout(std::uint64_t seed, bool selected_only) {
  if (selected_only && m_selection.objects.empty()) return false;
  const Wishes::Scope scope =
      scope_of(*m_snapshot, selected_only ? m_selection.objects : std::vector<ObjectId>());
  if (scope.things.empty()) return false;
  clear_layout();
  m_seeking = true;
  m_engine->request_layout(m_layout_request, seed, m_wishes.part(scope, seed),
                           m_wishes.list().size());
  Q_EMIT layout_changed();
  return true;
}

void Document::clear_layout() {
  m_engine->cancel_layout(m_layout_request++);
  if (!m_layout && !m_seeking) return;
  m_seeking = false;
  m_layout.reset();
  Q_EMIT layout_changed();
}

void Document::show_layout_progress(std::uint64_t number, const std::string& thing, int done,
                                    int total) {
  if (number == m_layout_request)
    Q_EMIT layout_progressed(QString::fromStdString(thing), done, total);
}

void Document::show_layout(std::uint64_t number, std::shared_ptr<const LayoutGhost> layout) {
  if (number != m_layout_request || layout->committed != m_snapshot->committed) return;
  m_seeking = false;
  m_layout = std::move(layout);
  Q_EMIT layout_changed();
  if (m_layout->ok) return;
  Message why{Message::Kind::Refused, m_layout->text, {}, {}};
  for (const std::string& name : m_layout->objects)
    if (const ObjectSnapshot* const object = m_snapshot->find(name))
      why.objects.push_back(object->id);
  Q_EMIT message(why);
}

Document::Job Document::accept_layout() {
  if (!m_layout || !m_layout->ok) return 0;
  const auto layout = m_layout;
  clear_layout();
  return start(tr("arrange").toStdString(),
               [layout](Engine& engine) { return engine.accept_layout(*layout); });
}

Document::Job Document::save_problem(const std::string& file) {
  const Wishes::Part part = m_wishes.part(scope_of(*m_snapshot, {}), m_wishes.seed());
  return start(with_name(tr("save \"%1\""), file),
               [file, part](Engine& engine) { return engine.save_problem(file, part.json); });
}

void Document::load_wishes(const std::string& file) {
  const nlohmann::json document =
      parse_json(read_input_text(file, kMostProblemBytes, TextKind::Json), file);
  const JsonPlace root(document, file);
  const auto found = root.find("arrange");
  const JsonPlace& place = found ? *found : root;
  if (!place.value().is_object())
    place.refuse("a problem of trivet arrange or its section \"arrange\", an object");
  arrange_operation(place.value().dump());  // refuses what it cannot be
  const bool is_layout = found && root.find("objects");
  const std::string json = (is_layout ? section_with_marks(root) : place.value()).dump();
  arrange_operation(json);
  set_wishes(Wishes(json));
}

}  // namespace trivet::edit
