#include <algorithm>
#include <filesystem>

#include "core/base/bad_input.h"
#include "core/io/json.h"
#include "core/io/staged_files.h"
#include "ops/files/labels/coco_images.h"
#include "ops/files/labels/data_sets.h"
#include "ops/files/labels/folders.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

/// annotations.json of a set that may be there already.
class CocoSet {
 public:
  explicit CocoSet(std::string file) : m_file(std::move(file)) {
    std::error_code ignored;
    if (!fs::exists(m_file, ignored)) return;
    const auto read =
        json_if_valid<OrderedJson>(read_text_file(m_file, kMaxSetBytes), {64, kMaxSetBytes});
    if (!read || !read->is_object()) refuse();
    m_json = *read;
    for (const char* const list : {"images", "categories", "annotations"})
      if (!m_json.contains(list) || !m_json[list].is_array()) refuse();
  }

  std::int64_t next_id(const char* list, std::int64_t first) const {
    std::int64_t next = first;
    if (m_json.contains(list))
      for (const OrderedJson& item : m_json[list]) next = std::max(next, id_of(item) + 1);
    return next;
  }
  /// The classes of the set, and after them those of a scene that it does not have.
  std::vector<std::string> classes_with(const std::vector<std::string>& of_scene) const {
    std::vector<std::string> classes;
    if (m_json.contains("categories"))
      for (const OrderedJson& item : m_json["categories"]) {
        if (id_of(item) != static_cast<std::int64_t>(classes.size()) + 1) refuse();
        if (!item.contains("name") || !item["name"].is_string()) refuse();
        classes.push_back(item["name"]);
      }
    for (const std::string& name : of_scene)
      if (std::find(classes.begin(), classes.end(), name) == classes.end()) classes.push_back(name);
    return classes;
  }
  std::string with(const CocoImages& added, const std::vector<std::string>& classes) const {
    OrderedJson out = m_json.empty() ? coco_head() : m_json;
    for (const auto& [list, items] :
         {std::pair("images", &added.images()), std::pair("annotations", &added.annotations())}) {
      OrderedJson& all = out[list];
      if (!all.is_array()) all = OrderedJson::array();
      all.insert(all.end(), items->begin(), items->end());
    }
    out["categories"] = coco_categories(classes);
    return readable_json(out);
  }

 private:
  std::int64_t id_of(const OrderedJson& item) const {
    if (!item.is_object() || !item.contains("id") || !item["id"].is_number_integer()) refuse();
    const auto id = item["id"].get<std::int64_t>();
    if (id < 0 || id > std::int64_t{1} << 52) refuse();
    return id;
  }
  [[noreturn]] void refuse() const {
    bad_file(m_file,
             "is no COCO set that can be added to; accepted: one that Trivet wrote, or a new "
             "folder");
  }

  std::string m_file;
  OrderedJson m_json;
};

class CocoWriter : public DataSetWriter {
 public:
  CocoWriter(const std::string& folder, const LabelledScene& scene)
      : m_folder(folder),
        m_set(folder + "/annotations.json"),
        m_classes(m_set.classes_with(scene.classes)),
        m_next_image(m_set.next_id("images", 0)),
        m_images(scene, m_next_image, m_set.next_id("annotations", 1),
                 class_ids(scene.classes, m_classes)) {
    m_files.add_folder(folder + "/images");
  }

  void add(const LabelView& view, const Labels& labels, const std::string& picture) override {
    const std::string file = number_text(static_cast<int>(m_next_image++)) + ".png";
    m_files.add(m_folder + "/images/" + file, picture);
    m_images.add(view, labels, file);
  }
  void finish() override {
    m_files.add(m_folder + "/annotations.json", m_set.with(m_images, m_classes));
    m_files.commit();
  }

 private:
  static std::vector<int> class_ids(const std::vector<std::string>& own,
                                    const std::vector<std::string>& all) {
    std::vector<int> out;
    for (const std::string& name : own)
      out.push_back(1 + static_cast<int>(std::find(all.begin(), all.end(), name) - all.begin()));
    return out;
  }

  std::string m_folder;
  CocoSet m_set;
  std::vector<std::string> m_classes;
  std::int64_t m_next_image;
  CocoImages m_images;
  StagedFiles m_files;
};

}  // namespace

std::unique_ptr<DataSetWriter> make_coco_writer(const std::string& folder,
                                                const LabelledScene& scene) {
  return std::make_unique<CocoWriter>(folder, scene);
}

}  // namespace trivet
