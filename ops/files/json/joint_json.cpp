#include "ops/files/json/joint_json.h"

#include <algorithm>
#include <cmath>

#include "core/base/limits.h"
#include "core/scene/transaction.h"
#include "ops/files/json/values.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxHolding = 1e12;  // newtons or newton metres

Json numbers_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3 read_axis(const JsonPlace& place) {
  const std::vector<double> v = place.numbers(3, -kMaxDirectionComponent, kMaxDirectionComponent);
  const Vec3 axis(v[0], v[1], v[2]);
  if (axis.cwiseAbs().maxCoeff() < kMinDirectionComponent)
    place.refuse("a direction whose length is not zero");
  // An axis of unit length is taken as it is, so that it is read to the same bits.
  return std::abs(axis.squaredNorm() - 1) <= 1e-15 ? axis : Vec3(axis.normalized());
}

double read_value(const JsonPlace& place, const char* key, double otherwise) {
  const auto value = place.find(key);
  return value ? value->number(-kMaxJointValue, kMaxJointValue) : otherwise;
}

void read_limits(const JsonPlace& place, LinkJoint& joint) {
  joint.lower = read_value(place, "lower", joint.lower);
  joint.upper = read_value(place, "upper", joint.upper);
  if (joint.lower > joint.upper) place.at("upper").refuse("a number from \"lower\" on");
  joint.value = read_value(place, "value", std::clamp(0.0, joint.lower, joint.upper));
  if (joint.value < joint.lower || joint.value > joint.upper)
    place.at("value").refuse(
        say("a number from %1 to %2", figure(joint.lower), figure(joint.upper)));
  if (const auto friction = place.find("friction"))
    joint.friction = friction->number(0, kMaxHolding);
}

NamedJoint read_keys(const JsonPlace& place) {
  NamedJoint out;
  out.in = place.at("in").text();
  const auto slide = place.find("slide"), hinge = place.find("hinge"), at = place.find("at");
  if (slide.has_value() == hinge.has_value())
    place.fail("accepted: \"slide\", the axis of a drawer, or \"hinge\", that of a door");
  out.joint.kind = hinge ? LinkJoint::Kind::Hinge : LinkJoint::Kind::Slide;
  out.joint.axis = read_axis(hinge ? *hinge : *slide);
  if (at && slide) at->fail("a slide has no place; accepted: with \"hinge\"");
  if (at) out.joint.anchor = read_position(*at);
  read_limits(place, out.joint);
  return out;
}

Pose read_stored_pose(const JsonPlace& place) {
  const std::vector<double> n = place.numbers(7, -kMaxLength, kMaxLength);
  return {{n[3], n[4], n[5], n[6]}, {n[0], n[1], n[2]}};
}

Json stored_pose_json(const Pose& pose) {
  const Rotation& r = pose.rotation;
  const Vec3& t = pose.translation;
  return {t.x(), t.y(), t.z(), r.w, r.x, r.y, r.z};
}

}  // namespace

NamedJoint read_joint(const JsonPlace& place) {
  place.expect_object({"in"}, {"slide", "hinge", "at", "lower", "upper", "value", "friction"});
  return read_keys(place);
}

Json joint_json(const NamedJoint& named) {
  const LinkJoint& joint = named.joint;
  Json json = {{"in", named.in}};
  json[joint.turns() ? "hinge" : "slide"] = numbers_json(joint.axis);
  if (joint.turns()) json["at"] = numbers_json(joint.anchor);
  if (joint.lower > -kInfinity) json["lower"] = joint.lower;
  if (joint.upper < kInfinity) json["upper"] = joint.upper;
  json["value"] = joint.value;
  if (joint.friction) json["friction"] = *joint.friction;
  return json;
}

NamedJoint read_stored_joint(const JsonPlace& place) {
  place.expect_object({"in", "parent_then", "at_zero"},
                      {"slide", "hinge", "at", "lower", "upper", "value", "friction"});
  NamedJoint out = read_keys(place);
  out.joint.parent_then = read_stored_pose(place.at("parent_then"));
  out.joint.at_zero = read_stored_pose(place.at("at_zero"));
  return out;
}

Json stored_joint_json(const NamedJoint& named) {
  Json json = joint_json(named);
  json["parent_then"] = stored_pose_json(named.joint.parent_then);
  json["at_zero"] = stored_pose_json(named.joint.at_zero);
  return json;
}

NamedJoint named_joint(const Scene& scene, const LinkJoint& joint) {
  return {scene.at(joint.parent).name, joint};
}

void hang(Scene& scene, ObjectId link, ObjectId parent, LinkJoint joint) {
  joint.parent = parent;
  Transaction transaction(scene);
  transaction.edit(link, [&](Object& object) {
    object.fixed = true;
    object.joint = std::make_shared<const LinkJoint>(std::move(joint));
  });
  transaction.edit(parent, [&](Object& object) {
    std::vector<ObjectId>& links = object.links;
    if (std::find(links.begin(), links.end(), link) == links.end()) links.push_back(link);
  });
  transaction.commit();
}

}  // namespace trivet
