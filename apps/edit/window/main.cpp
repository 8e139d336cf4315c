// The editor trivet-edit.
#include <QApplication>
#include <QMainWindow>

#include "apps/edit/document/document.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QCoreApplication::setApplicationName("trivet-edit");
  QCoreApplication::setApplicationVersion(TRIVET_VERSION);
  trivet::edit::Document document({});
  QMainWindow window;
  window.resize(1280, 720);
  window.show();
  return QApplication::exec();
}
