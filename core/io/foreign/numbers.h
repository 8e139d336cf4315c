// Numbers in attributes of XML.
#pragma once

#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/base/types.h"
#include "core/io/foreign/xml_text.h"

namespace trivet {

/// The place of an element for messages: "scene.xml, line 12, <geom>".
struct XmlPlace {
  const std::vector<XmlFile>& files;
  const XmlNode& node;

  std::string text() const;
  /// @throws Error (BadInput): "PLACE: ATTRIBUTE "VALUE"; accepted: ..."
  [[noreturn]] void refuse(const std::string& attribute, const std::string& value,
                           const Sentence& accepted) const;
};

/// All words of a text as finite numbers. @throws Error (BadInput) naming the place.
std::vector<double> numbers_in(const std::string& text, const std::string& attribute,
                               const XmlPlace& place);
/// The same; `least` to `most` of them.
std::vector<double> numbers_in(const std::string& text, const std::string& attribute,
                               const XmlPlace& place, size_t least, size_t most);

}  // namespace trivet
