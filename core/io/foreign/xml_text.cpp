#include "core/io/foreign/xml_text.h"

#include <expat.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/base/bad_input.h"
#include "core/io/text/file_bytes.h"

namespace trivet {
namespace {

std::string_view tag_without_prefix(std::string_view name) {
  const size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

/// Builds the tree while Expat reads. Exceptions must not pass through C: a trouble stops it.
class TreeBuilder {
 public:
  // @param limits  what is left of them.
  TreeBuilder(XML_Parser parser, size_t file, const XmlLimits& limits)
      : m_parser(parser), m_file(file), m_limits(limits) {
    m_open.push_back(&m_top);
  }

  void begin(const char* name, const char** attributes) {
    if (++m_num_elements > m_limits.max_elements) return stop("too many elements");
    if (static_cast<int>(m_open.size()) > m_limits.max_depth) return stop("nested too deeply");
    XmlNode& node = m_open.back()->children.emplace_back();
    node.tag = tag_without_prefix(name);
    for (const char** at = attributes; *at; at += 2) node.attributes.emplace_back(at[0], at[1]);
    node.file = m_file;
    node.begin = position();
    node.content = node.begin + static_cast<size_t>(XML_GetCurrentByteCount(m_parser));
    node.line = XML_GetCurrentLineNumber(m_parser);
    m_open.push_back(&node);
  }
  void end() {
    // An empty element ends where it begins.
    m_open.back()->end = std::max(position(), m_open.back()->content);
    m_open.pop_back();
  }
  void text(const char* text, int length) {
    m_open.back()->text.append(text, static_cast<size_t>(length));
  }
  void stop(const char* why) {
    if (m_trouble) return;
    m_trouble = why;
    XML_StopParser(m_parser, XML_FALSE);
  }
  const char* trouble() const { return m_trouble; }
  size_t num_elements() const { return m_num_elements; }
  XmlNode take() { return std::move(m_top.children.front()); }

 private:
  size_t position() const { return static_cast<size_t>(XML_GetCurrentByteIndex(m_parser)); }

  XML_Parser m_parser;
  size_t m_file;
  XmlLimits m_limits;
  XmlNode m_top;
  std::vector<XmlNode*> m_open;  // a parent gets no further child while one is open
  size_t m_num_elements = 0;
  const char* m_trouble = nullptr;
};

TreeBuilder& builder(void* data) { return *static_cast<TreeBuilder*>(data); }

void set_handlers(XML_Parser parser, TreeBuilder& tree) {
  XML_SetUserData(parser, &tree);
  XML_SetElementHandler(
      parser, [](void* d, const char* name, const char** a) { builder(d).begin(name, a); },
      [](void* d, const char*) { builder(d).end(); });
  XML_SetCharacterDataHandler(
      parser, [](void* d, const char* text, int length) { builder(d).text(text, length); });
  // Entities could make bytes and numbers disagree, and much of little.
  XML_SetEntityDeclHandler(parser, [](void* d, const char*, int, const char*, int, const char*,
                                      const char*, const char*, const char*) {
    builder(d).stop("has entities of its own; accepted: files without");
  });
}

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
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate("UTF-8"), XML_ParserFree);
  TreeBuilder tree(parser.get(), index, limits);
  set_handlers(parser.get(), tree);
  const XML_Status status =
      XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE);
  if (tree.trouble())
    bad_file(path, "line %1: %2", XML_GetCurrentLineNumber(parser.get()), tree.trouble());
  if (status != XML_STATUS_OK)
    bad_file(path, "line %1, column %2: %3", XML_GetCurrentLineNumber(parser.get()),
             XML_GetCurrentColumnNumber(parser.get()) + 1,
             std::string(XML_ErrorString(XML_GetErrorCode(parser.get()))));
  files.push_back({path, std::move(bytes), tree.num_elements()});
  return tree.take();
}

}  // namespace trivet
