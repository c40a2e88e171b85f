// SPDX-License-Identifier: GPL-3.0-or-later
// What the library page needs for files of postures: the form in the place of the text, the
// pictures beside it, and recording postures of the arm that is connected. GUI thread.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "gui/library_pages/posture_editor.hpp"
#include "gui/library_pages/posture_take.hpp"
#include "gui/library_pages/posture_view.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class PostureDesk final : public QObject {
  Q_OBJECT

 public:
  /// Form and pictures belong to whoever puts them into a page.
  explicit PostureDesk(SessionPresenter& presenter, QObject* parent);

  [[nodiscard]] PostureEditor& editor() noexcept { return *editor_; }
  [[nodiscard]] PostureView& view() noexcept { return *view_; }

  /// The file with that text; false: it cannot be read, the form shows nothing new. `editable` and
  /// `changed` as PostureEditor::show_file().
  bool show_text(const std::string& text, const std::string& path, bool editable, bool changed);
  /// No file of postures is looked at.
  void leave();
  /// A file that new_file() asked for stands there: postures of the same session go on in it.
  void made(const std::string& path);

 Q_SIGNALS:
  void edited(const QString& text);  ///< of the file that is shown
  /// One with its first posture; `remark` is said where it stands open.
  void new_file(const QString& text, const QString& remark);
  void said(const QString& words);  ///< what came of an act, or why it was refused

 private:
  void show_pictures();
  void refresh_recording();
  void press_record();
  void look();
  void take();
  /// A session is open whose rig makes the chain of an arm.
  [[nodiscard]] bool sees_an_arm() const;
  /// … which may be recorded now.
  [[nodiscard]] bool may_record() const;
  [[nodiscard]] bool goes_on_in_this_file() const;

  SessionPresenter& presenter_;
  PostureEditor* editor_;
  PostureView* view_;
  std::unique_ptr<PostureScene> scene_;  ///< of the chain that is shown; null: nothing was yet
  /// What is shown; an empty path: nothing.
  std::string path_;
  std::string text_;
  bool editable_ = false;
  bool changed_ = false;
  PostureTake take_;
  /// Where postures of a session were recorded into: only there do others fit.
  struct Recorded {
    std::string path;
    std::string session;  ///< uuid
  };
  std::optional<Recorded> recorded_;
};

}  // namespace isograsp::gui
