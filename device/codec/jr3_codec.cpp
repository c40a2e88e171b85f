// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/jr3_codec.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp {

namespace {

constexpr Timestamp kLongestJr3Pair = std::chrono::milliseconds(100);
constexpr Timestamp kLongestJr3Repeat = std::chrono::milliseconds(2);
constexpr double kJr3FullScale = 16384.0;   // counts
constexpr double kDecinewtonMetres = 10.0;  // in one newton metre

void put_little_endian(BusFrame& frame, std::size_t at, std::uint32_t value,
                       std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; ++i)
    frame.data[at + i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFF);
}

std::uint16_t get_word(const BusFrame& frame, std::size_t at) noexcept {
  return static_cast<std::uint16_t>(frame.data[at] | frame.data[at + 1] << 8);
}

BusFrame frame_of(std::uint8_t node, Jr3Opcode opcode, std::uint8_t length) noexcept {
  assert(node >= 1 && node <= 127);
  BusFrame frame;
  frame.id = static_cast<std::uint32_t>(opcode) + node;
  frame.length = length;
  return frame;
}

}  // namespace

bool jr3_owns(std::uint8_t node, const BusFrame& frame) noexcept {
  return !frame.error && frame.id <= 0x7FF && frame.id >= 0x100 && (frame.id & 0x7F) == node;
}

bool is_jr3_sync(const BusFrame& frame) noexcept {
  return frame == jr3_sync();
}

Jr3Opcode jr3_opcode(const BusFrame& frame) noexcept {
  return static_cast<Jr3Opcode>(frame.id & 0x780);
}

Jr3Word jr3_word(const BusFrame& frame) noexcept {
  if (!frame.is_standard()) return Jr3Word::foreign;
  const auto if_length = [&](unsigned length, Jr3Word word) {
    return frame.length == length ? word : Jr3Word::foreign;
  };
  switch (jr3_opcode(frame)) {
    case Jr3Opcode::acknowledge:
      return frame.length == 1 ? Jr3Word::answer : if_length(7, Jr3Word::answer);
    case Jr3Opcode::start_sync:
    case Jr3Opcode::set_filter: return if_length(2, Jr3Word::request);
    case Jr3Opcode::start_async: return if_length(6, Jr3Word::request);
    case Jr3Opcode::stop:
    case Jr3Opcode::zero_offsets:
    case Jr3Opcode::state:
    case Jr3Opcode::force_scales:
    case Jr3Opcode::moment_scales:
    case Jr3Opcode::reset: return if_length(0, Jr3Word::request);
    case Jr3Opcode::force:
    case Jr3Opcode::moment: return if_length(8, Jr3Word::answer);
    case Jr3Opcode::boot_up: return if_length(0, Jr3Word::answer);
    case Jr3Opcode::gripper: return if_length(4, Jr3Word::request);
    case Jr3Opcode::sync: break;  // belongs to no adaptor
  }
  return Jr3Word::foreign;
}

BusFrame jr3_request(std::uint8_t node, Jr3Opcode opcode) noexcept {
  return frame_of(node, opcode, 0);
}

BusFrame jr3_sync() noexcept {
  BusFrame frame;
  frame.id = static_cast<std::uint32_t>(Jr3Opcode::sync);
  return frame;
}

std::optional<std::uint16_t> jr3_cutoff(double cutoff_Hz) noexcept {
  const double steps = std::round(cutoff_Hz * 100.0);
  if (!(steps >= 0.0 && steps <= UINT16_MAX)) return std::nullopt;
  return static_cast<std::uint16_t>(steps);
}

BusFrame jr3_start_sync(std::uint8_t node, std::uint16_t cutoff_cHz) noexcept {
  BusFrame frame = frame_of(node, Jr3Opcode::start_sync, 2);
  put_little_endian(frame, 0, cutoff_cHz, 2);
  return frame;
}

BusFrame jr3_start_async(std::uint8_t node, std::uint16_t cutoff_cHz,
                         std::uint32_t period_us) noexcept {
  BusFrame frame = frame_of(node, Jr3Opcode::start_async, 6);
  put_little_endian(frame, 0, cutoff_cHz, 2);
  put_little_endian(frame, 2, period_us, 4);
  return frame;
}

BusFrame jr3_set_filter(std::uint8_t node, std::uint16_t cutoff_cHz) noexcept {
  BusFrame frame = frame_of(node, Jr3Opcode::set_filter, 2);
  put_little_endian(frame, 0, cutoff_cHz, 2);
  return frame;
}

