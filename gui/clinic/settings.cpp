// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/settings.hpp"

#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

namespace isograsp::gui {

namespace {

// Keys of the file; a unit stands in the name.
constexpr const char* kLanguage = "language";
constexpr const char* kOperator = "operator";
constexpr const char* kFont = "font_percent";
constexpr const char* kPatientScreen = "patient/display";
constexpr const char* kDistance = "patient/viewing_distance_m";
constexpr const char* kHeight = "patient/picture_height_m";
constexpr const char* kDelay = "patient/display_delay_s";
constexpr const char* kVolume = "sound/volume_percent";
constexpr const char* kDevices = "devices";
constexpr const char* kDeviceName = "name";
constexpr const char* kDeviceAddress = "address";
constexpr const char* kShare = "live_grip_in_percent_of_maximum";

/// Reads numbers and says what was wrong with them.
class Reader {
 public:
  Reader(const QSettings& file, QStringList& problems) : file_(file), problems_(problems) {}

  std::optional<double> number(const char* key, double least, double most) {
    if (!file_.contains(key)) return std::nullopt;
    bool good = false;
    const auto text = file_.value(key).toString();
    const double value = text.toDouble(&good);
    if (good && value >= least && value <= most) return value;
    problems_ += SettingsFile::tr(
                     "%1: %2 = \"%3\" is not a number from %4 to %5; it counts as "
                     "not set. Correct it in the settings.")
                     .arg(file_.fileName(), QLatin1String(key), text)
                     .arg(least)
                     .arg(most);
    return std::nullopt;
  }

 private:
  const QSettings& file_;
  QStringList& problems_;
};

std::vector<NamedDevice> read_devices(QSettings& file, QStringList& problems) {
  std::vector<NamedDevice> devices;
  const int count = file.beginReadArray(kDevices);
  for (int i = 0; i < std::min(count, limits::kMostDevices); ++i) {
    file.setArrayIndex(i);
    const NamedDevice device{file.value(kDeviceName).toString().toStdString(),
                             file.value(kDeviceAddress).toString().toStdString()};
    if (!device.name.empty() && !device.uri.empty()) devices.push_back(device);
  }
  file.endArray();
  if (const int left_out = count - static_cast<int>(devices.size()); left_out > 0)
    problems += SettingsFile::tr(
                    "%1: %2 devices are left out: without a name or an address, or behind the "
                    "first %3. Add them again in a session.")
                    .arg(file.fileName())
                    .arg(left_out)
                    .arg(limits::kMostDevices);
  return devices;
}

void write(QSettings& file, const std::vector<NamedDevice>& devices) {
  file.remove(kDevices);
  file.beginWriteArray(kDevices, static_cast<int>(devices.size()));
  for (int i = 0; i < static_cast<int>(devices.size()); ++i) {
    file.setArrayIndex(i);
    file.setValue(kDeviceName, QString::fromStdString(devices[static_cast<std::size_t>(i)].name));
    file.setValue(kDeviceAddress, QString::fromStdString(devices[static_cast<std::size_t>(i)].uri));
  }
  file.endArray();
}

void write(QSettings& file, const char* key, const std::optional<double>& value) {
  if (value)
    file.setValue(key, *value);
  else
    file.remove(key);
}

}  // namespace

SettingsFile::SettingsFile(const QString& path, QObject* parent) : QObject(parent), path_(path) {
  if (!path_.isEmpty()) read();
}

QString SettingsFile::usual_path() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
         QStringLiteral("/isograsp.ini");
}

void SettingsFile::read() {
  QSettings file(path_, QSettings::IniFormat);
  if (file.status() == QSettings::FormatError)
    problems_ += tr("%1 is not a settings file; everything is as at first. Set it anew, or remove "
                    "the file.")
                     .arg(path_);
  Reader reader(file, problems_);
  const Settings usual;
  now_.language = file.value(kLanguage, languages::kDesktopLanguage).toString().toStdString();
  now_.operator_name = file.value(kOperator).toString().toStdString();
  now_.patient_screen = file.value(kPatientScreen).toString().toStdString();
  now_.font_percent = static_cast<int>(
      reader.number(kFont, limits::kSmallestFont_percent, limits::kLargestFont_percent)
          .value_or(usual.font_percent));
  now_.viewing_distance_m = reader.number(kDistance, limits::kNearest_m, limits::kFarthest_m)
                                .value_or(usual.viewing_distance_m);
  now_.screen_height_m = reader.number(kHeight, limits::kLowestScreen_m, limits::kHighestScreen_m);
  now_.display_delay_s = reader.number(kDelay, 0.0, limits::kLongestDelay_s);
  now_.volume_percent =
      static_cast<int>(reader.number(kVolume, 0, 100).value_or(usual.volume_percent));
  now_.devices = read_devices(file, problems_);
  now_.share_of_maximum = file.value(kShare, usual.share_of_maximum).toBool();
}

void SettingsFile::change(const Settings& settings) {
  if (settings == now_) return;
  now_ = settings;
  if (path_.isEmpty()) return Q_EMIT changed();
  QSettings file(path_, QSettings::IniFormat);
  file.setValue(kLanguage, QString::fromStdString(now_.language));
  file.setValue(kOperator, QString::fromStdString(now_.operator_name));
  file.setValue(kFont, now_.font_percent);
  file.setValue(kPatientScreen, QString::fromStdString(now_.patient_screen));
  file.setValue(kDistance, now_.viewing_distance_m);
  write(file, kHeight, now_.screen_height_m);
  write(file, kDelay, now_.display_delay_s);
  file.setValue(kVolume, now_.volume_percent);
  file.setValue(kShare, now_.share_of_maximum);
  write(file, now_.devices);
  file.sync();
  Q_EMIT changed();
  if (file.status() != QSettings::NoError)
    Q_EMIT failed(tr("The settings could not be written to %1: they hold until the program ends.")
                      .arg(path_));
}

}  // namespace isograsp::gui
