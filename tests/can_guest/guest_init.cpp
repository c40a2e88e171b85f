// SPDX-License-Identifier: GPL-3.0-or-later
// The first process of the guest kernel: mounts what programs expect, loads the CAN modules, makes
// vcan0, runs the command given as its arguments, prints its exit status and switches off.
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
  const int status = run({argv + 1, argv + argc});
  std::printf("guest: exit status %d\n", status);
  std::fflush(stdout);
  reboot(RB_POWER_OFF);
  return status;
}
