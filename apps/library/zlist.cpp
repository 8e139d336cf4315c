#include "trivet/zlist.h"

#include "apps/library/scene_internal.h"
#include "raster/zlist/complete_zlists.h"

namespace trivet::v0 {
namespace {

/// The placed objects: bodies of the lists, and which object each is.
struct DrawnBodies {
  std::vector<Body> bodies;
  std::vector<std::int32_t> object_of;
  std::vector<std::string> names;  // of all objects

  explicit DrawnBodies(const trivet::Scene& scene) {
    for (const trivet::ObjectId id : scene.ids()) {
      const Object& object = scene.at(id);
      if (object.placed) {
        object_of.push_back(static_cast<std::int32_t>(names.size()));
        bodies.emplace_back(*object.shape, object.world_from_object());
      }
      names.push_back(object.name);
    }
  }
};

void add_projection(const Projection& view, ZLists& out) {
  out.width = view.width, out.height = view.height;
  out.pixel = view.pixel;
  out.right = v0::outer(view.right), out.up = v0::outer(view.up),
  out.direction = v0::outer(view.direction);
  out.corner = v0::outer(view.corner);
}

}  // namespace

ZLists z_lists(const Scene& scene, const ZListOptions& options) {
  return guarded([&] {
    ProjectionOptions projection;
    projection.direction = inner(options.direction);
    projection.resolution = options.resolution;
    projection.num_threads = 0;
    DrawnBodies drawn(scene.internal().scene());
    const CompleteZLists lists(drawn.bodies, projection);
    const Projection& view = lists.projection();
    ZLists out;
    add_projection(view, out);
    out.start.push_back(0);
    for (int row = 0; row < view.height; ++row)
      for (int column = 0; column < view.width; ++column) {
        for (const trivet::ZListItem& item : lists.list(column, row))
          out.items.push_back({drawn.object_of[item.body], static_cast<std::int32_t>(item.face),
                               view.depth(item.lower), view.depth(item.upper)});
        out.start.push_back(static_cast<std::int64_t>(out.items.size()));
      }
    out.objects = std::move(drawn.names);
    return out;
  });
}

}  // namespace trivet::v0
