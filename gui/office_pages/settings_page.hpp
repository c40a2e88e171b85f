// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of this workstation; each takes effect as it is chosen.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QWidget>
#include <functional>

#include "gui/clinic/settings.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/look/card.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/patient_screen/speaker.hpp"

namespace isograsp::gui {

class SettingsPage final : public QWidget {
  Q_OBJECT

 public:
  SettingsPage(SettingsFile& settings, const Staff& staff, QWidget* parent = nullptr);

 private:
  [[nodiscard]] QWidget* make_window_card();
  [[nodiscard]] QWidget* make_screen_card();
  [[nodiscard]] QWidget* make_sound_card();
  void fill_screens();
  /// Takes over what `edit` does to the settings.
  void change(const std::function<void(Settings&)>& edit);
  void refresh();

  SettingsFile& settings_;
  Speaker speaker_;
  ChoiceBox* language_;
  QLineEdit* operator_;
  ChoiceBox* letters_;
  ChoiceBox* forces_;
  ChoiceBox* screen_;
  QSpinBox* distance_cm_;
  QDoubleSpinBox* height_cm_;
  QDoubleSpinBox* delay_ms_;
  QSlider* volume_;
  QPushButton* try_sound_;
  QPushButton* try_voice_;
  QLabel* sound_words_;
};

}  // namespace isograsp::gui
