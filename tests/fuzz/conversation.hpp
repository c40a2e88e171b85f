// SPDX-License-Identifier: GPL-3.0-or-later
// A conversation between a session and its emulated sensor, with faults on the way out of the
// input. Laws: asking ends, counters only grow, measurements are finite and have the time of their
// frame, and when the faults are over the sensor is soon streaming again.
#pragma once

#include <deque>

#include "device/emulator/emulated_sensor.hpp"
#include "device/protocol/sensor_session.hpp"
#include "tests/fuzz/frames.hpp"

namespace isograsp::fuzz {

class Conversation final : private EmulatorWorld {
 public:
  Conversation(SensorSession& session, EmulatedSensor& sensor)
      : session_(session), sensor_(sensor) {
    session_.begin(now_);
  }

  /// `stranger` makes a frame out of the input that the sensor never sent.
  template <class Stranger>
  void run(Numbers& in, const Stranger& stranger) {
    constexpr int kMostActs = 120;
    for (int act = 0; act < kMostActs && !in.empty(); ++act) {
      switch (const std::uint8_t what = in.byte(); what) {
        case 0xF0: drop(); break;
        case 0xF1: repeat(); break;
        case 0xF2: swap(); break;
        case 0xF3: damage(in); break;
        case 0xF4: hear(stranger(in)); break;
        case 0xF5: pass(take_pause(in)); break;
        case 0xF6: sensor_.power_dip(now_, *this); break;
        case 0xF7: session_.begin(now_); break;
        case 0xF8: forget_counters(); break;
        case 0xF9: deaf_ = !deaf_; break;
        default:
          for (int i = 0; i < 1 + what % 8; ++i) step();
      }
    }
    deaf_ = false;
    require_recovery();
  }

 private:
  struct Flying {
    Timestamp when;
    BusFrame frame;
  };

  void send_sample(std::size_t, Timestamp when, std::span<const BusFrame> frames) override {
    fly(std::max(when, now_), frames);
  }
  void send_answer(std::size_t, Timestamp now, std::span<const BusFrame> frames) override {
    fly(now + std::chrono::microseconds(500), frames);
  }
  Wrench feel(std::size_t, double play_s) override {
    return {Vec3(1.0, -2.0, -5.0 - play_s), Vec3(0.01, 0.02, -0.03)};
  }
  int noise_counts() override { return noise_ = (noise_ + 1) % 3; }
  bool filtered() const override { return false; }
  std::string serial_number(std::size_t) const override { return "FT12345"; }
  double clock_factor(std::size_t) const override { return 1.0001; }
  double phase(std::size_t) const override { return 0.3; }

  void fly(Timestamp when, std::span<const BusFrame> frames) {
    for (const auto& frame : frames) {
      when += std::chrono::microseconds(130);
      const auto behind =
          std::upper_bound(flying_.begin(), flying_.end(), when,
                           [](Timestamp t, const Flying& other) { return t < other.when; });
      flying_.insert(behind, {when, frame});
    }
  }

  /// To the next thing that happens by itself.
  void step() {
    Timestamp next = std::min(session_.due(), sensor_.next_measurement());
    if (!flying_.empty()) next = std::min(next, flying_.front().when);
    if (session_.ready()) session_.go(now_);
    if (next != Timestamp::max()) now_ = std::max(now_, next);
    settle();
  }
  void pass(Timestamp pause) {
    now_ += pause;
    settle();
  }
  void settle() {
    while (now_ >= sensor_.next_measurement()) sensor_.measure(*this);
    while (!flying_.empty() && flying_.front().when <= now_) {
      const BusFrame frame = flying_.front().frame;
      flying_.pop_front();
      hear(frame);
    }
    constexpr int kMostQuestions = 64;
    int questions = 0;
    while (const auto frame = session_.poll(now_)) {
      require(++questions < kMostQuestions, "asking ends");
      if (!deaf_) sensor_.receive(*frame, now_, *this);
    }
  }
  void hear(const BusFrame& frame) {
    if (!session_.owns(frame)) return;
    Measurement out;
    if (session_.take(frame, now_, out)) {
      ++measurements_;
      require(session_.streaming(), "only a sensor that streams measures");
      require(out.stamp == now_, "a measurement has the time of its frame");
      require(out.wrench_S.force.allFinite() && out.wrench_S.torque.allFinite(),
              "a measurement is finite");
    }
    require_growth();
  }
  void require_growth() {
    const SessionCounters now = session_.counters();
    require(now.torn >= counters_.torn && now.duplicate >= counters_.duplicate &&
                now.late >= counters_.late && now.lost >= counters_.lost &&
                now.foreign >= counters_.foreign && now.restarts >= counters_.restarts,
            "counters only grow");
    counters_ = now;
  }
  void forget_counters() {
    session_.reset_counters();
    counters_ = session_.counters();
  }

  void drop() {
    if (!flying_.empty()) flying_.pop_front();
  }
  void repeat() {
    if (!flying_.empty()) flying_.push_front(flying_.front());
  }
  void swap() {
    if (flying_.size() >= 2) std::swap(flying_[0].frame, flying_[1].frame);
  }
  void damage(Numbers& in) {
    const std::uint8_t where = in.byte();
    const std::uint8_t how = in.byte();
    if (flying_.empty()) return;
    BusFrame& frame = flying_.front().frame;
    if (where < 64)
      frame.data[where % 8U] ^= how;
    else
      frame.length = how % 9;
  }

  void require_recovery() {
    constexpr Timestamp kSoon = std::chrono::seconds(10);
    constexpr std::uint64_t kEnough = 3;
    const Timestamp end = now_ + kSoon;
    const std::uint64_t before = measurements_;
    while (measurements_ < before + kEnough) {
      require(now_ < end, "after the faults the sensor streams again");
      step();
    }
    require(session_.failure() == SensorSession::Failure::none, "a sensor that streams is well");
  }

  SensorSession& session_;
  EmulatedSensor& sensor_;
  Timestamp now_ = std::chrono::seconds(1);
  std::deque<Flying> flying_;
  SessionCounters counters_;
  std::uint64_t measurements_ = 0;
  int noise_ = 0;
  bool deaf_ = false;  ///< what the session says does not arrive
};

}  // namespace isograsp::fuzz
