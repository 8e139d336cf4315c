// Size, unit and up axis of a model's file in words; what was chosen for its folder.
#pragma once

#include <optional>

#include "apps/edit/window/asset_thumbnails.h"

namespace trivet::edit {

/// "23.5 × 10 × 7.4, likely cm"
QString size_text(const AssetInfo& info);
/// "up: y, likely"
QString up_text(const AssetInfo& info);

/// On what was left out, or the error, in the language of the windows.
QStringList notes_text(const AssetInfo& info);

/// The folder of models' pictures; empty: none are kept.
QString picture_cache();

/// Choices for the models of a folder, kept in the user's settings.
struct FolderChoice {
  double metres = 0;         // per unit; 0: as stated or likely
  std::optional<UpAxis> up;  // nullopt: as stated or likely
  static FolderChoice of(const QString& folder);
  /// Chosen for the nearest folder above the file, up to `top`.
  static std::optional<UpAxis> up_of(const QString& file, const QString& top);
  void remember(const QString& folder) const;
};

}  // namespace trivet::edit
