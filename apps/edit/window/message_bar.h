// What the editor has to say, over the views: never a question, never in the way.
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
  /// Information goes by itself, after a while; refusals and errors stay until they are closed or
  /// something is done.
  void show_message(const Message& message);
  void dismiss();
  /// As high as its text then needs.
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
