#include "apps/edit/document/joint_words.h"

#include <QCoreApplication>
#include <QLocale>

#include "apps/edit/document/results.h"
#include "core/base/quoted.h"
#include "core/scene/joint.h"

namespace trivet::edit {

std::string joint_value_in_words(double value, bool turns) {
  const QLocale locale;
  const QString text =
      turns ? QCoreApplication::translate("results", "%1°").arg(locale.toString(value, 'f', 1))
            : QCoreApplication::translate("results", "%1 m").arg(locale.toString(value, 'f', 3));
  return text.toStdString();
}

std::string dragged_joint_in_words(const SceneSnapshot& scene, const Object& link) {
  std::string out =
      quoted(link.name) + ": " + joint_value_in_words(link.joint->value, link.joint->turns());
  if (!scene.drag) return out;
  OperationResult ended;
  ended.end = scene.drag->end;
  ended.blocked_by = scene.drag->blocked_by;
  const double value = link.joint->value;
  const bool at_limit = value == link.joint->lower || value == link.joint->upper;
  if (ended.end == OperationResult::End::Reached && at_limit)
    ended.end = OperationResult::End::Limit;
  const std::string why = why_it_ended(MoveJointOperation(), ended);
  return why.empty() ? out : out + "; " + why;
}

}  // namespace trivet::edit
