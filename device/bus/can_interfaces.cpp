// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/can_interfaces.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "device/bus/bus.hpp"

namespace isograsp {

bool is_switched_on(const std::string& interface) noexcept {
  const int fd = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return false;
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  const bool up = ioctl(fd, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
  ::close(fd);
  return up;
}

bool is_off_the_bus(const std::string& interface) {
  // The carrier file is right at once; the flags of the interface follow up to a second later.
  std::ifstream carrier("/sys/class/net/" + interface + "/carrier");
  int present = 0;
  return carrier >> present && present == 0;
}

std::vector<CanInterface> list_can_interfaces() {
  std::vector<CanInterface> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/sys/class/net", ignored)) {
    int type = 0;
    std::ifstream(entry.path() / "type") >> type;
    const auto name = entry.path().filename().string();
    if (type == ARPHRD_CAN) found.push_back({name, is_switched_on(name)});
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return found;
}

}  // namespace isograsp
