#include "ops/files/report/repaired.h"

#include <cstdio>

#include "core/base/count_of.h"
#include "core/base/quoted.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

std::string move_text(const SettledObject& o) {
  char text[120];
  const double up = o.to.translation.z() - o.from.translation.z();
  std::snprintf(text, sizeof text, ": %.4g mm%s, turned by %.3g degrees\n", 1000 * o.moved,
                up > 0.7 * o.moved    ? " up"
                : up < -0.7 * o.moved ? " down"
                                      : "",
                o.turned_deg);
  return "  " + quoted(o.name) + text;
}

std::string quoted_names(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + quoted(name);
  return out;
}

std::string relation_text(const ChangedRelation& r) {
  std::string out = "  " + quoted(r.object);
  if (!r.lost.empty()) out += " no longer rests on " + quoted_names(r.lost);
  if (!r.gained.empty())
    out += (r.lost.empty() ? " now rests on " : ", but on ") + quoted_names(r.gained) +
           (r.lost.empty() ? ", too" : "");
  return out + "\n";
}

}  // namespace

Json point_in_file(double lift, Vec3 point) {
  point.z() -= lift;
  return {point.x(), point.y(), point.z()};
}

Json settled_json(const SettledScene& settled, double lift) {
  Json json = {{"moved", Json::array()}, {"unable", Json::array()}};
  for (const SettledObject& o : settled.moved)
    json["moved"].push_back({{"object", o.name},
                             {"from", point_in_file(lift, o.from.translation)},
                             {"to", point_in_file(lift, o.to.translation)},
                             {"metres", o.moved},
                             {"degrees", o.turned_deg}});
  for (const UnsettledObject& o : settled.unable)
    json["unable"].push_back({{"object", o.name}, {"why", in_english(o.why)}});
  return json;
}

Json mended_json(const MendedScene& mended, double lift) {
  Json json = settled_json(mended, lift);
  json["tolerance"] = mended.tolerance;
  json["supports_meant"] = mended.num_meant;
  json["supports_kept"] = mended.num_kept;
  json["relations"] = Json::array();
  for (const ChangedRelation& r : mended.relations)
    json["relations"].push_back({{"object", r.object}, {"lost", r.lost}, {"gained", r.gained}});
  return json;
}

Json repaired_json(const MendedScene& repaired) {
  return repaired.tolerance > 0 ? mended_json(repaired) : settled_json(repaired);
}

std::string settled_text(const SettledScene& settled) {
  std::string out = count_of(settled.moved.size(), "object") + " moved\n";
  for (const SettledObject& o : settled.moved) out += move_text(o);
  for (const UnsettledObject& o : settled.unable)
    out += "  " + quoted(o.name) + " stays where it was: " + in_english(o.why) + "\n";
  return out;
}

std::string mended_text(const MendedScene& mended) {
  std::string out = settled_text(mended);
  if (mended.num_meant == 0) return out;
  char text[120];
  std::snprintf(text, sizeof text,
                "%zu of %zu supports kept; poses were taken to be off by %.3g mm\n",
                mended.num_kept, mended.num_meant, 1000 * mended.tolerance);
  out += text;
  for (const ChangedRelation& r : mended.relations) out += relation_text(r);
  return out;
}

}  // namespace trivet
