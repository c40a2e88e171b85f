// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/device_config.hpp"

#include <algorithm>
#include <vector>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"

namespace isograsp {

Wrench Mounting::to_contact(const Wrench& wrench_S) const noexcept {
  const Mat3 R_CS = q_CS.toRotationMatrix();
  Wrench wrench_C;
  wrench_C.force = R_CS * wrench_S.force;
  wrench_C.torque = R_CS * (wrench_S.torque - p_SC_S.cross(wrench_S.force));
  return wrench_C;
}

Wrench Mounting::to_sensor(const Wrench& wrench_C) const noexcept {
  const Mat3 R_SC = q_CS.toRotationMatrix().transpose();
  Wrench wrench_S;
  wrench_S.force = R_SC * wrench_C.force;
  wrench_S.torque = R_SC * wrench_C.torque + p_SC_S.cross(wrench_S.force);
  return wrench_S;
}

namespace {

std::uint8_t read_id(TomlReader& sensor, std::string_view key, std::uint8_t fallback) {
  const auto id = sensor.integer(key, fallback);
  if (id < 1 || id > 255) {
    sensor.fail(key, "not an identifier of this sensor family", "give one from 1 to 255");
    return fallback;
  }
  return static_cast<std::uint8_t>(id);
}

double read_positive(TomlReader& sensor, std::string_view key, double fallback) {
  const double value = sensor.number(key, fallback);
  if (value > 0.0) return value;
  sensor.fail(key, "not positive", "give a number above 0");
  return fallback;
}

void read_range(TomlReader& sensor, std::string_view key, int first, Vec6& range) {
  if (!sensor.has(key)) return;
  const Vec3 values = sensor.vec3(key);
  if (values.minCoeff() <= 0.0)
    sensor.fail(key, "a rating that is not positive", "give three numbers above 0");
  else
    range.segment<3>(first) = values;
}

Mounting read_mounting(TomlReader& sensor) {
  Mounting mounting;
  constexpr std::string_view kQuaternion = "quaternion_wxyz";
  const auto q = sensor.numbers(kQuaternion, 4, 4, false);
  if (!q.empty()) {
    const Quat turn(q[0], q[1], q[2], q[3]);
    if (turn.norm() < 1e-6)
      sensor.fail(kQuaternion, "a quaternion of length zero", "give w, x, y, z of a rotation");
    else
      mounting.q_CS = turn.normalized();
  }
  mounting.p_SC_S = sensor.vec3("contact_point_m", Vec3::Zero());
  return mounting;
}

void read_sensor(TomlReader& sensor, RftConfig& config, std::array<bool, kFingerCount>& seen) {
  const auto f = sensor.choice("finger", {"thumb", "index", "middle"});
  if (seen[f]) sensor.fail("finger", "the finger has two sensors", "give each finger once");
  seen[f] = true;
  RftSensorConfig& s = config.sensors[f];
  s.ids.command = read_id(sensor, "command_id", s.ids.command);
  s.ids.first = read_id(sensor, "first_id", s.ids.first);
  s.ids.second = read_id(sensor, "second_id", s.ids.second);
  if (s.ids.first >= s.ids.second)
    sensor.fail("second_id", "not above first_id: the bus could turn a pair of frames around",
                "program the sensor so that first_id is the smaller one");
  s.serial_number = sensor.text("serial_number", "");
  s.divisors.force_per_N = read_positive(sensor, "force_divisor", s.divisors.force_per_N);
  s.divisors.torque_per_Nm = read_positive(sensor, "torque_divisor", s.divisors.torque_per_Nm);
  read_range(sensor, "range_N", 0, s.range);
  read_range(sensor, "range_Nm", 3, s.range);
  s.mounting = read_mounting(sensor);
}

bool ids_differ(const RftConfig& config) {
  std::vector<int> ids;
  for (const auto& s : config.sensors)
    ids.insert(ids.end(), {s.ids.command, s.ids.first, s.ids.second});
  std::sort(ids.begin(), ids.end());
  return std::adjacent_find(ids.begin(), ids.end()) == ids.end();
}

}  // namespace

RftConfig RftConfig::standard() {
  RftConfig config;
  for (std::size_t f = 0; f < kFingerCount; ++f) config.sensors[f].ids = kRftIds[f];
  return config;
}

Result<RftConfig> RftConfig::parse(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-device-1");
  if (!root) return root.error();
  RftConfig config = standard();
  (void)root->choice("protocol", {"rft"});
  (void)root->text("name", "");
  config.filter_Hz = root->number("filter_Hz", config.filter_Hz);
  if (!rft_filter_code(config.filter_Hz))
    root->fail("filter_Hz", "the sensor has no such filter",
               "use 0 (none), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 or 1");
  config.filter_table = root->choice("filter_codes", {"manual", "header"}, 0) == 0
                            ? RftFilterTable::manual
                            : RftFilterTable::header;
  std::array<bool, kFingerCount> seen{};
  for (auto& sensor : root->tables("sensor")) read_sensor(sensor, config, seen);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (!seen[f])
      root->fail("sensor", "there is no sensor for the " + std::string(kFingerNames[f]),
                 "add a [[sensor]] with finger = \"" + std::string(kFingerNames[f]) + "\"");
  if (!ids_differ(config))
    root->fail("sensor", "two of the nine identifiers are the same", "make them all different");
  if (auto done = root->finish(); !done) return done.error();
  return config;
}

Result<RftConfig> RftConfig::read(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return parse(*text, path);
}

}  // namespace isograsp
