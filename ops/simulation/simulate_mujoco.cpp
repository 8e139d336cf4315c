#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/error.h"
#include "ops/simulation/simulate.h"

namespace trivet {
namespace {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

class MujocoRun {
 public:
  explicit MujocoRun(const std::string& path) {
    mju_user_warning = [](const char*) {};  // else it writes a file to the working directory
    char why[1000] = "";
    m_model.reset(mj_loadXML(path.c_str(), nullptr, why, sizeof why));
    if (!m_model) throw Error(Error::Kind::BadInput, path + ": MuJoCo does not accept it: " + why);
    m_data.reset(mj_makeData(m_model.get()));
    mj_forward(m_model.get(), m_data.get());
  }

  Affine pose(const SimulationBody& body) const {
    const int id = mj_name2id(m_model.get(), mjOBJ_BODY, body.file_name.c_str());
    Affine out;
    for (int r = 0; r < 3; ++r) {
      out.translation[r] = m_data->xpos[3 * id + r];
      for (int c = 0; c < 3; ++c) out.linear(r, c) = m_data->xmat[9 * id + 3 * r + c];
    }
    return out;
  }

  void run(double seconds) {
    while (m_data->time < seconds) mj_step(m_model.get(), m_data.get());
    mj_forward(m_model.get(), m_data.get());
  }

  int num_warnings() const {
    int count = 0;
    for (const mjWarningStat& warning : m_data->warning) count += warning.number;
    return count;
  }

 private:
  std::unique_ptr<mjModel, DeleteModel> m_model;
  std::unique_ptr<mjData, DeleteData> m_data;
};

SimulatedObject moved_between(const SimulationModel& model, const std::string& name,
                              const Affine& from, const Affine& to) {
  SimulatedObject out{name};
  for (const ConvexPart& part : model.parts)
    for (const Vec3& v : part.vertices)
      out.moved = std::max(out.moved, (to.apply(v) - from.apply(v)).norm());
  const double cosine = ((to.linear * from.linear.transpose()).trace() - 1) / 2;
  out.turned_deg = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / 3.14159265358979323846;
  return out;
}

}  // namespace

bool can_simulate() { return true; }

SimulatedScene simulate(const SimulationExport& done, double seconds) {
  const std::string& path = done.files.at(0);
  MujocoRun run(path);
  std::vector<Affine> before;
  for (const SimulationBody& body : done.scene.bodies) before.push_back(run.pose(body));
  run.run(seconds);
  SimulatedScene out;
  out.simulator = std::string("MuJoCo ") + mj_versionString();
  out.seconds = seconds;
  out.num_warnings = run.num_warnings();
  for (size_t i = 0; i < before.size(); ++i) {
    const SimulationBody& body = done.scene.bodies[i];
    if (!body.fixed)
      out.objects.push_back(
          moved_between(done.scene.models[body.model], body.name, before[i], run.pose(body)));
  }
  return out;
}

}  // namespace trivet
