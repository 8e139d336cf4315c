// Exported scenes at rest in Debian's MuJoCo, 2.2.2: mujoco2_rest SECONDS [--starts FILE]
// SCENE.xml..., of `trivet export --mujoco 2`. See rest.h.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "interop/simulators/rest.h"

namespace {

using rest::Json;

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Point = std::array<double, 3>;

class World {
 public:
  World(const std::string& scene, const rest::Starts& starts) {
    mju_user_warning = [](const char*) {};  // else it writes a file to the working directory
    char why[1000] = "";
    m_model.reset(mj_loadXML(scene.c_str(), nullptr, why, sizeof why));
    if (!m_model) throw std::runtime_error(scene + ": " + why);
    if (*why) std::cerr << scene << ": " << why << "\n";  // a warning
    m_data.reset(mj_makeData(m_model.get()));
    for (const auto& [name, start] : starts) place(name, start);
    mj_forward(m_model.get(), m_data.get());
    for (int body = 0; body < m_model->nbody; ++body) {
      m_points.push_back(points(body));
      m_rotations.push_back(rotation(body));
    }
  }

  std::string simulator() const { return std::string("MuJoCo ") + mj_versionString(); }
  double timestep() const { return m_model->opt.timestep; }
  void step() { mj_step(m_model.get(), m_data.get()); }

  double penetration() const {
    double deepest = 0;
    for (int i = 0; i < m_data->ncon; ++i) deepest = std::max(deepest, -m_data->contact[i].dist);
    return deepest;
  }
  int warnings() const {
    int count = 0;
    for (const mjWarningStat& warning : m_data->warning) count += warning.number;
    return count;
  }
  int num_hulls() const {
    int count = 0;
    for (int geom = 0; geom < m_model->ngeom; ++geom) count += is_hull(geom);
    return count;
  }

  Json objects() const {
    Json out = Json::array();
    for (int body = 1; body < m_model->nbody; ++body)
      if (m_model->body_jntnum[body] > 0) out.push_back(object(body));
    return out;
  }

 private:
  bool is_hull(int geom) const {
    return m_model->geom_type[geom] == mjGEOM_MESH && m_model->geom_contype[geom] == 1;
  }

  void place(const std::string& name, const rest::Start& start) {
    const int body = mj_name2id(m_model.get(), mjOBJ_BODY, name.c_str());
    if (body < 0) throw std::runtime_error("no body \"" + name + "\"");
    const bool fixed = m_model->body_jntnum[body] == 0;
    double* const at = fixed ? m_model->body_pos + 3 * body
                             : m_data->qpos + m_model->jnt_qposadr[m_model->body_jntadr[body]];
    std::copy_n(start.position.begin(), 3, at);
    std::copy_n(start.rotation.begin(), 4, fixed ? m_model->body_quat + 4 * body : at + 3);
  }

  // Corners of a body's hulls in the world.
  std::vector<Point> points(int body) const {
    std::vector<Point> out;
    const int first = m_model->body_geomadr[body];
    for (int geom = first; geom < first + m_model->body_geomnum[body]; ++geom) {
      if (!is_hull(geom)) continue;
      const int mesh = m_model->geom_dataid[geom];
      const float* vertex = m_model->mesh_vert + 3 * m_model->mesh_vertadr[mesh];
      for (int i = 0; i < m_model->mesh_vertnum[mesh]; ++i, vertex += 3) {
        const double local[3] = {vertex[0], vertex[1], vertex[2]};
        Point& point = out.emplace_back();
        mju_rotVecMat(point.data(), local, m_data->geom_xmat + 9 * geom);
        mju_addTo3(point.data(), m_data->geom_xpos + 3 * geom);
      }
    }
    return out;
  }
  std::array<double, 4> rotation(int body) const {
    const double* const q = m_data->xquat + 4 * body;
    return {q[0], q[1], q[2], q[3]};
  }

  Json object(int body) const {
    const std::vector<Point> now = points(body);
    double moved = 0, cosine = 0;
    for (size_t i = 0; i < now.size(); ++i)
      moved = std::max(moved, mju_dist3(now[i].data(), m_points[body][i].data()));
    const std::array<double, 4> turned = rotation(body);
    for (int k = 0; k < 4; ++k) cosine += turned[k] * m_rotations[body][k];
    const double* const p = m_data->xpos + 3 * body;
    return {{"name", mj_id2name(m_model.get(), mjOBJ_BODY, body)},
            {"moved", moved},
            {"turned_deg", 2 * std::acos(std::min(1.0, std::abs(cosine))) * 180 / mjPI},
            {"position", {p[0], p[1], p[2]}},
            {"rotation", turned}};
  }

  std::unique_ptr<mjModel, DeleteModel> m_model;
  std::unique_ptr<mjData, DeleteData> m_data;
  std::vector<std::vector<Point>> m_points;        // of the bodies, at the start
  std::vector<std::array<double, 4>> m_rotations;  // of the bodies, at the start
};

}  // namespace

int main(int count, char** arguments) { return rest::run<World>(count, arguments); }
