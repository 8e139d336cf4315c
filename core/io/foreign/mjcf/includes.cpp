#include "core/io/foreign/mjcf/includes.h"

#include <filesystem>

#include "core/base/bad_input.h"
#include "core/io/foreign/numbers.h"

namespace trivet::mjcf {
namespace {

constexpr size_t kMostFiles = 1000;
constexpr int kMostIncluded = 32;  // files within files

class Includer {
 public:
  Includer(const XmlLimits& limits, const SceneRoots& roots, std::vector<XmlFile>& files)
      : m_limits(limits), m_roots(roots), m_files(files) {}

  void splice(XmlNode& node, int depth) {
    std::vector<XmlNode> children;
    for (XmlNode& child : node.children) {
      if (child.tag != "include") {
        splice(child, depth);
        children.push_back(std::move(child));
        continue;
      }
      XmlNode root = read(child, depth);
      splice(root, depth + 1);
      for (XmlNode& inner : root.children) children.push_back(std::move(inner));
    }
    node.children = std::move(children);
  }

 private:
  XmlNode read(const XmlNode& include, int depth) {
    const XmlPlace place{m_files, include};
    const std::string* const file = include.find("file");
    if (!file) place.refuse("file", "", "the path of a file");
    if (depth >= kMostIncluded || m_files.size() >= kMostFiles)
      place.refuse("file", *file, say("%1 files, %2 within each other", kMostFiles, kMostIncluded));
    const std::string path = path_of(include, *file);
    m_roots.check(path, place.text());
    return read_xml_tree(path, m_files.size(), m_limits, m_files);
  }

  std::string path_of(const XmlNode& include, const std::string& file) const {
    const auto from = [&](size_t index) {
      return (std::filesystem::path(m_files[index].path).parent_path() / file)
          .lexically_normal()
          .string();
    };
    std::error_code error;
    const std::string of_main = from(0);
    return std::filesystem::exists(of_main, error) ? of_main : from(include.file);
  }

  XmlLimits m_limits;
  const SceneRoots& m_roots;
  std::vector<XmlFile>& m_files;
};

}  // namespace

XmlNode read_with_includes(const std::string& path, const XmlLimits& limits,
                           const SceneRoots& roots, std::vector<XmlFile>& files) {
  XmlNode root = read_xml_tree(path, 0, limits, files);
  Includer(limits, roots, files).splice(root, 0);
  return root;
}

}  // namespace trivet::mjcf
