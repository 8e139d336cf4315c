// Properties: what the object is made of.
#include <QSignalBlocker>

#include "apps/edit/window/properties.h"
#include "core/scene/materials.h"

namespace trivet::edit {

void Properties::add_material() {
  m_preset->setObjectName("material");
  m_friction->setObjectName("friction");
  m_preset->addItem(tr("Custom"));
  for (const std::string& name : material_names()) m_preset->addItem(QString::fromStdString(name));
  const auto add = [&](const QString& name, QWidget* field, const QString& tip) {
    auto* const title = new QLabel(name);
    title->setObjectName("faint");
    title->setToolTip(tip);
    field->setToolTip(tip);
    m_form->addRow(title, field);
  };
  add(tr("Material"), m_preset, tr("A preset, or the numbers below"));
  add(tr("Friction"), m_friction,
      tr("Coulomb coefficient; of two surfaces in contact the smaller one holds"));
  add(tr("Density"), m_density, tr("For weights, and for simulators"));
  add(tr("Restitution"), m_restitution, tr("For simulators: nothing bounces here"));
  connect(m_preset, &QComboBox::activated, this, [this](int index) {
    if (index > 0) take_material(*material_preset(m_preset->itemText(index).toStdString()));
  });
  const std::pair<QDoubleSpinBox*, double PhysicsMaterial::*> numbers[] = {
      {m_friction, &PhysicsMaterial::friction},
      {m_density, &PhysicsMaterial::density},
      {m_restitution, &PhysicsMaterial::restitution}};
  for (const auto& [box, member] : numbers)
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, member = member](double value) {
      PhysicsMaterial material = m_material;  // unchanged values keep all their digits
      material.name.clear();
      material.*member = value;
      take_material(material);
    });
}

void Properties::show_material(const PhysicsMaterial& material) {
  m_material = material;
  const QSignalBlocker preset(m_preset), friction(m_friction), density(m_density),
      restitution(m_restitution);
  m_preset->setCurrentIndex(
      is_preset(material) ? m_preset->findText(QString::fromStdString(material.name)) : 0);
  m_friction->setValue(material.friction);
  m_density->setValue(material.density);
  m_restitution->setValue(material.restitution);
}

void Properties::take_material(const PhysicsMaterial& material) {
  const auto snapshot = m_document.snapshot();
  std::vector<Operation> operations;
  for (const ObjectId id : m_document.selection().objects)
    if (const ObjectSnapshot* const object = snapshot->find(id))
      operations.push_back(MaterialOperation{(*object)->name, material});
  if (!operations.empty())
    m_document.perform_all(tr("material").toStdString(), std::move(operations));
}

}  // namespace trivet::edit
