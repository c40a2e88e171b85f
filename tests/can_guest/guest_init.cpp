// SPDX-License-Identifier: GPL-3.0-or-later
// The first process of the guest kernel: mounts what programs expect, loads the CAN modules, makes
// vcan0, runs the command given as its arguments, prints its exit status and switches off. Status
// 77: the guest is too slow to tell anything about a bus.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// Three sensors at 500 Hz are 3,000 frames a second, each written, waited for, read and stamped on
/// both sides: some 20,000 calls. Dearer calls than this leave no time in between.
constexpr double kDearestCall_us = 50.0;

/// What a call of the guest's kernel costs. The host's kernel stops the guest for each one, which
/// takes it from a few microseconds to, within another virtual computer, almost a millisecond. The
/// least of some batches: other work of the host only adds to it.
double cost_of_a_call_us() {
  using Clock = std::chrono::steady_clock;
  constexpr int kCalls = 100;
  double least_us = 1e9;
  for (int batch = 0; batch < 10; ++batch) {
    const auto began = Clock::now();
    for (int i = 0; i < kCalls; ++i) (void)syscall(SYS_getppid);
    const std::chrono::duration<double, std::micro> taken = Clock::now() - began;
    least_us = std::min(least_us, taken.count() / kCalls);
  }
  return least_us;
}

void mount_at(const char* type, const char* place) {
  if (mount(type, place, type, 0, nullptr) != 0)
    std::printf("guest: %s on %s: %s\n", type, place, std::strerror(errno));
}

void load_module(const std::string& file) {
  utsname kernel{};
  uname(&kernel);
  const std::string path =
      std::string("/usr/lib/uml/modules/") + kernel.release + "/kernel/" + file;
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0 || syscall(SYS_finit_module, fd, "", 0) != 0)
    std::printf("guest: %s: %s\n", path.c_str(), std::strerror(errno));
  if (fd >= 0) close(fd);
}

int run(std::vector<const char*> words) {
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execvp(words[0], const_cast<char* const*>(words.data()));
    std::printf("guest: %s: %s\n", words[0], std::strerror(errno));
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return 127;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int main(int argc, char** argv) {
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  mount_at("proc", "/proc");
  mount_at("sysfs", "/sys");
  mount_at("tmpfs", "/mnt");  // not /tmp: the program may stand there
  mkdir("/dev/pts", 0755);    // the kernel has put its own devices on /dev
  mount_at("devpts", "/dev/pts");
  for (const char* module :
       {"net/can/can.ko", "net/can/can-raw.ko", "drivers/net/can/dev/can-dev.ko",
        "drivers/net/can/vcan.ko", "drivers/net/can/slcan/slcan.ko"})
    load_module(module);
  setenv("PATH", "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", 1);
  setenv("HOME", "/mnt", 1);
  setenv("TMPDIR", "/mnt", 1);
  setenv("ISOGRASP_CAN_INTERFACE", "vcan0", 1);
  setenv("ISOGRASP_SLCAN_INTERFACE", "can0", 1);
  run({"ip", "link", "set", "lo", "up"});
  run({"ip", "link", "add", "dev", "vcan0", "type", "vcan"});
  run({"ip", "link", "set", "vcan0", "up"});
  const double call_us = cost_of_a_call_us();
  std::printf("guest: a call of the kernel costs %.1f us\n", call_us);
  if (call_us > kDearestCall_us)
    std::printf("guest: too slow for a bus in real time (most: %.0f us)\n", kDearestCall_us);
  const int status = call_us > kDearestCall_us ? 77 : run({argv + 1, argv + argc});
  std::printf("guest: exit status %d\n", status);
  std::fflush(stdout);
  reboot(RB_POWER_OFF);
  return status;
}
