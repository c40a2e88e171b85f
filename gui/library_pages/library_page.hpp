// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks, scenes, protocols and postures: the list, the editor with the reader's own errors as one
// types, and what the text will be. Shipped files are read-only; Duplicate makes an own one. A file
// of postures is a form instead of its text, as long as that can be read.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <array>
#include <optional>

#include "gui/clinic/background.hpp"
#include "gui/clinic/clinic.hpp"
#include "gui/library/library_files.hpp"
#include "gui/library_pages/library_view.hpp"
#include "gui/library_pages/posture_desk.hpp"
#include "gui/look/toml_editor.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class LibraryPage final : public QWidget {
  Q_OBJECT

 public:
  LibraryPage(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);
  ~LibraryPage() override;

  /// Keeps what was typed, without waiting for the second after the last key.
  void keep_draft_now();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_list();
  [[nodiscard]] QWidget* make_editor();
  [[nodiscard]] QWidget* make_pictures();
  void watch_editor();
  void add_keys();
  void show_kind(LibraryKind kind);
  /// Reads the list again; then the file at `path` is chosen, with its name selected if it is new.
  void list_files(const std::string& path, bool select_name = false);
  void fill_list();
  void choose_row(int row);
  void open(const LibraryEntry& entry, bool select_name);
  /// The form in the place of the text, where there is one for it.
  void show_body();
  void focus_body();
  void add_file(const QString& text, const QString& remark);
  void text_changed();
  void check();
  void show_checked(const std::optional<Error>& error);
  void duplicate();
  void save();
  void show_saved(const LibraryEntry& entry, const LibraryFiles::Saved& saved,
                  const std::string& sent);
  void revert();
  void remove();
  void bring_back();
  void refresh();
  void say(const QString& words);
  [[nodiscard]] std::string text() const { return editor_->toPlainText().toStdString(); }
  [[nodiscard]] bool modified() const {
    return entry_ && entry_->own && loaded_ && text() != former_shown_;
  }

  Clinic& clinic_;
  SessionPresenter& presenter_;
  LibraryFiles files_;
  LibraryKind kind_ = LibraryKind::tasks;
  std::vector<LibraryEntry> entries_;  ///< of this kind
  std::optional<LibraryEntry> entry_;  ///< in the editor
  std::string former_;                 ///< text of its file
  std::string former_shown_;           ///< as the editor gives it back: other line ends and spaces
  std::optional<Error> error_;         ///< of the text as it was checked last
  bool checked_ = false;               ///< that was the text which stands there
  bool loaded_ = false;                ///< its text has come
  bool saving_ = false;
  bool showing_ = false;   ///< a text is put into the editor: nobody types
  QString remark_of_new_;  ///< said where the file that is made stands open
  int opened_ = 0;         ///< answers to earlier requests are dropped
  int checks_ = 0;
  int lists_ = 0;
  struct Removed {
    LibraryEntry entry;
    std::string place;
  };
  std::optional<Removed> removed_;

  std::array<QPushButton*, kLibraryKindCount> kinds_{};
  QLineEdit* search_;
  QListWidget* list_;
  QPushButton* bring_back_;
  QLabel* name_;
  QLabel* place_;
  QPushButton* duplicate_;
  QPushButton* save_;
  QPushButton* revert_;
  QPushButton* remove_;
  QPushButton* undo_;
  QPushButton* redo_;
  QLabel* remark_;
  QStackedWidget* body_;  ///< the text, or the form of postures
  TomlEditor* editor_;
  PostureDesk* postures_;
  QLabel* problem_;
  QPushButton* go_to_;
  LibraryView* view_;
  QTimer check_soon_;
  QTimer draft_soon_;
  Background worker_;  ///< last: its jobs end before anything else goes away
};

}  // namespace isograsp::gui
