// SPDX-License-Identifier: GPL-3.0-or-later
// A device of this workstation: what it is, where it is plugged in (or what answers), whether it
// works, and what people call it. Nothing is stored here.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "gui/clinic/background.hpp"
#include "gui/clinic/settings.hpp"
#include "gui/device_pages/device_address.hpp"
#include "session/ask_device.hpp"

namespace isograsp::gui {

class AddDeviceDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `taken`: names that are there already.
  AddDeviceDialog(const std::string& library, QStringList taken,
                  std::span<const session::ApparatusRow> apparatuses, QWidget* parent = nullptr);
  ~AddDeviceDialog() override;  ///< ends a check; waits for the device to be let go

  /// As it is filled in. @pre accepted
  [[nodiscard]] NamedDevice device() const;

 private:
  void make_fields();
  void make_acts();
  [[nodiscard]] DeviceDraft draft() const;
  void offer();
  void show_draft(const DeviceDraft& draft);
  void refresh();
  /// Asks these one after the other; the first that answers is shown.
  void ask(std::vector<DeviceDraft> drafts);
  void ask_next();
  void take(const Result<session::DeviceAnswer>& answer);
  void end_asking(const QString& words);

  std::string library_;
  QStringList taken_;
  std::span<const session::ApparatusRow> apparatuses_;
  Surroundings here_;
  std::stop_source asking_;
  std::vector<DeviceDraft> left_;  ///< to be asked, the next one last
  std::size_t asked_ = 0;
  std::optional<DeviceDraft> now_;  ///< is being asked
  QFormLayout* form_;
  QComboBox* kind_;
  QComboBox* family_;
  QComboBox* where_;
  QComboBox* setup_;
  QComboBox* rig_;
  QLineEdit* name_;
  QLabel* result_;
  QProgressBar* progress_;
  QPushButton* find_;
  QPushButton* check_;
  QPushButton* add_;
  Background worker_;  ///< last: its job ends before anything else goes away
};

}  // namespace isograsp::gui
