#include "core/io/assimp/stated_units.h"

#include <utility>

#include "core/io/assimp/xml_text.h"
#include "core/io/text/words.h"

namespace trivet {
namespace {

// Takes the first element that begins so. Empty: there is none, or no such attribute.
std::string_view attribute(std::string_view text, std::string_view element, std::string_view name) {
  const size_t begin = text.find(element);
  return begin == text.npos ? "" : attribute_of(text.substr(begin), name);
}

double unit_of_amf(std::string_view head) {
  const std::string unit = lower_case(attribute(head, "<amf", "unit"));
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"inch", 0.0254}, {"feet", 0.3048},     {"foot", 0.3048}, {"meter", 1},
      {"metre", 1},     {"micrometer", 1e-6}, {"micron", 1e-6}};
  for (const auto& [name, metres] : kUnits)
    if (unit == name) return metres;
  return 0.001;
}

double unit_of_x3d(std::string_view head) {
  for (size_t at = head.find("<unit"); at != head.npos; at = head.find("<unit", at + 1))
    if (attribute(head.substr(at), "<unit", "category") == "length")
      if (const auto factor = number_from(attribute(head.substr(at), "<unit", "conversionFactor")))
        return *factor;
  return 1;
}

// Lines of codes and values in turn; 0: no unit.
std::optional<double> unit_of_dxf(std::string_view head) {
  const size_t at = head.find("$INSUNITS");
  if (at == head.npos) return std::nullopt;
  TextLines lines(head.substr(at));
  std::string_view line;
  for (int i = 0; i < 3; ++i)
    if (!lines.next(line)) return std::nullopt;
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"1", 0.0254}, {"2", 0.3048}, {"3", 1609.344}, {"4", 0.001}, {"5", 0.01},
      {"6", 1},      {"7", 1000},   {"10", 0.9144},  {"13", 1e-6}, {"14", 0.1}};
  for (const auto& [code, metres] : kUnits)
    if (trimmed(line) == code) return metres;
  return std::nullopt;
}

}  // namespace

std::optional<double> stated_unit(const std::string& format, std::string_view head) {
  if (format == "amf") return unit_of_amf(head);
  if (format == "x3d") return unit_of_x3d(head);
  if (format == "dxf") return unit_of_dxf(head);
  return std::nullopt;
}

}  // namespace trivet
