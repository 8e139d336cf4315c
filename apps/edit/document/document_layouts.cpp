// Wishes and arrangements, on the side of the windows.
#include <QFile>
#include <nlohmann/json.hpp>

#include "apps/edit/document/document.h"
#include "apps/edit/document/engine.h"
#include "core/base/error.h"
#include "ops/files/arrange/arrange_section.h"

namespace trivet::edit {
namespace {

// The selected objects that may move, or all that may, and what they carry.
std::vector<std::string> things_of(const SceneSnapshot& scene,
                                   const std::vector<ObjectId>& selected) {
  std::set<std::string> out;
  std::vector<ObjectId> open = selected;
  if (selected.empty())
    for (const ObjectSnapshot& object : scene.objects) open.push_back(object.id);
  while (!open.empty()) {
    const ObjectSnapshot* const object = scene.find(open.back());
    open.pop_back();
    if (!object || (*object)->fixed || (*object)->locked || !out.insert((*object)->name).second)
      continue;
    for (const LoadSupport::Entry& entry : scene.support->entries)
      if (entry.object == object->id)
        open.insert(open.end(), entry.loads.begin(), entry.loads.end());
  }
  return {out.begin(), out.end()};
}

// The one object that carries each of them now.
std::map<std::string, std::string> carriers_of(const SceneSnapshot& scene) {
  std::map<std::string, std::string> out;
  for (const LoadSupport::Entry& entry : scene.support->entries) {
    const ObjectSnapshot* const object = scene.find(entry.object);
    if (!object || entry.on_floor || entry.supports.size() != 1) continue;
    if (const ObjectSnapshot* const below = scene.find(entry.supports.front()))
      out[(*object)->name] = (*below)->name;
  }
  return out;
}

}  // namespace

void Document::set_wishes(Wishes wishes) {
  if (wishes.json() == m_wishes.json()) return;
  m_wishes = std::move(wishes);
  m_engine->set_wishes(m_wishes.json());
  clear_layout();
  Q_EMIT wishes_changed();
}

void Document::show_wishes(const std::string& json) {
  try {
    if (!json.empty()) arrange_operation(json);  // refuses what it cannot be
    m_wishes = Wishes(json);
  } catch (const Error& e) {
    m_wishes = {};
    Q_EMIT message(Message{Message::Kind::Error, e.what(), {}, {}});
  }
  Q_EMIT wishes_changed();
}

bool Document::request_layout(std::uint64_t seed, bool selected_only) {
  const std::vector<ObjectId> selected =
      selected_only ? m_selection.objects : std::vector<ObjectId>();
  const std::vector<std::string> things = selected_only && selected.empty()
                                              ? std::vector<std::string>()
                                              : things_of(*m_snapshot, selected);
  if (things.empty()) return false;
  clear_layout();
  m_seeking = true;
  m_engine->request_layout(m_layout_request, seed,
                           m_wishes.part(things, seed, carriers_of(*m_snapshot)),
                           m_wishes.list().size());
  Q_EMIT layout_changed();
  return true;
}

void Document::clear_layout() {
  ++m_layout_request;
  m_engine->cancel_layout();
  if (!m_layout && !m_seeking) return;
  m_seeking = false;
  m_layout.reset();
  Q_EMIT layout_changed();
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
  const std::string problem = m_layout->problem;
  clear_layout();
  return start("arrange", [problem](Engine& engine) { return engine.accept_layout(problem); });
}

Document::Job Document::save_problem(const std::string& file) {
  std::vector<std::string> things = things_of(*m_snapshot, {});
  const Wishes::Part part = m_wishes.part(things, m_wishes.seed(), carriers_of(*m_snapshot));
  return start("save \"" + file + "\"",
               [file, part](Engine& engine) { return engine.save_problem(file, part.json); });
}

void Document::load_wishes(const std::string& file) {
  QFile in(QString::fromStdString(file));
  const std::string where = "\"" + file + "\": ";
  if (!in.open(QIODevice::ReadOnly))
    throw Error(Error::Kind::Environment, where + "cannot be read");
  const auto document = nlohmann::ordered_json::parse(in.readAll().toStdString(), nullptr, false);
  if (!document.is_object())
    throw Error(Error::Kind::BadInput, where +
                                           "accepted: a JSON object, a problem of trivet "
                                           "arrange or its section \"arrange\"");
  auto section = document.value("arrange", document);
  // Beside the objects, as problem files may have them.
  if (document.contains("arrange") && document.contains("objects"))
    for (const auto& object : document["objects"])
      for (const auto& [key, in_section] :
           {std::pair("front", "fronts"), std::pair("zones", "zones")})
        if (object.is_object() && object.contains(key) && object.contains("name") &&
            object["name"].is_string())
          section[in_section][object["name"].get<std::string>()] = object[key];
  arrange_operation(section.dump());  // refuses what it cannot be
  set_wishes(Wishes(section.dump()));
}

}  // namespace trivet::edit
