// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/device_list.hpp"

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

#include "session/open_two_platforms.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

struct DeviceListTexts {
  Q_DECLARE_TR_FUNCTIONS(DeviceList)
};

std::string text(const QString& words) {
  return words.toStdString();
}

std::vector<std::string> can_interfaces(const std::string& network_folder) {
  constexpr int kCan = 280;  // ARPHRD_CAN of <linux/if_arp.h>, as /sys/class/net/*/type prints it
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(network_folder, ignored)) {
    int type = 0;
    if (std::ifstream(entry.path() / "type") >> type && type == kCan)
      names.push_back(entry.path().filename());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<DeviceChoice> sensors_on_can(const std::string& network_folder) {
  std::vector<DeviceChoice> choices;
  for (const auto& name : can_interfaces(network_folder))
    choices.push_back(
        {text(DeviceListTexts::tr("Force sensors on %1").arg(QString::fromStdString(name))),
         "can://" + name + "?protocol=rft"});
  return choices;
}

std::vector<DeviceChoice> with_preset(std::vector<DeviceChoice> choices,
                                      const std::string& preset) {
  if (preset.empty()) return choices;
  const auto known = std::find_if(choices.begin(), choices.end(),
                                  [&](const DeviceChoice& c) { return c.uri == preset; });
  if (known == choices.end())
    choices.insert(choices.begin(), {preset, preset});
  else
    std::rotate(choices.begin(), known, known + 1);
  return choices;
}

/// Of a person in software, by the name of its file.
QString words_of_pair(const std::string& name) {
  if (name == "healthy") return DeviceListTexts::tr("Simulated, both healthy");
  if (name == "paretic_left") return DeviceListTexts::tr("Simulated, left hand paretic");
  if (name == "paretic_right") return DeviceListTexts::tr("Simulated, right hand paretic");
  return DeviceListTexts::tr("Simulated: %1").arg(QString::fromStdString(name));
}

}  // namespace

std::vector<DeviceChoice> list_platforms(const std::string& preset, const std::string& library,
                                         const std::string& network_folder) {
  std::vector<DeviceChoice> choices = sensors_on_can(network_folder);
  for (const std::string& name : session::simulated_pairs(library))
    choices.push_back({text(words_of_pair(name)), "sim://pair?file=" + name + "&seed=7"});
  return with_preset(std::move(choices), preset);
}

std::vector<DeviceChoice> list_devices(const std::string& preset,
                                       const std::string& network_folder) {
  std::vector<DeviceChoice> choices = sensors_on_can(network_folder);
  choices.push_back(
      {text(DeviceListTexts::tr("Simulated patient, healthy")), "sim://healthy?seed=7"});
  choices.push_back(
      {text(DeviceListTexts::tr("Simulated patient, paretic")), "sim://paretic?seed=7"});
  choices.push_back({text(DeviceListTexts::tr("A recording …")), kAskRecording});
  choices.push_back({text(DeviceListTexts::tr("Arm, seen by cameras …")), kAskCameras});
  choices.push_back(
      {text(DeviceListTexts::tr("Simulated arm, healthy")), "sim://arm?patient=healthy&seed=7"});
  choices.push_back(
      {text(DeviceListTexts::tr("Simulated arm, paretic")), "sim://arm?patient=paretic&seed=7"});
  choices.push_back(
      {text(DeviceListTexts::tr("Hand, by the Leap service here")), "leap://127.0.0.1"});
  choices.push_back(
      {text(DeviceListTexts::tr("Hand, by a script here")), "udp-hand://127.0.0.1:6440"});
  choices.push_back({text(DeviceListTexts::tr("Simulated tracked hand, healthy")),
                     "sim://hand?user=healthy&seed=7"});
  choices.push_back({text(DeviceListTexts::tr("Simulated tracked hand, paretic")),
                     "sim://hand?user=paretic&seed=7"});
  return with_preset(std::move(choices), preset);
}

std::string recording_uri(const std::string& path) {
  constexpr std::array<char, 16> kHex{'0', '1', '2', '3', '4', '5', '6', '7',
                                      '8', '9', 'A', 'B', 'C', 'D', 'E', 'F'};
  std::string uri = "replay://";
  for (const char c : path) {
    if (c == '%' || c == '?') {
      const auto byte = static_cast<unsigned char>(c);
      uri += '%';
      uri += kHex[byte / 16];
      uri += kHex[byte % 16];
    } else {
      uri += c;
    }
  }
  return uri;
}

}  // namespace isograsp::gui
