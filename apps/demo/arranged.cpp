#include "apps/demo/arranged.h"

#include "apps/demo/problem_writer.h"
#include "core/base/error.h"

namespace trivet {
namespace {

constexpr std::pair<const char*, ArrangedDemo (*)()> kArranged[] = {
    {"table-for-six", make_table_for_six},
    {"tight-table", make_tight_table},
    {"bookcase", make_bookcase_demo},
    {"market", make_market},
    {"office3", make_office3},
    {"workshop", make_workshop}};

}  // namespace

std::vector<std::string> arranged_demo_names() {
  std::vector<std::string> out;
  for (const auto& [name, make] : kArranged) out.emplace_back(name);
  return out;
}

ArrangedDemo make_arranged_demo(const std::string& name) {
  std::string accepted;
  for (const auto& [known, make] : kArranged) {
    if (name == known) return make();
    accepted += (accepted.empty() ? "" : ", ") + std::string(known);
  }
  throw Error(Error::Kind::BadInput, "no arranged demo '%1'; there are %2", name, accepted);
}

}  // namespace trivet
