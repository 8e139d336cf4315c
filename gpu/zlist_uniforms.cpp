#include "gpu/zlist_lists.h"

namespace trivet {

void set_view_uniforms(const GlProgram& program, const ZListView& view) {
  glUniform2i(program.uniform("size"), view.width, view.height);
  glUniform1f(program.uniform("first_radius"), view.first_radius);
  glUniform1f(program.uniform("sample_error"), view.sample_error);
  glUniform1f(program.uniform("period"), view.period);
  glUniform1f(program.uniform("first_depth"), view.first_depth);
}

void set_body_uniforms(const GlProgram& program, const ZListBody& body) {
  glUniform4fv(program.uniform("rows"), 3, body.rows.data());
  glUniform1f(program.uniform("blur"), body.blur);
  glUniform1f(program.uniform("depth_blur"), body.depth_blur);
  glUniform1ui(program.uniform("first_face"), body.first_face);
}

}  // namespace trivet
