// XML as it streams by (Expat).
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace trivet {

/// An element as it begins. Names have no prefix of a namespace.
class XmlElement {
 public:
  XmlElement(const char* name, const char** attributes) : m_name(name), m_attributes(attributes) {}

  std::string_view name() const;
  /// Null: not there. A name with a prefix ("p:path") asks for that one only.
  const char* find(std::string_view attribute) const;

 private:
  const char* m_name;
  const char** m_attributes;
};

struct XmlHandlers {
  std::function<void(const XmlElement&)> begin;
  std::function<void(std::string_view)> end;  // name of the element
};

/// Exceptions of the handlers pass through. @param file  for messages.
/// @throws Error (BadInput) naming the file, the part and the line: not well formed.
void read_xml(const std::string& file, const std::string& part, std::string_view text,
              const XmlHandlers& handlers);

}  // namespace trivet
