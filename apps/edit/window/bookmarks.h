// View bookmarks: cameras under the numbers 1 to 9.
//
// They are kept in the settings, under the name of the scene's file, and not in the file: how
// somebody looks at a scene is no part of it, and storing a view neither modifies it nor changes
// its bytes.
#pragma once

#include <QString>
#include <map>

#include "apps/edit/tools/events.h"
#include "apps/edit/window/view_camera.h"

namespace trivet::edit {

struct Bookmark {
  WindowKind window = WindowKind::Perspective;  // where it was stored, and is shown again
  ViewCamera camera;
};

class Bookmarks {
 public:
  static constexpr int kMost = 9;

  /// @param number  1 to kMost.
  void store(int number, const Bookmark& bookmark);
  /// Null: none under this number.
  const Bookmark* find(int number) const;

  /// Loads the bookmarks of a file; none of an unnamed scene.
  void load(const QString& file);
  /// Under the name of this file, from now on at every store().
  void keep_for(const QString& file);

 private:
  void save() const;

  std::map<int, Bookmark> m_bookmarks;
  QString m_file;  // empty: unnamed, kept until another scene is opened
};

}  // namespace trivet::edit
