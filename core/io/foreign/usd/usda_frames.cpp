#include "core/io/foreign/usd/usda_frames.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/io/foreign/scene.h"
#include "core/io/foreign/tag_text.h"

namespace trivet {
namespace {

constexpr double kNoScale = 1e-12;    // of a linear part that is taken as the identity
constexpr double kNoExtent = 1e-300;  // of an axis that has no direction
constexpr const char* kOwnSuffix = ":trivet";

// The turn of a matrix, and what is left of it, mirrors, too.
UsdaFrame frame_of_linear(const Mat3& m) {
  UsdaFrame out;
  out.linear = m;
  const Vec3 x = m.col(0);
  const Vec3 y = m.col(1) - x * (x.dot(m.col(1)) / x.squaredNorm());
  if (!(x.norm() > kNoExtent) || !(y.norm() > kNoExtent)) return out;
  Mat3 axes;
  axes.col(0) = x.normalized(), axes.col(1) = y.normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  out.pose.rotation = Rotation::from_matrix(axes).normalized();
  const Mat3 left = out.pose.rotation.matrix().transpose() * m;
  out.linear =
      (left - Mat3::Identity()).cwiseAbs().maxCoeff() <= kNoScale ? Mat3::Identity() : left;
  return out;
}

Mat3 scaled(const Vec3& factors) { return factors.asDiagonal(); }

Vec3 axis_of_letter(char letter) { return Vec3::Unit(letter - 'X'); }

// About the axes in their order, each fixed: "rotateXYZ" turns about x first.
Rotation turn_of(const std::string& axes, const std::vector<double>& degrees) {
  Rotation out;
  for (size_t i = 0; i < axes.size(); ++i)
    out = turn_about(axis_of_letter(axes[i]),
                     degrees[axes.size() == 1 ? 0 : static_cast<size_t>(axes[i] - 'X')]) *
          out;
  return out.normalized();
}

UsdaFrame frame_of_matrix(const std::vector<double>& n) {
  // Rows of the text are images of the axes, the last one the translation.
  Mat3 linear;
  for (Index r = 0; r < 3; ++r)
    for (Index c = 0; c < 3; ++c) linear(c, r) = n[static_cast<size_t>(4 * r + c)];
  UsdaFrame out = frame_of_linear(linear);
  out.pose.translation = {n[12], n[13], n[14]};
  return out;
}

// Gives nothing if it is not read. @param kind  "translate".
std::optional<UsdaFrame> frame_of_op(const std::string& kind, const std::vector<double>& n) {
  UsdaFrame out;
  const bool finite = std::all_of(n.begin(), n.end(), [](double v) { return std::isfinite(v); });
  const std::string axes = kind.starts_with("rotate") ? kind.substr(6) : "";
  if (!finite) return std::nullopt;
  if (kind == "translate" && n.size() == 3)
    out.pose.translation = {n[0], n[1], n[2]};
  else if (kind == "scale" && n.size() == 3)
    out.linear = scaled({n[0], n[1], n[2]});
  else if (kind == "orient" && n.size() == 4)
    out.pose.rotation = Rotation{n[0], n[1], n[2], n[3]}.normalized();
  else if (kind == "transform" && n.size() == 16)
    out = frame_of_matrix(n);
  else if ((axes.size() == 1 && n.size() == 1) || (axes.size() == 3 && n.size() == 3))
    if (axes.find_first_not_of("XYZ") == std::string::npos)
      out.pose.rotation = turn_of(axes, n);
    else
      return std::nullopt;
  else
    return std::nullopt;
  return out;
}

std::optional<UsdaFrame> inverted(const UsdaFrame& frame) {
  const Mat3 linear = frame.pose.rotation.matrix() * frame.linear;
  const Mat3 back = linear.inverse();
  if (!back.allFinite()) return std::nullopt;
  UsdaFrame out;
  // Turns and shifts alone stay as they are.
  if (frame.linear == Mat3::Identity())
    out.pose = inverse(frame.pose);
  else
    out = frame_of_linear(back), out.pose.translation = -(back * frame.pose.translation);
  return out;
}

std::string kind_of_op(const std::string& name) {
  const size_t begin = name.find("xformOp:");
  if (begin == std::string::npos) return "";
  return name.substr(begin + 8, name.find(':', begin + 8) - (begin + 8));
}

std::string tuple_of(const std::vector<double>& values) {
  std::string out = "(";
  for (size_t i = 0; i < values.size(); ++i) out += (i ? ", " : "") + with_numbers("", {values[i]});
  return out += ')';
}

bool is_same_turn(const Rotation& a, const Rotation& b) {
  const double dot = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  const double sign = dot < 0 ? -1 : 1;
  return std::max({std::abs(a.w - sign * b.w), std::abs(a.x - sign * b.x),
                   std::abs(a.y - sign * b.y), std::abs(a.z - sign * b.z)}) <= 1e-15;
}

std::string order_line(bool resets, const std::vector<std::string>& names) {
  std::string out = "uniform token[] xformOpOrder = [";
  if (resets) out += "\"!resetXformStack!\", ";
  for (size_t i = 0; i < names.size(); ++i) out += (i ? ", \"" : "\"") + names[i] + "\"";
  return out + "]";
}

/// Ops as "translate, turn, rest": each of the first two may be missing.
class PlainOps {
 public:
  explicit PlainOps(const UsdaPlace& place)
      : m_place(place), m_scale(uniform_scale(place.parent.linear)) {
    const auto& ops = place.ops.ops;
    size_t i = 0;
    if (i < ops.size() && ops[i].name.starts_with("xformOp:translate") && ops[i].type != "half3")
      m_translate = &ops[i++];
    if (i < ops.size() && is_turn(ops[i])) m_turn = &ops[i++];
    for (; i < ops.size(); ++i)
      m_is_plain &=
          ops[i].name.starts_with("xformOp:scale") && ops[i].frame.linear.diagonal().minCoeff() > 0;
  }

