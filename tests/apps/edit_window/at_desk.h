// The editor at work in a test: a document, its window on the screen, and a user before it.
#pragma once

#include <QTemporaryDir>
#include <memory>

#include "apps/edit_window/user.h"

namespace trivet::edit::test {

struct Screen {
  bool german = false, dark = false;
  QSize size{1280, 800};
};

class AtDesk {
 protected:
  /// Settings, caches and recovery are in the folder. @param patience_s  seconds for a model's
  /// file, by the clock; 0: as usual.
  void sit_down(const Screen& screen, double patience_s = 0);
  void get_up();

  QTemporaryDir m_folder;
  std::unique_ptr<Document> m_document;
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<User> m_user;
};

/// The `main` of such a test. Takes --german, --dark and --size 1280x800 from the arguments; others
/// are those of `make` and of Qt Test.
int run_at_desk(
    int argc, char** argv, const char* name,
    const std::function<std::unique_ptr<QObject>(const Screen&, QStringList& arguments)>& make);

}  // namespace trivet::edit::test
