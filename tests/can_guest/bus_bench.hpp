// SPDX-License-Identifier: GPL-3.0-or-later
// `isograsp emulate` in a process of its own and the driver in this one, on a CAN bus of the
// kernel.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "device/sensors/force_device.hpp"
#include "hand/finger_forces.hpp"
#include "tests/support/command.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::test {

inline std::string can_interface() {
  const char* name = std::getenv("ISOGRASP_CAN_INTERFACE");
  return name == nullptr ? "vcan0" : name;
}

/// Rows at the times t_s as a finger-forces file; wrench(row, finger) in the contact frame.
template <class WrenchOf>
std::string forces_file(const TemporaryFolder& folder, const std::vector<double>& t_s,
                        WrenchOf wrench) {
  std::string text;
  for (const auto& name : finger_forces_columns()) text += (name == "t_s" ? "" : ",") + name;
  text += "\n";
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    FingerForcesRow row;
    row.t_s = t_s[k];
    row.present = {true, true, true};
    for (std::size_t f = 0; f < kFingerCount; ++f) row.wrench_C[f] = wrench(k, f);
    append_finger_forces(text, row);
  }
  return folder.write("forces.csv", text);
}

/// `isograsp emulate` in a process of its own; finish() waits for its end and returns its counters.
class EmulateProcess {
 public:
  EmulateProcess(const std::string& protocol, const std::string& play, double duration_s,
                 const std::string& more = "") {
    // With one processor, the driver that the first frame of a sample wakes would hold up the
    // second.
    const std::string command =
        "$(chrt -f 20 true 2>/dev/null && echo chrt -f 20) \"" ISOGRASP_EXECUTABLE
        "\" emulate --protocol " +
        protocol + " --json --on " + can_interface() + " --play " + play + " --duration " +
        std::to_string(duration_s) + " " + more;
    pipe_ = popen(command.c_str(), "r");
  }
  ~EmulateProcess() {
    if (pipe_ != nullptr) pclose(pipe_);
  }
  EmulateProcess(const EmulateProcess&) = delete;
  EmulateProcess& operator=(const EmulateProcess&) = delete;

  nlohmann::json finish() {
    std::string text;
    char part[256];
    while (std::fgets(part, sizeof part, pipe_) != nullptr) text += part;
    EXPECT_EQ(pclose(std::exchange(pipe_, nullptr)), 0);
    return nlohmann::json::parse(text);
  }

 private:
  FILE* pipe_;
};

/// Starts the driver as soon as the emulated sensors are there.
inline std::unique_ptr<ForceDevice> start_driver(const std::string& uri, SteadyClock& clock,
                                                 const DeviceOptions& options = {}) {
  auto device = open_device(uri, options);
  if (!device) {
    ADD_FAILURE() << device.error().message();
    return nullptr;
  }
  for (int i = 0; i < 30; ++i) {
    const auto started = (*device)->start(clock);
    if (started) return *std::move(device);
    if (i == 29) ADD_FAILURE() << started.error().message();
  }
  return nullptr;
}

struct Taken {
  SensorSample sample;
  Timestamp handed_over;  ///< when read() returned
};

/// Everything until no sample has come for half a second.
inline std::vector<Taken> read_all(ForceDevice& device, const SteadyClock& clock,
                                   std::size_t most) {
  using namespace std::chrono_literals;
  std::vector<Taken> taken;
  taken.reserve(most);
  Timestamp newest = clock.now();
  const auto before = allocations();
  constexpr int kLeastLooks = 40;  // a computer that stands still says nothing about sensors
  for (int looks = 0; (clock.now() < newest + 500ms || looks < kLeastLooks) && taken.size() < most;
       ++looks) {
    Taken next;
    if (device.read(clock.now() + 10ms, next.sample) != ReadStatus::sample) continue;
    looks = 0;
    next.handed_over = newest = clock.now();
    taken.push_back(next);
  }
  EXPECT_EQ(allocations(), before) << "reading must not allocate";
  return taken;
}

inline std::vector<Taken> of_finger(const std::vector<Taken>& all, std::size_t finger) {
  std::vector<Taken> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some),
               [&](const Taken& t) { return index_of(t.sample.finger) == finger; });
  return some;
}

/// The rule of docs/devices.md, applied to the stamps of the samples.
inline std::uint64_t lost_by_gaps(const std::vector<Taken>& samples, double rate_Hz) {
  std::uint64_t lost = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const double periods =
        to_seconds(samples[k].sample.stamp - samples[k - 1].sample.stamp) * rate_Hz;
    if (periods > 1.5) lost += static_cast<std::uint64_t>(std::llround(periods)) - 1;
  }
  return lost;
}

}  // namespace isograsp::test
