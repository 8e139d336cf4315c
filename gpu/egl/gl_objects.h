// Private to gpu: owners of OpenGL objects. All need a current context to be created and destroyed;
// without any (EglContext::None) they are dropped, for use after a lost context.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>

#include "core/base/image.h"
#include "core/base/types.h"

namespace trivet {

/// True if a context is current on this thread.
bool has_gl_context();

/// Owns one OpenGL name; move-only. 0: owns no object.
template <typename Kind>
class GlHandle {
 public:
  GlHandle() = default;
  explicit GlHandle(GLuint id) : m_id(id) {}
  static GlHandle create() { return GlHandle(Kind::create()); }
  ~GlHandle() {
    if (m_id != 0 && has_gl_context()) Kind::destroy(m_id);
  }
  GlHandle(GlHandle&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(m_id, other.m_id);
    return *this;
  }
  GLuint id() const { return m_id; }

 private:
  GLuint m_id = 0;
};

struct GlBufferKind {
  static GLuint create();
  static void destroy(GLuint id);
};
struct GlTextureKind {
  static GLuint create();
  static void destroy(GLuint id);
};
struct GlFramebufferKind {
  static GLuint create();
  static void destroy(GLuint id);
};
struct GlRenderbufferKind {
  static GLuint create();
  static void destroy(GLuint id);
};
struct GlVertexArrayKind {
  static GLuint create();
  static void destroy(GLuint id);
};
struct GlSamplerKind {
  static GLuint create();
  static void destroy(GLuint id);
};
struct GlShaderKind {
  static void destroy(GLuint id);
};
struct GlProgramKind {
  static void destroy(GLuint id);
};
using GlBuffer = GlHandle<GlBufferKind>;
using GlTexture = GlHandle<GlTextureKind>;
using GlFramebuffer = GlHandle<GlFramebufferKind>;
using GlRenderbuffer = GlHandle<GlRenderbufferKind>;
using GlSampler = GlHandle<GlSamplerKind>;
using GlVertexArray = GlHandle<GlVertexArrayKind>;

struct GlShaderSource {
  GLenum stage;  // GL_VERTEX_SHADER
  std::string text;
};

/// Linked shaders. Sets of uniforms removed by the compiler are ignored.
class GlProgram {
 public:
  /// @param name  for messages.
  /// @param feedback  variable recorded by transform feedback, or null.
  /// @throws Error (Environment) with the compiler's log.
  GlProgram(const char* name, std::initializer_list<GlShaderSource> shaders,
            const char* feedback = nullptr);
  GlProgram(const char* name, const std::string& vertex, const std::string& fragment);

  GLuint id() const { return m_program.id(); }
  void use() const { glUseProgram(id()); }
  GLint uniform(const char* name) const { return glGetUniformLocation(id(), name); }

 private:
  GlHandle<GlProgramKind> m_program;
};

/// Sets a uniform of the program in use.
void set_uniform(const GlProgram& program, const char* name, float value);
void set_uniform(const GlProgram& program, const char* name, int value);
void set_uniform(const GlProgram& program, const char* name, const Vec3& v);
void set_uniform(const GlProgram& program, const char* name, const std::array<float, 4>& v);
void set_uniform(const GlProgram& program, const char* name, const Eigen::Matrix4d& m);

/// Binds a texture to a unit, for the program in use.
void bind_texture(int unit, GLenum target, GLuint texture);

/// Makes an immutable buffer.
GlBuffer make_buffer(GLenum target, const void* data, std::size_t bytes);

/// An offset within the buffer that is bound, as OpenGL takes it.
const void* buffer_offset(std::size_t bytes);

/// A texture of one level, read texel by texel (nearest, clamped); not initialised.
GlTexture make_texture_2d(GLenum internal_format, int width, int height);

/// Switches a texture to linear filtering.
void set_linear(const GlTexture& texture);

/// Makes an array of textures, likewise.
GlTexture make_texture_array(GLenum internal_format, int width, int height, int layers);

/// Makes an array of float32 depth textures, likewise.
GlTexture make_depth_array(int size, int layers);

/// Framebuffer of these colour textures in order and, unless 0, this depth texture.
/// @throws Error (Environment) if the driver does not support the combination.
GlFramebuffer make_framebuffer(std::initializer_list<GLuint> colours, GLuint depth);

/// Render target with several samples per pixel (0: one), not readable as a texture.
GlRenderbuffer make_renderbuffer(GLenum internal_format, int width, int height, int samples);

/// A framebuffer of a colour and a depth renderbuffer.
GlFramebuffer make_framebuffer(const GlRenderbuffer& colour, const GlRenderbuffer& depth);

/// A framebuffer of all layers of an array; geometry shaders choose among them.
GlFramebuffer make_layered_framebuffer(GLuint colour_array);

/// A framebuffer of one layer of a depth array and no colour.
GlFramebuffer make_depth_framebuffer(GLuint depth_array, int layer);

/// Reads the lower left part of the current framebuffer, rows from top to bottom.
Image read_picture(int width, int height);

/// Checks for OpenGL errors since the last call.
/// @throws Error (Environment) naming `stage` and the OpenGL error.
void check_gl(const char* stage);

/// Checks whether the graphics hardware was reset since the context was made: its objects are lost,
/// and so are results that were read. Contexts without robustness never tell.
/// @throws Error (Environment) with the driver's reason.
void check_no_reset();

}  // namespace trivet
