#include "core/io/threemf/xml_reader.h"

#include <expat.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>

#include "core/base/bad_input.h"

namespace trivet {
namespace {

std::string_view local_name(std::string_view name) {
  const size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

bool equals(const char* text, std::string_view other) {
  return std::strncmp(text, other.data(), other.size()) == 0 && text[other.size()] == '\0';
}

// Exceptions must not pass through C.
struct Reading {
  const XmlHandlers& handlers;
  XML_Parser parser;
  std::exception_ptr error;

  template <class Call>
  void guarded(const Call& call) {
    if (error) return;
    try {
      call();
    } catch (...) {
      error = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
};

void begin_element(void* data, const char* name, const char** attributes) {
  auto& reading = *static_cast<Reading*>(data);
  reading.guarded([&] { reading.handlers.begin(XmlElement(name, attributes)); });
}

void end_element(void* data, const char* name) {
  auto& reading = *static_cast<Reading*>(data);
  reading.guarded([&] { reading.handlers.end(local_name(name)); });
}

}  // namespace

std::string_view XmlElement::name() const { return local_name(m_name); }

const char* XmlElement::find(std::string_view attribute) const {
  const bool whole = attribute.find(':') != attribute.npos;
  for (const char** at = m_attributes; *at; at += 2) {
    if (equals(*at, attribute)) return at[1];
    const char* const colon = whole ? nullptr : std::strchr(*at, ':');
    if (colon && equals(colon + 1, attribute)) return at[1];
  }
  return nullptr;
}

void read_xml(const std::string& file, const std::string& part, std::string_view text,
              const XmlHandlers& handlers) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), XML_ParserFree);
  Reading reading{handlers, parser.get(), nullptr};
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin_element, end_element);
  constexpr size_t kPiece = size_t{1} << 22;  // Expat copies each
  XML_Status status = XML_STATUS_OK;
  do {
    const size_t length = std::min(text.size(), kPiece);
    const bool last = length == text.size();
    status = XML_Parse(parser.get(), text.data(), static_cast<int>(length), last);
    text.remove_prefix(length);
    if (last) break;
  } while (status == XML_STATUS_OK);
  if (reading.error) std::rethrow_exception(reading.error);
  if (status != XML_STATUS_OK)
    bad_file(file, "%1, line %2: %3", part, XML_GetCurrentLineNumber(parser.get()),
             std::string(XML_ErrorString(XML_GetErrorCode(parser.get()))));
}

}  // namespace trivet
