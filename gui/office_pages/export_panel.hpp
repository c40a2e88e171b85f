// SPDX-License-Identifier: GPL-3.0-or-later
// Signals and measures as files for research: whose, which sessions, what will be written, where
// to.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "gui/clinic/clinic.hpp"
#include "gui/look/work_progress.hpp"
#include "gui/office_pages/session_span.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ExportPanel final : public QWidget {
  Q_OBJECT

 public:
  ExportPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

  /// Into a new folder below `folder`.
  void write_into(const QString& folder);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_choices();
  [[nodiscard]] QWidget* make_list();
  void look_again();
  void load_sessions();
  void list_files();
  void ask_where();
  void refresh();
  [[nodiscard]] exports::ExportRequest request() const;
  [[nodiscard]] exports::ExportFormat format() const;

  Clinic& clinic_;
  SessionPresenter& presenter_;
  std::string code_;  ///< whose sessions are listed
  bool stale_ = true;
  int lists_ = 0;
  QString problem_;

  QComboBox* whose_;
  SessionSpan* span_;
  QComboBox* format_;
  QPushButton* export_;
  WorkProgress* writing_;
  QLabel* remark_;
  QLabel* count_;
  QListWidget* files_;
};

}  // namespace isograsp::gui
