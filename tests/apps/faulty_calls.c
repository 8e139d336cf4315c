// Loaded into trivet before its libraries (LD_PRELOAD): system calls that fail, lie or wait as variables of the
// environment say. What is not set is done as ever.
//   FAULTY_LINK=ERRNO       link fails with it
//   FAULTY_RENAMEAT2=ERRNO  renameat2 fails with it
//   SLOW_RENAME_MS=N        rename and renameat2 wait before they begin
//   CLOCK_AHEAD=SECONDS     of the wall clock
//   CLOCK_JUMPS=SECONDS     the wall clock is ahead by so much at every second reading
//   FAULTY_SCENE=K          the process that is asked for scene K gets the signal
//   FAULTY_SIGNAL=NUMBER
//   FAULTY_LOG=FILE         which gets a byte for each such signal
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static long number(const char* name) {
  const char* text = getenv(name);
  return text ? atol(text) : 0;
}

static int fails_with(long error) {
  errno = (int)error;
  return error != 0;
}

int link(const char* from, const char* to) {
  if (fails_with(number("FAULTY_LINK"))) return -1;
  return ((int (*)(const char*, const char*))dlsym(RTLD_NEXT, "link"))(from, to);
}

int rename(const char* from, const char* to) {
  usleep((useconds_t)number("SLOW_RENAME_MS") * 1000);
  return ((int (*)(const char*, const char*))dlsym(RTLD_NEXT, "rename"))(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  if (fails_with(number("FAULTY_RENAMEAT2"))) return -1;
  usleep((useconds_t)number("SLOW_RENAME_MS") * 1000);
  return ((int (*)(int, const char*, int, const char*, unsigned))dlsym(RTLD_NEXT, "renameat2"))(
      from_folder, from, to_folder, to, flags);
}

static time_t ahead(void) {
  static int readings = 0;
  return number("CLOCK_AHEAD") + (++readings % 2 ? 0 : number("CLOCK_JUMPS"));
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  const int result =
      ((int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime"))(clock, now);
  if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
    now->tv_sec += ahead();
  return result;
}

time_t time(time_t* out) {
  const time_t now = ((time_t(*)(time_t*))dlsym(RTLD_NEXT, "time"))(NULL) + ahead();
  if (out) *out = now;
  return now;
}

int gettimeofday(struct timeval* now, void* zone) {
  const int result =
      ((int (*)(struct timeval*, void*))dlsym(RTLD_NEXT, "gettimeofday"))(now, zone);
  now->tv_sec += ahead();
  return result;
}

// Requests of workers are 16 bytes, which begin with the scene's number.
ssize_t recv(int socket, void* bytes, size_t size, int flags) {
  const ssize_t count =
      ((ssize_t(*)(int, void*, size_t, int))dlsym(RTLD_NEXT, "recv"))(socket, bytes, size, flags);
  uint64_t k = 0;
  if (!getenv("FAULTY_SCENE") || count != 16) return count;
  memcpy(&k, bytes, sizeof k);
  if (k != (uint64_t)number("FAULTY_SCENE")) return count;
  FILE* log = fopen(getenv("FAULTY_LOG"), "a");
  fputc('x', log);
  fclose(log);
  raise((int)number("FAULTY_SIGNAL"));
  return count;
}
