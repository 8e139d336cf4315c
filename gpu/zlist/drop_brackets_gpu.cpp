#include "gpu/zlist/drop_brackets_gpu.h"

#include <algorithm>
#include <cassert>

#include "core/base/error.h"
#include "gpu/egl/gl_objects.h"

namespace trivet {
namespace {

constexpr int kGroup = 64;

// One thread per place; `precise` keeps the compiler from rewriting the differences.
constexpr const char* kShader = R"(#version 430
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer ObjectMap { vec2 object_map[]; };
layout(std430, binding = 1) readonly buffer SceneMap { vec2 scene_map[]; };
layout(std430, binding = 2) writeonly buffer Brackets { vec2 brackets[]; };
uniform int object_width, object_height, scene_width, columns, num_places;
void main() {
  int place = int(gl_GlobalInvocationID.x);
  if (place >= num_places) return;
  ivec2 at = ivec2(place % columns, place / columns);
  vec2 lowest = vec2(uintBitsToFloat(0x7f800000u));
  for (int y = 0; y < object_height; ++y)
    for (int x = 0; x < object_width; ++x) {
      precise vec2 gap = object_map[y * object_width + x] -
                         scene_map[(y + at.y) * scene_width + x + at.x];
      lowest = mix(lowest, gap, lessThan(gap, lowest));
    }
  brackets[place] = lowest;
}
)";

// Interleaves bound and sample of each pixel.
std::vector<float> interleaved(const HeightMap& map) {
  std::vector<float> out;
  out.reserve(2 * map.bound.size());
  for (size_t i = 0; i < map.bound.size(); ++i) {
    out.push_back(map.bound[i]);
    out.push_back(map.sample[i]);
  }
  return out;
}

GlBuffer upload(const HeightMap& map) {
  const std::vector<float> data = interleaved(map);
  return make_buffer(GL_SHADER_STORAGE_BUFFER, data.data(), data.size() * sizeof(float));
}

}  // namespace

struct GpuDropBrackets::State {
  GpuFaults faults;
  EglContext context;
  std::unique_ptr<GlProgram> program;

  State(const EglOptions& options, const GpuFaults& injected)
      : faults(injected), context((injected.check_present(), options)) {
    if (context.gl_version() < 43)
      throw Error(Error::Kind::Environment, "brackets of falls need OpenGL 4.3, but %1 has less",
                  context.description());
    const EglContext::Current current(context);
    program = std::make_unique<GlProgram>(
        "brackets of falls", std::initializer_list<GlShaderSource>{{GL_COMPUTE_SHADER, kShader}});
  }
  ~State() {
    try {
      const EglContext::Current current(context);
      program.reset();
    } catch (const Error&) {  // the context is lost, including the program
      const EglContext::None none;
      program.reset();
    }
  }

  std::vector<DropBracket> run(const HeightMap& object, const HeightMap& scene, int columns,
                               int rows) const {
    static_assert(sizeof(DropBracket) == 2 * sizeof(float));
    const EglContext::Current current(context);
    std::vector<DropBracket> out(size_t(columns) * rows);
    if (out.empty()) return out;
    // Maps and results are buffers of this call; maps change with every call.
    const GlBuffer buffers[] = {
        upload(object), upload(scene),
        make_buffer(GL_SHADER_STORAGE_BUFFER, nullptr, out.size() * sizeof(DropBracket))};
    for (GLuint i = 0; i < 3; ++i) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i].id());
    program->use();
    glUniform1i(program->uniform("object_width"), object.width);
    glUniform1i(program->uniform("object_height"), object.height);
    glUniform1i(program->uniform("scene_width"), scene.width);
    glUniform1i(program->uniform("columns"), columns);
    glUniform1i(program->uniform("num_places"), static_cast<GLint>(out.size()));
    // A thread per place; the last group may have idle ones.
    glDispatchCompute(static_cast<GLuint>((out.size() + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[2].id());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                       static_cast<GLsizeiptr>(out.size() * sizeof(DropBracket)), out.data());
    check_gl("brackets of falls");
    faults.check_no_reset();
    return out;
  }
};

namespace {

// Compares with differences whose last bit reveals how they were rounded, including infinities.
bool is_exact(const std::vector<DropBracket>& found, const HeightMap& object,
              const HeightMap& scene) {
  for (size_t i = 0; i < found.size(); ++i)
    if (found[i].lower != object.bound[0] - scene.bound[i] ||
        found[i].upper != object.sample[0] - scene.sample[i])
      return false;
  return true;
}

}  // namespace

GpuDropBrackets::GpuDropBrackets(const EglOptions& options, const GpuFaults& faults)
    : m_state(std::make_unique<State>(options, faults)) {
  // Thirds, sevenths and tenths have differences that a driver gets wrong if it fuses or rounds
  // otherwise.
  HeightMap object(1, 1, 0), scene(256, 1, 0);
  object.bound[0] = 1.0F / 3;
  object.sample[0] = 1e4F / 7;
  for (int i = 0; i < 256; ++i) {
    scene.bound[i] = i == 0 ? -static_cast<float>(kInfinity) : 1.0F / static_cast<float>(i + 3);
    scene.sample[i] = static_cast<float>(i) * 0.1F;
  }
  if (!is_exact(m_state->run(object, scene, 256, 1), object, scene))
    throw Error(Error::Kind::Environment, "%1 does not compute differences exactly",
                m_state->context.description());
}

GpuDropBrackets::~GpuDropBrackets() = default;

std::string GpuDropBrackets::name() const { return m_state->context.renderer(); }

std::vector<DropBracket> GpuDropBrackets::operator()(const HeightMap& object,
                                                     const HeightMap& scene, int columns,
                                                     int rows) {
  assert(scene.width >= columns + object.width - 1 && scene.height >= rows + object.height - 1);
  return m_state->run(object, scene, columns, rows);
}

}  // namespace trivet
