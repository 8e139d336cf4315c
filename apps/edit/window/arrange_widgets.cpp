// Widgets of the dock for arrangements.
#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSizePolicy>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "apps/edit/window/arrange_panel.h"

namespace trivet::edit {
namespace {

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

/// As wide as its rows need in any language, `least_px` at least. Wrapped texts ask for no width.
QVBoxLayout* column_in(QWidget& box, int least_px, QLabel& wrapped) {
  wrapped.setWordWrap(true);
  wrapped.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  box.setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  auto* const column = new QVBoxLayout(&box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addStrut(least_px);
  return column;
}

}  // namespace

QWidget* ArrangePanel::make_new_wish() {
  m_pair = new QLabel;
  m_pair->setObjectName("wish_pair");
  m_swap = make_button("wish_swap", tr("Swap"), tr("Swap the two objects"));
  m_kind = new QComboBox;
  m_kind->setObjectName("wish_kind");
  for (const WishKind& kind : wish_kinds())
    m_kind->addItem(QCoreApplication::translate("wishes", kind.label));
  m_lower = make_number("wish_lower", 0, 100'000);
  m_upper = make_number("wish_upper", 10, 100'000);
  m_to = new QLabel(tr("to"));
  m_unit = new QLabel;
  m_is_soft = new QCheckBox(tr("Soft, weight"));
  m_is_soft->setObjectName("wish_soft");
  m_weight = make_number("wish_weight", kSoftWeight, 1000);
  m_add = make_button("wish_add", tr("Add constraint"), tr("Add the constraint to the scene's"));
  auto* const box = new QWidget;
  auto* const column = column_in(*box, 250, *m_pair);
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
  m_list->setHeaderLabels({tr("Constraint"), tr("Weight")});
  m_list->setRootIsDecorated(false);
  m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_list->header()->setStretchLastSection(false);
  m_all = new QCheckBox(tr("All"));
  m_all->setObjectName("wishes_all");
  m_all->setToolTip(tr("All constraints, not of the selected objects alone"));
  m_all->setChecked(true);
  m_remove = make_button("wish_remove", tr("Remove"), tr("Remove the chosen constraints"));
  auto* const load =
      make_button("wishes_load", tr("Load…"), tr("Load a problem of trivet arrange"));
  auto* const save = make_button("wishes_save", tr("Save…"),
                                 tr("Save scene and constraints as a problem of trivet arrange"));
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
  m_accept = make_button("arrange_accept", tr("Accept"), tr("Apply the arrangement, as one step"));
  m_reject = make_button("arrange_reject", tr("Reject"), tr("Leave the scene as it is"));
  m_drop = make_button("arrange_drop", tr("Drop the cheapest constraint"),
                       tr("Drop the constraint that is nearest to being met, and look again"));
  m_progress = new QProgressBar;
  m_progress->setTextVisible(false);
  m_progress->setMaximumHeight(6);
  m_status = new QLabel;
  m_status->setObjectName("arrange_status");
  auto* const box = new QWidget;
  auto* const column = column_in(*box, 400, *m_status);
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

}  // namespace trivet::edit
