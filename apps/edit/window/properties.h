// Properties of the active object: pose, mass, contacts, stability.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <map>

#include "apps/edit/document/document.h"
#include "apps/edit/document/pose_numbers.h"
#include "apps/edit/window/theme.h"
#include "apps/edit/window/vector_field.h"

namespace trivet::edit {

class Properties : public QScrollArea {
  Q_OBJECT

 public:
  explicit Properties(Document& document, QWidget* parent = nullptr);

 private:
  void show_object();
  void show_pose(const Object& object);
  void show_rest(const Object& object, ObjectId id);
  void lay_out();
  void follow_document();
  void add_pose();
  void add_scale();
  void add_frame();
  const Object* active_object() const;  // null: there is none
  // Another one has the model put anew in its place.
  void take_scale(double metres);
  void take_up(UpAxis up);
  void take_height(double metres);
  void show_frame(const Object& object);
  void stand(PosePart part, int axis, double value);
  void add_joint();
  void show_joint(const Object& object);
  void take_joint(double value);
  void add_material();
  void show_material(const PhysicsMaterial& material);
  /// Makes all selected objects of it, as one step.
  void take_material(const PhysicsMaterial& material);
  void set(const QString& name, const QString& value, const QString& tip = {});

  Document& m_document;
  QLabel* m_name;
  QLabel* m_empty;
  QFormLayout* m_form;
  QWidget* m_content;
  std::map<QString, QLabel*> m_values;
  QWidget* m_joint;
  QSlider* m_joint_slider;
  QDoubleSpinBox* m_joint_value;
  PhysicsMaterial m_material;  // of the active object
  QComboBox* m_preset;
  VectorField *m_position, *m_rotation;
  QDoubleSpinBox *m_scale, *m_height;
  QComboBox *m_unit, *m_up;
  QDoubleSpinBox *m_friction, *m_density, *m_restitution;
};

/// "12.5 mm", "1.25 m"
QString length_text(double metres);

}  // namespace trivet::edit
