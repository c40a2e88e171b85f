// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acquisition/realtime.hpp"

#include <thread>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isograsp::session::realtime_test {
namespace {

/// Runs `claim` in a process that may not ask for real time: another user, limits at nothing.
bool without_permission(bool (*claim)()) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    setrlimit(RLIMIT_MEMLOCK, &none);
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    _exit(claim() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(Realtime, RequiredAndRefusedItFailsAndNamesTheLimits) {
  EXPECT_TRUE(without_permission([] {
    const auto grant = enter_realtime(Realtime::require);
    if (grant) return false;
    const std::string message = grant.error().message();
    return grant.error().code == Error::Code::failed &&
           message.find("rtprio") != std::string::npos &&
           message.find("memlock") != std::string::npos &&
           message.find("ulimit") != std::string::npos &&
           message.find("limits.d") != std::string::npos;
  }));
}

TEST(Realtime, PreferredAndRefusedItGoesOnAndSaysWhatItGot) {
  EXPECT_TRUE(without_permission([] {
    const auto grant = enter_realtime(Realtime::prefer);
    return grant && grant->asked && grant->fifo_priority == 0 && !grant->memory_locked &&
           english(words_of(*grant)).find("ordinary scheduling (not permitted)") == 0 &&
           english(words_of(*grant)).find("memory not locked (the limit memlock") !=
               std::string::npos;
  }));
}

TEST(Realtime, WhatItSaysItGotIsWhatTheKernelSays) {
  std::thread([] {
    const auto grant = enter_realtime(Realtime::prefer);
    ASSERT_TRUE(grant);
    sched_param parameters{};
    sched_getparam(0, &parameters);
    const int policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    EXPECT_EQ(policy == SCHED_FIFO, grant->fifo_priority > 0) << english(words_of(*grant));
    EXPECT_EQ(parameters.sched_priority, grant->fifo_priority);
    std::thread([] { EXPECT_EQ(sched_getscheduler(0), SCHED_OTHER) << "not inherited"; }).join();
  }).join();
}

TEST(Realtime, OffAsksForNothing) {
  const auto grant = enter_realtime(Realtime::off);
  ASSERT_TRUE(grant);
  EXPECT_FALSE(grant->asked);
  EXPECT_EQ(english(words_of(*grant)), "");
}

TEST(Realtime, NamesComeBack) {
  for (const auto wish : {Realtime::off, Realtime::prefer, Realtime::require})
    EXPECT_EQ(realtime_from_name(name_of(wish)), wish);
  EXPECT_FALSE(realtime_from_name("maybe").has_value());
}

}  // namespace
}  // namespace isograsp::session::realtime_test
