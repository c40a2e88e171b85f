// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/emulated_rft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/codec/rft_codec.hpp"
#include "device/codec/rft_stream.hpp"
#include "device/config/rft_sensor.hpp"

namespace isograsp {

namespace {

constexpr double kOverload = 1.2;  // of the rating, from which on the overload bit is set
constexpr std::uint8_t kSuccess = 1;
constexpr std::uint8_t kUnsupported = 1;
constexpr std::uint8_t kOutOfRange = 2;

class EmulatedRft final : public EmulatedSensor {
 public:
  EmulatedRft(std::size_t finger, const DeviceConfig& config)
      : EmulatedSensor(finger),
        sensor_(config.sensors[finger]),
        rft_(sensor_.as<RftSensor>()),
        ids_(rft_.ids),
        ids_after_reboot_(ids_) {}

  void receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) override {
    if (const auto field = command_in(frame)) obey(*field, now, world);
  }
  [[nodiscard]] Timestamp next_measurement() const override {
    if (!streaming_) return Timestamp::max();
    return started_ + from_seconds((static_cast<double>(measured_) + phase_) * period_s() * clock_);
  }
  void measure(EmulatorWorld& world) override {
    const Timestamp when = next_measurement();
    send(world, when, encode(read(world), RftCommand::start));
    ++measured_;
  }
  /// Settings survive, start and bias do not, new identifiers act.
  void power_dip(Timestamp, EmulatorWorld&) override {
    streaming_ = false;
    bias_ = {};
    ids_ = ids_after_reboot_;
    filter_settled_ = false;
  }
  void answer_unasked(Timestamp now, EmulatorWorld& world) override {
    world.send_answer(
        finger(), now,
        packet(static_cast<std::uint8_t>(RftCommand::overload_counts), overload_counts_));
  }
  [[nodiscard]] Timestamp play_start() const override { return first_start_; }

 private:
  using Field = std::array<std::uint8_t, 8>;
  using Frames = std::vector<BusFrame>;

  [[nodiscard]] bool on_can() const noexcept { return rft_.address.empty(); }
  [[nodiscard]] double period_s() const noexcept { return 1.0 / rft_rate_Hz(rate_code_); }

  /// D1 … D8 of a command to this sensor.
  [[nodiscard]] std::optional<Field> command_in(const BusFrame& frame) const {
    if (!frame.is_standard()) return std::nullopt;
    Field field{};
    if (on_can()) {
      if (frame.id != ids_.command || frame.length != field.size()) return std::nullopt;
      std::copy_n(frame.data.begin(), field.size(), field.begin());
      return field;
    }
    if (frame.id != finger()) return std::nullopt;
    return decode_stream_command(frame.bytes());
  }
  [[nodiscard]] Frames packet(std::uint8_t command, std::span<const std::uint8_t> content) const {
    if (!on_can())
      return {encode_stream_packet(static_cast<std::uint32_t>(finger()), command, content)};
    const auto frames = encode_packet(ids_, command, content);
    return {frames.begin(), frames.end()};
  }
  [[nodiscard]] Frames encode(const RftCounts& counts, RftCommand command) const {
    return packet(static_cast<std::uint8_t>(command), content_of(counts));
  }
  void send(EmulatorWorld& world, Timestamp when, const Frames& frames) const {
    world.send_sample(finger(), when, frames);
  }

