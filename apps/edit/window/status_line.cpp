#include "apps/edit/window/status_line.h"

#include <QColor>
#include <QCoreApplication>
#include <QSizePolicy>

#include "apps/edit/document/margins.h"
#include "apps/edit/window/detection_choice.h"

namespace trivet::edit {
namespace {

constexpr int kBusyAfterMs = 250;    // quicker jobs show no progress
constexpr int kWidestVerdict = 260;  // pixels
constexpr int kWidestAnswering = 320;
constexpr int kNoteMs = 12000, kStoredNoteMs = 4000;

}  // namespace

StatusLine::StatusLine(Document& document, Toolbox& toolbox, const SceneDrawing& drawing,
                       QStatusBar& bar)
    : m_document(document), m_toolbox(toolbox), m_drawing(drawing), m_bar(bar) {
  make_widgets(bar);
  m_busy_for_long.setSingleShot(true);
  m_busy_for_long.setInterval(kBusyAfterMs);
  connect(&m_busy_for_long, &QTimer::timeout, this, &StatusLine::show_busy);
  connect(m_cancel, &QToolButton::clicked, this, &StatusLine::cancel_wanted);
  follow_document();
}

void StatusLine::make_widgets(QStatusBar& bar) {
  m_hand = new QLabel, m_hint = new QLabel, m_count = new QLabel, m_busy = new QLabel;
  m_hand->setObjectName("hand");
  m_hand->setContentsMargins(8, 0, 0, 0);
  m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_hint->setIndent(8);
  m_count->setObjectName("faint");
  m_count->setContentsMargins(0, 0, 6, 0);
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
  bar.addWidget(m_hand);
  bar.addWidget(m_hint, 1);
  for (QWidget* const widget : std::initializer_list<QWidget*>{m_busy, m_progress, m_cancel,
                                                               m_answering, m_stands, m_count})
    bar.addPermanentWidget(widget);
  bar.setSizeGripEnabled(false);
  for (QWidget* const widget : std::initializer_list<QWidget*>{m_busy, m_progress, m_cancel})
    widget->hide();
}

void StatusLine::follow_document() {
  connect(&m_document, &Document::ghost_changed, this, &StatusLine::follow_tool);
  connect(&m_document, &Document::detection_changed, this, &StatusLine::show_detection);
  connect(&m_document, &Document::snapshot_changed, this, &StatusLine::show_verdict);
  connect(&m_document, &Document::snapshot_changed, this, &StatusLine::follow_tool);
  connect(&m_document, &Document::verdict_changed, this, &StatusLine::show_verdict);
  connect(&m_document, &Document::detection_noted, this, &StatusLine::show_note);
  connect(&m_document, &Document::busy_changed, this, &StatusLine::follow_busy);
  connect(&m_document, &Document::progressed, this, &StatusLine::show_progress);
  show_detection();
}

// --- work ----------------------------------------------------------------------------------------

void StatusLine::follow_busy() {
  if (m_document.is_busy())
    m_busy_for_long.start();
  else
    m_busy_for_long.stop(), show_busy();
  follow_tool();
}

void StatusLine::show_busy() {
  const bool busy = m_document.is_busy() || m_other_work;
  if (busy && m_document.is_busy()) m_busy->setText(QString::fromStdString(m_document.busy_with()));
  if (!busy) m_progress->setRange(0, 0);
  for (QWidget* const widget : std::initializer_list<QWidget*>{m_busy, m_progress, m_cancel})
    widget->setVisible(busy);
}

void StatusLine::show_work(const QString& what) {
  m_other_work = !what.isEmpty();
  if (m_other_work) m_busy->setText(what);
  show_busy();
}

void StatusLine::show_progress(const QString& what, int done, int total) {
  m_busy->setText(what);
  m_progress->setRange(0, total);
  m_progress->setValue(done);
}

// --- notes ---------------------------------------------------------------------------------------

void StatusLine::show_note(const QString& note) { m_bar.showMessage(note, kNoteMs); }

void StatusLine::show_stored(int number) {
  m_bar.showMessage(tr("Stored as view %1: Alt+%1 shows it again").arg(number), kStoredNoteMs);
}

// --- tool, selection, scene ----------------------------------------------------------------------

void StatusLine::follow_tool() {
  const QString hand = QString::fromStdString(m_toolbox.in_hand());
  m_hand->setVisible(!hand.isEmpty());
  m_hand->setText(tr("In hand: %1").arg(hand));
  m_hand->setStyleSheet("font-weight: bold; color: " + m_drawing.theme().accent().name());
  m_hint->setText(hint());
  m_hint->setToolTip(m_hint->text());
  m_count->setText(count());
}

QString StatusLine::hint() const {
  QString typed = QString::fromStdString(m_toolbox.reading());
  if (!typed.isEmpty()) return typed;
  const auto& ghost = m_document.ghost();
  if (ghost && (!ghost->ok || ghost->hangs_back) && !ghost->text.empty())
    return QString::fromStdString(ghost->text);
  return QCoreApplication::translate("tools", m_toolbox.hint().c_str());
}

QString StatusLine::count() const {
  const auto snapshot = m_document.snapshot();
  const int selected = static_cast<int>(m_document.selection().objects.size());
  QString count = tr("Objects: %1").arg(snapshot->objects.size());
  if (selected > 0) count += tr(", selected: %1").arg(selected);
  const auto active = m_document.selection().active();
  if (const ObjectSnapshot* const last = active ? snapshot->find(*active) : nullptr;
      last && selected > 1)
    count += tr(" (last: %1)").arg(QString::fromStdString((*last)->name));
  return count;
}

void StatusLine::show_detection() {
  const Detection& now = m_document.detection();
  const QString text = tr("Detection: %1").arg(in_words(now.moves));
  m_answering->setText(
      m_answering->fontMetrics().elidedText(text, Qt::ElideRight, kWidestAnswering));
  m_answering->setToolTip(tr("Collision detection. Moves: %1. Previews: %2. See Preferences.")
                              .arg(in_words(now.moves), in_words(now.previews)));
}

// The last verdict is shown until there is another.
void StatusLine::show_verdict() {
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

}  // namespace trivet::edit
