// Set dressing by hand in a real window under a window system: what each job takes of clicks, drags
// and keys. Screenshots are kept.
#pragma once

#include "apps/edit_by_hand/jobs.h"
#include "apps/edit_window/at_desk.h"

namespace trivet::edit::test {

class TestByHand : public QObject, AtDesk {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();     // NOLINT(readability-identifier-naming): Qt's
  void cleanupTestCase();  // NOLINT(readability-identifier-naming): Qt's
  void cleanup();
  void lays_breakfast() { lay_breakfast(*m_work); }
  void moves_the_saucer() { move_the_saucer(*m_work); }
  void pours_fruit() { pour_fruit(*m_work); }
  void lays_mug() { lay_mug(*m_work); }
  void mends_unit() { mend_unit(*m_work); }
  void moves_desk() { move_desk(*m_work); }
  void furnishes_office() { furnish_office(*m_work); }
  void fills_bookshelf() { fill_bookshelf(*m_work); }
  void finds_action() { find_action(*m_work); }
  void edits_and_returns() { edit_and_return(*m_work); }

 private:
  void export_demo(const QString& name);

  std::unique_ptr<AtWork> m_work;
};

}  // namespace trivet::edit::test
