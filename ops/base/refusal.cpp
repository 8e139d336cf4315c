#include "ops/base/refusal.h"

#include <algorithm>
#include <utility>

#include "core/base/nearest_name.h"

namespace trivet {
namespace {

using Cause = Refusal::Cause;

}  // namespace

Named named(const Scene& scene, const Support& support) {
  return {support.is_floor() ? kFloorName : scene.at(support.object()).name, support};
}

Named named(const Scene& scene, const std::string& name) {
  if (name == kFloorName) return {name, Support::floor()};
  const std::optional<ObjectId> id = scene.find(name);
  return {name, id ? std::optional<Support>(*id) : std::nullopt};
}

Refusal unknown_object(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const ObjectId id : scene.ids()) names.push_back(scene.at(id).name);
  Refusal why{Cause::UnknownObject, {{name, std::nullopt}}};
  why.detail = nearest_name(name, names);
  return why;
}

double Refusal::number(const std::string& key) const {
  const auto it =
      std::find_if(numbers.begin(), numbers.end(), [&](const Number& n) { return n.key == key; });
  return it == numbers.end() ? 0 : it->value;
}

const char* to_string(Refusal::Cause cause) {
  static constexpr std::pair<Cause, const char*> kNames[] = {
      {Cause::InvalidArgument, "invalid_argument"},
      {Cause::UnknownObject, "unknown_object"},
      {Cause::InvalidName, "invalid_name"},
      {Cause::NameTaken, "name_taken"},
      {Cause::ModelNotLoaded, "model_not_loaded"},
      {Cause::NotInteractive, "not_interactive"},
      {Cause::Fixed, "fixed"},
      {Cause::Locked, "locked"},
      {Cause::NotPlaced, "not_placed"},
      {Cause::SupportNotPlaced, "support_not_placed"},
      {Cause::NoFloor, "no_floor"},
      {Cause::OnItself, "on_itself"},
      {Cause::TooCoarse, "too_coarse"},
      {Cause::InvalidClearance, "invalid_clearance"},
      {Cause::Crossing, "crossing"},
      {Cause::Inside, "inside"},
      {Cause::Float32Contact, "float32_contact"},
      {Cause::BelowFloor, "below_floor"},
      {Cause::Float32BelowFloor, "float32_below_floor"},
      {Cause::AlreadyTouches, "already_touches"},
      {Cause::NothingBelow, "nothing_below"},
      {Cause::Topples, "topples"},
      {Cause::Wedged, "wedged"},
      {Cause::TouchesAtStart, "touches_at_start"},
      {Cause::TooManyMotions, "too_many_motions"},
      {Cause::PathTooLong, "path_too_long"},
      {Cause::NothingToSlideOn, "nothing_to_slide_on"},
      {Cause::LiesOnNothing, "lies_on_nothing"},
      {Cause::NoContact, "no_contact"},
      {Cause::PointContact, "point_contact"},
      {Cause::NoFreePlace, "no_free_place"},
      {Cause::KeepTooLarge, "keep_too_large"},
      {Cause::RestsOnOther, "rests_on_other"},
      {Cause::RestsTooClose, "rests_too_close"},
      {Cause::LeavesRegion, "leaves_region"},
      {Cause::StandsBadly, "stands_badly"},
      {Cause::CrossesItself, "crosses_itself"},
      {Cause::NoSheet, "no_sheet"},
      {Cause::Overstretched, "overstretched"},
      {Cause::NotAtRest, "not_at_rest"},
      {Cause::NoArrangement, "no_arrangement"},
      {Cause::Cancelled, "cancelled"},
      {Cause::OutOfTime, "out_of_time"},
      {Cause::NotTried, "not_tried"},
  };
  const auto* const it = std::find_if(std::begin(kNames), std::end(kNames),
                                      [&](const auto& entry) { return entry.first == cause; });
  return it == std::end(kNames) ? "?" : it->second;
}

}  // namespace trivet
