// An importer that was taken over by its model, for tests: it tries to get out of its sandbox, and
// answers with the names of all tries that succeeded. The model's text names a file to read that is
// none of its business.
#include <fcntl.h>
#include <linux/bpf.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "apps/import/importer.h"
#include "core/base/error.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;
using Try = std::pair<const char*, std::function<bool()>>;

bool reads(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return in.get() != std::ifstream::traits_type::eof();
}

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool writes(const std::string& file, int flags) {
  const int opened = open(file.c_str(), flags, 0666);
  return opened >= 0 && write(opened, "x", 1) == 1;
}

bool lists(const char* folder) {
  std::error_code failed;
  return fs::directory_iterator(folder, failed) != fs::directory_iterator() && !failed;
}

bool runs_a_program() {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/true", "true", nullptr);
    _exit(1);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

bool forks() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  return child > 0;
}

bool spawns() {
  char name[] = "/bin/true";
  char* const arguments[] = {name, nullptr};
  pid_t child = 0;
  return posix_spawn(&child, name, nullptr, nullptr, arguments, environ) == 0;
}

bool connects_to_loopback() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(9);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return socket >= 0 &&
         (connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 ||
          errno == ECONNREFUSED);
}

bool reads_memory_of(pid_t other) {
  char byte = 0;
  const iovec here{&byte, 1}, there{reinterpret_cast<void*>(0x400000), 1};
  return process_vm_readv(other, &here, 1, &there, 1, 0) == 1 || errno == EFAULT;
}

bool maps_code() {
  return mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
         MAP_FAILED;
}

bool makes_code() {
  void* const page =
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return page != MAP_FAILED && mprotect(page, 4096, PROT_READ | PROT_EXEC) == 0;
}

bool calls(long number, long a = 0, long b = 0, long c = 0, long d = 0, long e = 0) {
  return syscall(number, a, b, c, d, e) >= 0;
}

std::vector<Try> tries_of_reading(const std::string& model) {
  const std::string folder = fs::path(model).parent_path().string();
  return {{"read beside", [=] { return reads(folder + "/beside.png"); }},
          {"read below", [=] { return reads(folder + "/below/deep.png"); }},
          {"read passwd", [] { return reads("/etc/passwd"); }},
          {"read shadow", [] { return reads("/etc/shadow"); }},
          {"read outside", [=] { return reads(text_of(model)); }},
          {"read above", [=] { return reads(folder + "/../secret"); }},
          {"read through a link", [=] { return reads(folder + "/link.png"); }},
          {"read environ", [] { return reads("/proc/self/environ"); }},
          {"read parent", [] { return reads("/proc/" + std::to_string(getppid()) + "/environ"); }},
          {"list root", [] { return lists("/"); }},
          {"list home", [] { return lists("/root"); }}};
}

std::vector<Try> tries_of_writing(const std::string& model) {
  const std::string folder = fs::path(model).parent_path().string();
  const std::string fresh = folder + "/fresh", beside = folder + "/beside.png";
  return {{"write model", [=] { return writes(model, O_WRONLY); }},
          {"write and read", [=] { return writes(model, O_RDWR); }},
          {"append", [=] { return writes(beside, O_WRONLY | O_APPEND); }},
          {"create", [=] { return writes(fresh, O_WRONLY | O_CREAT); }},
          {"create empty", [=] { return open(fresh.c_str(), O_RDONLY | O_CREAT, 0666) >= 0; }},
          {"create nameless", [=] { return writes(folder, O_WRONLY | O_TMPFILE); }},
          {"truncate while opening", [=] { return open(beside.c_str(), O_RDONLY | O_TRUNC) >= 0; }},
          {"truncate", [=] { return truncate(beside.c_str(), 0) == 0; }},
          {"unlink", [=] { return unlink(beside.c_str()) == 0; }},
          {"rename", [=] { return rename(beside.c_str(), fresh.c_str()) == 0; }},
          {"link", [=] { return link(beside.c_str(), fresh.c_str()) == 0; }},
          {"symlink", [=] { return symlink("beside.png", fresh.c_str()) == 0; }},
          {"mkdir", [=] { return mkdir(fresh.c_str(), 0777) == 0; }},
          {"mkfifo", [=] { return mkfifo(fresh.c_str(), 0666) == 0; }},
          {"chmod", [=] { return chmod(beside.c_str(), 0777) == 0; }},
          {"set times", [=] { return utimensat(AT_FDCWD, beside.c_str(), nullptr, 0) == 0; }},
          {"set attribute", [=] { return setxattr(beside.c_str(), "user.x", "1", 1, 0) == 0; }},
          {"write elsewhere", [] { return writes("/tmp/trivet_hostile", O_WRONLY | O_CREAT); }},
          {"memory file", [] { return calls(SYS_memfd_create, reinterpret_cast<long>("x")); }}};
}

std::vector<Try> tries_of_starting() {
  return {{"exec", runs_a_program},
          {"fork", forks},
          {"spawn", spawns},
          {"map code", maps_code},
          {"make code", makes_code}};
}

std::vector<Try> tries_of_connecting() {
  return {{"internet", connects_to_loopback},
          {"internet socket", [] { return socket(AF_INET, SOCK_DGRAM, 0) >= 0; }},
          {"local socket", [] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
          {"netlink", [] { return socket(AF_NETLINK, SOCK_RAW, 0) >= 0; }},
          {"socket pair", [] {
             int ends[2];
             return socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0;
           }}};
}

std::vector<Try> tries_of_mischief() {
  return {{"signal parent", [] { return kill(getppid(), 0) == 0; }},
          {"signal all", [] { return kill(-1, 0) == 0; }},
          {"own descriptor for parent", [] { return fcntl(3, F_SETOWN, getppid()) == 0; }},
          {"attach", [] { return ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr) == 0; }},
          {"memory of parent", [] { return reads_memory_of(getppid()); }},
          {"be root", [] { return setuid(0) == 0; }},
          {"namespace", [] { return unshare(CLONE_NEWUSER) == 0; }},
          {"mount", [] { return mount("x", "/tmp", "tmpfs", 0, nullptr) == 0; }},
          {"chroot", [] { return chroot("/") == 0; }},
          {"raise limits", [] { return calls(SYS_prlimit64, getppid(), 7); }},
          {"bpf", [] { return calls(SYS_bpf, BPF_MAP_CREATE) || errno == EINVAL; }},
          {"ring", [] { return calls(SYS_io_uring_setup, 1) || errno == EFAULT; }},
          {"keys", [] { return calls(SYS_keyctl, 0, -4, 1); }}};
}

Model read_hostile(const std::string& model, const ImportLimits&, const Tessellation&) {
  std::string done;
  for (const std::vector<Try>& tries :
       {tries_of_reading(model), tries_of_writing(model), tries_of_connecting(),
        tries_of_mischief(), tries_of_starting()})
    for (const auto& [name, succeeds] : tries)
      if (succeeds()) done += std::string(name) + ";";
  throw Error(Error::Kind::BadInput, model + ": did " + done);
}

}  // namespace
}  // namespace trivet

int main(int argc, char** argv) { trivet::apps::import_and_exit(argc, argv, trivet::read_hostile); }
