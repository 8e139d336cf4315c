#include "apps/edit/document/results.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>

#include "apps/edit/document/joint_words.h"
#include "apps/edit/document/words.h"
#include "core/base/quoted.h"
#include "core/base/tunables.h"
#include "core/scene/joint.h"
#include "ops/placement/clearance.h"
#include "ops/placement/neighbourhood.h"

namespace trivet::edit {
namespace {

void add(std::vector<ObjectId>& ids, std::optional<ObjectId> id) {
  if (id && std::find(ids.begin(), ids.end(), *id) == ids.end()) ids.push_back(*id);
}

// True if the objects stand in the way there; others are only named.
bool shows_objects(Refusal::Cause cause) {
  using Cause = Refusal::Cause;
  switch (cause) {
    case Cause::Crossing:
    case Cause::Inside:
    case Cause::Float32Contact:
    case Cause::AlreadyTouches:
    case Cause::Topples:
    case Cause::Wedged:
    case Cause::RestsOnOther:
    case Cause::RestsTooClose:
      return true;
    default:
      return false;
  }
}

// Fixed ones, such as a table, are named, but not lit: they may fill the picture.
void add_objects(const Scene& scene, const Refusal& refusal, std::vector<ObjectId>& ids) {
  if (shows_objects(refusal.cause))
    for (const Named& object : refusal.objects)
      if (object.support && object.support->is_object())
        if (const ObjectId id = object.support->object(); scene.contains(id) && !scene.at(id).fixed)
          add(ids, id);
  if (refusal.first) add_objects(scene, *refusal.first, ids);
}

// Objects that moved by less gave way for the settling alone.
constexpr double kVisibleMetres = 1e-5, kVisibleDeg = 0.05;

std::vector<GaveWay> visible(std::vector<GaveWay> objects) {
  std::erase_if(objects, [](const GaveWay& object) {
    return object.moved < kVisibleMetres && object.turned_deg < kVisibleDeg;
  });
  return objects;
}

std::vector<std::string> names_of(const std::vector<GaveWay>& objects) {
  std::vector<std::string> out;
  out.reserve(objects.size());
  for (const GaveWay& object : objects) out.push_back(object.name);
  return out;
}

QString phrase(const char* text) { return QCoreApplication::translate("results", text); }

QString quoted_names(const std::vector<std::string>& names) {
  QStringList out;
  for (const std::string& name : names) out << QString::fromStdString(quoted(name));
  if (out.size() < 2) return out.join("");
  const QString last = out.takeLast();
  return phrase(QT_TRANSLATE_NOOP("results", "%1 and %2")).arg(out.join(", "), last);
}

QString millimetres(double metres) {
  return phrase(QT_TRANSLATE_NOOP("results", "%1 mm"))
      .arg(QLocale().toString(1000 * metres, 'g', 2));
}

// "\"a\" by 1.2 mm and 0.3°, ...", each figure where it shows.
QString gave_way_words(const std::vector<GaveWay>& objects) {
  QStringList out;
  const QLocale locale;
  for (const GaveWay& object : objects) {
    QStringList by;
    if (object.moved >= kVisibleMetres) by << millimetres(object.moved);
    if (object.turned_deg >= kVisibleDeg)
      by << phrase(QT_TRANSLATE_NOOP("results", "%1°"))
                .arg(locale.toString(object.turned_deg, 'g', 2));
    const QString both = by.size() < 2
                             ? by.join("")
                             : phrase(QT_TRANSLATE_NOOP("results", "%1 and %2")).arg(by[0], by[1]);
    out << phrase(QT_TRANSLATE_NOOP("results", "%1 by %2"))
               .arg(QString::fromStdString(quoted(object.name)), both);
  }
  return out.join(", ");
}

// Uses current poses: objects released since may have moved on, so there may be none.
InterferingFaces faces_that_stopped(const Scene& scene, const Operation& operation,
                                    const OperationResult& result, double clearance) {
  std::vector<Placement> moved;
  std::vector<std::string> names = result.carried;
  names.push_back(object_name(operation));
  for (const std::string& name : names)
    if (const auto id = scene.find(name)) moved.push_back({*id, scene.at(*id).pose});
  if (!(clearance > 0)) clearance = default_clearance(scene);
  return blocking_faces(scene, moved, {*result.blocked_by.support, result.blocked_at},
                        kContactTolerance * clearance);
}

// "mend: 3 objects moved, by 2.1 mm at most; 5 of 5 supports kept; "a" stays where it was: ..."
Message message_of_repair(const Operation& operation, const MendedScene& repaired) {
  Message message;
  QStringList what;
  double farthest = 0;
  for (const SettledObject& o : repaired.moved) farthest = std::max(farthest, o.moved);
  const int num_moved = static_cast<int>(repaired.moved.size());
  what << QCoreApplication::translate("results", "%n objects moved, by %1 at most", nullptr,
                                      num_moved)
              .arg(phrase(QT_TRANSLATE_NOOP("results", "%1 mm"))
                       .arg(QLocale().toString(1000 * farthest, 'f', 1)));
  if (repaired.num_meant > 0)
    what << phrase(QT_TRANSLATE_NOOP("results", "%1 of %2 supports kept"))
                .arg(repaired.num_kept)
                .arg(repaired.num_meant);
  for (const UnsettledObject& o : repaired.unable) {
    message.kind = Message::Kind::Warning;
    message.objects.push_back(o.id);
    what << phrase(QT_TRANSLATE_NOOP("results", "%1 stays where it was: %2"))
                .arg(quoted_names({o.name}), QString::fromStdString(in_words(o.why)));
  }
  message.text = in_words(op_name(operation)) + ": " + what.join("; ").toStdString();
  return message;
}

// Only a PUSH ends at steps and edges.
QString how_it_ended(const Operation& operation, const OperationResult& result) {
  const auto* const push = std::get_if<PushOperation>(&operation);
  const std::string& name = result.blocked_by.name;
  const QString by =
      name == kFloorName ? phrase(QT_TRANSLATE_NOOP("results", "the floor")) : quoted_names({name});
  switch (result.end) {
    case OperationResult::End::Blocked:
      return phrase(QT_TRANSLATE_NOOP("results", "stopped by %1")).arg(by);
    case OperationResult::End::Step:
      return phrase(QT_TRANSLATE_NOOP("results", "stopped by a step of %1 higher than %2"))
          .arg(by, millimetres(push ? push->step_up : 0));
    case OperationResult::End::Edge:
      return phrase(QT_TRANSLATE_NOOP("results", "stopped at a drop deeper than %1"))
          .arg(millimetres(push ? push->step_down : 0));
    case OperationResult::End::Limit:
      return phrase(QT_TRANSLATE_NOOP("results", "at its limit"));
    case OperationResult::End::Done:
    case OperationResult::End::AtRest:
    case OperationResult::End::Reached:
      break;
  }
  return {};
}

}  // namespace

std::string why_it_ended(const Operation& operation, const OperationResult& result) {
  return how_it_ended(operation, result).toStdString();
}

std::optional<Message> message_of(const Scene& scene, const Operation& operation,
                                  const OperationResult& result, double clearance) {
  Message message;
  if (!result.ok()) {
    message.kind = Message::Kind::Refused;
    message.text = reason_in_words(result);
    if (result.refusal) add_objects(scene, *result.refusal, message.objects);
    return message;
  }
  if (result.repaired) return message_of_repair(operation, *result.repaired);
  QStringList what;
  if (const QString why = how_it_ended(operation, result); !why.isEmpty()) {
    if (const auto id = scene.find(object_name(operation)); id && result.joint_value)
      what << QString::fromStdString(
          joint_value_in_words(*result.joint_value, scene.at(*id).joint->turns()));
    what << why;
    add(message.objects, scene.find(result.blocked_by.name));
    if (result.blocked_by.support) {
      message.points.push_back(result.blocked_at);
      message.faces = faces_that_stopped(scene, operation, result, clearance);
    }
  }
  const std::vector<GaveWay> moved = visible(result.gave_way);
  const std::vector<std::string> gave_way = names_of(moved);
  if (!gave_way.empty())
    what << phrase(QT_TRANSLATE_NOOP("results", "gave way: %1")).arg(gave_way_words(moved));
  if (!result.unsupported.empty())
    what << phrase(QT_TRANSLATE_NOOP("results", "%1 left without support"))
                .arg(quoted_names(result.unsupported));
  if (!result.interpenetrates.empty())
    what << phrase(QT_TRANSLATE_NOOP("results", "interpenetrates %1"))
                .arg(quoted_names(result.interpenetrates));
  if (!result.unsound.empty())
    what << phrase(
                QT_TRANSLATE_NOOP("results", "rests on what is held, unsupported or invalid: %1"))
                .arg(quoted_names(result.unsound));
  if (what.isEmpty()) return std::nullopt;
  if (!result.unsupported.empty() || !result.interpenetrates.empty() || !result.unsound.empty())
    message.kind = Message::Kind::Warning;
  for (const auto* const names : {&gave_way, &result.unsupported, &result.interpenetrates})
    for (const std::string& other : *names) add(message.objects, scene.find(other));
  message.text = quoted(object_name(operation)) + ": " + what.join("; ").toStdString();
  return message;
}

}  // namespace trivet::edit
