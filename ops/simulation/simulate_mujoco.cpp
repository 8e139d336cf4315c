#include <dlfcn.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "core/base/error.h"
#include "ops/simulation/simulate.h"

namespace trivet {
namespace {

constexpr double kFirstContacts = 0.05;  // seconds in which gaps of contacts close

constexpr const char* kLibrary = "libmujoco.so." TRIVET_MUJOCO_VERSION;

// MuJoCo's functions, of the library as of the headers. Opened at run time, so that all else works
// without it.
struct Mujoco {
  static const Mujoco* get() {
    static const Mujoco library;
    return library.m_found ? &library : nullptr;
  }

  decltype(&mj_loadXML) load = nullptr;
  decltype(&mj_makeData) make_data = nullptr;
  decltype(&mj_deleteModel) delete_model = nullptr;
  decltype(&mj_deleteData) delete_data = nullptr;
  decltype(&mj_forward) forward = nullptr;
  decltype(&mj_step) step = nullptr;
  decltype(&mj_name2id) number = nullptr;
  decltype(&mj_versionString) version = nullptr;
  decltype(&mju_user_warning) user_warning = nullptr;

 private:
  Mujoco() : m_library(dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL)) {
#ifdef TRIVET_MUJOCO_FILE  // where this build found it: it need not be in the loader's path
    if (!m_library) m_library = dlopen(TRIVET_MUJOCO_FILE, RTLD_NOW | RTLD_LOCAL);
#endif
    if (!m_library) return;
    m_found = find("mj_loadXML", load) && find("mj_makeData", make_data) &&
              find("mj_deleteModel", delete_model) && find("mj_deleteData", delete_data) &&
              find("mj_forward", forward) && find("mj_step", step) && find("mj_name2id", number) &&
              find("mj_versionString", version) && find("mju_user_warning", user_warning);
  }
  template <class Pointer>
  bool find(const char* name, Pointer& pointer) {
    pointer = reinterpret_cast<Pointer>(dlsym(m_library, name));
    return pointer != nullptr;
  }

  void* m_library;
  bool m_found = false;
};

const Mujoco& mujoco() {
  if (const Mujoco* const found = Mujoco::get()) return *found;
  throw Error(Error::Kind::BadInput, no_simulator());
}

struct DeleteModel {
  void operator()(mjModel* model) const { mujoco().delete_model(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mujoco().delete_data(data); }
};

class MujocoRun {
 public:
  explicit MujocoRun(const std::string& path) {
    *m_mujoco.user_warning = [](const char*) {};  // else it writes a file to the working directory
    char why[1000] = "";
    m_model.reset(m_mujoco.load(path.c_str(), nullptr, why, sizeof why));
    if (!m_model)
      throw Error(Error::Kind::BadInput, "%1: MuJoCo does not accept it: %2", path, why);
    m_data.reset(m_mujoco.make_data(m_model.get()));
    m_mujoco.forward(m_model.get(), m_data.get());
  }

  Affine pose(const SimulationBody& body) const {
    const int id = body_number(body);
    Affine out;
    for (int r = 0; r < 3; ++r) {
      out.translation[r] = m_data->xpos[3 * id + r];
      for (int c = 0; c < 3; ++c) out.linear(r, c) = m_data->xmat[9 * id + 3 * r + c];
    }
    return out;
  }

  void run(double seconds) {
    while (m_data->time < seconds) m_mujoco.step(m_model.get(), m_data.get());
    m_mujoco.forward(m_model.get(), m_data.get());
  }

  /// Pairs of bodies with a contact in any step up to this time.
  std::set<std::array<std::string, 2>> touched(const SimulationScene& scene, double until) {
    std::map<int, std::string> names{{0, "floor"}};
    for (const SimulationBody& body : scene.bodies) names[body_number(body)] = body.name;
    std::set<std::array<std::string, 2>> out;
    do {
      for (int i = 0; i < m_data->ncon; ++i) {
        const mjContact& contact = m_data->contact[i];
        out.insert({names[m_model->geom_bodyid[contact.geom1]],
                    names[m_model->geom_bodyid[contact.geom2]]});
      }
      m_mujoco.step(m_model.get(), m_data.get());
    } while (m_data->time < until);
    return out;
  }

  double penetration() const {
    double deepest = 0;
    for (int i = 0; i < m_data->ncon; ++i) deepest = std::max(deepest, -m_data->contact[i].dist);
    return deepest;
  }

  int num_warnings() const {
    int count = 0;
    for (const mjWarningStat& warning : m_data->warning) count += warning.number;
    return count;
  }

 private:
  int body_number(const SimulationBody& body) const {
    return m_mujoco.number(m_model.get(), mjOBJ_BODY, body.file_name.c_str());
  }

  const Mujoco& m_mujoco = mujoco();
  std::unique_ptr<mjModel, DeleteModel> m_model;
  std::unique_ptr<mjData, DeleteData> m_data;
};

/// The scene file that this simulator reads: the one that was written, or one beside it.
class ReadableFile {
 public:
  ReadableFile(const SimulationExport& done, SimulationFileOptions files)
      : m_path(done.files.at(0)) {
    const bool is_old = mujoco().version()[0] == '2';
    if (!is_old || files.mujoco == kOldestMujoco) return;
    const std::filesystem::path file(m_path);
    if (files.mesh_folder.empty()) files.mesh_folder = file.stem().string() + "_meshes";
    files.mujoco = kOldestMujoco;
    files.asleep = false;
    m_path = (file.parent_path() / ("." + file.stem().string() + ".mujoco2.xml")).string();
    m_is_own = true;
    SimulationScene scene = done.scene;
    write_simulation(scene, m_path, files);
  }
  ~ReadableFile() {
    std::error_code ignored;
    if (m_is_own) std::filesystem::remove(m_path, ignored);
  }
  ReadableFile(const ReadableFile&) = delete;
  ReadableFile& operator=(const ReadableFile&) = delete;

  const std::string& path() const { return m_path; }

 private:
  std::string m_path;
  bool m_is_own = false;
};

}  // namespace

bool can_simulate() { return Mujoco::get() != nullptr; }

std::string no_simulator() {
  return std::string("this machine has no ") + kLibrary +
         " (Debian: libmujoco" TRIVET_MUJOCO_VERSION ")";
}

SimulatedScene simulate(const SimulationExport& done, double seconds,
                        const SimulationFileOptions& files) {
  const ReadableFile file(done, files);
  MujocoRun run(file.path());
  std::vector<Affine> before;
  for (const SimulationBody& body : done.scene.bodies) before.push_back(run.pose(body));
  SimulatedScene out;
  out.penetration = run.penetration();
  out.touched = run.touched(done.scene, std::min(seconds, kFirstContacts));
  run.run(seconds);
  out.simulator = std::string("MuJoCo ") + mujoco().version();
  out.seconds = seconds;
  out.num_warnings = run.num_warnings();
  for (size_t i = 0; i < before.size(); ++i) {
    const SimulationBody& body = done.scene.bodies[i];
    if (!body.fixed) out.objects.push_back(simulated_object(done, body, before[i], run.pose(body)));
  }
  return out;
}

}  // namespace trivet
