// Title, status bar and enabled actions of the main window, as the document is.
#include <QColor>
#include <QCoreApplication>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QSizePolicy>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include "apps/edit/document/margins.h"
#include "apps/edit/window/main_window.h"

namespace trivet::edit {
namespace {

constexpr int kBusyAfterMs = 250;    // quicker jobs show no progress
constexpr int kWidestVerdict = 260;  // pixels
constexpr int kWidestAnswering = 320;

}  // namespace

void MainWindow::make_status_bar() {
  m_hand = new QLabel, m_hint = new QLabel, m_count = new QLabel, m_busy = new QLabel;
  m_hand->setObjectName("hand");
  m_hand->setContentsMargins(8, 0, 0, 0);
  m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_hint->setIndent(8);
  m_count->setObjectName("faint");
  m_count->setContentsMargins(8, 0, 8, 0);
  m_answering = new QLabel;
  m_answering->setObjectName("faint");
  m_stands = new QLabel;
  m_stands->setObjectName("stands");
  m_progress = new QProgressBar;
  m_progress->setFixedSize(140, 12);
  m_progress->setTextVisible(false);
  m_cancel = new QToolButton;
  m_cancel->setText(tr("Cancel"));
  m_cancel->setToolTip(tr("Stop the running operation; the scene stays unchanged (Escape)"));
  statusBar()->addWidget(m_hand);
  statusBar()->addWidget(m_hint, 1);
  for (QWidget* const widget : std::initializer_list<QWidget*>{m_busy, m_progress, m_cancel,
                                                               m_answering, m_stands, m_count})
    statusBar()->addPermanentWidget(widget);
  statusBar()->setSizeGripEnabled(false);
  m_count->setContentsMargins(0, 0, 6, 0);
  for (QWidget* const widget : std::initializer_list<QWidget*>{m_busy, m_progress, m_cancel})
    widget->hide();
  connect(m_cancel, &QToolButton::clicked, this, [this] {
    m_document.cancel();
    if (m_picture) m_picture->cancel();
  });
  m_busy_for_long.setSingleShot(true);
  m_busy_for_long.setInterval(kBusyAfterMs);
  connect(&m_busy_for_long, &QTimer::timeout, this, &MainWindow::show_busy);
}

void MainWindow::update_title() {
  const QString title = QString::fromStdString(m_document.title());
  setWindowTitle((title == "Untitled" ? tr("Untitled") : title) + "[*] – Trivet");
  setWindowModified(m_document.is_modified());
  update_actions();
}

void MainWindow::follow_busy() {
  // Dismisses messages about earlier operations.
  if (m_document.is_busy() && !m_was_busy) m_message_bar->dismiss();
  m_was_busy = m_document.is_busy();
  if (m_document.is_busy())
    m_busy_for_long.start();
  else
    m_busy_for_long.stop(), show_busy();
  update_actions();
  update_status();
}

void MainWindow::show_busy() {
  const bool busy = m_document.is_busy() || m_picture;
  if (busy && m_document.is_busy()) m_busy->setText(QString::fromStdString(m_document.busy_with()));
  if (!busy) m_progress->setRange(0, 0);
  for (QWidget* const widget : std::initializer_list<QWidget*>{m_busy, m_progress, m_cancel})
    widget->setVisible(busy);
}

void MainWindow::update_status() {
  const QString hand = QString::fromStdString(m_toolbox.in_hand());
  m_hand->setVisible(!hand.isEmpty());
  m_hand->setText(tr("In hand: %1").arg(hand));
  m_hand->setStyleSheet("font-weight: bold; color: " + m_drawing.theme().accent().name());
  const QString typed = QString::fromStdString(m_toolbox.reading());
  QString hint =
      typed.isEmpty() ? QCoreApplication::translate("tools", m_toolbox.hint().c_str()) : typed;
  const auto& ghost = m_document.ghost();
  if (typed.isEmpty() && ghost && (!ghost->ok || ghost->hangs_back) && !ghost->text.empty())
    hint = QString::fromStdString(ghost->text);
  m_hint->setText(hint);
  m_hint->setToolTip(hint);
  const auto snapshot = m_document.snapshot();
  const int selected = static_cast<int>(m_document.selection().objects.size());
  QString count = tr("Objects: %1").arg(snapshot->objects.size());
  if (selected > 0) count += tr(", selected: %1").arg(selected);
  const auto active = m_document.selection().active();
  if (const ObjectSnapshot* const last = active ? snapshot->find(*active) : nullptr;
      last && selected > 1)
    count += tr(" (last: %1)").arg(QString::fromStdString((*last)->name));
  m_count->setText(count);
}

void MainWindow::show_detection() {
  const Detection& now = m_document.detection();
  const QString text = tr("Detection: %1").arg(in_words(now.moves));
  m_answering->setText(
      m_answering->fontMetrics().elidedText(text, Qt::ElideRight, kWidestAnswering));
  m_answering->setToolTip(tr("Collision detection. Moves: %1. Previews: %2. See Preferences.")
                              .arg(in_words(now.moves), in_words(now.previews)));
}

// The last verdict is shown until there is another.
void MainWindow::show_verdict() {
  const auto verdict = m_document.verdict();
  if (!verdict) return;
  const QString text = QString::fromStdString(whole_text(*m_document.snapshot(), *verdict));
  const Theme& theme = m_drawing.theme();
  const Stability::Status status = verdict->stability.status;
  const QColor colour = status == Stability::Status::Unstable         ? theme.refused()
                        : is_barely(*m_document.snapshot(), *verdict) ? theme.warning()
                                                                      : theme.faint_text();
  m_stands->setStyleSheet("color: " + colour.name());
  m_stands->setText(m_stands->fontMetrics().elidedText(text, Qt::ElideRight, kWidestVerdict));
  m_stands->setToolTip(tr("The scene as a whole, at the friction of the materials: %1").arg(text));
}

void MainWindow::update_actions() {
  const bool idle = !m_document.is_busy();
  const bool selected = !m_document.selection().objects.empty();
  action("undo")->setEnabled(idle && m_document.can_undo());
  action("redo")->setEnabled(idle && m_document.can_redo());
  for (const char* const name :
       {"duplicate", "delete", "lock", "unlock", "fix", "unfix", "group", "ungroup", "rename",
        "array", "scatter", "align", "replace", "hide", "not selectable", "collect", "uncollect"})
    action(name)->setEnabled(idle && selected);
  action("put all")->setEnabled(idle);
  m_colours->setEnabled(selected);
  for (const char* const name : {"save", "save as", "export", "picture"})
    action(name)->setEnabled(idle);
}

}  // namespace trivet::edit
