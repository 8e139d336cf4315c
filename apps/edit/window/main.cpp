// The editor trivet-edit.
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QStandardPaths>
#include <iostream>

#include "apps/detection/detection.h"
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
  parser.addOption(
      {"demo",
       "Opens a demo: spoon-saucer, breakfast, office1, office2, tablecloth, desk, towel, kitchen, "
       "table-for-six, tight-table, bookcase, market, office3, workshop",
       "name"});
  parser.addOption({{"detector", "backend"},
                    "Detector of candidates for contact: auto, bvh, software, gpu, framebuffer or "
                    "compute; results do not depend on it",
                    "name"});
  parser.addOption({"device", "Number of the EGL device for OpenGL, from 1, or auto", "number"});
  parser.addOption({"perfect-friction",
                    "Settles with nearly perfect friction, each object alone, as the paper does"});
  parser.addOption({"objects-alone",
                    "Settles each object on what stands still, whether the whole stands or not"});
  parser.addOption({"robust", "Settles with a reserve of friction, for simulators"});
  parser.addOption({"language",
                    "Language of the windows: en or de; default: the chosen one, else the system's",
                    "code"});
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

// The saved choice, and what the command line says otherwise.
trivet::edit::EditorDetection detection_of(const QCommandLineParser& parser, QString& note) {
  trivet::edit::EditorDetection out = trivet::edit::saved_detection(&note);
  if (parser.isSet("detector")) out.set_detector(parser.value("detector"));
  const bool has_device = parser.isSet("device") && parser.value("device") != "auto";
  out.device = has_device ? trivet::device_from_text(parser.value("device").toStdString())
                          : trivet::usual_device();
  return out;
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
  const trivet::edit::EditorDetection detection = detection_of(parser, note);
  trivet::edit::DocumentOptions options;
  options.version = TRIVET_VERSION;
  options.detection = trivet::edit::backend_options(detection);
  if (parser.isSet("perfect-friction")) options.rules.perfect_friction = true;
  if (parser.isSet("objects-alone")) options.rules.whole_at_rest = false;
  if (parser.isSet("robust")) options.rules.robust = true;
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
