#include "gpu/live/view.h"

#include "core/base/error.h"
#include "gpu/live/renderer.h"

namespace trivet {
namespace {

// Drafts of larger scenes cache the static objects: this many triangles take some 30 ms.
constexpr std::int64_t kManyOnCpu = 100'000, kManyOnGpu = 5'000'000;
constexpr int kMaxViewSide = 16384;  // pixels

void check_size(const LiveOptions& options) {
  const auto is_good = [](int side) { return side >= 1 && side <= kMaxViewSide; };
  if (is_good(options.width) && is_good(options.height)) return;
  throw Error(Error::Kind::BadInput,
              "a view of %1 x %2 pixels; accepted: 1 to %3 in each dimension", options.width,
              options.height, kMaxViewSide);
}

}  // namespace

struct LiveView::State {
  EglContext& context;
  std::unique_ptr<LiveRenderer> renderer;
};

LiveView::LiveView(EglContext& context) : m_state(std::make_unique<State>(State{context, {}})) {
  const EglContext::Current current(context);
  m_state->renderer =
      std::make_unique<LiveRenderer>(context.is_software() ? kManyOnCpu : kManyOnGpu);
}

LiveView::~LiveView() {
  const EglContext::Current current(m_state->context);
  m_state->renderer.reset();
}

Image LiveView::draw(const LiveScene& scene, const LiveCamera& camera, const LiveOptions& options) {
  check_size(options);
  const EglContext::Current current(m_state->context);
  return m_state->renderer->draw(scene, camera, options);
}

const LiveView::Work& LiveView::work() const { return m_state->renderer->work(); }

}  // namespace trivet
