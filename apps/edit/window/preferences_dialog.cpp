#include "apps/edit/window/preferences_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>

#include "apps/edit/window/language.h"

namespace trivet::edit {

PreferencesDialog::PreferencesDialog(Document& document, const EditorDetection& choice,
                                     const SnapSteps& steps, QWidget* parent)
    : QDialog(parent), m_document(document), m_device(choice.device), m_answering(new QLabel) {
  setWindowTitle(tr("Preferences"));
  m_backend = make_box("backend",
                       {{"auto", tr("Automatic: the fastest here")},
                        {"bvh", tr("BVHs")},
                        {"software", tr("z-lists in software")},
                        {"gpu", tr("z-lists on the graphics card")}},
                       choice.backend);
  m_method = make_box("gpu_method",
                      {{"auto", tr("Automatic: the faster one")},
                       {"framebuffer", tr("Framebuffers")},
                       {"compute", tr("Compute shaders")}},
                      choice.gpu_method);
  m_grid =
      make_step("grid step", 1000 * steps.grid, 1000 * kLeastGrid, 1000 * kLargestGrid, tr(" mm"));
  m_angle = make_step("angle step", steps.angle_deg, kLeastAngle, kLargestAngle, tr("°"));
  auto* const form = new QFormLayout(this);
  form->setContentsMargins(20, 20, 20, 14);
  form->setVerticalSpacing(10);
  auto* const snapping = new QLabel(tr("Steps of drags while the magnet or Control is on."));
  snapping->setWordWrap(true);
  form->addRow(snapping);
  form->addRow(tr("Grid"), m_grid);
  form->addRow(tr("Angles"), m_angle);
  auto* const about = new QLabel(tr(
      "Method that finds what stops a motion. Results are the same with all of them, to the bit."));
  about->setWordWrap(true);
  form->addRow(about);
  form->addRow(tr("Collision detection"), m_backend);
  form->addRow(tr("On the graphics card by"), m_method);
  form->addRow(tr("Language"), make_languages());
  m_answering->setObjectName("faint");
  m_answering->setWordWrap(true);
  form->addRow(m_answering);
  auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  form->addRow(buttons);
  setMinimumWidth(460);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&m_document, &Document::detection_changed, this, &PreferencesDialog::show_answering);
  show_answering();
}

QComboBox* PreferencesDialog::make_languages() {
  auto* const box = new QComboBox;
  box->setObjectName("language");
  box->setToolTip(tr("From the next start on"));
  box->addItem(tr("As the system"), QString());
  for (const Language& language : languages()) box->addItem(language.name, language.code);
  box->setCurrentIndex(std::max(0, box->findData(saved_language())));
  connect(box, &QComboBox::activated, this,
          [box] { save_language(box->currentData().toString()); });
  return box;
}

QComboBox* PreferencesDialog::make_box(const char* name,
                                       std::initializer_list<std::pair<const char*, QString>> items,
                                       const QString& current) {
  auto* const box = new QComboBox;
  box->setObjectName(name);
  for (const auto& [key, text] : items) box->addItem(text, QString(key));
  box->setCurrentIndex(std::max(0, box->findData(current)));
  connect(box, &QComboBox::activated, this, [this] {
    m_method->setEnabled(choice().backend != "bvh" && choice().backend != "software");
    Q_EMIT detection_chosen(choice());
  });
  return box;
}

QDoubleSpinBox* PreferencesDialog::make_step(const char* name, double value, double least,
                                             double largest, const QString& unit) {
  auto* const box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(least, largest);
  box->setDecimals(2);
  box->setSuffix(unit);
  box->setValue(value);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
    Q_EMIT steps_chosen({0.001 * m_grid->value(), m_angle->value()});
  });
  return box;
}

EditorDetection PreferencesDialog::choice() const {
  return {m_backend->currentData().toString(), m_method->currentData().toString(), m_device};
}

void PreferencesDialog::show_answering() {
  const Detection& now = m_document.detection();
  m_method->setEnabled(choice().backend != "bvh" && choice().backend != "software");
  m_answering->setText(
      tr("Answering now: %1; previews: %2").arg(in_words(now.moves), in_words(now.previews)));
}

}  // namespace trivet::edit
