// Preferences: steps of snapping and who answers first-contact queries, at once; the language, at
// the next start.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>

#include "apps/edit/window/detection_choice.h"

namespace trivet::edit {

/// Steps of snapping: metres, degrees.
struct SnapSteps {
  double grid, angle_deg;
};
inline constexpr double kLeastGrid = 1e-4, kLargestGrid = 100;
inline constexpr double kLeastAngle = 0.01, kLargestAngle = 180;

class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param document  tells who answers.
  PreferencesDialog(Document& document, const EditorDetection& choice, const SnapSteps& steps,
                    QWidget* parent);

 Q_SIGNALS:
  void detection_chosen(const trivet::edit::EditorDetection& choice);
  void steps_chosen(const trivet::edit::SnapSteps& steps);

 private:
  QComboBox* make_box(const char* name,
                      std::initializer_list<std::pair<const char*, QString>> items,
                      const QString& current);
  QDoubleSpinBox* make_step(const char* name, double value, double least, double largest,
                            const QString& unit);
  QComboBox* make_languages();
  EditorDetection choice() const;
  void show_answering();

  Document& m_document;
  QComboBox *m_backend, *m_method;
  int m_device;  // of the command line
  QDoubleSpinBox *m_grid, *m_angle;
  QLabel* m_answering;
};

}  // namespace trivet::edit
