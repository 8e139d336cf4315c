#include "core/io/foreign/xml_text.h"

#include <algorithm>
#include <filesystem>

#include "core/base/bad_input.h"
#include "core/io/text/file_bytes.h"
#include "core/io/text/xml_reader.h"

namespace trivet {
namespace {

/// Builds the tree while elements stream by.
class TreeBuilder {
 public:
  // @param limits  what is left of them.
  TreeBuilder(const std::string& path, size_t file, const XmlLimits& limits)
      : m_path(path), m_file(file), m_limits(limits) {
    m_open.push_back(&m_top);
  }

  void begin(const XmlElement& element) {
    if (++m_num_elements > m_limits.max_elements) fail(element.line(), "too many elements");
    if (static_cast<int>(m_open.size()) > m_limits.max_depth)
      fail(element.line(), "nested too deeply");
    XmlNode& node = m_open.back()->children.emplace_back();
    node.tag = element.name();
    for (const char** at = element.attributes(); *at; at += 2)
      node.attributes.emplace_back(at[0], at[1]);
    node.file = m_file;
    node.begin = element.begin();
    node.content = element.content();
    node.line = element.line();
    m_open.push_back(&node);
  }
  void end(size_t at) {
    // An empty element ends where it begins.
    m_open.back()->end = std::max(at, m_open.back()->content);
    m_open.pop_back();
  }
  void text(std::string_view text) { m_open.back()->text.append(text); }
  // Entities could make bytes and numbers disagree, and much of little.
  void refuse_entity(size_t line) const {
    fail(line, "has entities of its own; accepted: files without");
  }
  size_t num_elements() const { return m_num_elements; }
  XmlNode take() { return std::move(m_top.children.front()); }

 private:
  [[noreturn]] void fail(size_t line, const char* why) const {
    bad_file(m_path, "line %1: %2", line, why);
  }

  const std::string& m_path;
  size_t m_file;
  XmlLimits m_limits;
  XmlNode m_top;
  std::vector<XmlNode*> m_open;  // a parent gets no further child while one is open
  size_t m_num_elements = 0;
};

std::string xml_bytes_of(const std::string& path, const XmlLimits& limits) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) bad_file(path, "is no file");
  auto bytes = file_bytes(path, limits.max_bytes);
  if (!bytes)
    bad_file(path, "cannot be read, or is larger than the %1 bytes left", limits.max_bytes);
  return std::move(*bytes);
}

// The limits less the files that were read.
XmlLimits left_of(XmlLimits limits, const std::vector<XmlFile>& files) {
  for (const XmlFile& file : files) {
    limits.max_bytes -= std::min<std::uintmax_t>(limits.max_bytes, file.bytes.size());
    limits.max_elements -= std::min(limits.max_elements, file.num_elements);
  }
  return limits;
}

}  // namespace

const std::string* XmlNode::find(std::string_view attribute) const {
  for (const auto& [name, value] : attributes)
    if (name == attribute) return &value;
  return nullptr;
}

const XmlNode* XmlNode::child(std::string_view name) const {
  for (const XmlNode& node : children)
    if (node.tag == name) return &node;
  return nullptr;
}

XmlNode read_xml_tree(const std::string& path, size_t index, const XmlLimits& all_limits,
                      std::vector<XmlFile>& files) {
  const XmlLimits limits = left_of(all_limits, files);
  std::string bytes = xml_bytes_of(path, limits);
  TreeBuilder tree(path, index, limits);
  const XmlHandlers handlers{[&](const XmlElement& element) { tree.begin(element); },
                             [&](std::string_view, size_t at) { tree.end(at); },
                             [&](std::string_view text) { tree.text(text); },
                             [&](size_t line) { tree.refuse_entity(line); }};
  if (const auto fault = read_xml(bytes, handlers, "UTF-8"))
    bad_file(path, "line %1, column %2: %3", fault->line, fault->column, fault->why);
  files.push_back({path, std::move(bytes), tree.num_elements()});
  return tree.take();
}

}  // namespace trivet
