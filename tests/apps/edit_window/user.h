// Simulated user who clicks and drags in the editor's window: events go through the window system's
// window to the widget there.
#pragma once

#include <QDir>
#include <QTest>

#include "apps/edit/window/main_window.h"

namespace trivet::edit::test {

/// Longest wait for anything that has to happen: on a busy machine a window answers late.
inline constexpr int kPatienceMs = 120'000;

class User {
 public:
  /// @param pictures  folder for screenshots.
  User(Document& document, MainWindow& window, const QString& pictures);

  void press_key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  void click(QWidget& widget, const QPoint& at, Qt::KeyboardModifiers modifiers = {});
  void click(QWidget& widget) { click(widget, widget.rect().center()); }
  /// Drags with the left button, in small steps.
  void drag(QWidget& widget, const QPoint& from, const QPoint& to);
  void move_to(QWidget& widget, const QPoint& at);
  // The single steps, without waiting.
  void press(QWidget& widget, const QPoint& at, Qt::MouseButton button);
  void send_move(QWidget& widget, const QPoint& at);
  void release(QWidget& widget, const QPoint& at, Qt::MouseButton button);
  /// Pixel of a world point in a view.
  QPoint pixel(WindowKind kind, const Vec3& world);
  /// Pixel of an object in a view, far from its centre of mass.
  QPoint pixel_on(const std::string& name, WindowKind kind);
  void click(WindowKind kind, const Vec3& world);
  void drag(WindowKind kind, const Vec3& from, const Vec3& to);
  void take(const QString& tool);  // a button of the tool bar
  void select(const std::string& name, Qt::KeyboardModifiers modifiers = {});  // in the outliner
  void show_tab(const QString& title);  // of the control window

  /// Waits until the document is idle and all views show it. @return false on timeout.
  bool wait();
  /// Waits until the drag has followed the last move and the view shows it, as a draft at least.
  /// @return false on timeout, and if there is no drag.
  bool wait_for_drag(const SceneView& view);
  /// Saves and returns a screenshot.
  QImage look(const QString& name);
  QString pictures() const { return m_pictures.path(); }  // their folder

  /// Imports a file as an object of this name; not placed unless it is put at a position.
  void import_model(const QString& file, const std::string& name,
                    const std::optional<Vec3>& put = {}, bool fixed = false);
  /// Into the outliner's field for a name, which has to be open; ends with Return.
  void enter_name(const QString& name);

  /// Drops files from a file manager; `then` runs when a dialog has opened.
  void drop(const QStringList& files, std::function<void(QWidget& dialog)> then);
  /// Opens a dialog by `open` and continues in it.
  void with_dialog(std::function<void()> open, std::function<void(QWidget& dialog)> then);

  const Object& object(const std::string& name);

  // Any window: a dialog, a menu.
  void click_in(QWidget& widget, const QPoint& at);
  void type(QWidget& widget, const QString& text);
  void press_key_in(QWidget& widget, Qt::Key key, Qt::KeyboardModifiers modifiers = {});
  /// By two clicks, from the menu bar.
  void choose(const QString& action);

  /// Effort of the hand. A drag counts once, a key with its modifiers once.
  struct Effort {
    int clicks = 0, drags = 0, keys = 0;
  };
  const Effort& effort() const { return m_effort; }

 private:
  QPoint in_window(QWidget& widget, const QPoint& at) { return widget.mapTo(&m_window, at); }

  Document& m_document;
  MainWindow& m_window;
  QDir m_pictures;
  int m_number = 0;
  Effort m_effort;
};

}  // namespace trivet::edit::test
