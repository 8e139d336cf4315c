// Refusals and names of steps in another language.
#include <QCoreApplication>
#include <QTranslator>

#include "apps/edit/document/words.h"
#include "apps/edit_document/testing.h"

namespace trivet::edit::test {
namespace {

/// A language in which the parts of some sentences come in another order.
class Backwards : public QTranslator {
 public:
  Backwards() { QCoreApplication::installTranslator(this); }
  ~Backwards() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char*, int) const override {
    const std::pair<std::string, const char*> known[] = {
        {"%1 passes through %2", "%2 <- %1"},
        {"at its start position %1", "[%1]"},
        {"the floor", "Boden"},
        {"put", "hinstellen"},
    };
    for (const auto& [english, other] : known)
      if (text == english && (std::string(context) == "refusal" || english == "put")) return other;
    return {};
  }
};

Refusal crossing(const std::string& name) {
  return {Refusal::Cause::Crossing, {{name, {}}, {"floor", {}}}, {}, {}, Refusal::At::Start};
}

TEST(Words, AreThoseOfOpsInEnglish) {
  for (int cause = 0; cause <= static_cast<int>(Refusal::Cause::NotTried); ++cause)
    for (const auto at : {Refusal::At::End, Refusal::At::Now}) {
      Refusal refusal = crossing("cup %1");
      refusal.cause = static_cast<Refusal::Cause>(cause);
      refusal.at = at;
      refusal.numbers = {{"spacing", 0.012345}, {"friction", 1e-9}, {"keep", 12345.6}};
      const std::string words = in_words(sentence_of(refusal));
      EXPECT_EQ(words, message(refusal));
      EXPECT_EQ(words.find("%2"), std::string::npos) << words;
    }
}

TEST(Words, PutPartsWhereTheLanguageHasThem) {
  const Backwards translator;
  EXPECT_EQ(in_words(sentence_of(crossing("a%2b"))), "[Boden <- \"a%2b\"]");
  OperationResult result;
  EXPECT_EQ(reason_in_words(result), "");
  result.refuse(crossing("cup"));
  EXPECT_EQ(reason_in_words(result), "Boden <- \"cup\"") << "not where it starts";
  EXPECT_EQ(result.reason(), "at its start position \"cup\" passes through the floor");
  PutOperation put;
  put.object = "cup";
  SessionStep step{"put \"cup\"", {put}, {}};
  EXPECT_EQ(label_of(step), "hinstellen \"cup\"");
  step.operations.emplace_back(put);
  EXPECT_EQ(label_of(step), "hinstellen 2 objects");
  step.operations.back() = LockOperation{"cup", true};
  EXPECT_EQ(label_of(step), "hinstellen \"cup\" and lock");
}

}  // namespace
}  // namespace trivet::edit::test
