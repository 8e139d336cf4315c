// Table of all measurements of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "perf/timing.h"

namespace trivet::perf {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// 10'000 as "10K", 1'000'000 as "1M".
std::string short_count(std::int64_t n);

struct Row {
  std::string what;
  Samples samples;
  double goal_ms = 0;   // for the median; 0: none
  double ours_ms = 0;   // median CPU time of Trivet for the same, in rows of others; 0: none
  std::string outcome;  // result, and cost in other units
};

class Report {
 public:
  // All of them print the added row to stderr.

  /// A row that spans the table.
  void section(const std::string& title);
  void add(Row row);
  /// A row without timing.
  void remark(const std::string& what, const std::string& outcome) {
    add({what, {}, 0, 0, outcome});
  }
  /// Adds text of its own below the table.
  void append(const std::string& markdown) { m_appendix += markdown; }
  /// Adds a line of comma-separated values for plots; the first names the columns.
  void add_data(const std::string& line) { m_data += line + "\n"; }
  const std::string& data() const { return m_data; }
  /// Adds to the hash of the run.
  void mix(std::uint64_t section_hash) {
    m_hash = (m_hash.value_or(0xcbf29ce484222325) ^ section_hash) * 0x100000001b3;
  }
  /// Adds to the hash of the run, and a row.
  void add_hash(std::uint64_t section_hash) {
    remark("hash of these results", text("%016llx", static_cast<unsigned long long>(section_hash)));
    mix(section_hash);
  }
  /// Nullopt if no section added a hash.
  std::optional<std::uint64_t> hash() const { return m_hash; }

  std::string markdown() const;

 private:
  struct Line {
    bool is_section;
    Row row;
  };
  std::vector<Line> m_rows;
  std::string m_data, m_appendix;
  std::optional<std::uint64_t> m_hash;
};

}  // namespace trivet::perf
