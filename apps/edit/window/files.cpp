// File actions of the main window: open, save, import, export.
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
#include <QStringList>

#include "apps/edit/window/asset_facts.h"
#include "apps/edit/window/import_dialog.h"
#include "apps/edit/window/main_window.h"
#include "ops/files/report/scene_file.h"
#include "ops/simulation/scene_formats.h"

namespace trivet::edit {
namespace {

constexpr int kMostRecent = 10;

/// Folder of the last file; else the user's documents, or the home folder.
QString usual_folder() {
  const QString last = QSettings().value("files/folder").toString();
  for (const QString& folder :
       {last, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)})
    if (!folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
  return QDir::homePath();
}

/// The formats of the command line: all of them, then each.
QStringList export_filters() {
  QStringList all, out;
  for (const SceneFormat& format : scene_formats()) {
    QStringList patterns;
    for (const std::string& extension : format.extensions)
      patterns << "*" + QString::fromStdString(extension);
    all << patterns;
    const QString what =
        format.kind == SceneFormat::Kind::Simulator ? MainWindow::tr("%1, for simulators")
        : format.kind == SceneFormat::Kind::Table   ? MainWindow::tr("%1, a table of poses")
                                                    : QString("%1");
    out << what.arg(QString::fromStdString(format.name)) + " (" + patterns.join(' ') + ")";
  }
  out.prepend(MainWindow::tr("All formats") + " (" + all.join(' ') + ")");
  return out;
}

bool is_scene_or_layout(const QString& file) {
  if (file.endsWith(".json", Qt::CaseInsensitive)) return true;
  if (!file.endsWith(".glb", Qt::CaseInsensitive)) return false;
  try {
    return is_scene_file(file.toStdString());
  } catch (const std::exception&) {
    return true;  // opening reports the error
  }
}

}  // namespace

void MainWindow::say(Message::Kind kind, const QString& text) {
  Message message;
  message.kind = kind;
  message.text = text.toStdString();
  show_workspace();
  m_workspace->show_message(message);
}

/// @return whether the user was asked, or did not need to be: then() runs, now or later.
bool MainWindow::may_lose_work(std::function<void()> then) {
  if (!m_document.is_modified()) {
    then();
    return true;
  }
  QMessageBox box(QMessageBox::Question, tr("Unsaved work"),
                  tr("Save the changes to %1?").arg(QString::fromStdString(m_document.title())),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      save(std::move(then));
      return true;
    case QMessageBox::Discard:
      then();
      return true;
    default:
      return false;
  }
}

void MainWindow::new_scene() {
  may_lose_work([this] {
    when_finished(m_document.new_scene(), [this](bool) {
      m_workspace->frame_next_scene();
      show_workspace();
    });
  });
}

void MainWindow::open_file(const QString& file) {
  if (!is_scene_or_layout(file)) return import_files({file});
  may_lose_work([this, file] {
    show_workspace();
    when_finished(m_document.open(file.toStdString()), [this, file](bool ok) {
      if (ok) remember_file(file);
    });
  });
}

void MainWindow::open_demo(const QString& name) {
  may_lose_work([this, name] {
    show_workspace();
    const Document::Job job = m_document.open_demo(name.toStdString());
    when_finished(job, [this](bool ok) {
      if (!ok || m_document.wishes().empty()) return;
      m_arrange_dock->show();
      m_document.request_layout(m_document.wishes().seed(), false);
    });
  });
}

void MainWindow::ask_open() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open"), usual_folder(), tr("Scenes and layouts (*.glb *.json);;All files (*)"));
  if (!file.isEmpty()) open_file(file);
}

void MainWindow::save(std::function<void()> then) {
  if (m_document.file().empty()) return save_as(std::move(then));
  when_finished(m_document.save(), [this, then = std::move(then)](bool ok) {
    if (ok && !then)
      say(Message::Kind::Info, tr("Saved: %1").arg(QString::fromStdString(m_document.file())));
    if (ok && then) then();
  });
}

/// Proposal: beside the scene's file, else where the last one was; by its name or title.
QString MainWindow::file_to_save(const QString& extension) const {
  const QString title = QString::fromStdString(m_document.title());
  const QString stem = title == "Untitled" ? tr("scene") : QFileInfo(title).completeBaseName();
  const QString own = QString::fromStdString(m_document.file());
  const QString folder = own.isEmpty() ? usual_folder() : QFileInfo(own).absolutePath();
  return QDir(folder).filePath(stem + "." + extension);
}

