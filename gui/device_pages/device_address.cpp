// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/device_pages/device_address.hpp"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <filesystem>
#include <fstream>

#include "device/config/family_facts.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

struct DeviceAddressTexts {
  Q_DECLARE_TR_FUNCTIONS(DeviceAddress)
};

constexpr int kSensors = 3;
constexpr const char* kHere = "127.0.0.1";
constexpr const char* kScriptPort = "6440";

/// Of the URI.
std::string scheme_of(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::can: return "can";
    case DeviceKind::network: return "udp";
    case DeviceKind::serial: return "serial";
    case DeviceKind::qualisys: return "qtm";
    case DeviceKind::motive: return "natnet";
    case DeviceKind::leap: return "leap";
    case DeviceKind::script: return "udp-hand";
  }
  return {};
}

QStringList parts_of(const std::string& where) {
  QStringList parts;
  for (const QString& part : QString::fromStdString(where).split(QLatin1Char(',')))
    if (!part.trimmed().isEmpty()) parts << part.trimmed();
  return parts;
}

/// "192.168.1.1" as that and the two behind it; empty: it has none behind it.
QStringList three_in_a_row(const QString& first) {
  const int dot = first.lastIndexOf(QLatin1Char('.'));
  bool number = false;
  const int last = first.mid(dot + 1).toInt(&number);
  constexpr int kLargest = 255;
  if (dot < 0 || !number || last + kSensors - 1 > kLargest) return {};
  QStringList three;
  for (int i = 0; i < kSensors; ++i) three << first.left(dot + 1) + QString::number(last + i);
  return three;
}

/// Three of them, or nothing.
std::string target_of_forces(const DeviceDraft& draft) {
  QStringList parts = parts_of(draft.where);
  if (draft.kind == DeviceKind::can) return parts.size() == 1 ? parts.front().toStdString() : "";
  if (draft.kind == DeviceKind::network && parts.size() == 1) parts = three_in_a_row(parts.front());
  return parts.size() == kSensors ? parts.join(QLatin1Char(',')).toStdString() : "";
}

std::vector<std::string> names_in(const fs::path& folder, const char* prefix) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with(prefix)) names.push_back(entry.path());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

QString words_of(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::can: return DeviceAddressTexts::tr("Force sensors on a CAN bus");
    case DeviceKind::network: return DeviceAddressTexts::tr("Force sensors in the network");
    case DeviceKind::serial: return DeviceAddressTexts::tr("Force sensors on serial lines");
    case DeviceKind::qualisys: return DeviceAddressTexts::tr("Cameras: Qualisys Track Manager");
    case DeviceKind::motive: return DeviceAddressTexts::tr("Cameras: OptiTrack Motive");
    case DeviceKind::leap: return DeviceAddressTexts::tr("Tracked hand: Leap service");
    case DeviceKind::script: return DeviceAddressTexts::tr("Tracked hand: a script that sends it");
  }
  return {};
}

bool is_force(DeviceKind kind) noexcept {
  return kind == DeviceKind::can || kind == DeviceKind::network || kind == DeviceKind::serial;
}

bool is_cameras(DeviceKind kind) noexcept {
  return kind == DeviceKind::qualisys || kind == DeviceKind::motive;
}

std::vector<FamilyChoice> families_of(DeviceKind kind) {
  std::vector<FamilyChoice> choices;
  if (!is_force(kind)) return choices;
  for (const FamilyFacts* family : all_families())
    for (const FamilyBus& bus : family->buses)
      if (bus.scheme == scheme_of(kind) && !bus.devices.empty())
        choices.push_back({std::string(family->name), std::string(family->title)});
  return choices;
}

std::string uri_of(const DeviceDraft& draft) {
  const std::string scheme = scheme_of(draft.kind) + "://";
  if (is_force(draft.kind)) {
    const std::string target = target_of_forces(draft);
    if (target.empty() || draft.family.empty()) return {};
    const std::string uri = scheme + escaped_for_uri(target) + "?protocol=" + draft.family;
    return draft.setup.empty() ? uri : uri + "&config=" + escaped_for_uri(draft.setup);
  }
  const QStringList parts = parts_of(draft.where);
  if (parts.size() != 1) return {};
  const std::string host = escaped_for_uri(parts.front().toStdString());
  if (is_cameras(draft.kind))
    return draft.rig.empty() ? "" : scheme + host + "?rig=" + escaped_for_uri(draft.rig);
  return scheme + host;
}

Surroundings look_around(const std::string& network_folder, const std::string& device_folder) {
  constexpr int kCan = 280;  // ARPHRD_CAN of <linux/if_arp.h>, as /sys/class/net/*/type prints it
  Surroundings here;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(network_folder, ignored)) {
    int type = 0;
    if (std::ifstream(entry.path() / "type") >> type && type == kCan)
      here.can.push_back(entry.path().filename());
  }
  std::sort(here.can.begin(), here.can.end());
  const fs::path devices = device_folder;
  here.serial_ports = names_in(devices / "serial" / "by-id", "");
  if (here.serial_ports.empty())
    for (const char* const prefix : {"ttyUSB", "ttyACM"})
      for (auto& name : names_in(devices, prefix)) here.serial_ports.push_back(std::move(name));
  return here;
}

std::vector<std::string> toml_files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> rigs_in(const std::string& library) {
  std::vector<std::string> names;
  for (const auto& file : toml_files_in(library + "/rigs")) names.push_back(fs::path(file).stem());
  return names;
}

std::vector<DeviceDraft> candidates(const DeviceDraft& draft, const Surroundings& here) {
  std::vector<std::string> places;
  if (!draft.where.empty()) {
    places = {draft.where};
  } else if (draft.kind == DeviceKind::can) {
    places = here.can;
  } else if (draft.kind == DeviceKind::serial) {
    std::string three;
    for (std::size_t i = 0; i < kSensors && i < here.serial_ports.size(); ++i)
      three += (i == 0 ? "" : ",") + here.serial_ports[i];
    places = {three};
  } else if (draft.kind == DeviceKind::script) {
    places = {std::string(kHere) + ":" + kScriptPort};
  } else if (draft.kind != DeviceKind::network) {
    places = {kHere};
  }
  auto families = families_of(draft.kind);
  if (families.empty()) families.emplace_back();  // it has none
  std::vector<DeviceDraft> all;
  for (const auto& place : places)
    for (const auto& family : families) {
      DeviceDraft one = draft;
      one.where = place;
      one.family = family.name;
      if (one.family != draft.family) one.setup.clear();  // it is that of another family
      if (!uri_of(one).empty()) all.push_back(std::move(one));
    }
  return all;
}

std::string escaped_for_uri(const std::string& text) {
  std::string escaped;
  for (const char c : text)
    escaped += c == '%' ? "%25" : c == '?' ? "%3F" : c == '&' ? "%26" : std::string(1, c);
  return escaped;
}

}  // namespace isograsp::gui
