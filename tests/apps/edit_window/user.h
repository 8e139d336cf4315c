// Somebody who clicks and drags in the editor's window, as a user does: events go to the window of
// the window system, and find the widget that is there.
#pragma once

#include <QDir>
#include <QTest>

#include "apps/edit/window/main_window.h"

namespace trivet::edit::test {

class User {
 public:
  /// @param pictures  folder that keeps what was seen.
  User(Document& document, MainWindow& window, const QString& pictures);

  void press_key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  void click(QWidget& widget, const QPoint& at, Qt::KeyboardModifiers modifiers = {});
  void click(QWidget& widget) { click(widget, widget.rect().center()); }
  /// The left button, in small steps.
  void drag(QWidget& widget, const QPoint& from, const QPoint& to);
  void move_to(QWidget& widget, const QPoint& at);
  // The same, one by one, without waiting.
  void press(QWidget& widget, const QPoint& at, Qt::MouseButton button);
  void send_move(QWidget& widget, const QPoint& at);
  void release(QWidget& widget, const QPoint& at, Qt::MouseButton button);
  /// In a view, where a point of the world is seen.
  QPoint pixel(WindowKind kind, const Vec3& world);
  /// In a view, where an object is seen, far from its centre of mass.
  QPoint pixel_on(const std::string& name, WindowKind kind);
  void click(WindowKind kind, const Vec3& world);
  void drag(WindowKind kind, const Vec3& from, const Vec3& to);
  void take(const QString& tool);  // a button of the tool bar
  void select(const std::string& name, Qt::KeyboardModifiers modifiers = {});  // in the outliner
  void show_tab(const QString& title);  // of the control window

  /// Until the document is idle and all views show it. @return whether it came so far.
  bool wait(int timeout_ms = 120000);
  /// Keeps what the screen shows.
  QImage look(const QString& name);

  /// Files from a file manager; `then` runs when a dialog has come up.
  void drop(const QStringList& files, std::function<void(QWidget& dialog)> then);
  /// Does something that opens a dialog, and goes on in it.
  void with_dialog(std::function<void()> open, std::function<void(QWidget& dialog)> then);

  const Object& object(const std::string& name);

 private:
  QPoint in_window(QWidget& widget, const QPoint& at) { return widget.mapTo(&m_window, at); }

  Document& m_document;
  MainWindow& m_window;
  QDir m_pictures;
  int m_number = 0;
};

}  // namespace trivet::edit::test
