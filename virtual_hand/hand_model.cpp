// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/hand_model.hpp"

#include <cmath>
#include <numbers>
#include <span>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "kinematics/read_attitude.hpp"

namespace isograsp::virtual_hand {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
/// A hand is shorter than this in every measure [m]; what is longer is in millimetres.
constexpr double kLongest_m = 0.5;

double read_length(TomlReader& table, const char* key) {
  const double length_m = table.number(key);
  if (table.has(key) && !(length_m > 0.0 && length_m <= kLongest_m))
    table.fail(key, "is out of range"_text,
               "write metres, above 0 and at most %1"_text(format_number(kLongest_m)));
  return length_m;
}

std::array<double, kLinkCount> read_lengths(TomlReader& table, const char* key) {
  std::array<double, kLinkCount> lengths{};
  const auto given = table.numbers(key, kLinkCount, kLinkCount);
  for (std::size_t k = 0; k < kLinkCount; ++k) {
    lengths[k] = given[k];
    if (!(given[k] > 0.0 && given[k] <= kLongest_m))
      table.fail(key, "is out of range"_text,
                 "write metres, above 0 and at most %1"_text(format_number(kLongest_m)));
  }
  return lengths;
}

Vec3 read_place(TomlReader& table, const char* key) {
  const Vec3 place = table.vec3(key);
  if (table.has(key) && !(place.norm() <= kLongest_m))
    table.fail(key, "is out of range"_text,
               "write metres from the wrist, at most %1"_text(format_number(kLongest_m)));
  return place;
}

std::array<AngleRange, kAngleCount> read_limits(TomlReader& table) {
  constexpr double kTurn_deg = 180.0;
  std::array<AngleRange, kAngleCount> limits{};
  const auto pairs = table.number_lists("limits_deg", 2);
  if (table.has("limits_deg") && pairs.size() != kAngleCount)
    table.fail("limits_deg", "holds %1 ranges"_text(pairs.size()),
               "write least and most in degrees for abduction and three flexions"_text);
  for (std::size_t a = 0; a < kAngleCount && a < pairs.size(); ++a) {
    const double least = pairs[a][0];
    const double most = pairs[a][1];
    if (!(least >= -kTurn_deg && least < most && most <= kTurn_deg))
      table.fail("limits_deg", "is no range"_text,
                 "write least and most in degrees for abduction and three flexions"_text);
    limits[a] = {least * kDegree, most * kDegree};
  }
  return limits;
}

DigitModel read_digit(TomlReader& table) {
  DigitModel digit;
  digit.metacarpal_m = read_place(table, "metacarpal_m");
  digit.base_m = read_place(table, "base_m");
  digit.base_q = read_attitude(table, "base_quaternion_wxyz");
  digit.lengths_m = read_lengths(table, "lengths_m");
  digit.radii_m = read_lengths(table, "radii_m");
  digit.limits = read_limits(table);
  return digit;
}

/// Degrees that are read as exactly this angle: as somebody would write them, if that does.
double degrees_of(double angle_rad) {
  constexpr double kWritten = 1e6;  // parts of a degree
  const double nearest = angle_rad / kDegree;
  for (const double degrees :
       {std::round(kWritten * nearest) / kWritten, nearest, std::nextafter(nearest, HUGE_VAL),
        std::nextafter(nearest, -HUGE_VAL)})
    if (degrees * kDegree == angle_rad) return degrees;
  return nearest;
}

/// TOML knows one zero.
Quat with_one_zero(const Quat& q) {
  return {q.w() + 0.0, q.x() + 0.0, q.y() + 0.0, q.z() + 0.0};
}
Vec3 with_one_zero(const Vec3& p) {
  return p + Vec3::Zero();
}

std::string list_of(std::span<const double> values) {
  std::string text = "[";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + format_number(value);
  return text + "]";
}

}  // namespace

Result<HandModel> parse_hand(std::string_view text, const std::string& path) {
  auto root = TomlReader::parse(text, path, "isograsp-hand-1");
  if (!root) return root.error();
  HandModel hand;
  hand.name = root->text("name");
  hand.side = root->choice("side", {"right", "left"}) == 0 ? Hand::right : Hand::left;
  hand.length_m = read_length(*root, "hand_length_m");
  hand.breadth_m = read_length(*root, "hand_breadth_m");
  std::size_t count = 0;
  for (TomlReader& table : root->tables("finger")) {
    const std::string name = table.text("name");
    if (count < kDigitCount && name != kDigitNames[count])
      table.fail("name", "'%1' does not stand here"_text(name),
                 "write thumb, index, middle, ring, little in this order"_text);
    const DigitModel digit = read_digit(table);
    if (count < kDigitCount) hand.digits[count] = digit;
    ++count;
  }
  if (count != kDigitCount)
    root->fail("finger", "stands there %1 times"_text(count),
               "write one [[finger]] for each of the five digits"_text);
  if (auto done = root->finish(); !done) return done.error();
  return hand;
}

std::string hand_text(const HandModel& hand) {
  std::string text = "format = \"isograsp-hand-1\"\nname = " + toml_text(hand.name) +
                     "\nside = \"" + (hand.side == Hand::right ? "right" : "left") +
                     "\"\nhand_length_m = " + format_number(hand.length_m) +
                     "\nhand_breadth_m = " + format_number(hand.breadth_m) + "\n";
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const DigitModel& digit = hand.digits[d];
    text += "\n[[finger]]\nname = \"" + std::string(kDigitNames[d]) +
            "\"\nmetacarpal_m = " + toml_numbers(with_one_zero(digit.metacarpal_m)) +
            "\nbase_m = " + toml_numbers(with_one_zero(digit.base_m)) +
            "\nbase_quaternion_wxyz = " + toml_numbers(with_one_zero(digit.base_q)) +
            "\nlengths_m = " + list_of(digit.lengths_m) + "\nradii_m = " + list_of(digit.radii_m) +
            "\nlimits_deg = [";
    for (std::size_t a = 0; a < kAngleCount; ++a)
      text +=
          std::string(a == 0 ? "" : ", ") +
          list_of(std::array{degrees_of(digit.limits[a].least), degrees_of(digit.limits[a].most)});
    text += "]\n";
  }
  return text;
}

}  // namespace isograsp::virtual_hand
