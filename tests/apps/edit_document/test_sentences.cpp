// Errors of files and conflicts of arrangements in another language.
#include <QCoreApplication>
#include <QRegularExpression>
#include <QTranslator>
#include <filesystem>
#include <fstream>

#include "apps/edit/document/words.h"
#include "apps/edit_document/testing.h"
#include "core/base/error.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/arrange/arrange_testing.h"
#include "ops/files/layout/layout.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/journal.h"

namespace trivet::edit::test {
namespace {

using trivet::test::Stage;

/// A language of capitals: small letters are not translated.
class Capitals : public QTranslator {
 public:
  Capitals() { QCoreApplication::installTranslator(this); }
  ~Capitals() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char*, int) const override {
    return std::string(context) == "refusal" ? QString(text).toUpper() : QString();
  }
};

/// Small letters outside quotes, files of the folder, places in JSON and numbers.
std::string left_in_english(const Sentence& sentence, const std::string& folder = "?") {
  EXPECT_EQ(in_words(sentence), in_english(sentence));
  const Capitals translator;
  QString said = QString::fromStdString(in_words(sentence));
  said.remove(QString::fromStdString(folder));
  for (const char* const name :
       {"\"[^\"]*\"", "'[^']*'", "[0-9]+\\.[a-z0-9]+", "/[a-z0-9/]+", "[0-9.]+e[-+]?[0-9]+"})
    said.remove(QRegularExpression(name));
  said.remove(QRegularExpression("[^a-z]+"));
  return said.toStdString();
}

Sentence error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(in_english(error.sentence()), error.what());
    return error.sentence();
  }
  return {};
}

class ErrorsOfFiles : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder.file(name), std::ios::binary) << bytes;
    return folder.file(name);
  }
  void expect_none_in_english(const std::vector<std::function<void()>>& all) const {
    for (size_t i = 0; i < all.size(); ++i) {
      const Sentence error = error_of(all[i]);
      ASSERT_FALSE(error.empty()) << i;
      EXPECT_EQ(left_in_english(error, folder.file("")), "") << in_english(error);
    }
  }

  TemporaryFolder folder;
};

TEST_F(ErrorsOfFiles, OfModelsAreTranslated) {
  const auto imports = [](const std::string& path) { return [path] { import_model(path, {}); }; };
  expect_none_in_english({
      imports(folder.file("1.obj")),
      imports(folder.file("")),
      imports(file("2.obj", "")),
      imports(file("3.4", "x")),
      imports(file("6.ply", "ply\nformat ascii 1.0\n")),
      imports(file("7.obj", "v 0 0 0\nv 1e31 0 0\nv 0 1 0\nf 1 2 3\n")),
      imports(file("8.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n")),
      [&] {
        ImportLimits limits;
        limits.max_file_bytes = 2;
        import_model(file("9.obj", "v 0 0 0\n"), limits);
      },
  });
}

TEST_F(ErrorsOfFiles, OfScenesAndLayoutsAreTranslated) {
  const auto opens = [](const std::string& path) { return [path] { read_layout(path); }; };
  const auto layout = [&](const std::string& objects) {
    static int number = 100;
    return opens(
        file(std::to_string(++number) + ".json", R"({"trivet": 1, "objects": )" + objects + "}"));
  };
  expect_none_in_english({
      opens(folder.file("1.json")),
      opens(file("2.json", " ")),
      opens(file("3.json", std::string(100, '['))),
      opens(file("4.json", R"({"trivet": 1, "trivet": 1})")),
      opens(file("5.json", R"({"trivet": 2, "objects": []})")),
      layout("5"),
      layout(R"([{"name": "a", "model": "a.obj", "scale": -1}])"),
      layout(R"([{"name": "floor", "model": "a.obj"}])"),
      layout(R"([{"name": "a", "model": "a.obj", "fixed": 3}])"),
      layout(R"([{"name": "a", "model": "a.obj", "rotation": [0, 0, 0, 0]}])"),
      [&] { read_scene_file(folder.file("6.glb")); },
      [&] { read_scene_file(file("7.glb", "glTF")); },
      [&] { read_journal(folder.file("8.journal")); },
  });
}

void expect_translated(const ArrangeResult& result, const std::string& part) {
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NE(result.reason().find(part), std::string::npos) << result.reason();
  EXPECT_EQ(left_in_english(result.sentence()), "") << result.reason();
}

TEST(ConflictsOfArrangements, BetweenRelationsAreTranslated) {
  Stage stage;
  stage.fix("post", trivet::test::box_between({-0.1, -0.1, 0}, {0.1, 0.1, 0.1}), {0, 0, 1e-5});
  stage.add_cube("cube");
  stage.relate<relations::RightOf>("cube", "post");
  stage.relate<relations::LeftOf>("cube", "post");
  expect_translated(stage.run(), "m are missing; the cheapest to drop: ");
  stage.arrangement.relations.clear();
  stage.relate<relations::Within>("cube").as<relations::Within>()->region = {
      {-0.09, -0.09}, {0.09, -0.09}, {0.09, 0.09}, {-0.09, 0.09}};
  expect_translated(stage.run(), "clear of \"post\"");
}

TEST(ConflictsOfArrangements, OfSupportsAndPatternsAreTranslated) {
  Stage stage;
  stage.fix("shelf", trivet::test::shelf({0.1, 0.4, 0.8}), {0, 0, 1e-5});
  stage.add_cube("cube", 0.29);
  stage.relate<relations::On>("cube", "shelf").as<relations::On>()->level = 0;
  expect_translated(stage.run(), "head room");
  stage.arrangement.relations.back().as<relations::On>()->level = 7;
  expect_translated(stage.run(), "surfaces, none of which is 7");
  Stage row;
  row.fix("board", trivet::test::box_between({-0.2, -0.1, 0}, {0.2, 0.1, 0.05}), {0, 0, 1e-5});
  Pattern pattern;
  pattern.on = "board";
  for (const char* const name : {"1", "2", "3", "4", "5"}) {
    row.add_cube(name);
    pattern.things.emplace_back(name);
  }
  row.arrangement.patterns.push_back(pattern);
  expect_translated(row.run(), "there is room for");
}

// A text of another library stays as it is, and so do names, whatever they are.
TEST(Sentences, LeaveNamesAsTheyAre) {
  const Capitals translator;
  EXPECT_EQ(in_words(say("%1: no such file", std::string("/a/b on c/d.obj"))),
            "/a/b on c/d.obj: NO SUCH FILE");
  EXPECT_EQ(in_words(say("\"%1\" tips", std::string("b tips"))), "\"b tips\" TIPS");
  EXPECT_EQ(in_words(std::runtime_error("said by a library")), "said by a library");
  EXPECT_EQ(in_words(Error(Error::Kind::BadInput, "is empty")), "IS EMPTY");
  EXPECT_EQ(in_words(Sentence()), "");
}

// Across the importer's process, with what the system says.
TEST(Sentences, ComeWholeFromAnotherProcess) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("6.ply"), std::ios::binary)
      << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1\n";
  ImportLimits limits;
  const auto programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  limits.importer = programs.parent_path().parent_path() / "apps/trivet-import";
  ASSERT_TRUE(std::filesystem::exists(limits.importer));
  EXPECT_EQ(left_in_english(error_of([&] { import_model(folder.file("6.ply"), limits); }),
                            folder.file("")),
            "");
}

}  // namespace
}  // namespace trivet::edit::test
