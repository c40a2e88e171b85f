// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/force_channel.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

namespace {

constexpr std::array<std::string_view, 7> kDigits{"grip",  "grip_mean", "pinch", "sum",
                                                  "thumb", "index",     "middle"};
constexpr std::array<std::string_view, kDirectionCount> kDirections{"+x", "-x", "+y",
                                                                    "-y", "+z", "-z"};

/// Makes the number of a channel from one number per finger; `grip` combines the two sides of a
/// grip.
template <class Sides, class Together>
double combine(const std::array<double, kFingerCount>& of, Digits digits, Sides&& smaller,
               Together&& together) noexcept {
  const auto [thumb, index, middle] = of;
  switch (digits) {
    case Digits::grip: return smaller(thumb, together(index, middle));
    case Digits::grip_mean: return 0.5 * together(thumb, together(index, middle));
    case Digits::pinch: return smaller(thumb, index);
    case Digits::sum: return together(thumb, together(index, middle));
    case Digits::thumb: return thumb;
    case Digits::index: return index;
    case Digits::middle: return middle;
  }
  return 0.0;
}

}  // namespace

Vec3 axis_of(Direction direction) noexcept {
  const auto number = static_cast<int>(direction);
  Vec3 axis = Vec3::Zero();
  axis[number / 2] = number % 2 == 0 ? 1.0 : -1.0;
  return axis;
}

std::string name_of(ForceChannel channel) {
  const std::string digits(kDigits[static_cast<std::size_t>(channel.digits)]);
  if (channel.direction == Direction::plus_z) return digits;
  if (channel.direction == Direction::minus_z)
    return channel.digits == Digits::grip ? "opening" : digits + "_opening";
  return digits + "_" + std::string(kDirections[static_cast<std::size_t>(channel.direction)]);
}

std::optional<ForceChannel> force_channel_from_name(std::string_view name) {
  for (std::size_t d = 0; d < kDigits.size(); ++d)
    for (std::size_t a = 0; a < kDirectionCount; ++a) {
      const ForceChannel channel{static_cast<Digits>(d), static_cast<Direction>(a)};
      if (name_of(channel) == name) return channel;
    }
  return std::nullopt;
}

std::optional<Finger> single_digit(ForceChannel channel) noexcept {
  if (channel.digits < Digits::thumb) return std::nullopt;
  return kFingers[static_cast<std::size_t>(channel.digits) -
                  static_cast<std::size_t>(Digits::thumb)];
}

double force_of(const FingerWrenches& wrench_C, ForceChannel channel) noexcept {
  const auto number = static_cast<int>(channel.direction);
  const double sign = number % 2 == 0 ? 1.0 : -1.0;
  std::array<double, kFingerCount> along{};
  for (std::size_t f = 0; f < kFingerCount; ++f) along[f] = sign * wrench_C[f].force[number / 2];
  return combine(
      along, channel.digits, [](double a, double b) { return std::min(a, b); },
      [](double a, double b) { return a + b; });
}

double noise_of(const std::array<Vec3, kFingerCount>& sd_N, ForceChannel channel) noexcept {
  const auto axis = static_cast<int>(channel.direction) / 2;
  return combine(
      {sd_N[0][axis], sd_N[1][axis], sd_N[2][axis]}, channel.digits,
      [](double a, double b) { return std::max(a, b); },
      [](double a, double b) { return std::hypot(a, b); });
}

}  // namespace isograsp
