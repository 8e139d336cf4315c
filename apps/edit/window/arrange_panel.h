// Dock for arrangements: wishes of the selection, new ones, previews by seed, conflicts.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QTreeWidget>
#include <QWidget>

#include "apps/edit/document/document.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

class ArrangePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ArrangePanel(Document& document, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);

 private:
  QWidget* make_new_wish();
  QWidget* make_list();
  QWidget* make_search();
  void connect_document();
  void follow_selection();
  void list_wishes();
  void show_kind();
  void add_wish();
  void remove_wishes();
  void weigh(QTreeWidgetItem* item, int column);
  void take_weight(size_t entry, std::optional<double> weight);
  void seek();
  void seek_next();
  void show_layout();
  void drop_cheapest();
  void save_problem();
  void load_problem();
  std::optional<std::pair<std::string, std::string>> pair() const;

  Document& m_document;
  Theme m_theme;
  QLabel* m_pair;
  QComboBox* m_kind;
  QDoubleSpinBox *m_lower, *m_upper, *m_weight;
  QLabel *m_to, *m_unit;
  QCheckBox *m_is_soft, *m_all, *m_selected_only;
  QPushButton *m_swap, *m_add, *m_remove, *m_arrange, *m_next, *m_accept, *m_reject, *m_drop;
  QTreeWidget* m_list;
  QSpinBox* m_seed;
  QLabel* m_status;
  QProgressBar* m_progress;
  QTimer m_turned;  // begins a search when the wheel of the seed has come to rest
  bool m_is_swapped = false, m_is_listing = false;
};

}  // namespace trivet::edit
