#include "apps/edit/window/asset_browser.h"

#include <QAbstractItemView>
#include <QDir>
#include <QDrag>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMimeData>
#include <QPainter>
#include <QPixmap>
#include <QScrollBar>
#include <QSettings>
#include <QShowEvent>
#include <QSignalBlocker>
#include <QStringList>
#include <QUrl>
#include <QVBoxLayout>
#include <QVariant>

#include "apps/edit/window/icons.h"
#include "apps/edit/window/units.h"

namespace trivet::edit {
namespace {

constexpr int kModelRole = Qt::UserRole;
constexpr int kIconPx = 88, kCellPx = 108;
constexpr int kRoomPx = 12, kDragPx = 32;
constexpr int kSettleMs = 80;  // after scrolling, until pictures are asked for

Asset asset_of(const QString& file, const AssetInfo& info, const FolderChoice& chosen) {
  return {file, chosen.metres > 0 ? chosen.metres : info.metres, chosen.up.value_or(info.up)};
}

/// With a row for each fact.
QString facts_text(const QString& file, const AssetInfo& info) {
  return QStringList{file, size_text(info), up_text(info), notes_text(info).join('\n')}
      .join('\n')
      .trimmed();
}

/// The same where the item is selected: its background stays as it is.
QIcon steady_icon(Icon icon, const QColor& colour) {
  return make_icon(icon, colour).pixmap(kIconPx);
}

}  // namespace

QMimeData* AssetList::mimeData(const QList<QListWidgetItem*>& items) const {
  QList<QUrl> urls;
  for (const QListWidgetItem* const item : items)
    urls << QUrl::fromLocalFile(item->data(kModelRole).toString());
  auto* const mime = new QMimeData;
  mime->setUrls(urls);
  mime->setData(kAssetsMime, "models");
  return mime;
}

// With a small picture: over a view the ghost of the model shows where it will be.
void AssetList::startDrag(Qt::DropActions actions) {
  const QList<QListWidgetItem*> items = selectedItems();
  if (items.isEmpty()) return;
  auto* const drag = new QDrag(this);
  drag->setMimeData(mimeData(items));
  drag->setPixmap(items.front()->icon().pixmap(kDragPx));
  drag->setHotSpot(QPoint(-kDragPx / 2, -kDragPx / 2));
  drag->exec(actions);
}

void AssetList::explain(const QString& text) {
  m_explanation = text;
  viewport()->update();
}

void AssetList::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  if (count() > 0) return;
  QPainter painter(viewport());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const QRect room = viewport()->rect().adjusted(kRoomPx, kRoomPx, -kRoomPx, -kRoomPx);
  painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, m_explanation);
}

AssetBrowser::AssetBrowser(const QString& cache, const ImportLimits& limits, QWidget* parent)
    : QWidget(parent),
      m_thumbnails(cache, AssetThumbnails::quick(limits)),
      m_folders(new QComboBox),
      m_unit(new QComboBox),
      m_search(new QLineEdit),
      m_add(new QToolButton),
      m_forget(new QToolButton),
      m_list(new AssetList) {
  make_widgets();
  m_scrolled.setSingleShot(true);
  m_scrolled.setInterval(kSettleMs);
  connect(&m_scrolled, &QTimer::timeout, this, &AssetBrowser::want_seen);
  connect(m_list->verticalScrollBar(), &QScrollBar::valueChanged, &m_scrolled,
          qOverload<>(&QTimer::start));
  connect(&m_thumbnails, &AssetThumbnails::listed, this, &AssetBrowser::fill);
  connect(&m_thumbnails, &AssetThumbnails::made, this, &AssetBrowser::show_made);
  connect(&m_thumbnails, &AssetThumbnails::dropped, this, &AssetBrowser::show_file);
  connect(m_add, &QToolButton::clicked, this, &AssetBrowser::ask_folder);
  connect(m_forget, &QToolButton::clicked, this, &AssetBrowser::forget_folder);
  connect(m_search, &QLineEdit::textChanged, this, &AssetBrowser::filter);
  connect(m_list, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
    with_asset(item->data(kModelRole).toString(),
               [this](const Asset& asset) { Q_EMIT put_wanted(asset); });
  });
  for (const QString& folder : QSettings().value("assets/folders").toStringList())
    m_folders->addItem(QDir(folder).dirName(), folder);
  m_folders->setCurrentIndex(
      std::max(0, m_folders->findData(QSettings().value("assets/folder").toString())));
  connect(m_folders, &QComboBox::currentIndexChanged, this, &AssetBrowser::show_folder);
  connect(m_unit, &QComboBox::currentIndexChanged, this,
          [this] { choose_unit(m_unit->currentData().toDouble()); });
}