  bool are_plain() const { return m_is_plain && m_scale; }

  std::vector<std::string> lines(const Pose& old, const Pose& pose) const {
    const Pose local = composed(inverse(m_place.parent.pose), pose);
    const Pose before = composed(inverse(m_place.parent.pose), old);
    std::vector<std::string> out;
    add_translation(local.translation - before.translation, out);
    const bool turned = !is_same_turn(old.rotation, pose.rotation);
    if (turned) add_turn(local.rotation.normalized(), out);
    if (!m_translate || (turned && !has_orient())) out.push_back(order(turned));
    return out;
  }

 private:
  static bool is_turn(const UsdaOp& op) {
    return op.name.starts_with("xformOp:orient") || op.name.starts_with("xformOp:rotate");
  }
  bool has_orient() const { return m_turn && (m_turn->type == "quatd" || m_turn->type == "quatf"); }

  // By what the body moved: a way that does not go along an axis changes no bit of its number.
  void add_translation(const Vec3& way, std::vector<std::string>& out) const {
    Vec3 at = m_translate ? m_translate->frame.pose.translation : Vec3::Zero();
    for (Index k = 0; k < 3; ++k)
      if (std::abs(way[k]) > 1e-15 * way.norm()) at[k] += way[k] / *m_scale;
    const std::string type = m_translate ? m_translate->type : "double3";
    const std::string name = m_translate ? m_translate->name : own_translate();
    if (!m_translate || at != m_translate->frame.pose.translation)
      out.push_back(type + " " + name + " = " + tuple_of({at.x(), at.y(), at.z()}));
  }

  void add_turn(const Rotation& r, std::vector<std::string>& out) const {
    const std::string type = has_orient() ? m_turn->type : "quatd";
    const std::string name = has_orient() ? m_turn->name : own_orient();
    out.push_back(type + " " + name + " = " + tuple_of({r.w, r.x, r.y, r.z}));
  }

  static std::string own_translate() { return std::string("xformOp:translate") + kOwnSuffix; }
  static std::string own_orient() { return std::string("xformOp:orient") + kOwnSuffix; }

