// English sentences that come as text: errors of files and conflicts of arrangements, as they are.
#include <QCoreApplication>
#include <QRegularExpression>
#include <QTranslator>
#include <fstream>

#include "apps/edit/document/sentence_reader.h"
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
std::string left_in_english(const std::string& english, const std::string& folder = "?") {
  EXPECT_EQ(in_english(read_sentence(english)), english);
  EXPECT_EQ(english_in_words(english), english);
  const Capitals translator;
  QString said = QString::fromStdString(english_in_words(english));
  said.remove(QString::fromStdString(folder));
  for (const char* const name :
       {"\"[^\"]*\"", "'[^']*'", "[0-9]+\\.[a-z0-9]+", "/[a-z0-9/]+", "[0-9.]+e[-+]?[0-9]+"})
    said.remove(QRegularExpression(name));
  said.remove(QRegularExpression("[^a-z]+"));
  return said.toStdString();
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
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
      const std::string english = error_of(all[i]);
      ASSERT_FALSE(english.empty()) << i;
      EXPECT_EQ(left_in_english(english, folder.file("")), "") << english;
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
  EXPECT_EQ(left_in_english(result.reason()), "") << result.reason();
}

TEST(ConflictsOfArrangements, BetweenRelationsAreTranslated) {
  Stage stage;
  stage.fix("post", trivet::test::box_between({-0.1, -0.1, 0}, {0.1, 0.1, 0.1}), {0, 0, 1e-5});
  stage.add_cube("cube");
  stage.relate("cube", RelationKind::RightOf, "post");
  stage.relate("cube", RelationKind::LeftOf, "post");
  expect_translated(stage.run(), "m are missing; the cheapest to drop: ");
  stage.arrangement.relations.clear();
  stage.relate("cube", RelationKind::Within).region = {
      {-0.09, -0.09}, {0.09, -0.09}, {0.09, 0.09}, {-0.09, 0.09}};
  expect_translated(stage.run(), "clear of \"post\"");
}

TEST(ConflictsOfArrangements, OfSupportsAndPatternsAreTranslated) {
  Stage stage;
  stage.fix("shelf", trivet::test::shelf({0.1, 0.4, 0.8}), {0, 0, 1e-5});
  stage.add_cube("cube", 0.29);
  stage.relate("cube", RelationKind::On, "shelf").level = 0;
  expect_translated(stage.run(), "head room");
  stage.arrangement.relations.back().level = 7;
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

// Names are no words, whatever they are.
TEST(SentenceReader, LeavesNamesAsTheyAre) {
  const Capitals translator;
  EXPECT_EQ(english_in_words("/a/b on c/d.obj: no such file"), "/a/b on c/d.obj: NO SUCH FILE");
  EXPECT_EQ(english_in_words("/an array: is empty; accepted: an array"),
            "/an array: IS EMPTY; ACCEPTED: AN ARRAY");
  EXPECT_EQ(english_in_words("\"a\" on \"b tips\"; \"c, d\" tips"),
            "\"a\" ON \"b tips\"; \"c, d\" TIPS");
  EXPECT_EQ(english_in_words("\"things\" on \"an array\""), "\"things\" ON \"an array\"");
  EXPECT_EQ(english_in_words("said by a library"), "said by a library");
  EXPECT_EQ(english_in_words(""), "");
}

}  // namespace
}  // namespace trivet::edit::test