void AssetBrowser::make_widgets() {
  m_folders->setObjectName("asset folders");
  m_folders->setMinimumContentsLength(14);
  m_folders->setToolTip(tr("Folder of models, with those below it"));
  m_add->setText(tr("Add folder…"));
  m_add->setObjectName("add folder");
  m_forget->setText(tr("Forget"));
  m_forget->setToolTip(tr("Take this folder out of the list; its files stay"));
  m_search->setObjectName("asset search");
  m_search->setPlaceholderText(tr("Search models"));
  m_search->setClearButtonEnabled(true);
  m_unit->setObjectName("asset unit");
  m_unit->setToolTip(tr("Unit of the files in this folder"));
  m_unit->addItem(tr("Unit: likely"), 0.0);
  for (const LengthUnit& unit : length_units())
    m_unit->addItem(tr("Unit: %1").arg(unit.name), unit.metres);
  m_list->setObjectName("assets");
  m_list->setViewMode(QListView::IconMode);
  m_list->setResizeMode(QListView::Adjust);
  m_list->setMovement(QListView::Static);
  m_list->setUniformItemSizes(true);
  m_list->setIconSize(QSize(kIconPx, kIconPx));
  m_list->setGridSize(QSize(kCellPx, kCellPx + 4));
  m_list->setWordWrap(false);
  m_list->setTextElideMode(Qt::ElideMiddle);
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_list->setDragDropMode(QAbstractItemView::DragOnly);
  m_list->setToolTip(tr("Drag a model into a view, or double click to take it in hand"));
  auto* const row = new QHBoxLayout;
  for (QWidget* const widget :
       std::initializer_list<QWidget*>{m_folders, m_add, m_forget, m_unit, m_search})
    row->addWidget(widget, widget == m_search ? 1 : 0);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(4);
  column->addLayout(row);
  column->addWidget(m_list, 1);
}

void AssetBrowser::set_theme(const Theme& theme) {
  m_theme = theme;
  for (QListWidgetItem* const item : m_items) show_item(*item);
}

// --- folders -----------------------------------------------------------------------------------

void AssetBrowser::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!m_listed) show_folder();
}

void AssetBrowser::save_folders() const {
  QStringList all;
  for (int i = 0; i < m_folders->count(); ++i) all << m_folders->itemData(i).toString();
  QSettings().setValue("assets/folders", all);
}

void AssetBrowser::ask_folder() {
  const QString folder = QFileDialog::getExistingDirectory(
      this, tr("Folder of models"), QSettings().value("files/models").toString());
  if (!folder.isEmpty()) add_folder(folder);
}

void AssetBrowser::add_folder(const QString& folder) {
  const QString whole = QDir(folder).absolutePath();
  int index = m_folders->findData(whole);
  if (index < 0) {
    const QSignalBlocker blocker(m_folders);
    index = m_folders->count();
    m_folders->addItem(QDir(whole).dirName(), whole);
    m_folders->setCurrentIndex(-1);
  }
  save_folders();
  m_folders->setCurrentIndex(index);
}

void AssetBrowser::forget_folder() {
  FolderChoice().remember(folder());
  m_folders->removeItem(m_folders->currentIndex());
  save_folders();
  if (m_folders->count() == 0) show_folder();
}

void AssetBrowser::choose_unit(double metres) {
  FolderChoice choice = FolderChoice::of(folder());
  choice.metres = metres;
  choice.remember(folder());
}

