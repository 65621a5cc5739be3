#include "gpu/opengl/timers.h"

#include "core/error.h"

namespace gg::gpu::opengl {

Timers::Timers(ContextRef context)
    : context_(std::move(context)), software_(is_software(context_->renderer())) {}

Timers::~Timers() {
  try {
    context_->gl().DeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
  } catch (const Error&) {
    // Not reachable from this thread: the context takes them along when it ends.
  }
}

void Timers::stamp() {
  const GladGLContext& gl = context_->gl();
  // A software rasterizer collects triangles and stamps alike and works them off later, tile by
  // tile; a stamp among triangles would tell when the last tile reached it.
  if (software_) gl.Finish();
  if (used_ == queries_.size()) {
    GLuint query = 0;
    gl.CreateQueries(GL_TIMESTAMP, 1, &query);
    context_->label(GL_QUERY, query, "timestamp");
    ++context_->counters.created;
    queries_.push_back(query);
  }
  gl.QueryCounter(queries_[used_++], GL_TIMESTAMP);
  if (software_) gl.Finish();
}

void Timers::collect(std::span<const Pass> passes, std::vector<PassTime>& times) {
  const GladGLContext& gl = context_->gl();
  const auto value = [&](std::size_t i) {
    GLuint64 nanoseconds = 0;
    gl.GetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &nanoseconds);
    return nanoseconds;
  };
  for (std::size_t i = 0; i < passes.size(); ++i)
    times.push_back({passes[i].label, 1e-6 * static_cast<double>(value(2 * i + 1) - value(2 * i))});
  used_ = 0;
}

} // namespace gg::gpu::opengl