  std::string order(bool turned) const {
    std::vector<std::string> names = {m_translate ? m_translate->name : own_translate()};
    if (turned && !has_orient())
      names.push_back(own_orient());
    else if (m_turn)
      names.push_back(m_turn->name);
    for (const UsdaOp& op : m_place.ops.ops)
      if (&op != m_translate && &op != m_turn) names.push_back(op.name);
    return order_line(m_place.ops.resets, names);
  }

  const UsdaPlace& m_place;
  std::optional<double> m_scale;
  const UsdaOp *m_translate = nullptr, *m_turn = nullptr;
  bool m_is_plain = true;
};

// Any other ops: a matrix before all of them.
std::vector<std::string> matrix_lines(const UsdaPlace& place, const Pose& old, const Pose& pose) {
  UsdaFrame moved{composed(pose, inverse(old)), Mat3::Identity()};
  const std::string own = std::string("xformOp:transform") + kOwnSuffix;
  std::vector<std::string> names = {own};
  UsdaFrame before;  // the matrix of an earlier time
  for (const UsdaOp& op : place.ops.ops)
    if (op.name == own)
      before = op.frame;
    else
      names.push_back(op.name);
  const std::optional<UsdaFrame> back = inverted(place.parent);
  if (back) moved = composed(composed(*back, moved), place.parent);
  moved = composed(moved, before);
  const Mat3 m = moved.pose.rotation.matrix() * moved.linear;
  const Vec3& t = moved.pose.translation;
  std::string text = "(";
  for (Index c = 0; c < 3; ++c) text += tuple_of({m(0, c), m(1, c), m(2, c), 0}) + ", ";
  return {"matrix4d " + own + " = " + text + tuple_of({t.x(), t.y(), t.z(), 1}) + ")",
          order_line(place.ops.resets, names)};
}

}  // namespace

Vec3 UsdaFrame::apply(const Vec3& p) const {
  return pose.rotation.matrix() * (linear * p) + pose.translation;
}

std::optional<double> uniform_scale(const Mat3& linear) {
  const double s = linear(0, 0);
  return s > 0 && linear == Mat3(s * Mat3::Identity()) ? std::optional(s) : std::nullopt;
}

UsdaFrame composed(const UsdaFrame& a, const UsdaFrame& b) {
  const Vec3 at = a.linear * b.pose.translation;
  // A scale of all axes goes through a turn.
  if (uniform_scale(a.linear))
    return {composed(a.pose, Pose{b.pose.rotation, at}), a.linear * b.linear};
  UsdaFrame turned = frame_of_linear(a.linear * b.pose.rotation.matrix() * b.linear);
  turned.pose.translation = at;
  return {composed(a.pose, turned.pose), turned.linear};
}

UsdaFrame UsdaOps::local() const {
  UsdaFrame out;
  for (const UsdaOp& op : ops) out = composed(out, op.frame);
  return out;
}

UsdaOps usda_ops(const UsdaPrim& prim, std::vector<Sentence>& unread) {
  UsdaOps out;
  const UsdaEntry* const order = prim.find("xformOpOrder");
  if (!order) return out;
  for (const auto& [kind, word] : order->value.words) {
    if (word == "!resetXformStack!") {
      out.ops.clear(), out.resets = true;
      continue;
    }
    const bool inverse_of = word.starts_with("!invert!");
    const std::string name = inverse_of ? word.substr(8) : word;
    const UsdaEntry* const value = prim.find(name);
    auto frame = value ? frame_of_op(kind_of_op(name), value->value.numbers) : std::nullopt;
    if (frame && inverse_of) frame = inverted(*frame);
    if (frame)
      out.ops.push_back({word, value->type, *frame});
    else if (prim.find(name + ".timeSamples"))
      note_once(unread, say("%1: poses over time are not read", prim.path));
    else
      note_once(unread, say("%1: %2 is not read", prim.path, word));
  }
  return out;
}

std::vector<std::string> usda_pose_lines(const UsdaPlace& place, const Pose& old,
                                         const Pose& pose) {
  const PlainOps plain(place);
  return plain.are_plain() ? plain.lines(old, pose) : matrix_lines(place, old, pose);
}

}  // namespace trivet
