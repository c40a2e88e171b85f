// SPDX-License-Identifier: GPL-3.0-or-later
// The form for a file of postures, in the place of its text: postures are chosen, named, turned and
// moved link by link, shortened, copied and removed. Each act gives a changed file, which becomes
// the text: Undo, drafts and Save are those of every file of the library.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <vector>

#include "gui/library/posture_file.hpp"
#include "kinematics/posture_edit.hpp"

namespace isograsp::gui {

class PostureEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit PostureEditor(QWidget* parent = nullptr);

  /// The chosen posture and link stay chosen as long as they are there. `editable`: false, only to
  /// look at. `changed`: it is not what is stored in the file.
  void show_file(const PostureFile& file, bool editable, bool changed);
  /// Selects the name of the file, to be typed over.
  void select_name();
  void choose(std::size_t index);

  [[nodiscard]] const PostureFile& file() const noexcept { return file_; }
  [[nodiscard]] std::size_t chosen() const noexcept { return chosen_; }
  /// Place in the chain of the segment whose axes are those of the fields.
  [[nodiscard]] std::size_t segment_of_axes() const;

  /// Of an arm that is connected: the button to record it. `progress`: 0 … 1 while it runs.
  struct Recording {
    bool offered = false;
    bool possible = false;
    bool running = false;
    double progress = 0.0;
    bool into_this_file = false;  ///< else into a new one
  };
  void show_recording(const Recording& recording);

  /// Keys that turn and move while the focus is in that widget, too.
  void add_keys(QWidget& widget);
  /// The same of a window that keeps its keys to itself.
  void act_on(int key, Qt::KeyboardModifiers modifiers);

 Q_SIGNALS:
  void edited(const PostureFile& file);
  void shown_changed();  ///< another posture, link or kind of axes
  void refused(const QString& why);
  void record_pressed();

 private:
  void make_list(QVBoxLayout& column);
  void make_link(QVBoxLayout& column);
  void make_steps(QVBoxLayout& column);
  void make_way(QVBoxLayout& column);
  void make_recording(QVBoxLayout& column);
  void fill_list();
  void fill_links();
  void fill_axes();
  void refresh();
  [[nodiscard]] QString changes_in_words() const;

  [[nodiscard]] const Posture& posture() const { return file_.postures.postures[chosen_]; }
  [[nodiscard]] std::size_t link() const;
  [[nodiscard]] EditAxes axes() const;
  void change_link(bool turn, EditAxis axis, int sign);
  void go_part_of_the_way(bool as_new);
  void duplicate();
  void remove();
  void rename();
  void rename_file();
  void put(Posture posture);
  void put(Postures postures, std::size_t chosen);
  void put(const Result<Postures>& postures, std::size_t chosen);

  static constexpr int kRow_px = 24;

  PostureFile file_;
  std::size_t chosen_ = 0;
  bool editable_ = false;

  QLineEdit* file_name_;
  QListWidget* list_;
  QPushButton* duplicate_;
  QPushButton* remove_;
  QLineEdit* name_;
  QComboBox* link_;
  QComboBox* axes_;
  QDoubleSpinBox* angle_deg_;
  QDoubleSpinBox* way_mm_;
  std::vector<QPushButton*> steps_;
  QSpinBox* way_percent_;
  QPushButton* this_one_;
  QPushButton* new_one_;
  QLabel* changes_;
  QLabel* series_;
  QPushButton* record_;
  QProgressBar* record_progress_;
};

}  // namespace isograsp::gui
