#include "apps/import/confinement.h"

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include "apps/import/landlock.h"
#include "apps/import/namespaces.h"
#include "apps/import/privileges.h"
#include "apps/import/system_calls.h"
#include "core/io/model_folder.h"

namespace trivet::apps {

Protection confine_process(int kept) {
  close_range(static_cast<unsigned>(kept) + 1, ~0U, 0);  // what the parent left open
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  Protection out;
  enter_namespaces(out);
  return out;
}

Protection confine_reading(const std::string& model, Protection protection) {
  const pid_t parent = getppid();
  protection.privileges = drop_privileges(model);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // forgotten with the old user
  if (getppid() != parent) _exit(1);
  protection.files = restrict_files(ModelFolder(model).folders());
  protection.calls = filter_system_calls();
  return protection;
}

}  // namespace trivet::apps
