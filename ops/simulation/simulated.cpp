// Poses of simulated objects beside those of the export.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "ops/files/json/text.h"
#include "ops/simulation/simulate.h"

namespace trivet {
namespace {

constexpr double kTwoMillimetres = 2e-3, kTwoDegrees = 2;

Affine pose_in(const JsonPlace& object) {
  const std::vector<double> p = object.at("position").numbers(3);
  const std::vector<double> q = object.at("rotation").numbers(4, -2, 2);
  const double length = Eigen::Vector4d(q[0], q[1], q[2], q[3]).norm();
  if (!(length > 0.5)) object.at("rotation").refuse("a unit quaternion, w first");
  const Rotation rotation{q[0] / length, q[1] / length, q[2] / length, q[3] / length};
  return {rotation.matrix(), Vec3(p[0], p[1], p[2])};
}

/// The last line that is an object of JSON, as programs print other things, too.
std::string last_object(const std::string& output) {
  std::string found;
  for (size_t begin = 0; begin < output.size();) {
    const size_t end = std::min(output.find('\n', begin), output.size());
    if (output[begin] == '{') found = output.substr(begin, end - begin);
    begin = end + 1;
  }
  return found;
}

class ProgramAnswer {
 public:
  ProgramAnswer(const JsonPlace& root, const SimulationExport& done) : m_root(root), m_done(done) {
    for (const SimulationBody& body : done.scene.bodies) m_names[body.file_name] = body.name;
    for (const JsonPlace& object : root.at("objects").items())
      m_poses.insert_or_assign(object.at("name").text(), pose_in(object));
  }

  SimulatedScene scene(const std::string& program, double seconds) const {
    SimulatedScene out;
    const auto name = m_root.find("simulator");
    out.simulator = name ? name->text() : program;
    out.seconds = seconds;
    if (const auto depth = m_root.find("penetration")) out.penetration = depth->number();
    if (const auto count = m_root.find("warnings"))
      out.num_warnings = static_cast<int>(count->number(0, 1e9));
    for (const SimulationBody& body : m_done.scene.bodies)
      if (!body.fixed)
        out.objects.push_back(simulated_object(
            m_done, body, world_from_object(body.world_from_link, UpAxis::Z, 1), pose_of(body)));
    add_contacts(out);
    return out;
  }

 private:
  const Affine& pose_of(const SimulationBody& body) const {
    const auto it = m_poses.find(body.file_name);
    if (it == m_poses.end())
      m_root.at("objects").fail(say("no object is called \"%1\"", body.file_name));
    return it->second;
  }

  void add_contacts(SimulatedScene& out) const {
    const auto contacts = m_root.find("contacts");
    if (!contacts) return;
    out.touched.emplace();
    for (const JsonPlace& pair : contacts->items()) {
      const std::vector<JsonPlace> names = pair.items();
      if (names.size() != 2) pair.refuse("two names");
      out.touched->insert({name_of(names[0].text()), name_of(names[1].text())});
    }
  }

  std::string name_of(const std::string& file_name) const {
    const auto it = m_names.find(file_name);
    return it == m_names.end() ? file_name : it->second;
  }

  const JsonPlace& m_root;
  const SimulationExport& m_done;
  std::map<std::string, std::string> m_names;  // by names in the file
  std::map<std::string, Affine> m_poses;
};

}  // namespace

SimulatedObject simulated_object(const SimulationExport& done, const SimulationBody& body,
                                 const Affine& from, const Affine& to) {
  SimulatedObject out;
  out.name = body.name;
  const SimulationModel& model = done.scene.models[body.model];
  const auto moved = [&](const Vec3& v) { return (to.apply(v) - from.apply(v)).norm(); };
  for (const ConvexPart& part : model.parts)
    for (const Vec3& v : part.vertices) out.moved = std::max(out.moved, moved(model.scale * v));
  if (model.parts.empty())  // its triangles collide
    for (const Vec3& v : model.model->mesh.vertices)
      out.moved = std::max(out.moved, moved(model.link_from_object.apply(v)));
  const double cosine = ((to.linear * from.linear.transpose()).trace() - 1) / 2;
  out.turned_deg = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / 3.14159265358979323846;
  return out;
}

SimulatedScene simulated_by_program(const std::string& output, const std::string& program,
                                    const SimulationExport& done, double seconds) {
  const std::string line = last_object(output);
  if (line.empty())
    throw Error(Error::Kind::BadInput,
                "%1: prints no line of JSON; accepted: {\"objects\": [{\"name\": ..., "
                "\"position\": [x, y, z], \"rotation\": [w, x, y, z]}, ...]}",
                program);
  const nlohmann::json json = parse_json(line, program);
  return ProgramAnswer(JsonPlace(json, program), done).scene(program, seconds);
}

StayedWithin stayed_within(const SimulatedScene& simulated) {
  StayedWithin out;
  for (const SimulatedObject& o : simulated.objects) {
    out.millimetre += o.moved <= kTold;
    out.two_millimetres_and_degrees += o.moved <= kTwoMillimetres && o.turned_deg <= kTwoDegrees;
    out.centimetre += o.moved <= kStays;
  }
  return out;
}

}  // namespace trivet
