// The images of a motion, side by side.
#include <algorithm>

#include "apps/trivet/canvas.h"
#include "apps/trivet/motion_lists.h"

namespace trivet::apps {
namespace {

constexpr int kPanelSize = 384, kLeastWidth = 190, kMargin = Canvas::kMargin;
constexpr int kCrossSize = 7;  // pixels from the middle of the mark
constexpr Rgb kFrame{160, 160, 160}, kWhite{255, 255, 255};

struct Panel {
  DepthShow show;
  const char* title;
};
constexpr Panel kPanels[] = {{DepthShow::Moving, "moving front"},
                             {DepthShow::Fixed, "fixed front"},
                             {DepthShow::Gap, "gap"}};

void copy(const std::vector<std::uint8_t>& rgba, int width, int left, int top, Canvas& canvas) {
  for (size_t i = 0; 4 * i < rgba.size(); ++i)
    if (rgba[4 * i + 3])
      canvas.set(left + static_cast<int>(i) % width, top + static_cast<int>(i) / width,
                 {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]});
}

void draw_frame(int left, int top, int width, int height, Canvas& canvas) {
  canvas.fill(left - 1, top - 1, width + 2, 1, kFrame);
  canvas.fill(left - 1, top + height, width + 2, 1, kFrame);
  canvas.fill(left - 1, top, 1, height, kFrame);
  canvas.fill(left + width, top, 1, height, kFrame);
}

// A white cross with a black rim, open in the middle.
void draw_cross(int x, int y, Canvas& canvas) {
  for (const auto& [room, colour] : {std::pair(1, Canvas::kBlack), std::pair(0, kWhite)})
    for (const int sign : {-1, 1}) {
      const int begin = sign < 0 ? -kCrossSize : 3, length = kCrossSize - 2;
      canvas.fill(x + begin - room, y - room, length + 2 * room, 1 + 2 * room, colour);
      canvas.fill(x - room, y + begin - room, 1 + 2 * room, length + 2 * room, colour);
    }
}

}  // namespace

Image motion_picture(const MotionLists& what) {
  const DepthPicture picture(what.lists.depths);
  const int longer = std::max({picture.width(), picture.height(), 1});
  const int magnify = std::max(1, kPanelSize / longer);
  const int width = magnify * picture.width(), height = magnify * picture.height();
  const int column = std::max(width, kLeastWidth) + 2 * kMargin;
  const int top = Canvas::kTextHeight + 2 * kMargin;
  Canvas canvas(static_cast<int>(std::size(kPanels)) * column,
                top + height + Canvas::kScaleHeight + 3 * kMargin);
  const FirstContact& contact = what.lists.contact;
  const bool touches =
      contact.status == FirstContact::Status::Contact && contact.fixed != FirstContact::kFloor;
  const auto met = touches ? picture.seen_at(contact.point) : std::nullopt;
  int left = kMargin;
  for (const Panel& panel : kPanels) {
    canvas.write(left, kMargin, panel.title);
    copy(picture.paint(panel.show, magnify), width, left, top, canvas);
    draw_frame(left, top, width, height, canvas);
    if (met)
      draw_cross(left + magnify * (*met)[0] + magnify / 2, top + magnify * (*met)[1] + magnify / 2,
                 canvas);
    if (const auto range = picture.range(panel.show))
      canvas.draw_scale(left, top + height + 2 * kMargin, column - 2 * kMargin, (*range)[0],
                        (*range)[1], what.lists.depths.unit(), false);
    left += column;
  }
  return canvas.take();
}

}  // namespace trivet::apps
