// MuJoCo: meshes as their convex hulls, its native treatment, or as the hulls of pieces.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "perf/report.h"
#include "perf/settling.h"

namespace trivet::perf {
namespace {

struct DeleteModel {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
};
struct DeleteData {
  void operator()(mjData* d) const { mj_deleteData(d); }
};

std::string mesh_asset(const std::string& name, const Piece& points) {
  std::string out = "<mesh name=\"" + name + "\" vertex=\"";
  for (const Vec3& p : points) out += text("%.9g %.9g %.9g ", p.x(), p.y(), p.z());
  return out + "\"/>\n";
}

std::string numbered(const char* name, size_t i) { return name + std::to_string(i); }

std::string model_xml(const SettleTask& task, const SimulationRules& rules,
                      const std::vector<Piece>& moving, const std::vector<Piece>& fixed) {
  std::string assets, moving_geoms, fixed_geoms;
  for (size_t i = 0; i < moving.size(); ++i) {
    assets += mesh_asset(numbered("m", i), moving[i]);
    moving_geoms += "<geom type=\"mesh\" mesh=\"" + numbered("m", i) + "\"/>\n";
  }
  for (size_t i = 0; i < fixed.size(); ++i) {
    assets += mesh_asset(numbered("f", i), fixed[i]);
    fixed_geoms += "<geom type=\"mesh\" mesh=\"" + numbered("f", i) + "\"/>\n";
  }
  // Room for more contacts than the default slows down every step.
  const char* size = fixed.size() > 1 ? "<size nconmax=\"400\" njmax=\"1600\"/>" : "";
  return std::string("<mujoco>") + size + text("<option gravity=\"0 0 %g\"/>\n", -rules.gravity) +
         text("<default><geom friction=\"%g 0.005 0.0001\"/></default>\n", rules.friction) +
         "<asset>\n" + assets + "</asset>\n<worldbody>\n" +
         "<geom type=\"plane\" size=\"1 1 1\"/>\n" + fixed_geoms + "<body><freejoint/>\n" +
         text("<inertial pos=\"0 0 0\" mass=\"%.17g\" diaginertia=\"%.17g %.17g %.17g\"/>\n",
              task.mass, task.inertia.x(), task.inertia.y(), task.inertia.z()) +
         moving_geoms + "</body>\n</worldbody></mujoco>\n";
}

std::unique_ptr<mjModel, DeleteModel> compiled(const std::string& xml) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "task.xml", static_cast<int>(xml.size()));
  std::memcpy(files->filedata[0], xml.data(), xml.size());
  char message[1000] = "";
  std::unique_ptr<mjModel, DeleteModel> model(
      mj_loadXML("task.xml", files.get(), message, sizeof message));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo refuses the task: ") + message);
  return model;
}

class MujocoSimulator : public Simulator {
 public:
  MujocoSimulator(const SettleTask& task, const SimulationRules& rules, std::string name,
                  const std::vector<Piece>& moving, const std::vector<Piece>& fixed)
      : m_task(task),
        m_rules(rules),
        m_name(std::move(name)),
        m_model(compiled(model_xml(task, rules, moving, fixed))),
        m_data(mj_makeData(m_model.get())) {}

  std::string name() const override { return m_name; }

  Settled settle(const Pose& start) override {
    mj_resetData(m_model.get(), m_data.get());
    set_pose(m_task.body_pose(start));
    RestClock clock(m_rules);
    Settled out;
    const double dt = m_model->opt.timestep;
    while (!out.at_rest && out.simulated_s < m_rules.longest) {
      mj_step(m_model.get(), m_data.get());
      out.simulated_s += dt;
      const mjtNum* v = m_data->qvel;
      out.speed = Vec3(v[0], v[1], v[2]).norm();
      out.spin = Vec3(v[3], v[4], v[5]).norm();
      out.at_rest = clock.step(dt, out.speed, out.spin);
    }
    out.pose = m_task.object_pose(pose());
    return out;
  }

 private:
  void set_pose(const Pose& pose) {
    const Vec3& p = pose.translation;
    const Rotation& r = pose.rotation;
    const std::array<double, 7> values{p.x(), p.y(), p.z(), r.w, r.x, r.y, r.z};
    std::copy(values.begin(), values.end(), m_data->qpos);
  }
  Pose pose() const {
    const mjtNum* q = m_data->qpos;
    return {Rotation{q[3], q[4], q[5], q[6]}.normalized(), Vec3(q[0], q[1], q[2])};
  }

  const SettleTask& m_task;
  SimulationRules m_rules;
  std::string m_name;
  std::unique_ptr<mjModel, DeleteModel> m_model;
  std::unique_ptr<mjData, DeleteData> m_data;
};

}  // namespace

std::vector<std::unique_ptr<Simulator>> mujoco_simulators(const SettleTask& task,
                                                          const SimulationRules& rules) {
  mju_user_warning = [](const char*) {};  // otherwise it writes a file to the working directory
  std::vector<std::unique_ptr<Simulator>> out;
  out.push_back(std::make_unique<MujocoSimulator>(task, rules, "MuJoCo, one hull per mesh",
                                                  std::vector<Piece>{task.moving.vertices},
                                                  std::vector<Piece>{task.fixed.vertices}));
  out.push_back(std::make_unique<MujocoSimulator>(
      task, rules,
      text("MuJoCo, %zu hulls on %zu", task.moving_pieces.size(), task.fixed_pieces.size()),
      task.moving_pieces, task.fixed_pieces));
  return out;
}

std::string mujoco_version() {
  return std::string(mj_versionString()) + ", double precision, step 2 ms, all defaults";
}

}  // namespace trivet::perf
