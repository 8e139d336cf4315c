// Panel with the z-lists of the motion under the hand: depth images, bounds, pairs of faces.
#pragma once

#include <QLabel>
#include <QTreeWidget>
#include <QWidget>

#include "apps/edit/document/document.h"
#include "apps/edit/window/theme.h"

namespace trivet::edit {

/// Moving front, fixed front and gap side by side, each with its scale; doubtful pixels outlined.
class DepthImages : public QWidget {
  Q_OBJECT

 public:
  explicit DepthImages(QWidget* parent = nullptr);
  void show_view(std::shared_ptr<const ZListView> view);
  QSize sizeHint() const override { return {560, 210}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::shared_ptr<const ZListView> m_view;
};

class ZListPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ZListPanel(Document& document, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);

 private:
  void follow();
  void list_pairs(const ZListView& view);

  Document& m_document;
  QLabel* m_summary;
  DepthImages* m_images;
  QTreeWidget* m_pairs;
};

}  // namespace trivet::edit
