#include "apps/edit/window/quick_actions.h"

#include <QKeyEvent>
#include <QKeySequence>
#include <QPixmap>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

namespace trivet::edit {
namespace {

constexpr int kWidePx = 420, kHighPx = 380;
constexpr int kRowPx = 26, kIconPx = 18;

QString plain_text(const QAction& action) { return QString(action.text()).remove('&').remove("…"); }

/// The name of the action and its keys, without the markup of tool tips.
QString row_text(const QAction& action) {
  const QString keys = action.shortcut().toString(QKeySequence::NativeText);
  const QString name = plain_text(action);
  return keys.isEmpty() ? name : name + "    " + keys;
}

bool has_all(const QAction& action, const QStringList& words) {
  const QString text = plain_text(action) + " " + action.toolTip();
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

QuickActions::QuickActions(const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent), m_words(new QLineEdit), m_list(new QListWidget) {
  for (QAction* const action : actions)
    if (!action->text().isEmpty() && action->isEnabled()) m_actions << action;
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Quick actions"));
  setObjectName("quick actions");
  resize(kWidePx, kHighPx);
  m_list->setIconSize(QSize(kIconPx, kIconPx));
  m_words->setPlaceholderText(tr("What do you want to do?"));
  m_words->installEventFilter(this);
  auto* const column = new QVBoxLayout(this);
  column->addWidget(m_words);
  column->addWidget(m_list, 1);
  connect(m_words, &QLineEdit::textChanged, this, &QuickActions::filter);
  connect(m_list, &QListWidget::itemActivated, this, &QuickActions::run);
  connect(m_list, &QListWidget::itemClicked, this, &QuickActions::run);
  filter();
}

void QuickActions::filter() {
  const QStringList words = m_words->text().split(' ', Qt::SkipEmptyParts);
  m_list->clear();
  QPixmap blank(m_list->iconSize());  // texts begin below each other
  blank.fill(Qt::transparent);
  for (qsizetype i = 0; i < m_actions.size(); ++i) {
    if (!has_all(*m_actions[i], words)) continue;
    const QIcon icon = m_actions[i]->icon();
    auto* const item =
        new QListWidgetItem(icon.isNull() ? QIcon(blank) : icon, row_text(*m_actions[i]), m_list);
    item->setSizeHint(QSize(0, kRowPx));
    item->setData(Qt::UserRole, static_cast<int>(i));
    item->setToolTip(m_actions[i]->toolTip());
  }
  m_list->setCurrentRow(0);
}

// After it is closed: an action may open a dialog of its own.
void QuickActions::run(QListWidgetItem* item) {
  if (!item) return;
  QAction* const action = m_actions[item->data(Qt::UserRole).toInt()];
  accept();
  QTimer::singleShot(0, action, &QAction::trigger);
}

// The arrows choose in the list, while words are typed.
bool QuickActions::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<const QKeyEvent*>(event)->key();
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    run(m_list->currentItem());
    return true;
  }
  if (key != Qt::Key_Up && key != Qt::Key_Down) return QDialog::eventFilter(watched, event);
  const int row = m_list->currentRow() + (key == Qt::Key_Down ? 1 : -1);
  m_list->setCurrentRow(std::clamp(row, 0, std::max(m_list->count() - 1, 0)));
  return true;
}

}  // namespace trivet::edit