  void obey(const Field& d, Timestamp now, EmulatorWorld& world) {
    const auto reply = [&](std::span<const std::uint8_t> content) {
      world.send_answer(finger(), now, packet(d[0], content));
    };
    const auto text = [&](std::string_view words) {
      std::array<std::uint8_t, 15> content{};
      words = words.substr(0, content.size());
      std::copy(words.begin(), words.end(), content.begin());
      reply(content);
    };
    const auto result = [&](bool good) {
      reply(std::array<std::uint8_t, 2>{good ? kSuccess : std::uint8_t{0},
                                        good ? std::uint8_t{0} : kOutOfRange});
    };
    const auto command = static_cast<RftCommand>(d[0]);
    if (command == RftCommand::stop) {
      streaming_ = false;
      return;
    }
    if (command == RftCommand::set_bias) {
      bias_ = {};
      if (d[1] == 1) bias_ = read(world).raw;
      return;
    }
    if (streaming_) return;  // deaf to everything else
    switch (command) {
      case RftCommand::model_name: return text("RFT60-HA01");
      case RftCommand::serial_number: return text(world.serial_number(finger()));
      case RftCommand::firmware_version: return text("1.82");
      case RftCommand::set_ids: {
        const bool good =
            d[1] != 0 && d[2] != 0 && d[3] != 0 && d[1] != d[2] && d[2] != d[3] && d[1] != d[3];
        if (good) ids_after_reboot_ = {d[1], d[2], d[3]};
        return result(good);
      }
      case RftCommand::read_ids: {
        const RftIds& a = ids_;
        const RftIds& b = ids_after_reboot_;
        return reply(std::array{a.command, a.first, a.second, b.command, b.first, b.second});
      }
      case RftCommand::set_filter: {
        const bool good = d[1] == 0 || (d[1] == 1 && d[2] <= 14);
        if (good) {
          filter_type_ = d[1];
          filter_code_ = d[2];
          filter_settled_ = false;
        }
        return result(good);
      }
      case RftCommand::read_filter: return reply(std::array{filter_type_, filter_code_});
      case RftCommand::read_once:
        return world.send_answer(finger(), now, encode(read(world), RftCommand::read_once));
      case RftCommand::start:
        streaming_ = true;
        started_ = now;
        measured_ = 0;
        clock_ = world.clock_factor(finger());
        phase_ = world.phase(finger());
        first_start_ = std::min(first_start_, now);
        return;
      case RftCommand::set_rate:
        if (d[1] <= 8) rate_code_ = d[1];
        return result(d[1] <= 8);
      case RftCommand::read_rate: return reply(std::array{rate_code_});
      case RftCommand::overload_counts: return reply(overload_counts_);
      default: return reply(std::array<std::uint8_t, 2>{0, kUnsupported});
    }
  }

  [[nodiscard]] RftCounts read(EmulatorWorld& world) {
    const double own_s = static_cast<double>(measured_) * period_s();
    const Wrench wrench_S = world.feel(finger(), own_s);
    const double cutoff_Hz = filter_type_ == 1 ? rft_filter_Hz(filter_code_) : 0.0;
    const double pass = world.filtered() && cutoff_Hz > 0.0 && filter_settled_
                            ? 1.0 - std::exp(-2.0 * std::numbers::pi * cutoff_Hz * period_s())
                            : 1.0;
    RftCounts counts;
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const auto i = static_cast<int>(axis % 3);
      const double per_unit = axis < 3 ? rft_.divisors.force_per_N : rft_.divisors.torque_per_Nm;
      const double true_value = (axis < 3 ? wrench_S.force[i] : wrench_S.torque[i]) * per_unit;
      double& value = filter_state_[axis];
      value += pass * (true_value - value);
      std::int64_t count = std::llround(pass == 1.0 ? true_value : value);
      count += world.noise_counts() - bias_[axis];
      counts.raw[axis] =
          static_cast<std::int32_t>(std::clamp<std::int64_t>(count, INT16_MIN, INT16_MAX));
      if (std::abs(static_cast<double>(count)) >
          kOverload * sensor_.range[static_cast<int>(axis)] * per_unit) {
        counts.overload |= static_cast<std::uint8_t>(0x20 >> axis);
        if (overload_counts_[axis] < 255) ++overload_counts_[axis];
      }
    }
    filter_settled_ = true;
    return counts;
  }

  SensorConfig sensor_;
  RftSensor rft_;
  RftIds ids_;
  RftIds ids_after_reboot_;
  bool streaming_ = false;
  std::uint8_t rate_code_ = 0;  ///< 0: the default, 200 Hz
  std::uint8_t filter_type_ = 0;
  std::uint8_t filter_code_ = 0;
  double clock_ = 1.0;
  double phase_ = 0.5;
  Timestamp started_{0};
  Timestamp first_start_ = Timestamp::max();
  std::int64_t measured_ = 0;  ///< since start
  std::array<double, 6> filter_state_{};
  bool filter_settled_ = false;
  std::array<std::int32_t, 6> bias_{};
  std::array<std::uint8_t, 6> overload_counts_{};
};

}  // namespace

std::unique_ptr<EmulatedSensor> make_emulated_rft(std::size_t finger, const DeviceConfig& config) {
  return std::make_unique<EmulatedRft>(finger, config);
}

}  // namespace isograsp