void MainWindow::save_as(std::function<void()> then) {
  QString file = QFileDialog::getSaveFileName(this, tr("Save as"), file_to_save("glb"),
                                              tr("Scene (*.glb);;Layout (*.json)"));
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += ".glb";
  when_finished(m_document.save_as(file.toStdString()),
                [this, file, then = std::move(then)](bool ok) {
                  if (!ok) return;
                  remember_file(file);
                  if (then)
                    then();
                  else
                    say(Message::Kind::Info, tr("Saved: %1").arg(file));
                });
}

void MainWindow::ask_export() {
  QString chosen;
  QString file = QFileDialog::getSaveFileName(this, tr("Export"), file_to_save("obj"),
                                              export_filters().join(";;"), &chosen);
  if (file.isEmpty()) return;
  // Without an extension, the first one of the chosen kind.
  if (QFileInfo(file).suffix().isEmpty())
    file += "." + chosen.section("*.", 1, 1).section(QRegularExpression("[ )]"), 0, 0);
  when_finished(m_document.export_to(file.toStdString()), [this, file](bool ok) {
    if (ok) say(Message::Kind::Info, tr("Exported: %1").arg(file));
  });
}

void MainWindow::ask_import() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Import models"), QSettings().value("files/models").toString(),
      ImportDialog::filter());
  if (files.isEmpty()) return;
  QSettings().setValue("files/models", QFileInfo(files.front()).path());
  import_files(files);
}

void MainWindow::import_files(const QStringList& files) {
  ImportDialog dialog(files, picture_cache(), m_document.import_limits(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  dialog.remember_choices();
  show_workspace();
  m_imports.add(dialog.models());
}

void MainWindow::connect_imports() {
  connect(&m_imports, &ImportQueue::last_imported, this, [this] { take_tool(ToolKind::Put); });
  connect(&m_imports, &ImportQueue::some_refused, this, [this](const QStringList& files) {
    say(Message::Kind::Error,
        tr("%n models were not imported: %1", nullptr, static_cast<int>(files.size()))
            .arg(files.join(", ")));
  });
}

void MainWindow::ask_picture() {
  const auto wish = ask_for_picture(this, usual_folder());
  if (!wish || m_picture) return;
  PictureOptions options;
  options.width = wish->width, options.height = wish->height, options.samples = wish->samples;
  if (wish->transparent) options.background = {1, 1, 1, 0};
  const SceneView& shown = view(WindowKind::Perspective);
  m_picture = std::make_unique<PictureJob>(m_drawing.scene(shown.view()), shown.camera().camera(),
                                           options, wish->file, nullptr);
  const QString what = tr("Picture");
  m_status->show_work(what);
  connect(m_picture.get(), &PictureJob::progressed, this,
          [this, what](int percent) { m_status->show_progress(what, percent, 100); });
  connect(m_picture.get(), &PictureJob::done, this, [this](bool ok, const QString& text) {
    m_picture.reset();
    m_status->show_work({});
    if (!text.isEmpty()) say(ok ? Message::Kind::Info : Message::Kind::Error, text);
  });
}

// --- recent files ------------------------------------------------------------------------------

void MainWindow::remember_file(const QString& file) {
  QSettings settings;
  const QString whole = QFileInfo(file).absoluteFilePath();
  QStringList files = settings.value("files/recent").toStringList();
  files.removeAll(whole);
  files.prepend(whole);
  settings.setValue("files/recent", QStringList(files.mid(0, kMostRecent)));
  settings.setValue("files/folder", QFileInfo(whole).path());
  control().show_files(recent_files());
}

QStringList MainWindow::recent_files() const {
  QStringList there;
  for (const QString& file : QSettings().value("files/recent").toStringList())
    if (QFileInfo::exists(file)) there << file;
  return there;
}

void MainWindow::fill_recent_menu() {
  m_recent_menu->clear();
  for (const QString& file : recent_files())
    m_recent_menu->addAction(QDir::toNativeSeparators(file), [this, file] { open_file(file); });
  if (m_recent_menu->isEmpty()) m_recent_menu->addAction(tr("None"))->setEnabled(false);
}

}  // namespace trivet::edit
