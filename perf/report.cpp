#include "perf/report.h"

#include <cstdarg>
#include <cstdio>

namespace trivet::perf {
namespace {

// Three digits, for readable columns.
std::string digits(double value) {
  return text(value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : value >= 1 ? "%.2f" : "%.3f", value);
}

std::string goal_cell(const Row& row) {
  if (!(row.goal_ms > 0)) return "";
  return text("%g ms: ", row.goal_ms) + (row.samples.median_ms() <= row.goal_ms ? "met" : "missed");
}

std::string ratio_cell(const Row& row) {
  if (!(row.ours_ms > 0) || row.samples.count() == 0) return "";
  return "x " + digits(row.samples.median_cpu_ms() / row.ours_ms);
}

std::string row_text(const Row& row) {
  const Samples& s = row.samples;
  std::string out = "| " + row.what + " | ";
  if (s.count() == 0)
    out += " | | | | ";
  else
    out += std::to_string(s.count()) + " | " + digits(s.median_ms()) + " | " + digits(s.p95_ms()) +
           " | " + digits(s.median_cpu_ms()) + " | ";
  return out + goal_cell(row) + " | " + ratio_cell(row) + " | " + row.outcome + " |";
}

}  // namespace

std::string text(const char* format, ...) {
  char buffer[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

std::string short_count(std::int64_t n) {
  if (n >= 1'000'000) return text(n % 1'000'000 ? "%.2fM" : "%.0fM", static_cast<double>(n) * 1e-6);
  if (n >= 1'000) return text(n % 1'000 ? "%.1fK" : "%.0fK", static_cast<double>(n) * 1e-3);
  return std::to_string(n);
}

void Report::section(const std::string& title) {
  std::fprintf(stderr, "\n%s\n", title.c_str());
  m_rows.push_back({true, {title, {}, 0, 0, ""}});
}

void Report::add(Row row) {
  std::fprintf(stderr, "%s\n", row_text(row).c_str());
  m_rows.push_back({false, std::move(row)});
}

std::string Report::markdown() const {
  std::string out =
      "| measurement | n | median ms | p95 ms | median CPU ms | goal | CPU against ours | result "
      "|\n"
      "|---|--:|--:|--:|--:|---|--:|---|\n";
  for (const Line& line : m_rows)
    out += line.is_section ? "| **" + line.row.what + "** | | | | | | | |\n"
                           : row_text(line.row) + "\n";
  return out + m_appendix;
}

}  // namespace trivet::perf
