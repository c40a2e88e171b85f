// SPDX-License-Identifier: GPL-3.0-or-later
// Which cameras see the arm: whose system, where it is, or which recording of markers; and the rig
// that says what its markers are.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <string>

namespace isograsp::gui {

class CamerasDialog final : public QDialog {
  Q_OBJECT

 public:
  /// Offers the rigs of that library.
  explicit CamerasDialog(const std::string& library, QWidget* parent = nullptr);
  /// What is filled in, as a device URI; empty: something is missing.
  [[nodiscard]] std::string uri() const;

 private:
  void choose_file();
  void refresh();

  QComboBox* source_;
  QLabel* where_title_;
  QLineEdit* where_;
  QPushButton* browse_;
  QComboBox* rig_;
  QPushButton* accept_;
};

}  // namespace isograsp::gui
