// A view with a title bar; a double click maximises it.
#pragma once

#include <QFrame>
#include <QLabel>

namespace trivet::edit {

/// Any of the four windows.
class ViewFrame : public QFrame {
  Q_OBJECT

 public:
  ViewFrame(const QString& title, QWidget* content, QWidget* parent = nullptr);

  QWidget* content() const { return m_content; }
  /// Adds a widget at the right end of the title.
  void add_to_title(QWidget* widget);
  void set_note(const QString& note);  // beside the title: "along the contact's normal"

 Q_SIGNALS:
  void maximise_wanted();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QWidget* m_bar;
  QWidget* m_content;
  QLabel *m_title, *m_note;
};

}  // namespace trivet::edit
