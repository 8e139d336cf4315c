// The editor trivet-edit.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QStandardPaths>
#include <iostream>

#include "apps/edit/window/main_window.h"
#include "core/base/standard_streams.h"

int main(int argc, char** argv) {
  trivet::open_standard_streams();
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName("trivet");
  QCoreApplication::setApplicationName("trivet-edit");
  QCoreApplication::setApplicationVersion(TRIVET_VERSION);
  QCommandLineParser parser;
  parser.setApplicationDescription("Lays out 3D objects without interpenetration, at rest.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("file", "A scene (.glb), a layout (.json), or a model to import",
                               "[FILE]");
  parser.addOption({"demo", "Opens a demo: spoon-saucer, breakfast, office1, office2", "name"});
  parser.process(application);
  try {
    trivet::edit::DocumentOptions options;
    options.version = TRIVET_VERSION;
    options.recovery_folder =
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString();
    QDir().mkpath(QString::fromStdString(options.recovery_folder));
    trivet::edit::Document document(options);
    trivet::edit::MainWindow window(document);
    window.show();
    if (parser.isSet("demo"))
      window.open_demo(parser.value("demo"));
    else if (!parser.positionalArguments().isEmpty())
      window.open_file(parser.positionalArguments().front());
    return QApplication::exec();
  } catch (const std::exception& error) {
    std::cerr << "trivet-edit: " << error.what() << "\n";
    return 3;
  }
}
