// SPDX-License-Identifier: GPL-3.0-or-later
// The first and the last session of a patient that are asked for: two lists; the first never lies
// behind the last.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QWidget>
#include <optional>
#include <vector>

#include "storage/records/records.hpp"

namespace isograsp::gui {

class SessionSpan final : public QWidget {
  Q_OBJECT

 public:
  /// `first`, `last`: captions with their mnemonics; `name` begins the names of both lists.
  SessionSpan(const QString& first, const QString& last, const QString& name,
              QWidget* parent = nullptr);

  /// Oldest first. All of them are chosen; a choice stays while the same patient is shown.
  void show_sessions(const std::vector<storage::SessionRecord>& sessions, bool same_patient);
  [[nodiscard]] int first() const { return first_->currentIndex() + 1; }
  /// Nothing: up to the newest, also one that is to come.
  [[nodiscard]] std::optional<int> last() const;

 Q_SIGNALS:
  void changed();  ///< by the user

 private:
  QComboBox* first_;
  QComboBox* last_;
};

}  // namespace isograsp::gui
