// The sandbox of importers: what one that was taken over by its model can still do.
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef TRIVET_TEST_SECCOMP
#include <seccomp.h>
#endif

#include <cerrno>
#include <functional>

#include "core/io/io_testing.h"
#include "core/io/process/protection.h"
#include "core/io/process/sandboxed_import.h"

namespace trivet {
namespace {

using testing::error_of;
using Before = std::function<bool()>;

std::string read_all(int descriptor) {
  std::string out;
  char piece[4096];
  for (ssize_t count = 0; (count = read(descriptor, piece, sizeof piece)) > 0;)
    out.append(piece, static_cast<size_t>(count));
  return out;
}

// Returns the result of `call` in a process of its own, after `before`; "skip": that was false.
std::string in_child(const Before& before, const std::function<std::string()>& call) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const std::string out = before() ? call() : "skip";
    _exit(write(ends[1], out.data(), out.size()) == static_cast<ssize_t>(out.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string out = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? out : "crashed";
}

bool as_it_is() { return true; }

bool as_ordinary_user() {
  constexpr unsigned kNobody = 65534;
  return geteuid() != 0 ||
         (setresgid(kNobody, kNobody, kNobody) == 0 && setresuid(kNobody, kNobody, kNobody) == 0);
}

// As on a system without these calls.
Before without(const std::vector<int>& numbers) {
#ifdef TRIVET_TEST_SECCOMP
  return [numbers] {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    bool ok = true;
    for (const int number : numbers)
      ok = ok && seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), number, 0) == 0;
    // libseccomp falls back to it.
    for (const int number : numbers)
      if (number == SYS_seccomp)
        ok = ok && seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SYS_prctl, 1,
                                    SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP)) == 0;
    ok = ok && seccomp_load(filter) == 0;
    seccomp_release(filter);
    return ok;
  };
#else
  return [numbers] { return numbers.empty(); };
#endif
}

const std::vector<int> kLandlock = {444, 445, 446};
const std::vector<int> kNamespaces = {SYS_unshare};
const std::vector<int> kSeccomp = {SYS_seccomp};

std::vector<int> joined(std::initializer_list<std::vector<int>> lists) {
  std::vector<int> out;
  for (const std::vector<int>& list : lists) out.insert(out.end(), list.begin(), list.end());
  return out;
}

class ConfinementTest : public testing::IoTest {
 protected:
  void SetUp() override {
    IoTest::SetUp();
    namespace fs = std::filesystem;
    fs::permissions(folder(), fs::perms::others_read | fs::perms::others_exec,
                    fs::perm_options::add);
    fs::create_directories(folder() / "models/below");
    fs::create_directories(folder() / "models_too");
    m_model = write("models/model.obj", write("models_too/secret", "secret"));
    write("secret", "secret");
    write("models/beside.png", "texels");
    write("models/below/deep.png", "texels");
    fs::create_symlink(folder() / "secret", folder() / "models/link.png");
    const auto programs = fs::read_symlink("/proc/self/exe").parent_path();
    m_hostile = programs / "hostile_importer";
    m_real = programs.parent_path() / "apps/trivet-import";
    ASSERT_EQ(access(m_hostile.c_str(), X_OK), 0) << m_hostile;
  }
  // Names of what a hostile importer did, each with a semicolon behind.
  std::string done_after(const Before& before) const {
    const std::string out = in_child(before, [this] {
      ImportLimits limits;
      limits.importer = m_hostile;
      return error_of([&] { read_model_sandboxed(m_model, limits); });
    });
    if (out == "skip") return out;
    const std::string words = m_model + ": did ";
    EXPECT_EQ(out.rfind(words, 0), 0u) << out;
    return out.substr(std::min(out.size(), words.size()));
  }
  // Names the importer's protection, and checks that it reads.
  std::string protection_after(const Before& before) const {
    const std::string good = write("models/good.obj", testing::tetrahedron_obj());
    return in_child(before, [&] {
      ImportLimits limits;
      limits.importer = m_real;
      const SharedImporters shared;
      for (int i = 0; i < 2; ++i)
        if (read_model_sandboxed(good, limits).mesh.triangles.size() != 4) return std::string("no");
      std::string out;
      for (const std::string& part : parts_of(import_protection().value_or(Protection{})))
        out += part + ";";
      return out + warning_about(*import_protection());
    });
  }
  bool has(const char* part) const {
    return protection_after(as_it_is).find(part) != std::string::npos;
  }

  std::string m_model, m_hostile, m_real;
};

constexpr const char* kOnlyItsFolder = "read beside;read below;";

void expect_none(const std::string& done, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    EXPECT_EQ((";" + done).find(";" + name + ";"), std::string::npos) << name << " in " << done;
}

const std::vector<std::string> kWrites = {
    "write model",  "write and read",  "append",
    "create",       "create nameless", "truncate",
    "unlink",       "rename",          "link",
    "mkdir",        "mkfifo",          "symlink",
    "create empty", "write elsewhere", "truncate while opening"};

