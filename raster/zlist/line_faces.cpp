#include "raster/zlist/line_faces.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "raster/zlist/draw_faces.h"

namespace trivet {
namespace {

class LineSink final : public SpanSink {
 public:
  static constexpr bool kCentres = false;

  LineSink(const Layer& layer, int width, TriangleRaster& raster,
           const std::function<void(const FaceOnLine&)>& met)
      : m_layer(layer), m_width(width), m_raster(raster), m_met(met) {}

  // Vertices in float32 are too coarse where a face is small and its body is far larger than the
  // image.
  void small(const SmallFace& f) {
    if (!f.centres) return;
    face = f.face;
    m_raster.draw(m_layer.corners(face), *this);
  }
  void span(const Span& s) override {
    if (s.centre_error > kLargestCentreError) return;
    for (int i = 0; i < s.count; ++i)
      if (!std::isnan(s.centre[i])) meet(s.row * m_width + s.first + i, s.centre[i]);
  }

 private:
  void meet(int pixel, float depth) const {
    const Layer::FaceId id = m_layer.id(face);
    m_met({static_cast<std::uint32_t>(pixel), static_cast<std::uint32_t>(id.body),
           static_cast<std::uint32_t>(id.face), depth});
  }

  const Layer& m_layer;
  int m_width;
  TriangleRaster& m_raster;
  const std::function<void(const FaceOnLine&)>& m_met;
};

}  // namespace

void for_each_face_on_lines(std::span<const Body> bodies, const Projection& projection,
                            const std::function<void(const FaceOnLine&)>& met) {
  if (projection.width == 0) return;
  const ZListFrame frame = frame_of(projection);
  std::vector<Index> all(bodies.size());
  std::iota(all.begin(), all.end(), 0);
  Layer layer(frame, bodies, all);
  layer.project(1);
  const View view = View::whole(frame, false);
  TriangleRaster raster(view);
  LineSink sink(layer, view.width, raster, met);
  draw_faces<false>(layer, view, Wanted::all_of(view), 0, layer.num_faces(), 1, raster, sink);
}

}  // namespace trivet
