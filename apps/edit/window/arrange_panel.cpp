#include "apps/edit/window/arrange_panel.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "core/base/error.h"

namespace trivet::edit {
namespace {

constexpr int kEntryRole = Qt::UserRole;
constexpr int kWheelRestsMs = 250;
constexpr double kSoftWeight = 1;

QDoubleSpinBox* make_number(const char* name, double value, double most) {
  auto* const box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setDecimals(1);
  box->setRange(0, most);
  box->setValue(value);
  return box;
}

QPushButton* make_button(const char* name, const QString& text, const QString& tip) {
  auto* const button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}

QHBoxLayout* row_of(std::initializer_list<QWidget*> widgets) {
  auto* const row = new QHBoxLayout;
  for (QWidget* const widget : widgets) row->addWidget(widget);
  return row;
}

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

QWidget* ArrangePanel::make_new_wish() {
  m_pair = new QLabel;
  m_pair->setObjectName("wish_pair");
  m_pair->setWordWrap(true);
  m_swap = make_button("wish_swap", tr("Swap"), tr("Swap the two objects"));
  m_kind = new QComboBox;
  m_kind->setObjectName("wish_kind");
  for (const WishKind& kind : wish_kinds()) m_kind->addItem(tr(kind.label));
  m_lower = make_number("wish_lower", 0, 100'000);
  m_upper = make_number("wish_upper", 10, 100'000);
  m_to = new QLabel(tr("to"));
  m_unit = new QLabel;
  m_is_soft = new QCheckBox(tr("Soft, weight"));
  m_is_soft->setObjectName("wish_soft");
  m_weight = make_number("wish_weight", kSoftWeight, 1000);
  m_add = make_button("wish_add", tr("Add wish"), tr("Add the wish to the scene's"));
  auto* const box = new QWidget;
  box->setMaximumWidth(300);
  auto* const column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_pair);
  column->addLayout(row_of({m_kind, m_swap}));
  column->addLayout(row_of({m_lower, m_to, m_upper, m_unit}));
  column->addLayout(row_of({m_is_soft, m_weight, m_add}));
  column->addStretch(1);
  connect(m_kind, &QComboBox::currentIndexChanged, this, &ArrangePanel::show_kind);
  connect(m_is_soft, &QCheckBox::toggled, this, &ArrangePanel::show_kind);
  connect(m_swap, &QPushButton::clicked, this, [this] {
    m_is_swapped = !m_is_swapped;
    follow_selection();
  });
  connect(m_add, &QPushButton::clicked, this, &ArrangePanel::add_wish);
  return box;
}

QWidget* ArrangePanel::make_list() {
  m_list = new QTreeWidget;
  m_list->setObjectName("wishes");
  m_list->setHeaderLabels({tr("Wish"), tr("Weight")});
  m_list->setRootIsDecorated(false);
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_list->header()->setStretchLastSection(false);
  m_all = new QCheckBox(tr("All"));
  m_all->setObjectName("wishes_all");
  m_all->setToolTip(tr("All wishes, not of the selected objects alone"));
  m_all->setChecked(true);
  m_remove = make_button("wish_remove", tr("Remove"), tr("Remove the chosen wishes"));
  auto* const load =
      make_button("wishes_load", tr("Load…"), tr("Load a problem of trivet arrange"));
  auto* const save = make_button("wishes_save", tr("Save…"),
                                 tr("Save scene and wishes as a problem of trivet arrange"));
  auto* const box = new QWidget;
  auto* const column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_list, 1);
  auto* const row = row_of({m_all, m_remove, load, save});
  row->insertStretch(1);
  column->addLayout(row);
  connect(m_all, &QCheckBox::toggled, this, &ArrangePanel::list_wishes);
  connect(m_remove, &QPushButton::clicked, this, &ArrangePanel::remove_wishes);
  connect(m_list, &QTreeWidget::itemChanged, this, &ArrangePanel::weigh);
  connect(load, &QPushButton::clicked, this, &ArrangePanel::load_problem);
  connect(save, &QPushButton::clicked, this, &ArrangePanel::save_problem);
  return box;
}

QWidget* ArrangePanel::make_search() {
  m_selected_only = new QCheckBox(tr("Selected only"));
  m_selected_only->setObjectName("arrange_selected");
  m_selected_only->setToolTip(tr("Arrange the selected objects; all others stay"));
  m_seed = new QSpinBox;
  m_seed->setObjectName("arrange_seed");
  m_seed->setRange(0, 1'000'000);
  m_seed->setValue(1);
  m_seed->setPrefix(tr("Seed "));
  m_seed->setToolTip(tr("Turn the wheel for the next solution"));
  m_arrange = make_button("arrange", tr("Arrange"), tr("Look for an arrangement: a preview"));
  m_next = make_button("arrange_next", tr("Next"), tr("The next solution: another seed"));
  m_accept = make_button("arrange_accept", tr("Accept"), tr("Do it, as one step"));
  m_reject = make_button("arrange_reject", tr("Reject"), tr("Leave the scene as it is"));
  m_drop = make_button("arrange_drop", tr("Drop the cheapest wish"),
                       tr("Drop the wish that is nearest to being met, and look again"));
  m_progress = new QProgressBar;
  m_progress->setTextVisible(false);
  m_progress->setMaximumHeight(6);
  m_status = new QLabel;
  m_status->setObjectName("arrange_status");
  m_status->setWordWrap(true);
  auto* const box = new QWidget;
  box->setFixedWidth(400);
  auto* const column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row_of({m_selected_only, m_seed, m_arrange, m_next}));
  column->addWidget(m_progress);
  column->addWidget(m_status, 1);
  column->addLayout(row_of({m_accept, m_reject, m_drop}));
  connect(m_arrange, &QPushButton::clicked, this, &ArrangePanel::seek);
  connect(m_next, &QPushButton::clicked, this, &ArrangePanel::seek_next);
  connect(m_seed, &QSpinBox::valueChanged, this, [this] { m_turned.start(); });
  connect(m_accept, &QPushButton::clicked, this, [this] { m_document.accept_layout(); });
  connect(m_reject, &QPushButton::clicked, this, [this] { m_document.clear_layout(); });
  connect(m_drop, &QPushButton::clicked, this, &ArrangePanel::drop_cheapest);
  return box;
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
    auto* const item = new QTreeWidgetItem(
        {QString::fromStdString(wishes[i].text), weight ? QString::number(*weight) : tr("hard")});
    item->setData(0, kEntryRole, static_cast<qulonglong>(i));
    item->setToolTip(1, tr("A number makes the wish soft, no number hard"));
    item->setFlags(item->flags() | Qt::ItemIsEditable);
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
  const double weight = item->text(1).toDouble(&is_number);
  const bool is_soft = is_number && weight >= 0;
  // After the event that edits the item, as the list is made anew.
  QTimer::singleShot(0, this, [this, entry, column, is_soft, weight] {
    if (column == 1 && entry < m_document.wishes().list().size())
      m_document.set_wishes(m_document.wishes().weighted(
          entry, is_soft ? std::optional<double>(weight) : std::nullopt));
    list_wishes();
  });
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
                            .arg(layout->milliseconds / 1000, 0, 'f', 1)
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
      QFileDialog::getOpenFileName(this, tr("Load wishes"), {}, tr("Problems (*.json)"));
  if (file.isEmpty()) return;
  try {
    m_document.load_wishes(file.toStdString());
  } catch (const Error& e) {
    Q_EMIT m_document.message(Message{Message::Kind::Error, e.what(), {}, {}});
  }
}

}  // namespace trivet::edit
