// z-lists of a scene as columns of arrays.
#include <pybind11/stl.h>

#include "apps/python/module/arrays.h"
#include "apps/python/module/bindings.h"
#include "raster/zlist/complete_zlists.h"

namespace trivet::python {
namespace {

using namespace py::literals;

struct Columns {
  Projection view;
  std::vector<std::int64_t> start{0};
  std::vector<Index> object, face;
  std::vector<double> nearest, farthest;
};

// @param number_of  of each body: its object's place in the scene's order.
Columns columns_of(const std::vector<Body>& bodies, const std::vector<Index>& number_of,
                   const ProjectionOptions& options) {
  const CompleteZLists lists(bodies, options);
  Columns out;
  out.view = lists.projection();
  for (int row = 0; row < out.view.height; ++row)
    for (int column = 0; column < out.view.width; ++column) {
      for (const ZListItem& item : lists.list(column, row)) {
        out.object.push_back(number_of[item.body]);
        out.face.push_back(static_cast<Index>(item.face));
        out.nearest.push_back(out.view.depth(item.lower));
        out.farthest.push_back(out.view.depth(item.upper));
      }
      out.start.push_back(static_cast<std::int64_t>(out.object.size()));
    }
  return out;
}

py::dict zlists(SharedScene& shared, const Doubles& direction, int resolution,
                const std::optional<std::array<double, 4>>& region, double most_bytes,
                int num_threads) {
  ProjectionOptions options;
  options.direction = vector_of(direction, "direction");
  options.resolution = resolution;
  options.most_bytes = static_cast<std::size_t>(most_bytes);
  options.num_threads = num_threads;
  if (region) {
    const auto& r = *region;
    options.region = ImageRegion{Vec2(r[0], r[1]), Vec2(r[2], r[3])};
  }
  Scene scene;
  {
    const SceneGuard guard(shared);
    scene = shared.scene();
  }
  std::vector<std::string> names;
  std::vector<Index> number_of;
  std::vector<Body> bodies;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.placed) {
      number_of.push_back(static_cast<Index>(names.size()));
      bodies.emplace_back(*object.shape, object.world_from_object());
    }
    names.push_back(object.name);
  }
  const Columns lists = without_gil([&] { return columns_of(bodies, number_of, options); });
  const Projection& view = lists.view;
  return py::dict("names"_a = py::tuple(py::cast(names)), "width"_a = view.width,
                  "height"_a = view.height, "pixel"_a = view.pixel,
                  "corner"_a = std::pair(view.corner.x(), view.corner.y()),
                  "right"_a = array_of(view.right), "up"_a = array_of(view.up),
                  "direction"_a = array_of(view.direction), "start"_a = column(lists.start),
                  "object"_a = column(lists.object), "face"_a = column(lists.face),
                  "nearest"_a = column(lists.nearest), "farthest"_a = column(lists.farthest));
}

}  // namespace

void bind_zlists(SceneClass& scene) {
  scene.def("zlists", &zlists, "direction"_a, "resolution"_a, "region"_a, "most_bytes"_a,
            "num_threads"_a);
}

}  // namespace trivet::python
