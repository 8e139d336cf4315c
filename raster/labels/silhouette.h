// An object as one camera sees it, and the pixels that it covers when alone. Private.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/labels/face_view.h"
#include "raster/labels/labels.h"

namespace trivet {

/// Vertices in the camera frame, those that triangles share once.
struct SeenObject {
  const PictureMesh* mesh;
  std::vector<Vec3> vertices;

  Triangle triangle(std::size_t face) const {
    const Index3& t = mesh->triangles[face];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};
SeenObject see_object(const PictureObject& object, const PinholeCamera& camera);
std::vector<SeenObject> seen_objects(const PictureScene& scene, const PinholeCamera& camera);

/// Three pictures wide and high, the picture in the middle.
PixelRange label_canvas(const PinholeCamera& camera);

/// ObjectLabel::whole_box.
LabelBox whole_box(const SeenObject& object, const PinholeCamera& camera);

/// A bit per pixel of a range.
class Silhouette {
 public:
  explicit Silhouette(const PixelRange& range);

  void add(int y, int x0, int x1);  // both ends in
  bool covers(int x, int y) const;  // false outside of the range
  std::int64_t count(const PixelRange& within) const;
  LabelBox box() const;  // of the pixels' centres

 private:
  std::uint64_t* row(int y) { return m_bits.data() + std::size_t(y - m_range.y0) * m_words; }
  const std::uint64_t* row(int y) const {
    return m_bits.data() + std::size_t(y - m_range.y0) * m_words;
  }

  PixelRange m_range;
  std::size_t m_words = 0;  // per row
  std::vector<std::uint64_t> m_bits;
};

/// Pixels of the window whose centre the object covers.
Silhouette draw_silhouette(const SeenObject& object, const PinholeCamera& camera,
                           const PixelRange& window);

}  // namespace trivet
