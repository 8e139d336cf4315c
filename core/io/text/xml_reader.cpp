#include "core/io/text/xml_reader.h"

#include <expat.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>

namespace trivet {
namespace {

constexpr size_t kXmlPiece = size_t{1} << 22;  // Expat copies each

std::string_view local_name(std::string_view name) {
  const size_t colon = name.find(':');
  return colon == name.npos ? name : name.substr(colon + 1);
}

bool equals(const char* text, std::string_view other) {
  return std::strncmp(text, other.data(), other.size()) == 0 && text[other.size()] == '\0';
}

size_t position(XML_Parser parser) { return static_cast<size_t>(XML_GetCurrentByteIndex(parser)); }

// Exceptions must not pass through C: the first one stops the parser and is thrown behind it.
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

Reading& reading_of(void* data) { return *static_cast<Reading*>(data); }

void begin_element(void* data, const char* name, const char** attributes) {
  Reading& reading = reading_of(data);
  reading.guarded([&] { reading.handlers.begin(XmlElement(reading.parser, name, attributes)); });
}

void end_element(void* data, const char* name) {
  Reading& reading = reading_of(data);
  reading.guarded([&] { reading.handlers.end(local_name(name), position(reading.parser)); });
}

void add_text(void* data, const char* text, int length) {
  Reading& reading = reading_of(data);
  reading.guarded([&] { reading.handlers.text({text, static_cast<size_t>(length)}); });
}

void declare_entity(void* data, const char*, int, const char*, int, const char*, const char*,
                    const char*, const char*) {
  Reading& reading = reading_of(data);
  reading.guarded([&] { reading.handlers.own_entity(XML_GetCurrentLineNumber(reading.parser)); });
}

void set_handlers(Reading& reading) {
  XML_SetUserData(reading.parser, &reading);
  XML_SetElementHandler(reading.parser, begin_element, end_element);
  if (reading.handlers.text) XML_SetCharacterDataHandler(reading.parser, add_text);
  if (reading.handlers.own_entity) XML_SetEntityDeclHandler(reading.parser, declare_entity);
}

XML_Status parse(XML_Parser parser, std::string_view text) {
  XML_Status status = XML_STATUS_OK;
  do {
    const size_t length = std::min(text.size(), kXmlPiece);
    const bool last = length == text.size();
    status = XML_Parse(parser, text.data(), static_cast<int>(length), last);
    text.remove_prefix(length);
    if (last) break;
  } while (status == XML_STATUS_OK);
  return status;
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

size_t XmlElement::begin() const { return position(m_parser); }

size_t XmlElement::content() const {
  return begin() + static_cast<size_t>(XML_GetCurrentByteCount(m_parser));
}

size_t XmlElement::line() const { return XML_GetCurrentLineNumber(m_parser); }

std::optional<XmlFault> read_xml(std::string_view text, const XmlHandlers& handlers,
                                 const char* encoding) {
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(encoding), XML_ParserFree);
  Reading reading{handlers, parser.get(), nullptr};
  set_handlers(reading);
  const XML_Status status = parse(parser.get(), text);
  if (reading.error) std::rethrow_exception(reading.error);
  if (status == XML_STATUS_OK) return std::nullopt;
  return XmlFault{XML_GetCurrentLineNumber(parser.get()),
                  XML_GetCurrentColumnNumber(parser.get()) + 1,
                  XML_ErrorString(XML_GetErrorCode(parser.get()))};
}

}  // namespace trivet
