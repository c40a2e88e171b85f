// SPDX-License-Identifier: GPL-3.0-or-later
// A text field for TOML: line numbers, quiet colours for keys, texts, numbers and comments, and a
// mark at the line that the reader refuses. Undo and redo are those of every text field.
#pragma once

#include <QPlainTextEdit>
#include <optional>

namespace isograsp::gui {

class TomlEditor final : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit TomlEditor(QWidget* parent = nullptr);

  /// Another text, which cannot be undone into the one before.
  void show_text(const QString& text);
  /// The same file with another text; Undo brings back what stood here.
  void replace_text(const QString& text);
  /// 1-based.
  void mark_line(std::optional<int> line);
  [[nodiscard]] std::optional<int> marked_line() const noexcept { return marked_; }
  /// The cursor to the beginning of a line, 1-based, and the focus here.
  void go_to_line(int line);
  /// Selects the value of the top-level key `name`.
  void select_name();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  friend class LineNumbers;
  void paint_numbers(QPaintEvent* event);
  [[nodiscard]] int numbers_width() const;
  void lay_out_numbers();
  void refresh_marks();

  QWidget* numbers_;
  std::optional<int> marked_;
};

}  // namespace isograsp::gui
