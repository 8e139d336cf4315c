// Collections in the outliner.
#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QDragMoveEvent>
#include <QDropEvent>
#include <QMenu>
#include <QMetaObject>
#include <QMimeData>
#include <QStringList>
#include <QTreeWidgetItemIterator>

#include "apps/edit/window/outliner.h"
#include "apps/edit/window/outliner_items.h"

namespace trivet::edit {
namespace {

constexpr const char* kObjectsMime = "application/x-trivet-objects";  // the selected ones

}  // namespace

void Outliner::add_collections(const SceneSnapshot& scene) {
  for (const Collection& collection : m_document.looks().collections.all()) {
    QTreeWidgetItem* const item = add_heading(QString::fromStdString(collection.name));
    item->setData(0, kCollectionRole, item->text(0));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable |
                   Qt::ItemIsDropEnabled);
    item->setForeground(0, m_theme.accent());
    for (const ObjectId id : collection.objects)
      if (const ObjectSnapshot* const object = scene.find(id)) add(item, *object);
    QStringList notes{tr("%n objects", nullptr, item->childCount())};
    if (collection.hidden) notes << tr("hidden");
    if (collection.not_selectable) notes << tr("not selectable");
    item->setText(1, notes.join(", "));
    item->setForeground(1, m_theme.faint_text());
  }
}

void Outliner::edit_name_of(const std::string& collection) {
  for (QTreeWidgetItemIterator it(this); *it; ++it)
    if (collection_of(**it) == collection) {
      setFocus();
      scrollToItem(*it);
      editItem(*it, 0);
      return;
    }
}

void Outliner::change_collections(const std::function<void(Collections&)>& change) {
  Looks looks = m_document.looks();
  change(looks.collections);
  m_document.set_looks(std::move(looks), tr("change of a collection").toStdString());
}

void Outliner::take_collection_name(const QTreeWidgetItem& item) {
  const std::string name = *collection_of(item), wanted = item.text(0).trimmed().toStdString();
  if (wanted == name) return;
  // The old name is shown again where the new one is taken.
  QMetaObject::invokeMethod(
      this,
      [this, name, wanted] {
        change_collections([&](Collections& all) { all.rename(name, wanted); });
        m_committed = 0;
        rebuild();
      },
      Qt::QueuedConnection);
}

// --- dragging ----------------------------------------------------------------------------------

QStringList Outliner::mimeTypes() const { return {kObjectsMime}; }

QMimeData* Outliner::mimeData(const QList<QTreeWidgetItem*>&) const {
  auto* const mime = new QMimeData;
  mime->setData(kObjectsMime, "selected");
  return mime;
}

void Outliner::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(kObjectsMime))
    event->acceptProposedAction();
  else
    event->ignore();
}

void Outliner::dragMoveEvent(QDragMoveEvent* event) {
  if (event->mimeData()->hasFormat(kObjectsMime))
    event->acceptProposedAction();
  else
    event->ignore();
}

// On a collection or one of its objects: into it; beside all objects: out of the one it is in.
void Outliner::dropEvent(QDropEvent* event) {
  if (!event->mimeData()->hasFormat(kObjectsMime)) return event->ignore();
  const QTreeWidgetItem* const at = itemAt(event->position().toPoint());
  const QTreeWidgetItem* item = at;
  while (item && !collection_of(*item)) item = item->parent();
  if (at && !item && id_of(*at)) return event->ignore();
  const std::vector<ObjectId> objects = m_document.selection().objects;
  change_collections([&](Collections& all) {
    if (item)
      all.put(objects, *collection_of(*item));
    else
      all.take_out(objects);
  });
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

// --- menu --------------------------------------------------------------------------------------

void Outliner::contextMenuEvent(QContextMenuEvent* event) {
  const QTreeWidgetItem* const item = itemAt(event->pos());
  const auto name = item ? collection_of(*item) : std::nullopt;
  const Collection* const collection = name ? m_document.looks().collections.find(*name) : nullptr;
  if (collection)
    show_collection_menu(*collection, event->globalPos());
  else
    Q_EMIT context_menu_wanted(event->globalPos());
}

void Outliner::show_collection_menu(const Collection& collection, const QPoint& global) {
  auto* const menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setObjectName("collection menu");
  const Collection c = collection;
  const auto show = [this, c](bool hidden, bool not_selectable) {
    change_collections([&](Collections& all) { all.show(c.name, hidden, not_selectable); });
  };
  menu->addAction(tr("Select its objects"), [this, c] {
    Selection selection;
    selection.objects = c.objects;
    m_document.select(std::move(selection));
  });
  menu->addAction(tr("Rename"), [this, c] { edit_name_of(c.name); });
  menu->addAction(c.hidden ? tr("Show") : tr("Hide"),
                  [show, c] { show(!c.hidden, c.not_selectable); });
  menu->addAction(c.not_selectable ? tr("Selectable") : tr("Not selectable"),
                  [show, c] { show(c.hidden, !c.not_selectable); });
  const auto lock = [this, c](bool locked) {
    std::vector<Operation> all;
    for (const ObjectId id : c.objects)
      if (const ObjectSnapshot* const object = m_document.snapshot()->find(id))
        all.emplace_back(LockOperation{(*object)->name, locked});
    if (!all.empty())
      m_document.perform_all((locked ? tr("lock") : tr("unlock")).toStdString(), std::move(all));
  };
  menu->addAction(tr("Lock"), [lock] { lock(true); });
  menu->addAction(tr("Unlock"), [lock] { lock(false); });
  menu->addSeparator();
  menu->addAction(tr("Dissolve; its objects stay"), [this, c] {
    change_collections([&](Collections& all) { all.dissolve(c.name); });
  });
  menu->popup(global);
}

}  // namespace trivet::edit
