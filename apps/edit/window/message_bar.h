// Message bar over the views: asks no questions, blocks no work.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QTimer>
#include <QToolButton>

#include "apps/edit/document/message.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  /// Information disappears after a while; refusals and errors stay until closed or until the next
  /// action.
  void show_message(const Message& message);
  void dismiss();
  /// The height follows from the text.
  void set_width(int width);
  QString text() const { return m_text->text(); }

 Q_SIGNALS:
  void dismissed();

 private:
  void paint();

  Theme m_theme;
  Message::Kind m_kind = Message::Kind::Info;
  QLabel* m_heading;
  QLabel* m_text;
  QTimer m_leave;
};

}  // namespace trivet::edit