BusFrame jr3_acknowledge(std::uint8_t node, const Jr3Acknowledge& content) noexcept {
  BusFrame frame = frame_of(node, Jr3Opcode::acknowledge, content.scales ? 7 : 1);
  frame.data[0] = content.ready ? 0 : 1;
  if (content.scales)
    for (std::size_t i = 0; i < 3; ++i)
      put_little_endian(frame, 1 + 2 * i, (*content.scales)[i], 2);
  return frame;
}

Jr3Acknowledge jr3_acknowledge_of(const BusFrame& frame) noexcept {
  Jr3Acknowledge content;
  content.ready = frame.data[0] == 0;
  if (frame.length == 7)
    content.scales = {get_word(frame, 1), get_word(frame, 3), get_word(frame, 5)};
  return content;
}

bool Jr3Calibration::usable() const noexcept {
  const auto positive = [](std::uint16_t scale) { return scale > 0; };
  return std::all_of(force_N.begin(), force_N.end(), positive) &&
         std::all_of(moment_dNm.begin(), moment_dNm.end(), positive);
}

Vec6 Jr3Calibration::units_per_count() const noexcept {
  Vec6 units;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    units[axis] = force_N[i] / kJr3FullScale;
    units[axis + 3] = moment_dNm[i] / (kJr3FullScale * kDecinewtonMetres);
  }
  return units;
}

bool Jr3Reading::saturated() const noexcept {
  return std::any_of(raw.begin(), raw.end(),
                     [](std::int32_t r) { return r <= INT16_MIN || r >= INT16_MAX; });
}

std::array<BusFrame, 2> jr3_reading_frames(std::uint8_t node, const Jr3Reading& reading) noexcept {
  std::array<BusFrame, 2> frames{frame_of(node, Jr3Opcode::force, 8),
                                 frame_of(node, Jr3Opcode::moment, 8)};
  for (std::size_t i = 0; i < reading.raw.size(); ++i) {
    assert(reading.raw[i] >= INT16_MIN && reading.raw[i] <= INT16_MAX);
    put_little_endian(frames[i / 3], 2 * (i % 3), static_cast<std::uint32_t>(reading.raw[i]), 2);
  }
  for (auto& frame : frames) put_little_endian(frame, 6, reading.number, 2);
  return frames;
}

Wrench wrench_of(const Jr3Reading& reading, const Jr3Calibration& calibration) noexcept {
  Wrench wrench;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    // The products are exact.
    wrench.force[axis] = 1.0 * reading.raw[i] * calibration.force_N[i] / kJr3FullScale;
    wrench.torque[axis] =
        1.0 * reading.raw[i + 3] * calibration.moment_dNm[i] / (kJr3FullScale * kDecinewtonMetres);
  }
  return wrench;
}

void Jr3Pairing::drop(Half& half) noexcept {
  if (half.waiting) ++torn_;
  half.waiting = false;
}

void Jr3Pairing::forget() noexcept {
  for (auto& half : halves_) drop(half);
  newest_.reset();
}

std::optional<Jr3Pairing::Reading> Jr3Pairing::push(const BusFrame& frame,
                                                    Timestamp stamp) noexcept {
  const Half mine{
      {static_cast<std::int16_t>(get_word(frame, 0)), static_cast<std::int16_t>(get_word(frame, 2)),
       static_cast<std::int16_t>(get_word(frame, 4))},
      get_word(frame, 6),
      jr3_opcode(frame) == Jr3Opcode::force,
      stamp,
      true};
  bool repeated = newest_ == mine.number && stamp >= newest_stamp_ &&
                  stamp - newest_stamp_ <= kLongestJr3Repeat;
  Half* other = nullptr;
  Half* place = &halves_[0];  // a free one, or the one that waits longest
  for (auto& half : halves_) {
    if (half.waiting && (stamp < half.stamp || stamp - half.stamp > kLongestJr3Pair)) drop(half);
    if (place->waiting && (!half.waiting || half.stamp < place->stamp)) place = &half;
    if (!half.waiting || half.number != mine.number) continue;
    if (half.force == mine.force)
      repeated = true;
    else
      other = &half;
  }
  if (repeated) {
    ++duplicate_;
    return std::nullopt;
  }
  if (other == nullptr) {
    drop(*place);
    *place = mine;
    return std::nullopt;
  }
  other->waiting = false;
  newest_ = mine.number;
  newest_stamp_ = stamp;
  Reading out;
  out.stamp = stamp;
  out.reading.number = mine.number;
  const Half& force = mine.force ? mine : *other;
  const Half& moment = mine.force ? *other : mine;
  for (std::size_t i = 0; i < 3; ++i) {
    out.reading.raw[i] = force.raw[i];
    out.reading.raw[i + 3] = moment.raw[i];
  }
  return out;
}

}  // namespace isograsp
