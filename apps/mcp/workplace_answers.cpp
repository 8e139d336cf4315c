// Calls that only tell: list, look, check.
#include <algorithm>
#include <filesystem>

#include "apps/mcp/views.h"
#include "apps/mcp/wording.h"
#include "apps/mcp/workplace.h"
#include "core/base/count_of.h"
#include "core/base/error.h"
#include "core/base/extension.h"
#include "ops/base/refusal.h"

namespace trivet::mcp {
namespace {

namespace fs = std::filesystem;

constexpr size_t kObjectsAtOnce = 50, kMostFiles = 200, kMostEntries = 20'000;
constexpr int kMostFolders = 6;  // one in another
constexpr int kLeastSide = 16, kMostSide = 1536, kUsualWidth = 640, kUsualHeight = 480;

bool may_be_opened(const fs::path& file) {
  static const std::vector<std::string> known = {
      ".3ds", ".3mf", ".brep", ".dae",  ".fbx", ".glb", ".gltf", ".iges", ".igs",   ".mjcf", ".obj",
      ".off", ".ply", ".sdf",  ".step", ".stl", ".stp", ".urdf", ".usda", ".world", ".xml"};
  return std::binary_search(known.begin(), known.end(), lower_extension(file));
}

// Relative names, sorted. @param more  is set where some are left out.
std::vector<std::string> files_below(const std::string& folder, bool& more) {
  std::vector<std::string> out;
  std::error_code error;
  const fs::path root = folder.empty() ? fs::path(".") : fs::path(folder);
  fs::recursive_directory_iterator it(root, fs::directory_options::skip_permission_denied, error);
  for (size_t seen = 0; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    if (++seen > kMostEntries) {
      more = true;
      break;
    }
    if (it.depth() >= kMostFolders) it.disable_recursion_pending();
    std::error_code ignored;
    if (it->is_regular_file(ignored) && may_be_opened(it->path()))
      out.push_back(it->path().lexically_relative(root).generic_string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

int side_of(const JsonPlace& arguments, const char* key, int usual) {
  const auto value = arguments.find(key);
  if (!value) return usual;
  if (!value->value().is_number_integer()) value->refuse("a whole number of pixels");
  return static_cast<int>(value->number(kLeastSide, kMostSide));
}

Vec3 point_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

}  // namespace

Answer Workplace::list(const JsonPlace& arguments) {
  arguments.expect_object({}, {"what", "first"});
  const auto what = arguments.find("what");
  const std::string word = what ? what->text() : "objects";
  size_t first = 0;
  if (const auto from = arguments.find("first")) first = static_cast<size_t>(from->number(0, 1e9));
  if (word == "objects") return list_objects(first);
  if (word == "files") return list_files();
  if (word == "joints") return list_joints();
  what->refuse("\"objects\", \"files\" or \"joints\"");
}

Answer Workplace::list_objects(size_t first) const {
  const std::vector<ObjectId> ids = scene().ids();
  const LoadSupport supports = load_support(scene());
  Answer out;
  out.text = count_of(ids.size(), "object") + (scene().floor ? ", a floor at z = 0" : ", no floor");
  out.data = {{"objects", Json::array()}, {"count", ids.size()}};
  const size_t end = std::min(ids.size(), first + kObjectsAtOnce);
  for (size_t i = first; i < end; ++i) {
    out.text += "\n" + object_line(scene(), ids[i], supports);
    out.data["objects"].push_back(object_data(scene(), ids[i], supports));
  }
  if (end < ids.size()) out.text += "\nmore with \"first\": " + std::to_string(end);
  if (ids.empty()) out.text += "\nNext: `list` with \"what\": \"files\", then `append`.";
  return out;
}

Answer Workplace::list_files() const {
  bool more = false;
  std::vector<std::string> files =
      files_below(m_place ? m_place->opened.model_folder : m_options.folder, more);
  more = more || files.size() > kMostFiles;
  if (files.size() > kMostFiles) files.resize(kMostFiles);
  Answer out;
  out.text = count_of(files.size(), "file") + (more ? ", and more" : "");
  for (const std::string& file : files) out.text += "\n" + file;
  out.text += "\nNext: `append` with \"model\", or `open` with \"file\".";
  out.data = {{"files", files}, {"more", more}};
  return out;
}

Answer Workplace::list_joints() const {
  Json answer = ask({{"query", "joints"}});
  Answer out;
  out.text = count_of(answer["joints"].size(), "joint");
  for (const Json& joint : answer["joints"]) out.text += "\n" + joint_line(joint);
  if (!answer["joints"].empty()) out.text += "\nNext: `move_joint`.";
  out.data = {{"joints", answer["joints"]}};
  return out;
}

Answer Workplace::look(const JsonPlace& arguments) {
  arguments.expect_object({}, {"view", "object", "eye", "target", "width", "height"});
  const int width = side_of(arguments, "width", kUsualWidth);
  const int height = side_of(arguments, "height", kUsualHeight);
  std::optional<ObjectId> of;
  if (const auto name = arguments.find("object")) {
    of = scene().find(name->text());
    if (!of || !scene().at(*of).placed)
      name->fail(of ? Sentence("the object is not in the scene")
                    : sentence_of(unknown_object(scene(), name->text())));
  }
  const auto view = arguments.find("view");
  const std::vector<std::string>& names = view_names();
  if (view && std::find(names.begin(), names.end(), view->value()) == names.end())
    view->refuse("\"corner\", \"above\", \"front\", \"back\", \"left\" or \"right\"");
  std::optional<Camera> camera = camera_of(scene(), view ? view->text() : "corner", of);
  const auto eye = arguments.find("eye"), target = arguments.find("target");
  if (eye.has_value() != target.has_value()) arguments.refuse("\"eye\" and \"target\" together");
  if (eye) {
    camera.emplace();
    camera->eye = point_of(eye->numbers(3, -kMaxLength, kMaxLength));
    camera->target = point_of(target->numbers(3, -kMaxLength, kMaxLength));
  }
  Answer out;
  out.png = m_options.draw(scene(), camera, width, height);
  out.text = "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (camera) out.text += ", from " + point_text(camera->eye) + " to " + point_text(camera->target);
  return out;
}

Answer Workplace::check(const JsonPlace& arguments) {
  arguments.expect_object({}, {});
  SceneVerdict verdict = place().dialogue.verdict();
  verdict.path = m_name;
  Answer out;
  out.text = verdict_text(verdict) + advice_on(verdict);
  out.data = Json::parse(verdict_json(verdict));
  out.data.erase("touching");  // a long list of what is right
  return out;
}

}  // namespace trivet::mcp
