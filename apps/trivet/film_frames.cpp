#include "apps/trivet/film_frames.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

#include "apps/trivet/outputs.h"
#include "core/base/bad_input.h"
#include "core/base/extension.h"
#include "core/io/atomic_file.h"
#include "core/picture/png.h"
#include "core/picture/webp_animation.h"
#include "ops/files/json/text.h"

namespace trivet::apps {
namespace {

constexpr double kMostFrames = 100'000;

void check_file(const std::string& file) {
  check_extension(file, {".webp", ".png"});
  if (lower_extension(file) == ".png" && file.find(kPlaceOfName) == std::string::npos)
    bad_input("--animation: %1 is one picture; accepted: a .png with {} for the number, or .webp",
              file);
}

struct FilmedRun {
  LayoutRun run;
  MotionFilm film;
};

FilmedRun filmed(const std::string& file, const Layout& layout, const CommonOptions& common) {
  const std::unique_ptr<Detector> detector = make_detector(common);
  RunOptions options = run_options(common, {}, detector.get());
  options.layout_file = file;
  std::optional<MotionFilm> film;
  LayoutRun run = run_layout(layout, models_in_folder(folder_of(file), common.limits()), options,
                             film_watch(film));
  return {std::move(run), std::move(*film)};
}

/// Keeps the meshes of all models that were seen.
class Frames {
 public:
  Frames(const MotionFilm& film, bool floor) : m_film(film), m_floor(floor) {}

  PictureScene at(double time) {
    PictureScene out;
    out.floor = m_floor;
    const std::vector<MotionFilm::Seen> all = m_film.at(time);
    out.objects.reserve(all.size());
    for (const MotionFilm::Seen& seen : all) {
      const auto [mesh, is_new] = m_meshes.try_emplace(seen.model.get());
      if (is_new) mesh->second = picture_mesh(seen.model);
      out.objects.push_back({&mesh->second, seen.world_from_object, std::nullopt});
    }
    return out;
  }

 private:
  const MotionFilm& m_film;
  bool m_floor;
  std::map<const Model*, PictureMesh> m_meshes;  // node-based: stable addresses
};

std::string numbered_file(const std::string& file, size_t number, size_t count) {
  std::ostringstream digits;
  const size_t width = std::max<size_t>(4, std::to_string(count).size());
  digits << std::setw(static_cast<int>(width)) << std::setfill('0') << number;
  return with_name(file, digits.str());
}

size_t num_frames(const MotionFilm& film, double fps) {
  const double count = std::floor(film.seconds() * fps) + 1;
  if (count > kMostFrames)
    bad_input("--fps: the film of %1 s has more than %2 pictures; accepted: fewer per second",
              figure(film.seconds()), figure(kMostFrames));
  return static_cast<size_t>(count);
}

}  // namespace

void add_film_options(CLI::App& app, FilmFrames& film) {
  CLI::Option* const file =
      app.add_option("--animation", film.file,
                     "Render the motions of a layout's operations, as an animated .webp or as "
                     "numbered pictures: a .png with {} for the number")
          ->type_name("FILE");
  app.add_option("--fps", film.fps, "Frames per second of the animation; default: 24")
      ->check(number_from(0.1, 1000))
      ->needs(file);
}

void check_can_be_filmed(const Layout& layout) {
  if (!layout.scene.empty())
    bad_input("--animation: is not accepted for scenes in place; accepted: layouts of models");
}

RunWatch film_watch(std::optional<MotionFilm>& film) {
  RunWatch watch;
  watch.standing = [&film](const Scene& start) { film.emplace(start); };
  watch.done = [&film](const Scene& after, const Operation& operation,
                       const OperationResult& done) { film->add(after, operation, done); };
  return watch;
}

int render_film(const std::string& file, const FilmFrames& film, const PictureRequest& request,
                const CommonOptions& common) {
  if (lower_extension(file) != ".json")
    bad_input("--animation: %1 has no operations; accepted: a layout (.json)", file);
  const Layout layout = read_layout(file, common.limits().max_file_bytes);
  check_can_be_filmed(layout);
  check_file(film.file);
  check_not_the_same({film.file}, model_files(layout, folder_of(file)));
  PictureMaker maker(request);
  const auto [run, motion] = filmed(file, layout, common);
  Frames frames(motion, layout.floor);
  const size_t count = num_frames(motion, film.fps);
  const double aspect = double(request.width) / request.height;
  const Camera camera =
      request.explicit_camera().value_or(automatic_camera(frames.at(motion.seconds()), aspect));
  const bool webp = lower_extension(film.file) == ".webp";
  std::optional<WebpAnimation> animation;
  if (webp) animation.emplace(request.width, request.height);
  const ProgressCallback progress = terminal_progress(common);
  for (size_t i = 0; i < count; ++i) {
    if (progress) progress({"picture", std::to_string(i + 1), i, count});
    const double time = i + 1 == count ? motion.seconds() : static_cast<double>(i) / film.fps;
    const Image image = maker.image(frames.at(time), camera);
    const auto at = [&](size_t k) { return std::lround(1000.0 * double(k) / film.fps); };
    if (webp)
      animation->add(image, static_cast<int>(at(i + 1) - at(i)));
    else
      write_file_atomically(numbered_file(film.file, i + 1, count), encode_png(image));
  }
  if (webp) write_file_atomically(film.file, animation->bytes());
  clear_progress_line(common);
  if (run.ok()) return 0;
  if (!common.quiet) std::cerr << summary(run);
  return 1;
}

}  // namespace trivet::apps
