// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/device_config.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <vector>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "device/codec/net_ft_box_config.hpp"
#include "device/config/fir.hpp"

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

std::uint8_t read_id(TomlReader& sensor, std::string_view key, std::int64_t fallback,
                     std::int64_t least, std::int64_t most) {
  const auto id = sensor.integer(key, fallback);
  if (id >= least && id <= most) return static_cast<std::uint8_t>(id);
  sensor.fail(key, "not an identifier of this sensor family",
              "give one from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<std::uint8_t>(fallback);
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
  constexpr double kShortest = 1e-6;  // of a quaternion that still has a direction
  const auto q = sensor.numbers(kQuaternion, 4, 4, false);
  if (!q.empty()) {
    const Quat turn(q[0], q[1], q[2], q[3]);
    if (turn.norm() < kShortest)
      sensor.fail(kQuaternion, "a quaternion of length zero", "give w, x, y, z of a rotation");
    else
      mounting.q_CS = turn.normalized();
  }
  mounting.p_SC_S = sensor.vec3("contact_point_m", Vec3::Zero());
  const auto sign = sensor.integer("sign", 1);
  if (sign != 1 && sign != -1) sensor.fail("sign", "neither 1 nor -1", "give 1 or -1");
  mounting.sign = sign < 0 ? -1.0 : 1.0;
  return mounting;
}

void read_support(TomlReader& sensor, Support& support) {
  support.p_PC = sensor.vec3("support_position_m", support.p_PC);
  if (!sensor.has("support_normal") && !sensor.has("support_tangent")) return;
  const Vec3 z = sensor.vec3("support_normal");
  const Vec3 tangent = sensor.vec3("support_tangent");
  constexpr double kParallel = 1e-6;  // below this the tangent says nothing
  if (z.norm() < kParallel || z.cross(tangent).norm() < kParallel * z.norm() * tangent.norm() ||
      tangent.norm() < kParallel) {
    sensor.fail("support_tangent", "normal and tangent do not span a plane",
                "give two directions that are not parallel");
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
    sensor.fail(kKey, calibration.error().message(), "correct or remove the calibration file");
    return std::nullopt;
  }
  if (config.serial_number.empty())
    sensor.fail(kKey, "a calibration belongs to one sensor, and none is named here",
                "give the sensor's serial_number too");
  else if (calibration->serial_number != config.serial_number)
    sensor.fail(kKey,
                "the calibration was made with sensor " + calibration->serial_number +
                    ", but this one is " + config.serial_number,
                "use the calibration of this sensor");
  return *std::move(calibration);
}

// The keys of each protocol.

struct WayReader {
  TomlReader& sensor;

  void operator()(RftSensor& s) const {
    constexpr std::int64_t kLargest = 255;
    s.ids.command = read_id(sensor, "command_id", s.ids.command, 1, kLargest);
    s.ids.first = read_id(sensor, "first_id", s.ids.first, 1, kLargest);
    s.ids.second = read_id(sensor, "second_id", s.ids.second, 1, kLargest);
    if (s.ids.first >= s.ids.second)
      sensor.fail("second_id", "not above first_id: the bus could turn a pair of frames around",
                  "program the sensor so that first_id is the smaller one");
    s.divisors.force_per_N = read_positive(sensor, "force_divisor", s.divisors.force_per_N);
    s.divisors.torque_per_Nm = read_positive(sensor, "torque_divisor", s.divisors.torque_per_Nm);
    s.address = sensor.text("address", "");
  }
  void operator()(AtiSensor& s) const {
    s.base = read_id(sensor, "base_id", s.base, 1, 0x7F);
    s.calibration = read_id(sensor, "calibration_slot", s.calibration, 0, 15);
  }
  void operator()(Jr3Sensor& s) const { s.node = read_id(sensor, "node", s.node, 1, 127); }
  void operator()(NetFtSensor& s) const {
    s.host = sensor.text("address", s.host);
    if (!NetFtAddress::parse(s.host))
      sensor.fail("address", "not an address in numbers", "write it as 192.168.1.1");
  }
  void operator()(Jr3ComediSensor& s) const {
    s.subdevice = read_id(sensor, "subdevice", s.subdevice, 0, 3);
  }
};

/// All that must differ between sensors, in order.
std::vector<std::string> identities(const DeviceConfig& config) {
  std::vector<std::string> all;
  const auto add = [&](auto value) { all.push_back(std::to_string(value)); };
  for (const auto& sensor : config.sensors) {
    if (const auto* rft = std::get_if<RftSensor>(&sensor.way)) {
      for (const auto id : {rft->ids.command, rft->ids.first, rft->ids.second}) add(id);
      if (!rft->address.empty()) all.push_back(rft->address);
    } else if (const auto* ati = std::get_if<AtiSensor>(&sensor.way)) {
      add(ati->base);
    } else if (const auto* jr3 = std::get_if<Jr3Sensor>(&sensor.way)) {
      add(jr3->node);
    } else if (const auto* box = std::get_if<NetFtSensor>(&sensor.way)) {
      all.push_back(box->host);
    } else {
      add(std::get<Jr3ComediSensor>(sensor.way).subdevice);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

void read_sensor(TomlReader& sensor, DeviceConfig& config, const std::string& file,
                 std::array<bool, kFingerCount>& seen) {
  const auto f = sensor.choice("finger", {"thumb", "index", "middle"});
  if (seen[f]) sensor.fail("finger", "the finger has two sensors", "give each finger once");
  seen[f] = true;
  SensorConfig& s = config.sensors[f];
  std::visit(WayReader{sensor}, s.way);
  s.serial_number = sensor.text("serial_number", "");
  if (config.protocol == Protocol::jr3_can && !s.serial_number.empty())
    sensor.fail("serial_number", "this adaptor tells no serial number: nothing could be compared",
                "leave it out; the guided check finds exchanged sensors");
  read_range(sensor, "range_N", 0, s.range);
  read_range(sensor, "range_Nm", 3, s.range);
  s.mounting = read_mounting(sensor);
  read_support(sensor, config.platform.supports[f]);
  s.calibration = read_calibration(sensor, s, file);
}

bool filter_exists(const DeviceConfig& config) {
  constexpr double kLargestJr3_Hz = 655.35;  // 16 bits of 0.01 Hz
  constexpr std::array<double, 7> kJr3Pci_Hz{0, 500, 125, 31.25, 7.8125, 1.953125, 0.48828125};
  switch (config.protocol) {
    case Protocol::rft: return rft_filter_code(config.filter_Hz).has_value();
    case Protocol::jr3_can: return config.filter_Hz >= 0.0 && config.filter_Hz <= kLargestJr3_Hz;
    case Protocol::jr3_comedi:
      return std::find(kJr3Pci_Hz.begin(), kJr3Pci_Hz.end(), config.filter_Hz) != kJr3Pci_Hz.end();
    case Protocol::ati_netcanoem:
    case Protocol::net_ft: return config.filter_Hz == 0.0;
  }
  return false;
}

std::string_view filters_of(Protocol protocol) {
  switch (protocol) {
    case Protocol::rft:
      return "use 0 (none), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 or 1";
    case Protocol::jr3_can: return "use 0 (none) to 655.35";
    case Protocol::jr3_comedi:
      return "use 0 (none), 500, 125, 31.25, 7.8125, 1.953125 or 0.48828125";
    case Protocol::ati_netcanoem:
      return "this board has none: leave filter_Hz out and use fir_taps";
    case Protocol::net_ft: return "set it in the box's web page, leave filter_Hz out";
  }
  return "";
}

void read_sampling(TomlReader& root, DeviceConfig& config) {
  constexpr double kSlowestSensor_Hz = 10.0;
  constexpr double kMostRate_Hz = 1000.0;
  config.rate_Hz = root.number("rate_Hz", config.rate_Hz);
  if (!(config.rate_Hz >= kSlowestSensor_Hz && config.rate_Hz <= kMostRate_Hz) ||
      (config.protocol == Protocol::rft && !rft_rate_code(config.rate_Hz)))
    root.fail("rate_Hz", "the sensors have no such rate",
              config.protocol == Protocol::rft ? "use 10, 20, 50, 100, 200, 333, 500 or 1000"
                                               : "use 10 to 1000");
  config.filter_Hz = root.number("filter_Hz", config.filter_Hz);
  if (!filter_exists(config))
    root.fail("filter_Hz", "the sensor has no such filter",
              std::string(filters_of(config.protocol)));
  config.fir_cutoff_Hz = read_positive(root, "fir_cutoff_Hz", config.fir_cutoff_Hz);
  config.fir_taps = static_cast<int>(
      std::clamp<std::int64_t>(root.integer("fir_taps", 0), -1, std::numeric_limits<int>::max()));
  if (config.fir_taps != 0 && config.rate_Hz > 0.0)
    if (const auto fir = design_fir(config.fir_taps, config.rate_Hz, config.fir_cutoff_Hz); !fir)
      root.fail("fir_taps", fir.error().what, fir.error().remedy);
  if (config.protocol == Protocol::rft) {
    config.filter_table = root.choice("filter_codes", {"manual", "header"}, 0) == 0
                              ? RftFilterTable::manual
                              : RftFilterTable::header;
    constexpr std::array<std::int64_t, 5> kBauds{57600, 115200, 230400, 460800, 921600};
    const auto baud = root.integer("baud", config.baud);
    if (std::find(kBauds.begin(), kBauds.end(), baud) == kBauds.end())
      root.fail("baud", "the sensors have no such speed",
                "use 57600, 115200, 230400, 460800 or 921600");
    else
      config.baud = static_cast<unsigned>(baud);
  }
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
    // A correction corrects by per cents. Twice as much or half is a matrix of another kind.
    constexpr double kLargest = 2.0;
    const double own = out.matrix(row, row);
    if (!(own >= 1.0 / kLargest && own <= kLargest))
      root->fail(key, "its own factor is not between 0.5 and 2: this is no correction",
                 "give true wrench = matrix * sensor's wrench, both in N and N m");
  }
  if (auto done = root->finish(); !done) return done.error();
  return out;
}

std::string_view title_of(Protocol protocol) noexcept {
  constexpr std::array<std::string_view, 5> kTitles{
      "Robotous RFT", "ATI NETCANOEM", "JR3 with CAN adaptor", "ATI Net F/T", "JR3 PCI"};
  return kTitles[static_cast<std::size_t>(protocol)];
}

std::optional<Protocol> protocol_from_name(std::string_view name) noexcept {
  const auto found = std::find(kProtocolNames.begin(), kProtocolNames.end(), name);
  if (found == kProtocolNames.end()) return std::nullopt;
  return static_cast<Protocol>(found - kProtocolNames.begin());
}

DeviceConfig DeviceConfig::standard(Protocol protocol) {
  constexpr double kJr3Filter_Hz = 31.25;  // the paper's
  DeviceConfig config;
  config.protocol = protocol;
  config.filter_Hz = 0.0;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    SensorConfig& s = config.sensors[f];
    const auto number = static_cast<std::uint8_t>(f);
    switch (protocol) {
      case Protocol::rft:
        s.way = RftSensor{kRftIds[f], "", {}};
        config.filter_Hz = 30.0;
        break;
      case Protocol::ati_netcanoem:
        s.way = AtiSensor{static_cast<std::uint8_t>(0x20 + number), 0};
        s.range << 145, 145, 290, 5, 5, 5;
        break;
      case Protocol::jr3_can: s.way = Jr3Sensor{static_cast<std::uint8_t>(1 + number)}; break;
      case Protocol::net_ft:
        s.way = NetFtSensor{"192.168.1." + std::to_string(1 + number)};
        s.range << 145, 145, 290, 5, 5, 5;
        break;
      case Protocol::jr3_comedi: s.way = Jr3ComediSensor{number}; break;
    }
    if (protocol == Protocol::jr3_can || protocol == Protocol::jr3_comedi) {
      s.range << 150, 150, 300, 8, 8, 8;
      config.filter_Hz = kJr3Filter_Hz;
    }
  }
  return config;
}

Result<DeviceConfig> DeviceConfig::parse(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-device-1");
  if (!root) return root.error();
  const auto protocol = static_cast<Protocol>(
      root->choice("protocol", {"rft", "ati-netcanoem", "jr3-can", "net-ft", "jr3-comedi"}));
  DeviceConfig config = standard(protocol);
  config.name = root->text("name", "");
  config.interface = root->text("interface", "");
  const auto hand = root->choice("hand", {"right", "left", "both"}, 2);
  if (hand < 2) config.hand = hand == 0 ? Hand::right : Hand::left;
  read_sampling(*root, config);
  std::array<bool, kFingerCount> seen{};
  for (auto& sensor : root->tables("sensor")) read_sensor(sensor, config, file, seen);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (!seen[f])
      root->fail("sensor", "there is no sensor for the " + std::string(kFingerNames[f]),
                 "add a [[sensor]] with finger = \"" + std::string(kFingerNames[f]) + "\"");
  const auto ids = identities(config);
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
    root->fail("sensor", "two sensors share an identifier or address", "make them all different");
  if (auto done = root->finish(); !done) return done.error();
  return config;
}

Result<DeviceConfig> DeviceConfig::read(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return parse(*text, path);
}

}  // namespace isograsp
