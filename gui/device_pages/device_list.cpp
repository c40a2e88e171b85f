// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/device_pages/device_list.hpp"

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <utility>

#include "device/config/uri.hpp"
#include "gui/device_pages/device_address.hpp"
#include "gui/library/session_library.hpp"
#include "session/open_apparatus.hpp"
#include "session/open_two_platforms.hpp"

namespace isograsp::gui {

namespace {

struct DeviceListTexts {
  Q_DECLARE_TR_FUNCTIONS(DeviceList)
};

std::string text(const QString& words) {
  return words.toStdString();
}

std::vector<DeviceChoice> sensors_on_can(const std::string& network_folder) {
  std::vector<DeviceChoice> choices;
  for (const auto& name : look_around(network_folder).can)
    choices.push_back(
        {text(DeviceListTexts::tr("Force sensors on %1").arg(QString::fromStdString(name))),
         "can://" + name + "?protocol=rft"});
  return choices;
}

/// Nothing whose name somebody has given.
void add_once(std::vector<DeviceChoice>& choices, DeviceChoice choice) {
  if (std::none_of(choices.begin(), choices.end(),
                   [&](const DeviceChoice& one) { return one.uri == choice.uri; }))
    choices.push_back(std::move(choice));
}

/// Of an address that is in no list: what people know of it.
std::string words_of_address(const std::string& uri) {
  const auto parsed = Uri::parse(uri);
  if (!parsed) return uri;
  const auto target = QString::fromStdString(parsed->target);
  if (parsed->scheme == "replay")
    return text(DeviceListTexts::tr("Recording %1").arg(target.section(QLatin1Char('/'), -1)));
  if (parsed->scheme == "sim") return text(DeviceListTexts::tr("Simulated: %1").arg(target));
  if (parsed->scheme == "qtm" || parsed->scheme == "natnet")
    return text(DeviceListTexts::tr("Cameras at %1").arg(target));
  if (parsed->scheme == "leap" || parsed->scheme == "udp-hand")
    return text(DeviceListTexts::tr("Tracked hand at %1").arg(target));
  return text(DeviceListTexts::tr("Force sensors on %1").arg(target));
}

std::vector<DeviceChoice> with_preset(std::vector<DeviceChoice> choices,
                                      const std::string& preset) {
  if (preset.empty()) return choices;
  const auto known = std::find_if(choices.begin(), choices.end(),
                                  [&](const DeviceChoice& c) { return c.uri == preset; });
  if (known == choices.end())
    choices.insert(choices.begin(), {words_of_address(preset), preset});
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

std::vector<DeviceChoice> list_platforms(const std::string& preset,
                                         const std::vector<NamedDevice>& added,
                                         const std::string& library,
                                         const std::string& network_folder) {
  std::vector<DeviceChoice> choices;
  for (const NamedDevice& device : added)
    if (session::kind_of_apparatus(device.uri) == kPlatform)
      choices.push_back({device.name, device.uri});
  for (auto& choice : sensors_on_can(network_folder)) add_once(choices, std::move(choice));
  for (const std::string& name : session::simulated_pairs(library))
    choices.push_back({text(words_of_pair(name)), "sim://pair?file=" + name + "&seed=7"});
  return with_preset(std::move(choices), preset);
}

std::vector<DeviceChoice> list_devices(const std::string& preset,
                                       const std::vector<NamedDevice>& added,
                                       const std::string& network_folder) {
  std::vector<DeviceChoice> choices;
  for (const NamedDevice& device : added) choices.push_back({device.name, device.uri});
  for (auto& choice : sensors_on_can(network_folder)) add_once(choices, std::move(choice));
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
  choices.push_back({text(DeviceListTexts::tr("Add a device …")), kAddDevice});
  return with_preset(std::move(choices), preset);
}

std::string recording_uri(const std::string& path) {
  return "replay://" + escaped_for_uri(path);
}

}  // namespace isograsp::gui
