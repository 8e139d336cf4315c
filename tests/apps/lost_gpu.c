// Loaded into trivet before its libraries (LD_PRELOAD): graphics hardware that is lost, as a driver
// tells it.
//   LOST_GPU_DRAW=N    the process in which OpenGL is asked for resets for the N-th time is told of one
//   LOST_GPU_ONCE=FILE only the process that makes this file; others go on
//   LOST_GPU_AGAIN=1   a new context is to be had; else there is none
// libepoxy calls OpenGL through pointers, and replaces one at its first call: ours are put back after each.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

#define GL_UNKNOWN_CONTEXT_RESET 0x8255

typedef unsigned (*ResetStatus)(void);
typedef void* (*CreateContext)(void* display, void* config, void* share, const int32_t* attributes);

static atomic_int num_asked, is_lost;
static ResetStatus real_status, *status_of_epoxy;
static CreateContext real_create, *create_of_epoxy;

static int loses_now(void) {
  const char* const draw = getenv("LOST_GPU_DRAW");
  const char* const once = getenv("LOST_GPU_ONCE");
  if (!draw || ++num_asked != atoi(draw)) return 0;
  if (!once) return 1;
  const int file = open(once, O_WRONLY | O_CREAT | O_EXCL, 0600);
  if (file >= 0) close(file);
  return file >= 0;
}

static unsigned reset_status(void) {
  if (loses_now()) {
    is_lost = getenv("LOST_GPU_AGAIN") == NULL;
    return GL_UNKNOWN_CONTEXT_RESET;
  }
  *status_of_epoxy = real_status;
  const unsigned status = real_status();
  real_status = *status_of_epoxy;
  *status_of_epoxy = reset_status;
  return status;
}

static void* create_context(void* display, void* config, void* share, const int32_t* attributes) {
  if (is_lost) return NULL;
  *create_of_epoxy = real_create;
  void* const context = real_create(display, config, share, attributes);
  real_create = *create_of_epoxy;
  *create_of_epoxy = create_context;
  return context;
}

__attribute__((constructor)) static void take_over(void) {
  status_of_epoxy = (ResetStatus*)dlsym(RTLD_DEFAULT, "epoxy_glGetGraphicsResetStatus");
  create_of_epoxy = (CreateContext*)dlsym(RTLD_DEFAULT, "epoxy_eglCreateContext");
  if (!status_of_epoxy || !create_of_epoxy) return;  // a program without OpenGL
  real_status = *status_of_epoxy;
  real_create = *create_of_epoxy;
  *status_of_epoxy = reset_status;
  *create_of_epoxy = create_context;
}
