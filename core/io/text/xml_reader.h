// XML as it streams by (Expat), for readers of any format.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

struct XML_ParserStruct;

namespace trivet {

/// An element as it begins. Names have no prefix of a namespace.
class XmlElement {
 public:
  XmlElement(XML_ParserStruct* parser, const char* name, const char** attributes)
      : m_parser(parser), m_name(name), m_attributes(attributes) {}

  std::string_view name() const;
  /// Null: not there. A name with a prefix ("p:path") asks for that one only.
  const char* find(std::string_view attribute) const;
  /// Names and values in turn, as they are written; a null pointer ends them.
  const char** attributes() const { return m_attributes; }

  std::size_t begin() const;    // byte of the start tag's '<'
  std::size_t content() const;  // byte behind its '>'
  std::size_t line() const;     // from 1

 private:
  XML_ParserStruct* m_parser;
  const char* m_name;
  const char** m_attributes;
};

/// Exceptions of these pass through.
struct XmlHandlers {
  std::function<void(const XmlElement&)> begin;
  /// @param at  byte of the end tag's '<'; of an empty element that of its start tag.
  std::function<void(std::string_view name, std::size_t at)> end;
  std::function<void(std::string_view text)> text = {};   // character data, in any pieces
  std::function<void(std::size_t line)> own_entity = {};  // an entity that the document declares
};

/// The place where text is not well formed, and why.
struct XmlFault {
  std::size_t line = 0, column = 0;  // from 1
  std::string why;
};

/// @param encoding  null: the document's own.
/// @return nullopt: all of it was read.
std::optional<XmlFault> read_xml(std::string_view text, const XmlHandlers& handlers,
                                 const char* encoding = nullptr);

}  // namespace trivet
