// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions and emulated sensors in virtual time with nothing but a delay between them; tests decide
// which frames of a sample are lost, and when frames leave. Frames stay in order.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "device/emulator/emulated_sensor.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp::test {

class Conversation : public EmulatorWorld {
 public:
  struct Sent {
    std::size_t finger;
    Timestamp when;  ///< that it was measured
    std::vector<BusFrame> frames;
    std::uint64_t number = 0;  ///< of its sensor
  };
  struct Taken {
    std::size_t finger;
    Measurement measurement;
  };

  void add(std::unique_ptr<SensorSession> session, std::unique_ptr<EmulatedSensor> sensor) {
    sessions.push_back(std::move(session));
    sensors.push_back(std::move(sensor));
    numbers_.push_back(0);
  }
  void begin() {
    for (auto& session : sessions) session->begin(now);
  }
  /// Frames first, then what the host has to say: as the device does it.
  void run_until(Timestamp end) {
    while (true) {
      deliver();
      serve();
      Timestamp next = end;
      for (const auto& session : sessions) next = std::min(next, session->due());
      for (const auto& sensor : sensors) next = std::min(next, sensor->next_measurement());
      if (!departures_.empty()) next = std::min(next, departures_.front().when);
      if (next >= end) break;
      ASSERT_GE(next, now);
      now = next;
    }
    now = end;
    deliver();
  }
  void run_for(Timestamp span) { run_until(now + span); }
  /// From the host or a stranger, to all sensors and nobody else.
  void put_on_bus(const BusFrame& frame) {
    for (auto& sensor : sensors) sensor->receive(frame, now, *this);
  }
  /// From a stranger to the host.
  void to_host(const BusFrame& frame) {
    for (std::size_t f = 0; f < sessions.size(); ++f) {
      Measurement out;
      if (sessions[f]->owns(frame) && sessions[f]->take(frame, now, out)) taken.push_back({f, out});
    }
  }

  std::vector<std::unique_ptr<SensorSession>> sessions;
  std::vector<std::unique_ptr<EmulatedSensor>> sensors;
  Timestamp now = std::chrono::seconds(1);
  bool go = true;               ///< sessions that are ready may start
  std::vector<BusFrame> asked;  ///< by the host
  std::vector<Sent> sent;       ///< samples
  std::vector<Taken> taken;
  /// Which frames of a sample are lost: bit 0 the first, bit 1 the second.
  std::function<unsigned(const Sent&)> lose = [](const Sent&) { return 0U; };
  /// When a frame leaves.
  std::function<Timestamp(Timestamp)> leave = [](Timestamp when) { return when; };
  std::function<Wrench(std::size_t, double)> wrench = [](std::size_t, double) { return Wrench{}; };
  int noise = 0;
  bool low_pass = false;
  bool mute = false;  ///< sensors are cut off
  std::vector<std::string> serials{"FT00001", "FT00002", "FT00003"};

 private:
  struct Departure {
    Timestamp when;
    BusFrame frame;
  };
  void depart(Timestamp when, const BusFrame& frame) {
    when = leave(when);
    const auto place = std::upper_bound(departures_.begin(), departures_.end(), when,
                                        [](Timestamp t, const Departure& d) { return t < d.when; });
    departures_.insert(place, {when, frame});
  }
  void deliver() {
    for (auto& sensor : sensors)
      while (sensor->next_measurement() <= now) sensor->measure(*this);
    while (!departures_.empty() && departures_.front().when <= now) {
      const BusFrame frame = departures_.front().frame;
      departures_.erase(departures_.begin());
      to_host(frame);
    }
  }
  void serve() {
    const auto send_due = [this](SensorSession& session) {
      while (const auto frame = session.poll(now)) {
        asked.push_back(*frame);
        put_on_bus(*frame);
      }
    };
    for (auto& session : sessions) {
      send_due(*session);
      if (!go || !session->ready()) continue;
      session->go(now);
      send_due(*session);
    }
  }

  void send_sample(std::size_t finger, Timestamp when, std::span<const BusFrame> frames) override {
    if (mute) return;
    Sent sample{finger, now, {frames.begin(), frames.end()}, numbers_[finger]++};
    const unsigned lost = lose(sample);
    for (std::size_t i = 0; i < frames.size(); ++i)
      if ((lost >> i & 1U) == 0) depart(when, frames[i]);
    sent.push_back(std::move(sample));
  }
  void send_answer(std::size_t, Timestamp at, std::span<const BusFrame> frames) override {
    if (mute) return;
    for (const auto& frame : frames) depart(at + std::chrono::microseconds(600), frame);
  }
  Wrench feel(std::size_t finger, double play_s) override { return wrench(finger, play_s); }
  int noise_counts() override { return noise; }
  bool filtered() const override { return low_pass; }
  std::string serial_number(std::size_t finger) const override { return serials[finger]; }
  double clock_factor(std::size_t) const override { return 1.0; }
  double phase(std::size_t) const override { return 0.0; }

  std::vector<Departure> departures_;
  std::vector<std::uint64_t> numbers_;
};

}  // namespace isograsp::test
