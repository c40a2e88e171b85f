// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/device_config.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "device/config/family_facts.hpp"
#include "device/config/fir.hpp"
#include "device/config/read_keys.hpp"

namespace isograsp {

Wrench Mounting::to_contact(const Wrench& wrench_S) const noexcept {
  const Mat3 R_CS = q_CS.toRotationMatrix();
  Wrench wrench_C;
  wrench_C.force = sign * (R_CS * wrench_S.force);
  wrench_C.torque = sign * (R_CS * (wrench_S.torque - p_SC_S.cross(wrench_S.force)));
  return wrench_C;
}

Wrench Mounting::to_sensor(const Wrench& wrench_C) const noexcept {
  const Mat3 R_SC = q_CS.toRotationMatrix().transpose();
  Wrench wrench_S;
  wrench_S.force = sign * (R_SC * wrench_C.force);
  wrench_S.torque = sign * (R_SC * wrench_C.torque) + p_SC_S.cross(wrench_S.force);
  return wrench_S;
}

Wrench SensorConfig::corrected(const Wrench& wrench_S) const noexcept {
  if (!calibration) return wrench_S;
  Vec6 value;
  value << wrench_S.force, wrench_S.torque;
  value = calibration->matrix * value;
  return {value.head<3>(), value.tail<3>()};
}

namespace {

void read_range(TomlReader& sensor, std::string_view key, int first, Vec6& range) {
  if (!sensor.has(key)) return;
  const Vec3 values = sensor.vec3(key);
  if (values.minCoeff() <= 0.0)
    sensor.fail(key, "a rating that is not positive"_text, "give three numbers above 0"_text);
  else
    range.segment<3>(first) = values;
}

Mounting read_mounting(TomlReader& sensor) {
  Mounting mounting;
  constexpr std::string_view kQuaternion = "quaternion_wxyz";
  constexpr double kShortest = 1e-6;  // of a quaternion that still has a direction
  const auto q = sensor.numbers(kQuaternion, 4, 4, false);
  if (!q.empty()) {
    const Quat turn(q[0], q[1], q[2], q[3]);
    if (turn.norm() < kShortest)
      sensor.fail(kQuaternion, "a quaternion of length zero"_text,
                  "give w, x, y, z of a rotation"_text);
    else
      mounting.q_CS = turn.normalized();
  }
  mounting.p_SC_S = sensor.vec3("contact_point_m", Vec3::Zero());
  const auto sign = sensor.integer("sign", 1);
  if (sign != 1 && sign != -1) sensor.fail("sign", "neither 1 nor -1"_text, "give 1 or -1"_text);
  mounting.sign = sign < 0 ? -1.0 : 1.0;
  return mounting;
}

void read_support(TomlReader& sensor, Support& support) {
  support.p_PC = sensor.vec3("support_position_m", support.p_PC);
  if (!sensor.has("support_normal") && !sensor.has("support_tangent")) return;
  const Vec3 z = sensor.vec3("support_normal");
  const Vec3 tangent = sensor.vec3("support_tangent");
  constexpr double kParallel = 1e-6;  // below this the direction of the tangent is rounding
  if (z.norm() < kParallel || z.cross(tangent).norm() < kParallel * z.norm() * tangent.norm() ||
      tangent.norm() < kParallel) {
    sensor.fail("support_tangent", "normal and tangent do not span a plane"_text,
                "give two directions that are not parallel"_text);
    return;
  }
  const Vec3 n = z.normalized();
  const Vec3 x = (tangent - tangent.dot(n) * n).normalized();
  support.R_PC << x, n.cross(x), n;
}

std::optional<ClinicCalibration> read_calibration(TomlReader& sensor, const SensorConfig& config,
                                                  const std::string& file) {
  constexpr std::string_view kKey = "calibration_file";
  const std::string name = sensor.text(kKey, "");
  if (name.empty()) return std::nullopt;
  const auto path = (std::filesystem::path(file).parent_path() / name).string();
  auto calibration = ClinicCalibration::read(path);
  if (!calibration) {
    sensor.fail(kKey, words_of(calibration.error()), "correct or remove the calibration file"_text);
    return std::nullopt;
  }
  if (config.serial_number.empty())
    sensor.fail(kKey, "a calibration belongs to one sensor, and none is named here"_text,
                "give the sensor's serial_number too"_text);
  else if (calibration->serial_number != config.serial_number)
    sensor.fail(kKey,
                "the calibration was made with sensor %1, but this one is %2"_text(
                    calibration->serial_number, config.serial_number),
                "use the calibration of this sensor"_text);
  return *std::move(calibration);
}

/// All that must differ between sensors, in order.
std::vector<std::string> identities(const DeviceConfig& config) {
  std::vector<std::string> all;
  for (const auto& sensor : config.sensors)
    for (auto& one : config.family->identities(sensor)) all.push_back(std::move(one));
  std::sort(all.begin(), all.end());
  return all;
}

void read_sensor(TomlReader& sensor, DeviceConfig& config, const std::string& file,
                 std::array<bool, kFingerCount>& seen) {
  const auto f = sensor.choice("finger", {"thumb", "index", "middle"});
  if (seen[f])
    sensor.fail("finger", "the finger has two sensors"_text, "give each finger once"_text);
  seen[f] = true;
  SensorConfig& s = config.sensors[f];
  config.family->read_sensor(sensor, s);
  s.serial_number = sensor.text("serial_number", "");
  read_range(sensor, "range_N", 0, s.range);
  read_range(sensor, "range_Nm", 3, s.range);
  s.mounting = read_mounting(sensor);
  read_support(sensor, config.platform.supports[f]);
  s.calibration = read_calibration(sensor, s, file);
}

void read_sampling(TomlReader& root, DeviceConfig& config) {
  const FamilyFacts& family = *config.family;
  config.rate_Hz = root.number("rate_Hz", config.rate_Hz);
  if (!family.has_rate(config.rate_Hz))
    root.fail("rate_Hz", "the sensors have no such rate"_text, family.rate_remedy);
  config.filter_Hz = root.number("filter_Hz", config.filter_Hz);
  if (!family.has_filter(config.filter_Hz))
    root.fail("filter_Hz", "the sensor has no such filter"_text, family.filter_remedy);
  config.fir_cutoff_Hz = read_positive(root, "fir_cutoff_Hz", config.fir_cutoff_Hz);
  config.fir_taps = static_cast<int>(
      std::clamp<std::int64_t>(root.integer("fir_taps", 0), -1, std::numeric_limits<int>::max()));
  if (config.fir_taps != 0 && config.rate_Hz > 0.0)
    if (const auto fir = design_fir(config.fir_taps, config.rate_Hz, config.fir_cutoff_Hz); !fir)
      root.fail("fir_taps", fir.error().what, fir.error().remedy);
  if (family.read_device != nullptr) family.read_device(root, config);
}

}  // namespace

Result<ClinicCalibration> ClinicCalibration::read(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  auto root = TomlReader::parse(*text, path, "isograsp-calibration-1");
  if (!root) return root.error();
  ClinicCalibration out;
  out.file = path;
  out.serial_number = root->text("serial_number");
  out.date = root->text("date");
  constexpr std::array<std::string_view, 6> kRows{"fx", "fy", "fz", "tx", "ty", "tz"};
  for (int row = 0; row < 6; ++row) {
    const auto key = kRows[static_cast<std::size_t>(row)];
    const auto values = root->numbers(key, 6, 6);
    if (values.size() != 6) continue;
    for (int column = 0; column < 6; ++column)
      out.matrix(row, column) = values[static_cast<std::size_t>(column)];
    // A correction changes values by some per cent. A factor of 2 or 1/2 shows another kind of
    // matrix.
    constexpr double kLargest = 2.0;
    const double own = out.matrix(row, row);
    if (!(own >= 1.0 / kLargest && own <= kLargest))
      root->fail(key, "its own factor is not between 0.5 and 2: this is no correction"_text,
                 "give true wrench = matrix * sensor's wrench, both in N and N m"_text);
  }
  if (auto done = root->finish(); !done) return done.error();
  return out;
}

DeviceConfig DeviceConfig::standard(const FamilyFacts& family) {
  DeviceConfig config;
  config.family = &family;
  config.filter_Hz = family.filter_Hz;
  for (std::size_t f = 0; f < kFingerCount; ++f) config.sensors[f] = family.standard(f);
  return config;
}

Result<DeviceConfig> DeviceConfig::parse(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-device-1");
  if (!root) return root.error();
  std::vector<std::string_view> names;
  for (const FamilyFacts* family : all_families()) names.push_back(family->name);
  DeviceConfig config = standard(*all_families()[root->choice("protocol", names)]);
  config.name = root->text("name", "");
  config.interface = root->text("interface", "");
  const auto hand = root->choice("hand", {"right", "left", "both"}, 2);
  if (hand < 2) config.hand = hand == 0 ? Hand::right : Hand::left;
  read_sampling(*root, config);
  std::array<bool, kFingerCount> seen{};
  for (auto& sensor : root->tables("sensor")) read_sensor(sensor, config, file, seen);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (!seen[f])
      root->fail("sensor",
                 "there is no sensor for the %1"_text(Known{std::string(kFingerNames[f])}),
                 "add a [[sensor]] with finger = \"%1\""_text(kFingerNames[f]));
  const auto ids = identities(config);
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
    root->fail("sensor", "two sensors share an identifier or address"_text,
               "make them all different"_text);
  if (auto done = root->finish(); !done) return done.error();
  return config;
}

Result<DeviceConfig> DeviceConfig::read(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return parse(*text, path);
}

}  // namespace isograsp
