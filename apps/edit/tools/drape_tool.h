// DRAPE: a click lets a sheet come down there; clicks from place to place lay a cable.
#pragma once

#include "apps/edit/tools/tool.h"
#include "ops/operations/drape.h"

namespace trivet::edit {

class DrapeTool : public Tool {
 public:
  DrapeTool(Document& document, const ToolOptions& options)
      : m_document(document), m_options(options) {}

  ToolKind kind() const override { return ToolKind::Drape; }
  bool pointer(const PointerEvent& event) override;
  bool key(const KeyEvent& event) override;
  void cancel() override;
  bool is_active() const override { return !m_corners.empty(); }
  Overlay overlay(const View& view) const override;
  Cursor cursor() const override { return Cursor::Cross; }
  std::string hint() const override;
  bool wants_key(const KeyEvent& event) const override;

 private:
  /// A place of a cable: beside a surface, which holds it if it is an end.
  struct Corner {
    Vec3 point;
    std::string holder;  // empty: the floor
  };
  bool lays_cable() const;
  Corner corner_at(const struct Picked& at) const;
  std::vector<Vec3> path(const std::vector<Corner>& corners) const;
  DrapeOperation sheet_at(const Vec3& point) const;
  bool click(const PointerEvent& event);
  bool finish();
  std::string new_name(const std::string& like) const;

  Document& m_document;
  const ToolOptions& m_options;
  std::vector<Corner> m_corners;
  std::optional<Corner> m_hovered;
  std::optional<Vec3> m_hovered_point;
  double m_turned_deg = 0;  // of the sheet
};

}  // namespace trivet::edit
