#include "apps/farm/pictures/scene_pictures.h"

#include <algorithm>

#include "apps/farm/pictures/cameras.h"
#include "apps/farm/pictures/data_set.h"
#include "apps/farm/scene/standing.h"
#include "core/base/arena.h"
#include "core/picture/image_files.h"
#include "ops/files/json/text.h"
#include "ops/files/labels/bop_scene.h"
#include "ops/files/labels/coco_images.h"
#include "ops/files/labels/folders.h"
#include "raster/path/picture.h"

namespace trivet::farm {
namespace {

/// Scene, views, and how its pictures are drawn.
struct Drawn {
  const LabelledScene& scene;
  const Views& views;
  const DrawPicture& opengl;
  std::function<PictureLook(int view)> look;

  std::string picture(const LabelView& view, int number) const {
    if (!views.picture) return "";
    if (opengl) return opengl(scene.picture, view.camera, views.samples);
    PathOptions path;
    path.bounces = views.bounces;
    if (look) path.look = look(number);
    return traced_png(scene.picture, view.camera, views.samples, path);
  }
};

/// Takes one view after another.
class SceneWriter {
 public:
  virtual ~SceneWriter() = default;
  /// @param number  of the view, from 0.
  virtual void add(const LabelView& view, int number) = 0;
  virtual void finish() {}
};

// Members of one view after another.
class ViewWriter : public SceneWriter {
 public:
  ViewWriter(const Drawn& drawn, std::uint64_t k, SceneMembers& out)
      : m_drawn(drawn), m_scene(drawn.scene), m_views(drawn.views), m_k(k), m_out(out) {}

  void add(const LabelView& view, int number) override {
    m_view = &view;
    if (m_views.any_labels()) add_labels();
    if (m_views.picture) add(".png", m_drawn.picture(view, number));
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

  const Drawn& m_drawn;
  const LabelledScene& m_scene;
  const Views& m_views;
  std::uint64_t m_k;
  SceneMembers& m_out;
  const LabelView* m_view = nullptr;
};

class BopMembers : public SceneWriter {
 public:
  BopMembers(const Drawn& drawn, SceneMembers& out)
      : m_drawn(drawn),
        m_bop(drawn.scene, drawn.views.depth_unit,
              [&out](const std::string& name, const std::string& bytes) {
                out.more.push_back({name, bytes});
              }) {}
  void add(const LabelView& view, int number) override {
    const Labels labels = render_labels(m_drawn.scene.picture, view.camera, {.normals = false});
    m_bop.add(view, labels, m_drawn.picture(view, number));
  }
  void finish() override { m_bop.finish(); }

 private:
  const Drawn& m_drawn;
  BopScene m_bop;
};

class CocoMembers : public SceneWriter {
 public:
  CocoMembers(const Drawn& drawn, std::uint64_t k, SceneMembers& out)
      : m_drawn(drawn), m_folder(number_text(k)), m_out(out), m_coco(drawn.scene) {}
  void add(const LabelView& view, int number) override {
    const Labels labels = render_labels(m_drawn.scene.picture, view.camera, {.normals = false});
    const std::string file = view.name + ".png";
    m_coco.add(view, labels, m_folder + "/" + file);
    if (m_drawn.views.picture) m_out.more.push_back({file, m_drawn.picture(view, number)});
  }
  void finish() override {
    const OrderedJson json = {{"images", m_coco.images()}, {"annotations", m_coco.annotations()}};
    m_out.more.push_back({"annotations.json", readable_json(json)});
  }

 private:
  const Drawn& m_drawn;
  std::string m_folder;
  SceneMembers& m_out;
  CocoImages m_coco;
};

std::unique_ptr<SceneWriter> writer_of(UnitFormat form, const Drawn& drawn, std::uint64_t k,
                                       SceneMembers& out) {
  if (form == UnitFormat::Bop) return std::make_unique<BopMembers>(drawn, out);
  if (form == UnitFormat::Coco) return std::make_unique<CocoMembers>(drawn, k, out);
  return std::make_unique<ViewWriter>(drawn, k, out);
}

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

}  // namespace

SceneMembers make_pictures(const PictureWork& work, SceneReader& scenes, const Recipe& recipe,
                           const LoadedModels& models, const PhiloxKey& key, std::uint64_t k,
                           const DrawPicture& opengl) {
  SceneMembers out{scenes.read(k / work.scenes.per_unit, k), {}};
  Json& views = out.scene["views"] = Json::array();
  if (out.scene.value("status", Json()) != "ok") {
    const LabelledScene nothing;
    if (is_data_set(work.form))  // files as of a scene without pictures
      writer_of(work.form, {nothing, work.views, opengl, nullptr}, k, out)->finish();
    return out;
  }
  const std::string where = "scene " + std::to_string(k);
  const Layout layout = layout_of_poses(recipe, out.scene, where);
  const Scene stands = standing(layout, models, where);
  const LabelIds ids = label_ids(recipe, models);
  const LabelledScene scene = labelled_scene(stands, layout, {}, &ids);
  Drawn drawn{scene, work.views, opengl, nullptr};
  if (work.views.look)
    drawn.look = [&](int view) {
      return look_of(*work.views.look, *work.environments, key, k, view);
    };
  const auto draw = [&] {
    const auto writer = writer_of(work.form, drawn, k, out);
    int number = 0;
    for (const LabelView& view : cameras_of(work.views, scene, key, k)) {
      views.push_back({{"name", view.name}, {"camera", camera_json(view.camera)}});
      writer->add(view, number++);
    }
    writer->finish();
  };
  in_arena(1, draw);
  // As folders have them.
  std::sort(out.more.begin(), out.more.end(),
            [](const Member& a, const Member& b) { return a.name < b.name; });
  return out;
}

}  // namespace trivet::farm
