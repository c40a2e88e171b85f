// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stop_signals.hpp"

#include <array>
#include <csignal>

namespace isograsp::app {

namespace {

struct Stopping {
  int number;
  const char* name;
};
constexpr std::array<Stopping, 3> kStopping{
    {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}}};

std::atomic<bool> g_stop{false};
std::atomic<int> g_number{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void note(int number) {
  if (g_stop.exchange(true) && number == SIGINT) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
  g_number = number;
}

}  // namespace

StopSignals::StopSignals() {
  g_stop = false;
  g_number = 0;
  for (const Stopping& one : kStopping) {
    struct sigaction act {};
    struct sigaction before {};
    sigaction(one.number, nullptr, &before);
    if (one.number == SIGHUP && before.sa_handler == SIG_IGN) continue;  // nohup
    act.sa_handler = note;
    act.sa_flags = SA_RESTART;
    sigemptyset(&act.sa_mask);
    sigaction(one.number, &act, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (const Stopping& one : kStopping) std::signal(one.number, SIG_DFL);
}

const std::atomic<bool>& StopSignals::stop() noexcept {
  return g_stop;
}

std::string StopSignals::name() {
  for (const Stopping& one : kStopping)
    if (one.number == g_number) return one.name;
  return "";
}

void let_writes_fail() {
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace isograsp::app
