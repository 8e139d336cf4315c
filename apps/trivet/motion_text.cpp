// z-lists of a motion as text and JSON.
#include <nlohmann/json.hpp>

#include "apps/trivet/list_output.h"
#include "apps/trivet/motion_lists.h"
#include "core/motion/motion.h"
#include "ops/files/json/text.h"
#include "raster/zlist/depth_picture.h"

namespace trivet::apps {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostPairs = 1000;

Json or_null(double x) { return x < kInfinity ? Json(x) : Json(nullptr); }

bool turns(const MotionLists& what) { return what.motion.kind == Motion::Kind::Rotation; }

// Time of a motion in display units: metres, or degrees.
double as_shown(const MotionLists& what, double time) {
  return turns(what) && time < kInfinity ? turned_deg(std::min(time, 1.0)) : time;
}

std::string time_text(const MotionLists& what, double time) {
  if (!(time < kInfinity)) return "none";
  return turns(what) ? formatted("%.9g deg", as_shown(what, time)) : formatted("%.9g m", time);
}

const char* status_name(FirstContact::Status status) {
  switch (status) {
    case FirstContact::Status::Free:
      return "free";
    case FirstContact::Status::Contact:
      return "contact";
    case FirstContact::Status::Crossing:
      break;
  }
  return "crossing";
}

const std::string& fixed_name(const MotionLists& what, Index fixed) {
  static const std::string floor = "floor";
  return fixed == FirstContact::kFloor ? floor : what.fixed_names[fixed];
}

Json motion_part(const MotionLists& what) {
  if (!turns(what))
    return {{"kind", "translation"},
            {"direction", numbers_json(what.motion.axis)},
            {"limit", what.motion.limit}};
  return {{"kind", "rotation"},
          {"axis", numbers_json(what.motion.axis)},
          {"centre", numbers_json(what.motion.centre)},
          {"limit", as_shown(what, what.motion.limit)}};
}

Json contact_part(const MotionLists& what) {
  const FirstContact& contact = what.lists.contact;
  Json out{{"status", status_name(contact.status)}};
  if (contact.status == FirstContact::Status::Free) return out;
  out["at"] = as_shown(what, contact.time);
  out["moving"] = what.moving_names[contact.moving];
  out["fixed"] = fixed_name(what, contact.fixed);
  out["faces"] = {contact.face_moving, contact.face_fixed};
  out["point"] = numbers_json(contact.point);
  out["normal"] = numbers_json(contact.normal);
  out["gap"] = contact.gap;
  return out;
}

Json image_part(const MotionLists& what) {
  const MotionDepths& depths = what.lists.depths;
  const DepthPicture picture(depths);
  return {{"width", picture.width()},
          {"height", picture.height()},
          {"pixel_size", depths.frame.pixel},
          {"right", numbers_json(picture.right())},
          {"up", numbers_json(picture.up())},
          {"unit", depths.unit()},
          {"complete", depths.complete},
          {"pixels", depths.num_pixels},
          {"doubtful_pixels", depths.num_doubtful}};
}

Json pairs_part(const MotionLists& what) {
  Json out = Json::array();
  for (const FacePair& pair : what.lists.confirmed()) {
    if (out.size() == kMostPairs) break;
    out.push_back({{"moving", what.moving_names[pair.moving]},
                   {"face_moving", pair.face_moving},
                   {"fixed", what.fixed_names[pair.fixed]},
                   {"face_fixed", pair.face_fixed},
                   {"not_before", as_shown(what, pair.not_before)}});
  }
  return out;
}

Json motion_head(const MotionLists& what) {
  const MotionZLists& lists = what.lists;
  const ZListWork& work = lists.candidates.work;
  Json in_the_way = Json::array();
  for (const Index i : lists.depths.frame.fixed) in_the_way.push_back(what.fixed_names[i]);
  return {{"motion", motion_part(what)},
          {"moving", what.moving_names},
          {"fixed", std::move(in_the_way)},
          {"finder", what.finder},
          {"usable", lists.candidates.usable},
          {"image", image_part(what)},
          {"bounds",
           {{"lower", or_null(as_shown(what, lists.lower()))},
            {"upper", or_null(as_shown(what, lists.upper()))},
            {"floor", or_null(as_shown(what, lists.floor))}}},
          {"contact", contact_part(what)},
          {"work",
           {{"body_pairs", work.body_pairs},
            {"pixels", work.pixels},
            {"doubtful_pixels", work.doubtful_pixels},
            {"face_pairs", work.face_pairs},
            {"asked_pairs", work.asked_pairs},
            {"confirmed_pairs", lists.num_confirmed},
            {"bytes_read_back", work.bytes_read_back}}},
          {"milliseconds", what.milliseconds}};
}

std::string names_text(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

std::string contact_text(const MotionLists& what) {
  const FirstContact& contact = what.lists.contact;
  if (contact.status == FirstContact::Status::Free) return "  contact: none, the motion is free\n";
  std::string out = contact.status == FirstContact::Status::Crossing
                        ? "  contact: faces cross from the start, "
                        : "  contact: at " + time_text(what, contact.time) + ", ";
  out += formatted("face %d of ", static_cast<int>(contact.face_moving));
  out += what.moving_names[contact.moving];
  if (contact.fixed == FirstContact::kFloor) return out + " and the floor\n";
  out += formatted(" and face %d of ", static_cast<int>(contact.face_fixed));
  return out + what.fixed_names[contact.fixed] + "\n";
}

Json depth_or_null(const std::optional<double>& depth) {
  return depth ? Json(*depth) : Json(nullptr);
}

}  // namespace

std::string motion_text(const MotionLists& what) {
  const MotionZLists& lists = what.lists;
  const MotionDepths& depths = lists.depths;
  const DepthPicture picture(depths);
  const Vec3 axis = what.motion.axis + Vec3::Zero();  // without negative zeros
  std::string out = "z-lists of " + names_text(what.moving_names);
  out += formatted(", %s %g %g %g, up to ", turns(what) ? "turning about" : "moving along",
                   axis.x(), axis.y(), axis.z());
  out += time_text(what, what.motion.limit) + "\n";
  if (depths.frame.empty())
    out += "  image: none, no other object is in the way\n";
  else
    out += formatted("  image: %d x %d pixels of %.6g m; %lld with both sides, %lld doubtful%s\n",
                     picture.width(), picture.height(), depths.frame.pixel,
                     static_cast<long long>(depths.num_pixels),
                     static_cast<long long>(depths.num_doubtful),
                     depths.complete ? "" : "; incomplete, next to the axis");
  out += "  bounds: not before " + time_text(what, lists.lower()) + ", at the latest " +
         time_text(what, lists.upper()) + "\n";
  out += contact_text(what);
  if (!lists.candidates.usable)
    return out + "  pairs: " + what.finder + " gave up: " + lists.candidates.why + "\n";
  out += formatted("  pairs of faces: %lld proposed by %s, %zu confirmed\n",
                   static_cast<long long>(lists.candidates.work.face_pairs), what.finder.c_str(),
                   lists.num_confirmed);
  return out + formatted("  cost: %.1f ms\n", what.milliseconds);
}

std::string motion_json(const MotionLists& what) {
  Json json = motion_head(what);
  json["pairs"] = pairs_part(what);
  return readable_json(json);
}

void write_motion(const MotionLists& what, const ByteSink& write) {
  JsonLines lines(write);
  Json head = motion_head(what);
  head["pairs"] = pairs_part(what);
  lines.add(head);
  const DepthPicture picture(what.lists.depths);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const auto moving = picture.value(DepthShow::Moving, x, y);
      const auto fixed = picture.value(DepthShow::Fixed, x, y);
      if (!moving && !fixed) continue;
      lines.add({{"pixel", {x, y}},
                 {"moving", depth_or_null(moving)},
                 {"fixed", depth_or_null(fixed)},
                 {"gap", depth_or_null(picture.value(DepthShow::Gap, x, y))},
                 {"doubtful", what.lists.depths.doubtful[picture.pixel(x, y)] != 0}});
    }
  lines.finish();
}

}  // namespace trivet::apps
