// Verdicts as lines, as a table and as JSON.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/base/count_of.h"
#include "core/base/quoted.h"
#include "core/base/tunables.h"
#include "core/io/json.h"
#include "ops/files/foreign/findings.h"

namespace trivet {
namespace {

using Kind = SceneFinding::Kind;
using Json = nlohmann::ordered_json;

constexpr size_t kMostLines = 40;   // findings shown of a scene
constexpr size_t kWidestName = 40;  // of a column
constexpr Kind kKinds[] = {Kind::PassesThrough, Kind::Floats, Kind::NotAtRest, Kind::Unstable};

// "2.3 mm", "1.2 m", "0.4 um".
std::string length_text(double metres) {
  char text[40];
  if (metres < 1e-4)
    std::snprintf(text, sizeof text, "%.2g um", 1e6 * metres);
  else if (metres < 1)
    std::snprintf(text, sizeof text, "%.3g mm", 1e3 * metres);
  else
    std::snprintf(text, sizeof text, "%.3g m", metres);
  return text;
}

std::string point_text(const Vec3& p) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.4g, %.4g, %.4g)", p.x(), p.y(), p.z());
  return text;
}

// "3 pairs interpenetrate, 2 objects float".
std::string counts_text(const std::vector<size_t>& counts) {
  std::string out;
  const auto add = [&](size_t n, const char* noun, const char* one, const char* many) {
    if (n) out += (out.empty() ? "" : ", ") + count_of(n, noun) + " " + (n == 1 ? one : many);
  };
  add(counts[0], "pair", "interpenetrates", "interpenetrate");
  add(counts[1], "object", "floats", "float");
  add(counts[2], "object", "is not at rest", "are not at rest");
  add(counts[3], "object", "is unstable in the whole", "are unstable in the whole");
  return out;
}

std::vector<size_t> counts_of(const SceneVerdict& verdict) {
  std::vector<size_t> out;
  for (const Kind kind : kKinds) out.push_back(verdict.count(kind));
  return out;
}

std::string detail_text(const SceneFinding& f) {
  switch (f.kind) {
    case Kind::PassesThrough:
      return length_text(f.metres) + " deep at " + point_text(f.point);
    case Kind::Floats:
      return f.other.empty() ? "over nothing: it would fall for ever"
                             : length_text(f.metres) + " above " + quoted(f.other);
    case Kind::NotAtRest:
      return f.way.empty() ? "what it touches does not hold it" : f.way;
    case Kind::Unstable:
      break;
  }
  return f.way.empty() ? "the whole does not hold it" : f.way;
}

std::string subject_text(const SceneFinding& f) {
  return quoted(f.object) + (f.kind == Kind::PassesThrough ? " and " + quoted(f.other) : "");
}

std::string padded(std::string text, size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string head_text(const SceneVerdict& v) {
  std::string out = v.path + ": " + v.format;
  if (!v.key.empty()) out += ", keyframe " + quoted(v.key);
  out += ": " + count_of(v.num_objects, "object") + ", " + std::to_string(v.num_free) + " free";
  if (v.num_joints) out += "; " + count_of(v.num_joints, "joint") + " held as they are";
  return out + "\n";
}

std::string verdict_line(const SceneVerdict& v) {
  const std::string part = v.whole() ? "" : " (judged in part)";
  if (v.ok())
    return "ok" + part + ": nothing interpenetrates, everything is at rest" +
           (v.num_flush() ? "; " + count_of(v.num_flush(), "pair") + " flush within rounding"
                          : "") +
           "\n";
  return "failed" + part + ": " + counts_text(counts_of(v)) + "\n";
}

Json finding_json(const SceneFinding& f) {
  Json json = {{"kind", to_string(f.kind)}, {"object", f.object}};
  if (!f.other.empty()) json["other"] = f.other;
  if (f.kind == Kind::PassesThrough) {
    json["depth"] = f.metres;
    json["point"] = {f.point.x(), f.point.y(), f.point.z()};
  }
  if (f.kind == Kind::Floats) json["height"] = f.other.empty() ? Json() : Json(f.metres);
  if (!f.way.empty()) json["way"] = f.way;
  return json;
}

std::string short_name(const std::string& path) {
  if (path.size() <= kWidestName) return path;
  return "..." + path.substr(path.size() - kWidestName + 3);
}

double deepest(const SceneVerdict& v) {
  double out = 0;
  for (const SceneFinding& f : v.findings)
    if (f.kind == Kind::PassesThrough) out = std::max(out, f.metres);
  return out;
}

std::string row_text(const SceneVerdict& v, size_t width) {
  std::string out = padded(short_name(v.path), width);
  if (!v.error.empty()) return out + "  not read: " + in_english(v.error) + "\n";
  char text[160];
  const std::vector<size_t> n = counts_of(v);
  std::snprintf(
      text, sizeof text, "  %7zu %5zu %7zu %7s %9s %7s %8s %9s  ", v.num_objects, v.num_free,
      v.pairs.touching.size(), n[0] ? std::to_string(n[0]).c_str() : "-",
      n[0] ? length_text(deepest(v)).c_str() : "-", n[1] ? std::to_string(n[1]).c_str() : "-",
      n[2] ? std::to_string(n[2]).c_str() : "-", n[3] ? std::to_string(n[3]).c_str() : "-");
  return out + text + (v.ok() ? "ok" : "failed") + (v.whole() ? "" : ", in part") + "\n";
}

}  // namespace