void AssetBrowser::show_folder() {
  m_listed = true;
  m_list->clear();
  m_items.clear();
  want_seen();
  const bool has_one = !folder().isEmpty();
  m_forget->setEnabled(has_one), m_unit->setEnabled(has_one), m_search->setEnabled(has_one);
  m_list->explain(has_one ? tr("There are no models in this folder and those below it, or they are "
                               "still being listed.")
                          : tr("Add a folder of models (.glb, .gltf, .obj, .stl, .ply, ...). Then "
                               "drag them from here into a view, or double click one to take it "
                               "in hand."));
  if (!has_one) return;
  QSettings().setValue("assets/folder", folder());
  const QSignalBlocker blocker(m_unit);
  const int unit = m_unit->findData(FolderChoice::of(folder()).metres);
  m_unit->setCurrentIndex(std::max(0, unit));
  m_folders->setToolTip(folder());
  m_thumbnails.list(folder());
}

void AssetBrowser::fill(const QString& folder, const QStringList& files) {
  if (folder != this->folder()) return;
  m_list->clear();
  m_items.clear();
  for (const QString& file : files) {
    auto* const item = new QListWidgetItem(QFileInfo(file).completeBaseName(), m_list);
    item->setData(kModelRole, file);
    item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    item->setSizeHint(m_list->gridSize());  // with room for the picture, which comes later
    m_items[file] = item;
    show_item(*item);
  }
  filter();
}

// --- items -------------------------------------------------------------------------------------

void AssetBrowser::show_item(QListWidgetItem& item) {
  const QString file = item.data(kModelRole).toString();
  const AssetInfo* const info = m_thumbnails.find(file);
  const bool is_bad = info && !info->error.empty();
  if (is_bad)
    item.setIcon(steady_icon(Icon::Invalid, m_theme.refused()));
  else if (info && !info->picture.isNull())
    item.setIcon(QPixmap::fromImage(info->picture));
  else
    item.setIcon(steady_icon(Icon::Import, m_theme.faint_text()));
  item.setData(Qt::ForegroundRole, is_bad ? QVariant(m_theme.refused()) : QVariant());
  item.setToolTip(is_bad ? notes_text(*info).join('\n') : info ? facts_text(file, *info) : file);
}

void AssetBrowser::show_file(const QString& file) {
  if (QListWidgetItem* const item = m_items.value(file)) show_item(*item);
}

void AssetBrowser::show_made(const QString& file) {
  show_file(file);
  const AssetInfo* const known = m_thumbnails.find(file);
  const auto waiting = m_waiting.extract(file);
  if (waiting.empty() || !known) return;
  const AssetInfo info = *known;
  if (!info.error.empty()) return Q_EMIT refused(notes_text(info).join('\n'));
  for (const Waiting& one : waiting.mapped()) one.then(asset_of(file, info, one.chosen));
}

// A bad one is read again: there may have been no time for it, or it may have been mended.
void AssetBrowser::with_asset(const QString& file, std::function<void(const Asset&)> then) {
  const FolderChoice chosen{m_unit->currentData().toDouble(), FolderChoice::up_of(file, folder())};
  const AssetInfo* const info = m_thumbnails.find(file);
  if (info && info->error.empty() && m_thumbnails.is_current(file))
    return then(asset_of(file, *info, chosen));
  m_thumbnails.forget(file);
  m_waiting[file].push_back({chosen, std::move(then)});
  want_seen();
}

void AssetBrowser::filter() {
  for (QListWidgetItem* const item : m_items)
    item->setHidden(!item->text().contains(m_search->text(), Qt::CaseInsensitive));
  m_scrolled.start();
}

// Thumbnails that are waited for come first, then the visible ones, then the rest.
void AssetBrowser::want_seen() {
  QStringList first, seen, rest;
  for (const auto& [file, then] : m_waiting) first << file;
  const QRect window = m_list->viewport()->rect();
  for (int row = 0; row < m_list->count(); ++row) {
    const QListWidgetItem* const item = m_list->item(row);
    if (m_waiting.count(item->data(kModelRole).toString())) continue;
    const bool is_seen = !item->isHidden() && m_list->visualItemRect(item).intersects(window);
    (is_seen ? seen : rest) << item->data(kModelRole).toString();
  }
  m_thumbnails.want(first + seen, rest);
}

}  // namespace trivet::edit
