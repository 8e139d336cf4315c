#include "apps/edit/window/arrange_panel.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLocale>
#include <QSignalBlocker>

#include "apps/edit/document/words.h"
#include "core/base/error.h"

namespace trivet::edit {
namespace {

constexpr int kEntryRole = Qt::UserRole;
constexpr int kWheelRestsMs = 250;

}  // namespace

ArrangePanel::ArrangePanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
  auto* const row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 4);
  row->addWidget(make_new_wish());
  row->addWidget(make_list(), 1);
  row->addWidget(make_search());
  m_turned.setSingleShot(true);
  m_turned.setInterval(kWheelRestsMs);
  connect(&m_turned, &QTimer::timeout, this, &ArrangePanel::seek);
  connect_document();
  show_kind();
  follow_selection();
  show_layout();
}

void ArrangePanel::connect_document() {
  connect(&m_document, &Document::selection_changed, this, &ArrangePanel::follow_selection);
  connect(&m_document, &Document::wishes_changed, this, &ArrangePanel::list_wishes);
  connect(&m_document, &Document::layout_changed, this, &ArrangePanel::show_layout);
  connect(&m_document, &Document::layout_progressed, this,
          [this](const QString& thing, int done, int total) {
            m_progress->setRange(0, total);
            m_progress->setValue(done);
            m_status->setText(tr("Looks for a place for %1").arg(thing));
          });
}

void ArrangePanel::set_theme(const Theme& theme) {
  m_theme = theme;
  list_wishes();
}

// The last two that were selected: a is to be ... b.
std::optional<std::pair<std::string, std::string>> ArrangePanel::pair() const {
  const std::vector<ObjectId>& selected = m_document.selection().objects;
  if (selected.size() < 2) return std::nullopt;
  const auto snapshot = m_document.snapshot();
  const ObjectSnapshot* a = snapshot->find(selected[selected.size() - 2]);
  const ObjectSnapshot* b = snapshot->find(selected.back());
  if (!a || !b) return std::nullopt;
  if (m_is_swapped) std::swap(a, b);
  return std::pair((*a)->name, (*b)->name);
}

void ArrangePanel::follow_selection() {
  const auto both = pair();
  m_pair->setText(both ? QString("<b>%1</b> … <b>%2</b>")
                             .arg(QString::fromStdString(both->first).toHtmlEscaped(),
                                  QString::fromStdString(both->second).toHtmlEscaped())
                       : tr("Select two objects: the first is to be … the second"));
  m_add->setEnabled(both.has_value());
  m_swap->setEnabled(both.has_value());
  list_wishes();
}

void ArrangePanel::show_kind() {
  const WishKind& kind = wish_kinds().at(static_cast<size_t>(m_kind->currentIndex()));
  const bool is_gap = kind.numbers == WishNumbers::Gap;
  const bool has_numbers = kind.numbers != WishNumbers::None;
  for (QWidget* const widget : {static_cast<QWidget*>(m_lower), static_cast<QWidget*>(m_to)})
    widget->setVisible(is_gap);
  m_upper->setVisible(has_numbers);
  m_unit->setText(kind.numbers == WishNumbers::Part ? tr("% at least")
                  : is_gap                          ? tr("cm")
                  : has_numbers                     ? tr("cm at most")
                                                    : QString());
  m_is_soft->setEnabled(kind.may_be_soft);
  m_weight->setEnabled(kind.may_be_soft && m_is_soft->isChecked());
}

void ArrangePanel::list_wishes() {
  m_is_listing = true;
  m_list->clear();
  const auto snapshot = m_document.snapshot();
  const auto& layout = m_document.layout();
  const std::vector<Wish>& wishes = m_document.wishes().list();
  for (size_t i = 0; i < wishes.size(); ++i) {
    bool is_shown = m_all->isChecked();
    for (const ObjectId id : m_document.selection().objects)
      if (const ObjectSnapshot* const object = snapshot->find(id))
        is_shown = is_shown || m_document.wishes().is_about(i, (*object)->name);
    if (!is_shown) continue;
    const std::optional<double>& weight = wishes[i].weight;
    auto* const item = new QTreeWidgetItem({QString::fromStdString(wishes[i].text),
                                            weight ? QLocale().toString(*weight) : tr("hard")});
    item->setData(0, kEntryRole, static_cast<qulonglong>(i));
    item->setToolTip(1, wishes[i].may_be_soft
                            ? tr("A number makes the constraint soft, no number hard")
                            : tr("This constraint is always hard"));
    if (wishes[i].may_be_soft) item->setFlags(item->flags() | Qt::ItemIsEditable);
    if (layout && layout->entries.count(i))
      for (const int column : {0, 1}) item->setForeground(column, m_theme.refused());
    m_list->addTopLevelItem(item);
  }
  m_is_listing = false;
}

