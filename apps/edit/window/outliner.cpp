#include "apps/edit/window/outliner.h"

#include <QAbstractItemView>
#include <QColor>
#include <QFont>
#include <QHeaderView>
#include <QIcon>
#include <QMetaObject>
#include <QSignalBlocker>
#include <QStringList>
#include <QTreeWidgetItemIterator>
#include <algorithm>
#include <map>

#include "apps/edit/window/icons.h"
#include "apps/edit/window/outliner_items.h"

namespace trivet::edit {
namespace {

/// First supporting object of each object, by slot. Supports are never below their loads.
std::map<std::uint32_t, std::uint32_t> supports(const SceneSnapshot& scene) {
  std::map<std::uint32_t, std::uint32_t> out;
  for (const LoadSupport::Entry& entry : scene.support->entries)
    if (!entry.on_floor && !entry.supports.empty())
      out[entry.object.index] = entry.supports.front().index;
  return out;
}

}  // namespace

QIcon state_icon(ObjectState state, const Theme& theme) {
  switch (state) {
    case ObjectState::Unplaced:
      return make_icon(Icon::Unplaced, theme.faint_text());
    case ObjectState::Fixed:
      return make_icon(Icon::Fixed, theme.faint_text());
    case ObjectState::Stable:
      return make_icon(Icon::Stable, QColor(88, 160, 92));
    case ObjectState::Wedged:
      return make_icon(Icon::Wedged, QColor(206, 160, 40));
    case ObjectState::Held:
      return make_icon(Icon::Held, theme.accent());
    case ObjectState::Unsupported:
      return make_icon(Icon::Unsupported, QColor(224, 128, 40));
    case ObjectState::Invalid:
      return make_icon(Icon::Invalid, theme.refused());
  }
  return {};
}

QString state_text(ObjectState state) {
  switch (state) {
    case ObjectState::Unplaced:
      return QObject::tr("unplaced");
    case ObjectState::Fixed:
      return QObject::tr("fixed");
    case ObjectState::Stable:
      return QObject::tr("stable");
    case ObjectState::Wedged:
      return QObject::tr("wedged");
    case ObjectState::Held:
      return QObject::tr("held");
    case ObjectState::Unsupported:
      return QObject::tr("unsupported");
    case ObjectState::Invalid:
      return QObject::tr("invalid");
  }
  return {};
}

Outliner::Outliner(Document& document, QWidget* parent)
    : QTreeWidget(parent), m_document(document) {
  setColumnCount(2);
  setHeaderHidden(true);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setUniformRowHeights(true);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setIndentation(14);
  setDragDropMode(QAbstractItemView::DragDrop);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  setToolTip(
      tr("Objects with their loads, and collections. Double click to frame an object, or to put "
         "one that is not placed yet; drag objects into a collection"));
  connect(&m_document, &Document::snapshot_changed, this, &Outliner::rebuild);
  connect(&m_document, &Document::selection_changed, this, &Outliner::show_selection);
  connect(&m_document, &Document::looks_changed, this, [this] {
    m_committed = 0;
    rebuild();
  });
  connect(this, &QTreeWidget::itemChanged, this,
          [this](const QTreeWidgetItem* item) { take_name(*item); });
  connect(this, &QTreeWidget::itemSelectionChanged, this, &Outliner::take_selection);
  connect(this, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
    const auto id = id_of(*item);
    const ObjectSnapshot* const object = id ? m_document.snapshot()->find(*id) : nullptr;
    if (!object && !collection_of(*item)) return;
    if (!object || (*object)->placed)
      Q_EMIT frame_wanted();
    else
      Q_EMIT put_wanted();
  });
}

void Outliner::set_theme(const Theme& theme) {
  m_theme = theme;
  m_committed = 0;
  rebuild();
}

QTreeWidgetItem* Outliner::add(QTreeWidgetItem* parent, const ObjectSnapshot& object) {
  auto* const item = new QTreeWidgetItem(parent);
  item->setText(0, QString::fromStdString(object->name));
  item->setFlags(item->flags() | Qt::ItemIsEditable);
  item->setData(0, kIdRole, data_of(object.id));
  item->setIcon(0, state_icon(object->state, m_theme));
  QStringList notes;
  if (object->locked) notes << tr("locked");
  const Look look = m_document.looks().of(object.id);
  if (look.hidden) notes << tr("hidden");
  if (look.not_selectable) notes << tr("not selectable");
  if (!object->group.empty()) notes << QString::fromStdString(object->group);
  if (object->state != ObjectState::Stable && object->state != ObjectState::Fixed &&
      object->state != ObjectState::Unplaced)
    notes << state_text(object->state);
  item->setText(1, notes.join(", "));
  item->setForeground(1, m_theme.faint_text());
  return item;
}

void Outliner::rebuild() {
  const auto snapshot = m_document.snapshot();
  if (snapshot->committed == m_committed) return;
  m_committed = snapshot->committed;
  const QSignalBlocker blocker(this);
  clear();
  add_collections(*snapshot);
  add_placed(*snapshot, add_heading(snapshot->floor ? tr("Floor") : tr("Scene")));
  QTreeWidgetItem* unplaced = nullptr;
  for (const ObjectSnapshot& object : snapshot->objects) {
    if (object->placed) continue;
    if (!unplaced) unplaced = add_heading(tr("Not placed yet"));
    add(unplaced, object);
  }
  expandAll();
  show_filter();
  show_selection();
}

