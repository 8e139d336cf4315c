#include "gpu/egl/gl_objects.h"

#include <epoxy/egl.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "gpu/egl/environment_error.h"

namespace trivet {
namespace {

using GlShader = GlHandle<GlShaderKind>;

const char* stage_name(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER:
      return "vertex";
    case GL_GEOMETRY_SHADER:
      return "geometry";
    case GL_COMPUTE_SHADER:
      return "compute";
    default:
      return "fragment";
  }
}

GlShader compile(const char* name, GLenum stage, const std::string& source) {
  GlShader shader(glCreateShader(stage));
  const char* text = source.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = 0, length = 0;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return shader;
  glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(length + 1, '\0');
  glGetShaderInfoLog(shader.id(), length, nullptr, log.data());
  throw environment_error(say("the %1 shader of %2 does not compile on this driver: %3",
                              stage_name(stage), name, log.data()));
}

void check_framebuffer() {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  check_gl("making a framebuffer");
  char number[16];
  std::snprintf(number, sizeof number, "0x%04x", status);
  throw environment_error(say("the driver does not support a framebuffer, status %1", number));
}

void set_nearest(GLenum target) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
}

/// The layout of the client's data must be valid even if there is none.
GLenum client_format(GLenum internal_format) {
  switch (internal_format) {
    case GL_DEPTH_COMPONENT32F:
      return GL_DEPTH_COMPONENT;
    case GL_RGBA32UI:
      return GL_RGBA_INTEGER;
    default:
      return GL_RGBA;
  }
}

GLenum client_type(GLenum internal_format) {
  return internal_format == GL_RGBA32UI ? GL_UNSIGNED_INT : GL_FLOAT;
}

}  // namespace

bool has_gl_context() { return eglGetCurrentContext() != EGL_NO_CONTEXT; }

GLuint GlBufferKind::create() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return id;
}
void GlBufferKind::destroy(GLuint id) { glDeleteBuffers(1, &id); }

GLuint GlTextureKind::create() {
  GLuint id = 0;
  glGenTextures(1, &id);
  return id;
}
void GlTextureKind::destroy(GLuint id) { glDeleteTextures(1, &id); }

GLuint GlFramebufferKind::create() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  return id;
}
void GlFramebufferKind::destroy(GLuint id) { glDeleteFramebuffers(1, &id); }

GLuint GlRenderbufferKind::create() {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  return id;
}
void GlRenderbufferKind::destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }

GLuint GlVertexArrayKind::create() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return id;
}
void GlVertexArrayKind::destroy(GLuint id) { glDeleteVertexArrays(1, &id); }

GLuint GlSamplerKind::create() {
  GLuint id = 0;
  glGenSamplers(1, &id);
  return id;
}
void GlSamplerKind::destroy(GLuint id) { glDeleteSamplers(1, &id); }

void GlShaderKind::destroy(GLuint id) { glDeleteShader(id); }
void GlProgramKind::destroy(GLuint id) { glDeleteProgram(id); }

GlProgram::GlProgram(const char* name, const std::string& vertex, const std::string& fragment)
    : GlProgram(name, {{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {}

GlProgram::GlProgram(const char* name, std::initializer_list<GlShaderSource> shaders,
                     const char* feedback)
    : m_program(glCreateProgram()) {
  std::vector<GlShader> stages;
  for (const GlShaderSource& shader : shaders)
    stages.push_back(compile(name, shader.stage, shader.text));
  for (const GlShader& stage : stages) glAttachShader(id(), stage.id());
  if (feedback) glTransformFeedbackVaryings(id(), 1, &feedback, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(id());
  for (const GlShader& stage : stages) glDetachShader(id(), stage.id());
  GLint linked = 0, length = 0;
  glGetProgramiv(id(), GL_LINK_STATUS, &linked);
  if (linked != 0) return;
  glGetProgramiv(id(), GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(length + 1, '\0');
  glGetProgramInfoLog(id(), length, nullptr, log.data());
  throw environment_error(
      say("the shaders of %1 do not link on this driver: %2", name, log.data()));
}

void set_uniform(const GlProgram& program, const char* name, float value) {
  glUniform1f(program.uniform(name), value);
}
void set_uniform(const GlProgram& program, const char* name, int value) {
  glUniform1i(program.uniform(name), value);
}
void set_uniform(const GlProgram& program, const char* name, const Vec3& v) {
  const Eigen::Vector3f f = v.cast<float>();
  glUniform3fv(program.uniform(name), 1, f.data());
}
void set_uniform(const GlProgram& program, const char* name, const std::array<float, 4>& v) {
  glUniform4fv(program.uniform(name), 1, v.data());
}
void set_uniform(const GlProgram& program, const char* name, const Eigen::Matrix4d& m) {
  const Eigen::Matrix4f f = m.cast<float>();
  glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, f.data());
}

void bind_texture(int unit, GLenum target, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture);
}

GlBuffer make_buffer(GLenum target, const void* data, std::size_t bytes) {
  GlBuffer buffer = GlBuffer::create();
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  check_gl("sending the scene to the graphics memory");
  return buffer;
}

const void* buffer_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

GlTexture make_texture_2d(GLenum internal_format, int width, int height) {
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0,
               client_format(internal_format), client_type(internal_format), nullptr);
  set_nearest(GL_TEXTURE_2D);
  check_gl("making a texture");
  return texture;
}

void set_linear(const GlTexture& texture) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

GlTexture make_texture_array(GLenum internal_format, int width, int height, int layers) {
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(internal_format), width, height, layers,
               0, client_format(internal_format), client_type(internal_format), nullptr);
  set_nearest(GL_TEXTURE_2D_ARRAY);
  check_gl("making textures");
  return texture;
}

GlTexture make_depth_array(int size, int layers) {
  return make_texture_array(GL_DEPTH_COMPONENT32F, size, size, layers);
}

GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colours, GLuint depth) {
  GlFramebuffer framebuffer = GlFramebuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  std::vector<GLenum> buffers;
  for (const GLuint colour : colours) {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
    glFramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, colour, 0);
  }
  if (depth != 0)
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  check_framebuffer();
  return framebuffer;
}

