#include "apps/python/module/drawn_scene.h"

#include "apps/python/module/errors.h"

namespace trivet::python {

DrawnScene::DrawnScene(SharedScene& shared, Names classes, Colours highlights)
    : m_classes(std::move(classes)), m_highlights(std::move(highlights)) {
  {
    const SceneGuard guard(shared);
    m_scene = shared.scene();
    m_layout = shared.session().layout();
    m_looks = shared.looks;
  }
  for (const auto& [name, class_name] : m_classes)
    if (!m_scene.find(name)) raise("NoSuchObject", "there is no object \"" + name + "\"");
  for (const auto& [name, colour] : m_highlights)
    if (const auto id = m_scene.find(name); !id || !m_scene.at(*id).placed)
      raise("NoSuchObject", "there is no object \"" + name + "\" in the scene");
}

LabelledScene& DrawnScene::labelled() {
  if (m_labelled) return *m_labelled;
  m_whole.emplace(m_scene);
  m_labelled = labelled_scene(m_whole->scene(), m_layout, m_classes);
  m_looks->share(*m_labelled, m_whole->scene());
  for (std::size_t i = 0; i < m_labelled->objects.size(); ++i)
    if (const auto found = m_highlights.find(m_labelled->objects[i].name);
        found != m_highlights.end())
      m_labelled->picture.objects[i].highlight = found->second;
  return *m_labelled;
}

}  // namespace trivet::python