std::string pairs_text(const PairClasses& pairs, double clearance) {
  const size_t near = pairs.touching.size();
  const auto part = [](size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  return "pairs: " + part(pairs.num_through, "passes", "pass") + " through, " +
         part(near, "touches or is", "touch or are") + " closer than " +
         length_text(kContactTolerance * clearance) + ", " + part(pairs.num_apart, "is", "are") +
         " apart";
}

std::string touching_text(const TouchingPair& pair) {
  return quoted(pair.a) + " and " + quoted(pair.b) + ", " +
         (pair.gap == 0  ? std::string("flush")
          : pair.gap > 0 ? length_text(pair.gap) + " apart"
                         : length_text(-pair.gap) + " in each other");
}

std::string finding_text(const SceneFinding& f) {
  const bool pair = f.kind == Kind::PassesThrough;
  const bool verb = f.kind == Kind::Floats;
  return subject_text(f) +
         (pair ? " interpenetrate" : (verb ? " " : " is ") + std::string(to_string(f.kind))) +
         ", " + detail_text(f);
}

std::string verdict_text(const SceneVerdict& v) {
  if (!v.error.empty()) return in_english(v.error) + "\n";
  std::ostringstream out;
  out << head_text(v);
  size_t width = 0;
  for (const SceneFinding& f : v.findings) width = std::max(width, subject_text(f).size());
  width = std::min(width, 2 * kWidestName);
  for (size_t i = 0; i < v.findings.size() && i < kMostLines; ++i) {
    const SceneFinding& f = v.findings[i];
    const char* const kind = f.kind == Kind::PassesThrough ? "interpenetrate" : to_string(f.kind);
    out << "  " << padded(kind, 15) << padded(subject_text(f), width) << "  " << detail_text(f)
        << "\n";
  }
  if (v.findings.size() > kMostLines)
    out << "  and " << v.findings.size() - kMostLines << " more; all with --json\n";
  if (v.pairs.num_judged() > 0) out << "  " << pairs_text(v.pairs, v.clearance) << "\n";
  for (const Sentence& what : v.unread) out << "  not judged: " << in_english(what) << "\n";
  for (const Sentence& note : v.notes) out << "  note: " << in_english(note) << "\n";
  out << verdict_line(v);
  return out.str();
}

std::string verdict_table(const std::vector<SceneVerdict>& verdicts) {
  size_t width = 5, num_ok = 0, num_unread = 0, num_part = 0;
  for (const SceneVerdict& v : verdicts) width = std::max(width, short_name(v.path).size());
  std::string out = padded("scene", width) +
                    "  objects  free   touch   pairs   deepest   float  no rest  unstable\n";
  std::vector<size_t> sums(std::size(kKinds), 0);
  for (const SceneVerdict& v : verdicts) {
    out += row_text(v, width);
    num_ok += v.ok();
    num_unread += !v.error.empty();
    num_part += v.error.empty() && !v.whole();
    for (size_t k = 0; k < sums.size(); ++k) sums[k] += v.count(kKinds[k]);
  }
  out += count_of(verdicts.size(), "scene") + ": " + std::to_string(num_ok) + " ok";
  if (const std::string counts = counts_text(sums); !counts.empty()) out += "; " + counts;
  if (num_part) out += "; " + std::to_string(num_part) + " judged in part";
  if (num_unread) out += "; " + std::to_string(num_unread) + " not read";
  return out + "\n";
}

std::string verdict_json(const SceneVerdict& v) {
  Json json = {{"file", v.path}};
  if (!v.error.empty()) {
    json["error"] = in_english(v.error);
    return json.dump();
  }
  json["format"] = v.format;
  if (!v.key.empty()) json["key"] = v.key;
  json["ok"] = v.ok();
  json["whole"] = v.whole();
  json["objects"] = v.num_objects;
  json["free"] = v.num_free;
  json["joints"] = v.num_joints;
  json["clearance"] = v.clearance;
  json["pairs"] = {{"passing_through", v.pairs.num_through},
                   {"touching", v.pairs.touching.size()},
                   {"apart", v.pairs.num_apart}};
  json["touching"] = Json::array();
  for (const TouchingPair& p : v.pairs.touching)
    json["touching"].push_back({{"object", p.a}, {"other", p.b}, {"gap", p.gap}});
  json["findings"] = Json::array();
  for (const SceneFinding& f : v.findings) json["findings"].push_back(finding_json(f));
  json["not_judged"] = in_english(v.unread);
  json["notes"] = in_english(v.notes);
  json["milliseconds"] = v.milliseconds;
  return json.dump();
}

}  // namespace trivet
