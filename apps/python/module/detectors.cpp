#include "apps/python/module/detectors.h"

#include <map>
#include <utility>

namespace trivet::python {

ChosenDetectors::ChosenDetectors(DetectionChoice choice)
    : m_choice(std::move(choice)),
      m_pool([options = shared_backend_options(m_choice, [this](const Sentence& text) {
                const std::lock_guard lock(m_mutex);
                m_notes.push_back(in_english(text));
              })] { return make_detector(options); }) {}

std::vector<std::string> ChosenDetectors::take_notes() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_notes, {});
}

std::shared_ptr<ChosenDetectors> detectors_of(const std::string& detector,
                                              const std::string& device) {
  // Outlives static destructors: drivers of OpenGL may be gone before these run.
  static auto* const known =
      new std::map<std::pair<std::string, int>, std::shared_ptr<ChosenDetectors>>;
  DetectionChoice choice;
  choice.detector = detector;
  choice.device = device == "auto" ? usual_device() : device_from_text(device);
  check_detection(choice);
  std::shared_ptr<ChosenDetectors>& out = (*known)[{detector, choice.device}];
  if (!out) out = std::make_shared<ChosenDetectors>(choice);
  return out;
}

}  // namespace trivet::python
