// On a screen of 1280x800 all is within reach: each dock, tab, tool and dialog, in English and in
// German, whose texts are longer. Screenshots are kept.
//   test_apps_edit_reach [--german] [--dark] [--size 1280x800] [Qt Test's own arguments]
#pragma once

#include "apps/edit_window/at_desk.h"

namespace trivet::edit::test {

class TestReach : public QObject, AtDesk {
  Q_OBJECT

 public:
  explicit TestReach(const Screen& screen) : m_screen(screen) {}

 private Q_SLOTS:
  void initTestCase();     // NOLINT(readability-identifier-naming): Qt's
  void cleanupTestCase();  // NOLINT(readability-identifier-naming): Qt's
  void tells_what_is_cut_off();
  void has_the_start_page();
  void has_docks_tabs_and_tools();
  void has_dialogs();
  void has_imports();
  void has_menus();

 private:
  void check(const QString& where);
  void fail_for_troubles();
  void check_tabs(const QString& where);
  void set_dock(const QString& name, bool shown);

  Screen m_screen;
  QStringList m_troubles;
};

}  // namespace trivet::edit::test