void ArrangePanel::add_wish() {
  const auto both = pair();
  if (!both) return;
  NewWish wish;
  wish.kind = static_cast<size_t>(m_kind->currentIndex());
  wish.a = both->first, wish.b = both->second;
  wish.lower = 0.01 * std::min(m_lower->value(), m_upper->value());
  wish.upper = 0.01 * m_upper->value();
  wish.part = std::min(1.0, 0.01 * m_upper->value());
  if (m_is_soft->isChecked()) wish.weight = m_weight->value();
  m_document.set_wishes(m_document.wishes().with(wish));
}

void ArrangePanel::remove_wishes() {
  std::set<size_t> entries;
  for (const QTreeWidgetItem* const item : m_list->selectedItems())
    entries.insert(item->data(0, kEntryRole).toULongLong());
  if (!entries.empty()) m_document.set_wishes(m_document.wishes().without(entries));
}

// A number in the second column: soft, else hard.
void ArrangePanel::weigh(QTreeWidgetItem* item, int column) {
  if (m_is_listing) return;
  const size_t entry = item->data(0, kEntryRole).toULongLong();
  bool is_number = false;
  const double weight = QLocale().toDouble(item->text(1), &is_number);
  const auto wanted = is_number ? std::optional(weight) : std::nullopt;
  // After the event that edits the item, as the list is made anew.
  QTimer::singleShot(0, this, [this, entry, column, wanted] {
    if (column == 1) take_weight(entry, wanted);
    list_wishes();
  });
}

void ArrangePanel::take_weight(size_t entry, std::optional<double> weight) {
  const Wishes& wishes = m_document.wishes();
  if (entry >= wishes.list().size()) return;
  if (!weight || (*weight >= 0 && *weight <= kMostWeight))
    return m_document.set_wishes(wishes.weighted(entry, weight));
  const QString text =
      tr("Weight %1: accepted: a number from 0 to %2, or none for a hard constraint")
          .arg(QLocale().toString(*weight))
          .arg(QLocale().toString(kMostWeight));
  Q_EMIT m_document.message(Message{Message::Kind::Refused, text.toStdString(), {}, {}});
}

void ArrangePanel::seek() {
  m_turned.stop();
  const bool begins = m_document.request_layout(static_cast<std::uint64_t>(m_seed->value()),
                                                m_selected_only->isChecked());
  if (!begins)
    m_status->setText(m_selected_only->isChecked() ? tr("Select objects that may move")
                                                   : tr("There is no object that may move"));
}

void ArrangePanel::seek_next() {
  {
    const QSignalBlocker blocker(m_seed);
    m_seed->setValue(m_seed->value() + 1);
  }
  seek();
}

void ArrangePanel::show_layout() {
  const auto& layout = m_document.layout();
  const bool seeks = m_document.is_seeking_layout();
  m_progress->setRange(0, seeks ? 0 : 1);
  m_progress->setVisible(seeks);
  m_accept->setEnabled(layout && layout->ok);
  m_reject->setEnabled(layout || seeks);
  m_reject->setText(seeks ? tr("Stop") : tr("Reject"));
  m_drop->setVisible(layout && layout->cheapest);
  QString text = seeks ? tr("Looks for an arrangement") : QString();
  if (layout)
    text = layout->ok ? tr("%1 (seed %2, %3 s)")
                            .arg(QString::fromStdString(layout->text))
                            .arg(layout->seed)
                            .arg(QLocale().toString(layout->milliseconds / 1000, 'f', 1))
                      : QString::fromStdString(layout->text);
  m_status->setText(text);
  list_wishes();
}

void ArrangePanel::drop_cheapest() {
  const auto layout = m_document.layout();
  if (!layout || !layout->cheapest) return;
  m_document.set_wishes(m_document.wishes().without({*layout->cheapest}));
  seek();
}

void ArrangePanel::save_problem() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save problem"), "problem.json",
                                                    tr("Problems (*.json)"));
  if (!file.isEmpty()) m_document.save_problem(file.toStdString());
}

void ArrangePanel::load_problem() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Load constraints"), {}, tr("Problems (*.json)"));
  if (file.isEmpty()) return;
  try {
    m_document.load_wishes(file.toStdString());
  } catch (const Error& e) {
    Q_EMIT m_document.message(Message{Message::Kind::Error, in_words(e), {}, {}});
  }
}

}  // namespace trivet::edit
