// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/realtime.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>

#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

namespace isograsp::session {

namespace {

constexpr std::array<std::string_view, 3> kNames{"off", "prefer", "require"};

/// Below the interrupt threads of a real-time kernel (50), which bring the samples.
constexpr int kPriority = 40;

/// What a frame may need of the stack, touched once so that no frame waits for a page.
void prefault_stack() noexcept {
  constexpr std::size_t kStack = 256 * 1024;
  constexpr std::size_t kPage = 4096;
  volatile char stack[kStack];
  for (std::size_t at = 0; at < kStack; at += kPage) stack[at] = 0;
  static_cast<void>(stack[0]);
}

/// May this process lock any amount of memory? With a limit a later allocation could fail, and with
/// it the session: then nothing is locked.
bool may_lock_all() {
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) return true;
  constexpr unsigned kCapIpcLock = 14;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("CapEff:", 0) == 0)
      return (std::stoull(line.substr(7), nullptr, 16) >> kCapIpcLock & 1U) != 0;
  return false;
}

Text memory_lock_refusal() {
  if (!may_lock_all()) return "the limit memlock is not unlimited"_text;
  // Pages are locked once they were used: the whole of a large program need not be read in.
  if (mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0) return {};
  return Known{std::strerror(errno)};
}

}  // namespace

std::string_view name_of(Realtime wish) noexcept {
  return kNames[static_cast<std::size_t>(wish)];
}

std::optional<Realtime> realtime_from_name(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<Realtime>(i);
  return std::nullopt;
}

Text words_of(const RealtimeGrant& grant) {
  if (!grant.asked) return {};
  if (grant.fifo_priority > 0)
    return grant.memory_locked ? "SCHED_FIFO %1, memory locked"_text(grant.fifo_priority)
                               : "SCHED_FIFO %1, memory not locked (%2)"_text(grant.fifo_priority,
                                                                              grant.memory_refusal);
  return grant.memory_locked ? "ordinary scheduling (%1), memory locked"_text(grant.fifo_refusal)
                             : "ordinary scheduling (%1), memory not locked (%2)"_text(
                                   grant.fifo_refusal, grant.memory_refusal);
}

Result<RealtimeGrant> enter_realtime(Realtime wish) {
  RealtimeGrant grant;
  if (wish == Realtime::off) return grant;
  grant.asked = true;
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  // Threads that this one may start later are ordinary ones.
  if (sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) == 0)
    grant.fifo_priority = kPriority;
  else
    grant.fifo_refusal =
        errno == EPERM ? Text("not permitted"_text) : Text(Known{std::strerror(errno)});
  grant.memory_refusal = memory_lock_refusal();
  grant.memory_locked = grant.memory_refusal.empty();
  prefault_stack();
  if (wish == Realtime::require && (grant.fifo_priority == 0 || !grant.memory_locked))
    return failed("real time is required, but the system gives %1"_text(words_of(grant)),
                  "write '@isograsp - rtprio 50' and '@isograsp - memlock unlimited' to "
                  "/etc/security/limits.d/isograsp.conf, join that group and log in again (check: "
                  "ulimit -r, ulimit -l), or use --realtime=prefer"_text)
        .about("--realtime");
  return grant;
}

}  // namespace isograsp::session
