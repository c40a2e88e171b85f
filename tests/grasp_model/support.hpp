// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the grasp model share: tables of reference values, scenes written in a line.
#pragma once

#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "grasp_model/plan.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp::test {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

inline std::string data_path(const std::string& name) {
  return std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/" + name;
}

/// A row of a table whose fields may be words, "inf" or too small for a double.
class GoldenRow {
 public:
  explicit GoldenRow(std::map<std::string, std::string> fields) : fields_(std::move(fields)) {}
  [[nodiscard]] const std::string& text(const std::string& name) const { return fields_.at(name); }
  [[nodiscard]] double operator[](const std::string& name) const {
    return std::strtod(fields_.at(name).c_str(), nullptr);
  }
  /// Three columns: a prefix and x, y, z with a suffix.
  [[nodiscard]] Vec3 vec3(const std::string& x, const std::string& y, const std::string& z) const {
    return {(*this)[x], (*this)[y], (*this)[z]};
  }

 private:
  std::map<std::string, std::string> fields_;
};

inline std::vector<GoldenRow> golden(const std::string& name) {
  std::ifstream in(data_path("golden/" + name));
  const auto split = [](const std::string& line) {
    std::vector<std::string> fields;
    std::stringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
    return fields;
  };
  std::string line;
  std::getline(in, line);
  const auto names = split(line);
  std::vector<GoldenRow> rows;
  while (std::getline(in, line)) {
    const auto fields = split(line);
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i) row[names[i]] = fields[i];
    rows.emplace_back(std::move(row));
  }
  return rows;
}

inline Scene scene_of(const std::string& text) {
  auto scene = parse_scene(text, "test.toml");
  EXPECT_TRUE(scene.ok()) << (scene.ok() ? "" : scene.error().message());
  return scene.ok() ? *scene : Scene{};
}

inline Scene scene_file(const std::string& path) {
  const auto text = read_text(path);
  EXPECT_TRUE(text.ok());
  return text.ok() ? scene_of(*text) : Scene{};
}

inline Plan plan_of(const Scene& scene, double hold_s = 0.01) {
  auto plan = Plan::compile(scene, hold_s);
  if (!plan.ok()) {
    ADD_FAILURE() << plan.error().message();
    std::abort();
  }
  return *plan;
}

/// The three contacts of the device.
inline const std::string kDeviceContacts = R"(
[[contact]]
finger = "thumb"
position_m = [-0.0325, 0, 0]
normal = [1, 0, 0]
tangent = [0, 1, 0]
model = "point"
friction = 0.8
[[contact]]
finger = "index"
position_m = [0.0325, 0.0125, 0]
normal = [-1, 0, 0]
tangent = [0, 1, 0]
model = "point"
friction = 0.8
[[contact]]
finger = "middle"
position_m = [0.0325, -0.0125, 0]
normal = [-1, 0, 0]
tangent = [0, 1, 0]
model = "point"
friction = 0.8
)";

/// A block with these lines in [dynamics] and whatever follows.
inline std::string block(const std::string& dynamics, const std::string& after = kDeviceContacts) {
  return R"(format = "isograsp-scene-1"
[object]
shape = "box"
size_m = [0.065, 0.06, 0.08]
mass_kg = 0.3
inertia_kg_m2 = [1e-4, 2e-4, 3e-4]
[dynamics]
)" + dynamics +
         "\n" + after;
}

inline Mat3 rotation_of(const ObjectState& state) {
  return state.X_WO.q.toRotationMatrix();
}

}  // namespace isograsp::test
