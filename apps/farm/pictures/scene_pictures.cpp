#include "apps/farm/pictures/scene_pictures.h"

#include <algorithm>

#include "apps/farm/pictures/cameras.h"
#include "core/base/arena.h"
#include "core/picture/image_files.h"
#include "core/scene/transaction.h"
#include "ops/files/json/text.h"
#include "raster/path/picture.h"

namespace trivet::farm {
namespace {

// Members of one view after another.
class ViewWriter {
 public:
  ViewWriter(const LabelledScene& scene, const Views& views, std::uint64_t k,
             const DrawPicture& opengl, SceneMembers& out)
      : m_scene(scene), m_views(views), m_k(k), m_opengl(opengl), m_out(out) {}

  void add(const LabelView& view) {
    m_view = &view;
    if (m_views.any_labels()) add_labels();
    if (!m_views.picture) return;
    if (m_opengl) return add(".png", m_opengl(m_scene.picture, view.camera, m_views.samples));
    PathOptions path;
    path.bounces = m_views.bounces;
    add(".png", traced_png(m_scene.picture, view.camera, m_views.samples, path));
  }

 private:
  void add(const std::string& ending, std::string bytes) {
    m_out.more.push_back({member_name(m_k, "." + m_view->name + ending), std::move(bytes)});
  }
  void add_grey(const std::string& ending, const std::vector<std::uint16_t>& values) {
    const PinholeCamera& c = m_view->camera;
    add(ending, encode_grey_png(c.width, c.height, std::span<const std::uint16_t>(values)));
  }
  void add_labels();

  const LabelledScene& m_scene;
  const Views& m_views;
  std::uint64_t m_k;
  const DrawPicture& m_opengl;
  SceneMembers& m_out;
  const LabelView* m_view = nullptr;
};

void ViewWriter::add_labels() {
  const Labels labels =
      render_labels(m_scene.picture, m_view->camera, {.normals = m_views.normals});
  if (m_views.depth) add_grey(".depth.png", depth_in_units(labels, m_views.depth_unit).units);
  if (m_views.instances) add_grey(".instances.png", labels.instances);
  if (m_views.classes) add_grey(".classes.png", class_mask(m_scene, labels));
  if (m_views.normals)
    add(".normals.png", encode_rgb_png(labels.width, labels.height, packed_normals(labels)));
  add(".labels.json", readable_json(labels_json(m_scene, *m_view, labels, true)));
}

// The poses as they are: they were judged when the scene was made.
Scene standing(const Layout& layout, const LoadedModels& models, const std::string& where) {
  Scene scene = trivet::make_scene(layout, models, where);
  Transaction transaction(scene);
  for (const LayoutObject& wanted : layout.objects)
    transaction.edit(*scene.find(wanted.name), [&](Object& object) {
      object.pose = *wanted.pose;
      object.placed = true;
    });
  transaction.commit();
  return scene;
}

}  // namespace

SceneMembers make_pictures(const PictureWork& work, SceneReader& scenes, const Recipe& recipe,
                           const LoadedModels& models, const PhiloxKey& key, std::uint64_t k,
                           const DrawPicture& opengl) {
  SceneMembers out{scenes.read(k / work.scenes.per_unit, k), {}};
  Json& views = out.scene["views"] = Json::array();
  if (out.scene.value("status", Json()) != "ok") return out;
  const std::string where = "scene " + std::to_string(k);
  const Layout layout = layout_of_poses(recipe, out.scene, where);
  const Scene stands = standing(layout, models, where);
  const LabelledScene scene = labelled_scene(stands, layout);
  const auto draw = [&] {
    ViewWriter writer(scene, work.views, k, opengl, out);
    for (const LabelView& view : cameras_of(work.views, scene.picture, key, k)) {
      views.push_back({{"name", view.name}, {"camera", camera_json(view.camera)}});
      writer.add(view);
    }
  };
  in_arena(1, draw);
  // As folders have them.
  std::sort(out.more.begin(), out.more.end(),
            [](const Member& a, const Member& b) { return a.name < b.name; });
  return out;
}

}  // namespace trivet::farm
