// Objects and collections behind the outliner's items. Private.
#pragma once

#include <QTreeWidgetItem>
#include <optional>
#include <string>

#include "core/scene/support.h"

namespace trivet::edit {

inline constexpr int kIdRole = Qt::UserRole, kCollectionRole = Qt::UserRole + 1;

inline QVariant data_of(ObjectId id) {
  return QVariant::fromValue((quint64{id.generation} << 32) | id.index);
}

/// The object of an outliner item.
inline std::optional<ObjectId> id_of(const QTreeWidgetItem& item) {
  const QVariant data = item.data(0, kIdRole);
  if (!data.isValid()) return std::nullopt;
  const quint64 bits = data.toULongLong();
  return ObjectId{static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
}

/// The name of a collection's item.
inline std::optional<std::string> collection_of(const QTreeWidgetItem& item) {
  const QVariant data = item.data(0, kCollectionRole);
  if (!data.isValid()) return std::nullopt;
  return data.toString().toStdString();
}

}  // namespace trivet::edit