GlRenderbuffer make_renderbuffer(GLenum internal_format, int width, int height, int samples) {
  GlRenderbuffer buffer = GlRenderbuffer::create();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal_format, width, height);
  check_gl("making a target to draw to");
  return buffer;
}

GlFramebuffer make_framebuffer(const GlRenderbuffer& colour, const GlRenderbuffer& depth) {
  GlFramebuffer framebuffer = GlFramebuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
  check_framebuffer();
  return framebuffer;
}

GlFramebuffer make_layered_framebuffer(GLuint colour_array) {
  GlFramebuffer framebuffer = GlFramebuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour_array, 0);
  check_framebuffer();
  return framebuffer;
}

GlFramebuffer make_depth_framebuffer(GLuint depth_array, int layer) {
  GlFramebuffer framebuffer = GlFramebuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth_array, 0, layer);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  check_framebuffer();
  return framebuffer;
}

Image read_picture(int width, int height) {
  Image image{width, height, {}};
  const std::size_t row = std::size_t{4} * width;
  std::vector<std::uint8_t> rows(row * height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  check_gl("reading a picture back");
  // OpenGL counts rows from below, images from above.
  image.rgba.resize(rows.size());
  for (int y = 0; y < height; ++y)
    std::copy_n(rows.data() + row * y, row, image.rgba.data() + row * (height - 1 - y));
  return image;
}

void check_gl(const char* stage) {
  const GLenum code = glGetError();
  if (code == GL_NO_ERROR) return;
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i)
    continue;  // clears error flags left by other code
  const char* name = code == GL_OUT_OF_MEMORY                   ? "GL_OUT_OF_MEMORY"
                     : code == GL_CONTEXT_LOST                  ? "GL_CONTEXT_LOST"
                     : code == GL_INVALID_OPERATION             ? "GL_INVALID_OPERATION"
                     : code == GL_INVALID_VALUE                 ? "GL_INVALID_VALUE"
                     : code == GL_INVALID_ENUM                  ? "GL_INVALID_ENUM"
                     : code == GL_INVALID_FRAMEBUFFER_OPERATION ? "GL_INVALID_FRAMEBUFFER_OPERATION"
                                                                : "an OpenGL error";
  char number[16];
  std::snprintf(number, sizeof number, " (0x%04x)", code);
  throw environment_error(say("OpenGL failed while %1: %2%3", stage, name, number));
}

void check_no_reset() {
  GLenum status = GL_NO_ERROR;
  if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"))
    status = glGetGraphicsResetStatus();
  else if (epoxy_has_gl_extension("GL_ARB_robustness"))
    status = glGetGraphicsResetStatusARB();
  if (status == GL_NO_ERROR) return;
  throw environment_error(
      say("the graphics hardware was reset, %1",
          (status == GL_GUILTY_CONTEXT_RESET     ? "GL_GUILTY_CONTEXT_RESET"
           : status == GL_INNOCENT_CONTEXT_RESET ? "GL_INNOCENT_CONTEXT_RESET"
                                                 : "GL_UNKNOWN_CONTEXT_RESET")));
}

}  // namespace trivet
