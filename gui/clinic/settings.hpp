// SPDX-License-Identifier: GPL-3.0-or-later
// What this workstation is set to: its screens, language, letters, sounds. Nothing of a patient.
// Kept in a small file that a person can read. GUI thread.
#pragma once

#include <QObject>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "gui/words/language.hpp"

namespace isograsp::gui {

/// A device that somebody has added.
struct NamedDevice {
  std::string name;  ///< "Room 2"
  std::string uri;
  bool operator==(const NamedDevice&) const = default;
};

struct Settings {
  std::string language = languages::kDesktopLanguage;
  std::string operator_name;   ///< who works here, where nobody logs in; stored with sessions
  int font_percent = 100;      ///< of the usual letters of the therapist's window
  std::string patient_screen;  ///< name of the display; empty: the second one
  double viewing_distance_m = 0.6;
  /// Height of the picture on the patient's display; nothing: as the display tells.
  std::optional<double> screen_height_m;
  /// From the picture's hand-over to the light, by photodiode or camera; nothing: not measured.
  std::optional<double> display_delay_s;
  int volume_percent = 50;
  std::vector<NamedDevice> devices;  ///< in the order in which they were added
  bool share_of_maximum = false;     ///< the live grip also in % of today's maximum

  friend bool operator==(const Settings&, const Settings&) = default;
};

namespace limits {
inline constexpr int kSmallestFont_percent = 100;
inline constexpr int kLargestFont_percent = 200;
inline constexpr double kNearest_m = 0.2;
inline constexpr double kFarthest_m = 5.0;
inline constexpr double kLowestScreen_m = 0.05;
inline constexpr double kHighestScreen_m = 3.0;
inline constexpr double kLongestDelay_s = 0.5;
inline constexpr int kMostDevices = 100;  ///< more than a workstation has; a file may say anything
}  // namespace limits

class SettingsFile final : public QObject {
  Q_OBJECT

 public:
  /// Reads `path` (INI); a file that is not there is as good as an empty one. No path: nothing is
  /// read or kept.
  explicit SettingsFile(const QString& path, QObject* parent = nullptr);
  /// Of the user who is logged in.
  [[nodiscard]] static QString usual_path();

  [[nodiscard]] const Settings& now() const noexcept { return now_; }
  /// Entries that make no sense, each in a sentence with what is used instead.
  [[nodiscard]] const QStringList& problems() const noexcept { return problems_; }
  /// Takes effect at once and is written at once.
  void change(const Settings& settings);

 Q_SIGNALS:
  void changed();
  void failed(const QString& why);  ///< the file could not be written

 private:
  void read();

  QString path_;
  Settings now_;
  QStringList problems_;
};

}  // namespace isograsp::gui
