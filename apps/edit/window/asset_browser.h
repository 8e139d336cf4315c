// Folders of models with their pictures: dragged into a view, or put by a double click.
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QSet>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <functional>

#include "apps/edit/window/asset_facts.h"
#include "apps/edit/window/asset_thumbnails.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

/// MIME type of models dragged out of the browser, in addition to their URLs.
inline constexpr const char* kAssetsMime = "application/x-trivet-models";

class AssetList : public QListWidget {
 public:
  using QListWidget::QListWidget;

  /// Shown while the list is empty.
  void explain(const QString& text);

 protected:
  QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
  void startDrag(Qt::DropActions actions) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QString m_explanation;
};

/// A model to import from the browser.
struct Asset {
  QString file;
  double metres = 1;      // per unit: as chosen for its folder, else stated or likely
  UpAxis up = UpAxis::Z;  // as chosen for its folder, else stated or likely
};

class AssetBrowser : public QWidget {
  Q_OBJECT

 public:
  /// @param cache, limits  see AssetThumbnails.
  AssetBrowser(const QString& cache, const ImportLimits& limits, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  /// Shows this folder, and remembers it.
  void add_folder(const QString& folder);
  QString folder() const { return m_folders->currentData().toString(); }
  AssetList& list() { return *m_list; }
  QLineEdit& search() { return *m_search; }
  const AssetThumbnails& thumbnails() const { return m_thumbnails; }
  /// Calls then() once it is known how large the model is, in the unit that is chosen now; not for
  /// a bad one.
  void with_asset(const QString& file, std::function<void(const Asset&)> then);

 Q_SIGNALS:
  void put_wanted(const trivet::edit::Asset& asset);
  /// A model that cannot be read was chosen.
  void refused(const QString& why);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void make_widgets();
  void ask_folder();
  void forget_folder();
  void choose_unit(double metres);
  void show_folder();
  void fill(const QString& folder, const QStringList& files);
  void show_made(const QString& file);
  void show_file(const QString& file);
  void show_item(QListWidgetItem& item);
  void filter();
  void want_seen();
  void save_folders() const;

  AssetThumbnails m_thumbnails;
  Theme m_theme;
  QComboBox *m_folders, *m_unit;
  QLineEdit* m_search;
  QToolButton *m_add, *m_forget;
  AssetList* m_list;
  QHash<QString, QListWidgetItem*> m_items;  // by file
  QTimer m_scrolled;
  struct Waiting {
    FolderChoice chosen;
    std::function<void(const Asset&)> then;
  };
  std::map<QString, std::vector<Waiting>> m_waiting;  // by file
  bool m_listed = false;
};

}  // namespace trivet::edit
