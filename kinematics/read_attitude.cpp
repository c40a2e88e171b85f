// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/read_attitude.hpp"

#include <cstdio>
#include <initializer_list>

#include "core/csv.hpp"

namespace isograsp {

namespace {

std::string bracketed(std::initializer_list<double> values) {
  std::string text = "[";
  for (const double value : values) {
    if (text.size() > 1) text += ", ";
    append_number(text, value);
  }
  return text + "]";
}

}  // namespace

Quat read_attitude(TomlReader& table, std::string_view key) {
  const auto c = table.numbers(key, 4, 4);
  if (const auto q = unit_quaternion(c[0], c[1], c[2], c[3])) return *q;
  table.fail(key, "is no attitude"_text, "write a quaternion w, x, y, z that is not zero"_text);
  return Quat::Identity();
}

Pose read_pose(TomlReader& table) {
  return {table.vec3("position_m"), read_attitude(table, "quaternion_wxyz")};
}

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04X", static_cast<unsigned>(c));
      quoted += escaped;
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string toml_numbers(const Vec3& values) {
  return bracketed({values.x(), values.y(), values.z()});
}

std::string toml_numbers(const Quat& q) {
  return bracketed({q.w(), q.x(), q.y(), q.z()});
}

}  // namespace isograsp
