// The editor trivet-edit.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QStandardPaths>
#include <iostream>

#include "apps/edit/window/language.h"
#include "apps/edit/window/main_window.h"
#include "core/base/error.h"
#include "core/io/process/freed_memory.h"
#include "core/io/process/standard_streams.h"

namespace {

void name_application() {
  QCoreApplication::setOrganizationName("trivet");
  QCoreApplication::setApplicationName("trivet-edit");
  QCoreApplication::setApplicationVersion(TRIVET_VERSION);
}

void add_options(QCommandLineParser& parser) {
  parser.setApplicationDescription("Lays out 3D objects without interpenetration, at rest.");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("file", "A scene (.glb), a layout (.json), or a model to import",
                               "[FILE]");
  parser.addOption({"demo", "Opens a demo: spoon-saucer, breakfast, office1, office2", "name"});
  parser.addOption({"backend",
                    "Who finds what stops a motion: auto, bvh, software or gpu; results do not "
                    "depend on it",
                    "name"});
  parser.addOption({"perfect-friction",
                    "Settles with nearly perfect friction, each object alone, as the paper does"});
  parser.addOption({"objects-alone",
                    "Settles each object on what stands still, whether the whole stands or not"});
  parser.addOption(
      {"language", "Of the windows: en or de; otherwise as chosen, or the system's", "code"});
  parser.addOption({"gpu-method", "How a GPU does it: auto, framebuffer or compute", "name"});
  parser.addOption(
      {"gpu-lists", "Who lists faces in its pixels in doubt: auto, gpu or software", "name"});
}

// Help, version and a language that is none need no display.
void answer_without_display(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  name_application();
  QCommandLineParser parser;
  add_options(parser);
  QStringList given;
  for (int i = 0; i < argc; ++i) given << QString::fromLocal8Bit(argv[i]);
  const bool is_known = parser.parse(given);
  const bool asks = is_known && (parser.isSet("help") || parser.isSet("version"));
  if (asks || given.contains("--help-all")) parser.process(application);
  if (is_known && parser.isSet("language")) trivet::edit::check_language(parser.value("language"));
}

int run(int argc, char** argv) {
  answer_without_display(argc, argv);
  QApplication application(argc, argv);
  name_application();
  QApplication::setWindowIcon(trivet::edit::application_icon());
  QCommandLineParser parser;
  add_options(parser);
  parser.process(application);
  trivet::edit::speak(application, parser.isSet("language") ? parser.value("language")
                                                            : trivet::edit::saved_language());
  QString note;
  trivet::edit::DetectionChoice detection = trivet::edit::saved_detection(&note);
  if (parser.isSet("backend")) detection.backend = parser.value("backend");
  if (parser.isSet("gpu-method")) detection.gpu_method = parser.value("gpu-method");
  if (parser.isSet("gpu-lists")) detection.gpu_lists = parser.value("gpu-lists");
  trivet::edit::DocumentOptions options;
  options.version = TRIVET_VERSION;
  options.detection = trivet::edit::backend_options(detection);
  if (parser.isSet("perfect-friction")) options.rules.perfect_friction = true;
  if (parser.isSet("objects-alone")) options.rules.whole_at_rest = false;
  options.recovery_folder =
      QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString();
  QDir().mkpath(QString::fromStdString(options.recovery_folder));
  trivet::edit::Document document(options);
  trivet::edit::MainWindow window(document, detection);
  window.show();
  if (!note.isEmpty()) window.show_note(note);
  if (parser.isSet("demo"))
    window.open_demo(parser.value("demo"));
  else if (!parser.positionalArguments().isEmpty())
    window.open_file(parser.positionalArguments().front());
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  trivet::open_standard_streams();
  trivet::keep_freed_memory();
  try {
    return run(argc, argv);
  } catch (const trivet::Error& error) {
    std::cerr << "trivet-edit: " << error.what() << "\n";
    return error.kind() == trivet::Error::Kind::BadInput ? 2 : 3;
  } catch (const std::exception& error) {
    std::cerr << "trivet-edit: " << error.what() << "\n";
    return 3;
  }
}