TEST_F(ConfinementTest, LeavesAHostileImporterItsFolder) {
  if (!has("landlock") || !has("seccomp")) GTEST_SKIP() << "not on this system";
  EXPECT_EQ(done_after(as_it_is), kOnlyItsFolder);
}

TEST_F(ConfinementTest, IsTheSameForOrdinaryUsers) {
  if (!has("landlock") || !has("seccomp")) GTEST_SKIP() << "not on this system";
  EXPECT_EQ(done_after(as_ordinary_user), kOnlyItsFolder);
}

TEST_F(ConfinementTest, DoesWithoutNamespaces) {
  if (!has("landlock") || !has("seccomp")) GTEST_SKIP() << "not on this system";
  const std::string done = done_after(without(kNamespaces));
  if (done == "skip") GTEST_SKIP() << "no libseccomp";
  EXPECT_EQ(done, kOnlyItsFolder);
}

// Reads what the user may read, and keeps it to itself.
TEST_F(ConfinementTest, NeitherWritesNorConnectsNorStartsWithoutLandlock) {
  if (!has("seccomp")) GTEST_SKIP() << "not on this system";
  const std::string done = done_after(without(joined({kLandlock, kNamespaces})));
  if (done == "skip") GTEST_SKIP() << "no libseccomp";
  EXPECT_NE(done.find("read passwd;"), std::string::npos) << done;
  expect_none(done, kWrites);
  expect_none(done, {"exec", "fork", "spawn", "internet", "local socket", "netlink", "map code",
                     "signal parent", "attach", "memory of parent", "chmod", "memory file"});
}

TEST_F(ConfinementTest, NeitherReadsElsewhereNorWritesWithoutSeccomp) {
  if (!has("landlock") || !has("mounts")) GTEST_SKIP() << "not on this system";
  const std::string done = done_after(without(kSeccomp));
  if (done == "skip") GTEST_SKIP() << "no libseccomp";
  EXPECT_NE(done.find("fork;"), std::string::npos) << done;
  expect_none(done, kWrites);
  expect_none(done, {"read passwd", "read outside", "read above", "read through a link",
                     "read environ", "read parent", "list root", "exec", "spawn", "internet",
                     "chmod", "set times", "attach", "memory of parent", "be root"});
}

TEST_F(ConfinementTest, WarnsWhereASystemHasNone) {
  const std::string none = protection_after(without(joined({kLandlock, kNamespaces, kSeccomp})));
  if (none == "skip") GTEST_SKIP() << "no libseccomp";
  EXPECT_EQ(none, "privileges;" + warning_about({}));
  EXPECT_NE(none.find("without Landlock"), std::string::npos) << none;
}

TEST_F(ConfinementTest, ToldByTheImporter) {
  const auto asked = protection_of(m_real);
  ASSERT_TRUE(asked);
  std::string parts;
  for (const std::string& part : parts_of(*asked)) parts += part + ";";
  EXPECT_EQ(protection_after(as_it_is), parts + warning_about(*asked));
  EXPECT_FALSE(protection_of("/bin/true"));
}

// A link's target has a folder, too; other links lead out.
TEST_F(ConfinementTest, LetsModelsBeLinks) {
  namespace fs = std::filesystem;
  write("models/linked.obj", "mtllib linked.mtl\n" + testing::tetrahedron_obj());
  write("models/linked.mtl", "newmtl a\nKd 1 0 0\n");
  fs::create_symlink(folder() / "models/linked.obj", folder() / "models_too/link.obj");
  ImportLimits limits;
  limits.importer = m_real;
  EXPECT_EQ(read_model_sandboxed(path("models_too/link.obj"), limits).mesh.triangles.size(), 4u);
}

// Root reads what belongs to others, as it did without a sandbox.
TEST_F(ConfinementTest, LetsRootReadWhatOthersHide) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root";
  const std::string hidden = write("models/hidden.obj", testing::tetrahedron_obj());
  ASSERT_EQ(chown(hidden.c_str(), 1000, 1000), 0);
  std::filesystem::permissions(hidden, std::filesystem::perms::owner_all);
  std::filesystem::permissions(folder(), std::filesystem::perms::owner_all);
  ImportLimits limits;
  limits.importer = m_real;
  EXPECT_EQ(read_model_sandboxed(hidden, limits).mesh.triangles.size(), 4u);
}

TEST(Protection, BitsGiveItBack) {
  for (unsigned bits = 0; bits < 32; ++bits) {
    const Protection protection = protection_of_bits(static_cast<std::uint8_t>(bits));
    EXPECT_EQ(bits_of(protection), bits);
    EXPECT_EQ(parts_of(protection).size() + lacking_in(protection).size(), 5u);
    EXPECT_EQ(warning_about(protection).empty(), (bits & 3) == 3);
  }
}

}  // namespace
}  // namespace trivet
