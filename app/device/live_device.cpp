// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/device/live_device.hpp"

#include <atomic>
#include <cmath>
#include <csignal>

#include "app/console.hpp"
#include "app/paths.hpp"
#include "device/config/family_facts.hpp"
#include "device/config/uri.hpp"
#include "device/sensors/frame_reader.hpp"
#include "session/simulated_person.hpp"
#include "tasks/task.hpp"

namespace isograsp::app {

namespace {

std::atomic<bool> interrupt_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

}  // namespace

void watch_for_interrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupt_flag = true; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() noexcept {
  return interrupt_flag;
}

Stimulus press_hold_release(double t_s, double grip_N) {
  constexpr double kCycle_s = 10.0;
  constexpr double kPress_s = 2.0;
  constexpr double kRelease_s = 7.0;
  constexpr double kTarget_N = 12.0;
  const double phase_s = std::fmod(t_s, kCycle_s);
  Stimulus screen;
  screen.t_s = t_s;
  screen.force_target_shown = phase_s >= kPress_s && phase_s < kRelease_s;
  screen.cue = screen.force_target_shown ? Cue::follow : Cue::relax;
  screen.target_force_N = screen.force_target_shown ? kTarget_N : 0.0;
  screen.shown_force_N = grip_N;
  return screen;
}

Result<DeviceConfig> family_config(const std::string& name, const std::string& file) {
  const FamilyFacts* family = family_named(name);
  if (family == nullptr || !family->on_wire())
    return refused("no protocol is called '%1'"_text(name), "use %1"_text(any_family()))
        .about("--protocol");
  if (file.empty()) return DeviceConfig::standard(*family);
  auto config = DeviceConfig::read(file);
  if (config && config->family != family)
    return refused("the file is for %1"_text(config->family->name),
                   "give a device file of this protocol"_text)
        .at(file)
        .about("protocol");
  return config;
}

Result<LiveDevice> LiveDevice::open(const std::string& text, const std::shared_ptr<BusTap>& tap) {
  LiveDevice live;
  const auto uri = Uri::parse(text);
  if (!uri) return uri.error();
  auto person = session::simulated_person(*uri, library_folder());
  if (!person) return person.error();
  live.person_ = *std::move(person);
  auto device = open_device(text, {live.person_.get(), tap});
  if (!device) return device.error();
  live.device_ = *std::move(device);
  return live;
}

Result<void> LiveDevice::ask_for(session::Realtime wish) {
  const auto got = session::enter_realtime(wish);
  if (!got) return got.error();
  if (const auto words = words_of(*got); !words.empty())
    print_note("acquisition with %1"_text(words));
  return {};
}

Result<void> LiveDevice::run(double duration_s,
                             const std::function<bool(const FingerFrame&)>& on_frame) {
  watch_for_interrupt();
  SteadyClock clock;
  if (auto started = device_->start(clock); !started) return started;
  FrameReader frames(*device_, clock, device_->now(clock));
  std::optional<Timestamp> last_frame;
  FingerFrame frame;
  while (!interrupted() && frames.next(frame)) {
    if (person_) person_->see(press_hold_release(frame.t_s, force_of(frame.wrench_C, {})));
    if (duration_s > 0.0 && frame.t_s >= duration_s) break;
    const Timestamp ready = clock.now();
    if (last_frame) timing_.period.add(to_seconds(ready - *last_frame));
    last_frame = ready;
    timing_.lateness.add(frames.lateness_s(frame));
    const bool more = on_frame(frame);
    timing_.compute.add(to_seconds(clock.now() - ready));
    if (const auto& stamp = frames.completed_by())
      timing_.latency.add(to_seconds(device_->now(clock) - *stamp));
    if (!more) break;
  }
  device_->stop();
  return {};
}

}  // namespace isograsp::app
