#include "apps/trivet/help.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace trivet::apps {
namespace {

constexpr size_t kTextColumn = 30, kWidth = 100;

// Lines of at most this width; longer words have a line of their own.
std::vector<std::string> wrapped(const std::string& text, size_t width) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width)
      lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

// A term, and beside it or below it what it means.
std::string entry(const std::string& term, const std::string& meaning) {
  std::string out = "  " + term;
  if (meaning.empty()) return out + "\n";
  bool same_line = out.size() + 2 <= kTextColumn;
  if (!same_line) out += "\n";
  for (const std::string& line : wrapped(meaning, kWidth - kTextColumn)) {
    const size_t indent = same_line ? kTextColumn - out.size() : kTextColumn;
    out.append(indent, ' ').append(line).append("\n");
    same_line = false;
  }
  return out;
}

// "a|b|c" for what has few values, else a word: INT:INTEGER is INTEGER.
std::string type_of(const CLI::Option& option) {
  std::string type = option.get_type_name();
  type.erase(0, type.rfind(':') + 1);
  return type == "FLOAT" ? "NUMBER" : type == "UINT" || type == "INT" ? "INTEGER" : type;
}

// [1,0,0,0] is 1 0 0 0, as it is typed; options that state their default in words show no other.
std::string default_of(const CLI::Option& option) {
  if (option.get_type_size() == 0 || option.get_required()) return "";
  if (option.get_description().find("default") != std::string::npos) return "";
  std::string value = option.get_default_str();
  for (const char bracket : {'[', ']', '{', '}', '"'})
    value.erase(std::remove(value.begin(), value.end(), bracket), value.end());
  std::replace(value.begin(), value.end(), ',', ' ');
  return value;
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  names.reserve(options.size());
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return CLI::detail::join(names, ", ");
}

// --perfect-friction,--finite-friction{false} is --perfect-friction, --finite-friction.
std::string spelling_of(const CLI::Option& option, bool positional) {
  std::string names = option.get_name(positional, !positional);
  for (size_t at = names.find("{false}"); at != std::string::npos; at = names.find("{false}"))
    names.erase(at, 7);
  for (size_t at = names.find(','); at != std::string::npos; at = names.find(',', at + 2))
    names.insert(at + 1, " ");
  return names;
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
    std::string out;
    std::istringstream paragraphs(app->get_description());
    for (std::string paragraph; std::getline(paragraphs, paragraph);)
      for (const std::string& line : wrapped(paragraph, kWidth)) out += line + "\n";
    out += make_usage(app, name) + make_positionals(app);
    for (const std::string& group : app->get_groups())
      if (group != kCommonGroup) out += group_text(app, group);
    // Options of every verb say least about this one.
    return out + make_subcommands(app, mode) + group_text(app, kCommonGroup) + make_footer(app);
  }

  std::string make_subcommand(const CLI::App* verb) const override {
    const std::string& text = verb->get_description();
    return entry(verb->get_name(), text.substr(0, text.find_first_of(":;")));
  }

  std::string make_footer(const CLI::App* app) const override {
    const std::string footer = app->get_footer();
    return footer.empty() ? "" : "\n" + footer;
  }

  std::string make_option(const CLI::Option* option, bool positional) const override {
    std::string term = spelling_of(*option, positional), meaning = option->get_description();
    if (option->get_type_size() != 0) {
      const std::string type = type_of(*option);
      if (!type.empty()) term += " " + type;
      if (option->get_expected_max() == CLI::detail::expected_max_vector_size &&
          type.find("...") == std::string::npos)
        term += " ...";
    }
    if (option->get_required() && !positional) meaning += " (required)";
    if (!option->get_needs().empty()) meaning += " (with " + names_of(option->get_needs()) + ")";
    if (!option->get_excludes().empty())
      meaning += " (not with " + names_of(option->get_excludes()) + ")";
    const std::string value = default_of(*option);
    if (!value.empty()) meaning += " (default: " + value + ")";
    return entry(term, meaning);
  }

 private:
  std::string group_text(const CLI::App* app, const std::string& group) const {
    const auto options = app->get_options([&](const CLI::Option* option) {
      return option->get_group() == group && option->nonpositional();
    });
    return group.empty() || options.empty() ? "" : make_group(group, false, options);
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

}  // namespace trivet::apps