// --- search ------------------------------------------------------------------------------------

bool Outliner::is_found(const QTreeWidgetItem& item) const {
  return id_of(item) && item.text(0).contains(m_filter, Qt::CaseInsensitive);
}

/// @return whether it, or one below it, is shown.
bool Outliner::filter(QTreeWidgetItem& item) {
  bool shown = is_found(item);
  for (int i = 0; i < item.childCount(); ++i) shown = filter(*item.child(i)) || shown;
  item.setHidden(!shown && !m_filter.isEmpty());
  return shown;
}

void Outliner::show_filter() {
  for (int i = 0; i < topLevelItemCount(); ++i) filter(*topLevelItem(i));
}

void Outliner::set_filter(const QString& part) {
  m_filter = part;
  show_filter();
}

void Outliner::select_found() {
  if (m_filter.isEmpty()) return;
  Selection selection;
  for (QTreeWidgetItemIterator it(this); *it; ++it)
    if (is_found(**it) && !selection.contains(*id_of(**it)))
      selection.objects.push_back(*id_of(**it));
  m_document.select(std::move(selection));
}

// --- names -------------------------------------------------------------------------------------

void Outliner::edit_name() {
  if (const auto collection = currentItem() ? collection_of(*currentItem()) : std::nullopt)
    return edit_name_of(*collection);
  const auto active = m_document.selection().active();
  for (QTreeWidgetItemIterator it(this); active && *it; ++it)
    if (id_of(**it) == active) {
      setFocus();
      scrollToItem(*it);
      editItem(*it, 0);
      return;
    }
}

void Outliner::take_name(const QTreeWidgetItem& item) {
  if (collection_of(item)) return take_collection_name(item);
  const auto id = id_of(item);
  const ObjectSnapshot* const object = id ? m_document.snapshot()->find(*id) : nullptr;
  const std::string wanted = item.text(0).trimmed().toStdString();
  if (object && !wanted.empty() && wanted != (*object)->name)
    m_document.perform(RenameOperation{(*object)->name, wanted});
  // Shows the old name until it is done.
  m_committed = 0;
  QMetaObject::invokeMethod(
      this, [this] { rebuild(); }, Qt::QueuedConnection);
}

// --- objects -----------------------------------------------------------------------------------

QTreeWidgetItem* Outliner::add_heading(const QString& text) {
  auto* const item = new QTreeWidgetItem(this);
  item->setText(0, text);
  item->setForeground(0, m_theme.faint_text());
  item->setFlags(Qt::ItemIsEnabled);
  return item;
}

// Each object under its first support; rings of mutual support under the floor.
void Outliner::add_placed(const SceneSnapshot& scene, QTreeWidgetItem* floor) {
  const auto support_of = supports(scene);
  std::map<std::uint32_t, const ObjectSnapshot*> waiting;
  for (const ObjectSnapshot& object : scene.objects)
    if (object->placed) waiting[object.id.index] = &object;
  std::map<std::uint32_t, QTreeWidgetItem*> items;
  for (bool ring = false; !waiting.empty();) {
    const size_t before = waiting.size();
    for (const ObjectSnapshot& object : scene.objects) {
      if (!waiting.count(object.id.index)) continue;
      const auto support = support_of.find(object.id.index);
      const bool on_other = support != support_of.end() && !ring;
      const auto parent = on_other ? items.find(support->second) : items.end();
      if (on_other && parent == items.end()) continue;
      items[object.id.index] = add(on_other ? parent->second : floor, object);
      waiting.erase(object.id.index);
      ring = false;
    }
    if (waiting.size() == before) ring = true;
  }
}

void Outliner::show_selection() {
  if (m_is_showing) return;
  const QSignalBlocker blocker(this);
  clearSelection();
  const auto active = m_document.selection().active();
  for (QTreeWidgetItemIterator it(this); *it; ++it) {
    const auto id = id_of(**it);
    QFont font = (*it)->font(0);
    font.setBold(id && active == id && m_document.selection().objects.size() > 1);
    (*it)->setFont(0, font);
    if (!id || !m_document.selection().contains(*id)) continue;
    (*it)->setSelected(true);
    if (active == id) scrollToItem(*it);
  }
  viewport()->update();
}

void Outliner::take_selection() {
  Selection selection;
  const auto add = [&](ObjectId id) {
    if (!selection.contains(id)) selection.objects.push_back(id);
  };
  for (const QTreeWidgetItem* item : selectedItems()) {
    if (const auto id = id_of(*item)) add(*id);
    const auto name = collection_of(*item);
    if (const Collection* const in = name ? m_document.looks().collections.find(*name) : nullptr)
      for (const ObjectId id : in->objects) add(id);
  }
  // The last clicked object becomes active.
  if (const auto current = currentItem() ? id_of(*currentItem()) : std::nullopt)
    if (const auto it = std::find(selection.objects.begin(), selection.objects.end(), *current);
        it != selection.objects.end())
      std::rotate(it, it + 1, selection.objects.end());
  m_is_showing = true;
  m_document.select(std::move(selection));
  m_is_showing = false;
}

}  // namespace trivet::edit
