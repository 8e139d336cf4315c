#include "apps/edit_document/testing.h"

#include <QCoreApplication>
#include <algorithm>
#include <stdexcept>

#include "apps/demo/demo.h"
#include "core/io/export.h"

namespace trivet::edit::test {

void write_models(const std::string& demo, const TemporaryFolder& folder) {
  for (const DemoModel& made : make_demo(demo).models) {
    ExportScene scene;
    scene.objects.push_back({"model", std::make_shared<const Model>(made.model), Affine{}, ""});
    write_scene(scene, folder.file(made.file));
  }
}

Recorder::Recorder(const std::string& recovery_folder, BackendOptions detection) {
  DocumentOptions options;
  options.detection = std::move(detection);
  options.recovery_folder = recovery_folder;
  options.version = "test";
  m_document = std::make_unique<Document>(options);
  QObject::connect(m_document.get(), &Document::message,
                   [this](const Message& message) { m_messages.push_back(message); });
  QObject::connect(m_document.get(), &Document::finished, [this](quint64 job, bool ok) {
    m_finished.push_back({job, ok});
  });
}

bool Recorder::done(Document::Job job) {
  if (!m_document->wait_until_idle()) throw std::runtime_error("the document did not become idle");
  return std::find(m_finished.begin(), m_finished.end(), std::pair(job, true)) != m_finished.end();
}

void Recorder::import(const std::string& file, const std::string& name, bool fixed) {
  ImportModel model;
  model.file = file;
  model.name = name;
  model.fixed = fixed;
  if (fixed) model.put = Pose{{}, Vec3(0, 0, 0.01)};
  if (!done(m_document->import_model(model))) throw std::runtime_error(last_text());
}

const Object& Recorder::object(const std::string& name) const {
  const ObjectSnapshot* const found = m_document->snapshot()->find(name);
  if (!found) throw std::runtime_error("no object " + name);
  return *found->object;
}

ObjectId Recorder::id(const std::string& name) const {
  const ObjectSnapshot* const found = m_document->snapshot()->find(name);
  if (!found) throw std::runtime_error("no object " + name);
  return found->id;
}

}  // namespace trivet::edit::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  QCoreApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
