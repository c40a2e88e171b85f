// SPDX-License-Identifier: GPL-3.0-or-later
// A database that another program has open in its windows: who that is, and what can be done.
#pragma once

#include <QDialog>
#include <optional>
#include <string>

#include "storage/file/window_lock.hpp"

namespace isograsp::gui {

class FileInUse final : public QDialog {
  Q_OBJECT

 public:
  enum class Choice : std::uint8_t { leave, look, another };
  FileInUse(const std::string& database, const std::string& holder, QWidget* parent = nullptr);
  [[nodiscard]] Choice choice() const noexcept { return choice_; }

 private:
  Choice choice_ = Choice::leave;
};

/// What the windows are to open.
struct FileToOpen {
  std::string database;
  bool look_only = false;
  std::optional<storage::WindowLock> use =
      std::nullopt;  ///< nothing: another program's, or not known
};

/// Takes `database`, or asks what to do while another program has it. Nothing: the user leaves.
[[nodiscard]] std::optional<FileToOpen> file_to_open(const std::string& database);

}  // namespace isograsp::gui
