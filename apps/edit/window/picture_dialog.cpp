#include "apps/edit/window/picture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QSpinBox>
#include <algorithm>
#include <map>

#include "apps/edit/document/words.h"
#include "core/base/image.h"
#include "core/picture/png.h"
#include "gpu/egl/context.h"
#include "gpu/egl/graphics_hardware.h"
#include "raster/path/picture.h"

namespace trivet::edit {
namespace {

struct Cancelled {};

}  // namespace

PictureJob::PictureJob(LiveScene scene, Camera camera, PictureOptions options, const QString& file,
                       QObject* parent)
    : QObject(parent),
      m_scene(std::move(scene)),
      m_camera(camera),
      m_options(std::move(options)),
      m_file(file) {
  m_options.progress = [this](double fraction) {
    if (m_cancelled) throw Cancelled{};
    Q_EMIT progressed(static_cast<int>(100 * fraction));
  };
  m_thread = std::thread([this] { run(); });
}

PictureJob::~PictureJob() {
  m_cancelled = true;
  m_thread.join();
}

void PictureJob::run() {
  try {
    std::map<const Model*, PictureMesh> meshes;  // node-based: stable addresses
    PictureScene picture;
    picture.floor = m_scene.floor;
    for (const LiveObject& object : m_scene.objects) {
      if (object.opacity < 1) continue;
      const auto [it, is_new] = meshes.try_emplace(object.model.get());
      if (is_new) it->second = picture_mesh(*object.model);
      picture.objects.push_back({&it->second, object.world_from_object, std::nullopt});
    }
    write_png(rendered(picture), m_file.toStdString());
    Q_EMIT done(true, tr("Picture written: %1").arg(m_file));
  } catch (const Cancelled&) {
    Q_EMIT done(false, QString());
  } catch (const std::exception& error) {
    Q_EMIT done(false, QString::fromStdString(in_words(error)));
  }
}

// OpenGL on graphics hardware; elsewhere rays, which are faster and need half the samples.
Image PictureJob::rendered(const PictureScene& picture) {
  if (graphics_hardware().empty()) {
    m_options.samples = std::max(m_options.samples / 2, 1);
    return trace_picture(picture, m_camera, m_options);
  }
  EglContext context;
  return render_picture(context, picture, m_camera, m_options);
}

std::optional<PictureWish> ask_for_picture(QWidget* parent, const QString& folder) {
  QDialog dialog(parent);
  dialog.setWindowTitle(QObject::tr("Picture"));
  QFormLayout form(&dialog);
  form.setContentsMargins(16, 16, 16, 12);
  QSpinBox width, height;
  for (QSpinBox* const box : {&width, &height}) {
    box->setRange(16, 16384);
    box->setSuffix(QObject::tr(" pixels"));
  }
  width.setValue(1920), height.setValue(1080);
  QComboBox quality;
  quality.addItem(QObject::tr("Draft"), 8);
  quality.addItem(QObject::tr("Clean"), 32);
  quality.addItem(QObject::tr("Print"), 128);
  quality.setCurrentIndex(1);
  QCheckBox transparent(QObject::tr("Transparent background"));
  QDialogButtonBox buttons(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  form.addRow(QObject::tr("Width"), &width);
  form.addRow(QObject::tr("Height"), &height);
  form.addRow(QObject::tr("Quality"), &quality);
  form.addRow(&transparent);
  form.addRow(&buttons);
  QObject::connect(&buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(&buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  QString file = QFileDialog::getSaveFileName(parent, QObject::tr("Save picture"),
                                              folder + "/scene.png", QObject::tr("PNG (*.png)"));
  if (file.isEmpty()) return std::nullopt;
  if (!file.endsWith(".png", Qt::CaseInsensitive)) file += ".png";
  return PictureWish{file, width.value(), height.value(), quality.currentData().toInt(),
                     transparent.isChecked()};
}

}  // namespace trivet::edit
