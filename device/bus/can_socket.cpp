// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/can_socket.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <vector>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <unistd.h>

namespace isograsp {

namespace {

constexpr int kReceiveBuffer = 1 << 20;  // 1 MiB: frames of some seconds, not of half a second

BusFrame from_kernel(const can_frame& in) noexcept {
  BusFrame frame;
  frame.extended = (in.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = (in.can_id & CAN_RTR_FLAG) != 0;
  frame.error = (in.can_id & CAN_ERR_FLAG) != 0;
  frame.id = in.can_id & (frame.extended || frame.error ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.length = std::min<std::uint8_t>(in.len, CAN_MAX_DLEN);
  std::copy_n(in.data, frame.length, frame.data.begin());
  return frame;
}

can_frame to_kernel(const BusFrame& frame) noexcept {
  assert(frame.length <= CAN_MAX_DLEN);
  can_frame out{};
  out.can_id = frame.id | (frame.extended ? CAN_EFF_FLAG : 0U) |
               (frame.remote ? CAN_RTR_FLAG : 0U) | (frame.error ? CAN_ERR_FLAG : 0U);
  out.len = frame.length;
  std::copy_n(frame.data.begin(), frame.length, out.data);
  return out;
}

template <class T>
bool set(int descriptor, int level, int option, const T& value) noexcept {
  return setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

bool set_options(int descriptor, std::span<const std::uint32_t> ids) {
  // The mask keeps out extended and remote frames that carry the same number.
  constexpr canid_t kExact = CAN_SFF_MASK | CAN_EFF_FLAG | CAN_RTR_FLAG;
  std::vector<can_filter> filters;
  for (const auto id : ids) filters.push_back({id, kExact});
  if (!filters.empty() &&
      setsockopt(descriptor, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                 static_cast<socklen_t>(filters.size() * sizeof(can_filter))) != 0)
    return false;
  // Losing an arbitration is no error: the frame goes out next.
  constexpr can_err_mask_t kErrors = CAN_ERR_MASK & ~CAN_ERR_LOSTARB;
  if (!set(descriptor, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kErrors) ||
      !set(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, 1) ||
      !set(descriptor, SOL_SOCKET, SO_RXQ_OVFL, 1))
    return false;
  // The larger buffer needs a privilege or a raised net.core.rmem_max; as much as allowed is fine.
  if (!set(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, kReceiveBuffer))
    (void)set(descriptor, SOL_SOCKET, SO_RCVBUF, kReceiveBuffer);
  return true;
}

}  // namespace

CanSocket open_can_socket(const std::string& interface, std::span<const std::uint32_t> ids) {
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(if_nametoindex(interface.c_str()));
  if (address.can_ifindex == 0) return {-1, ENODEV};
  const int descriptor = ::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW);
  if (descriptor < 0) return {-1, errno};
  if (set_options(descriptor, ids) &&
      ::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
    return {descriptor, 0};
  const int failure = errno;
  ::close(descriptor);
  return {-1, failure};
}

int read_can_socket(int descriptor, CanReading& out) noexcept {
  can_frame in{};
  iovec part{&in, sizeof in};
  KernelNotesRoom room{};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room.bytes;
  message.msg_controllen = sizeof room.bytes;
  const auto n = recvmsg(descriptor, &message, MSG_DONTWAIT);
  if (n < 0) return errno;
  assert(n == sizeof in);  // one read is one frame
  out.frame = from_kernel(in);
  out.notes = read_kernel_notes(message);
  out.from_this_computer = (message.msg_flags & MSG_DONTROUTE) != 0;
  return 0;
}

int write_can_socket(int descriptor, const BusFrame& frame) noexcept {
  const can_frame out = to_kernel(frame);
  return ::send(descriptor, &out, sizeof out, 0) == sizeof out ? 0 : errno;
}

}  // namespace isograsp
