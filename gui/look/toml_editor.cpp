// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/toml_editor.hpp"

#include <QPainter>
#include <QRegularExpression>
#include <QSyntaxHighlighter>
#include <QTextBlock>

#include "gui/look/look.hpp"

namespace isograsp::gui {

/// The strip at the left; it belongs to the editor, which paints it.
class LineNumbers final : public QWidget {
 public:
  explicit LineNumbers(TomlEditor& editor) : QWidget(&editor), editor_(editor) {}

 protected:
  void paintEvent(QPaintEvent* event) override { editor_.paint_numbers(event); }

 private:
  TomlEditor& editor_;
};

namespace {

const QColor kErrorLine{0xFC, 0xE9, 0xE7};
const QColor kCurrentLine{0xF4, 0xF8, 0xFC};
const QColor kStrip{0xF3, 0xF5, 0xF8};
// On white at least 5:1. Tables are bold, comments slanted: no colour stands alone.
const QColor kKey{0x0B, 0x5C, 0xAD};
const QColor kTable{0x1B, 0x27, 0x33};
const QColor kValue{0x8A, 0x3B, 0x00};
const QColor kComment{0x52, 0x60, 0x6D};

class TomlColors final : public QSyntaxHighlighter {
 public:
  explicit TomlColors(QTextDocument* document) : QSyntaxHighlighter(document) {
    table_.setForeground(kTable);
    table_.setFontWeight(QFont::Bold);
    key_.setForeground(kKey);
    value_.setForeground(kValue);
    comment_.setForeground(kComment);
    comment_.setFontItalic(true);
  }

 protected:
  void highlightBlock(const QString& line) override {
    int comment = line.size();
    bool in_text = false;
    for (int i = 0; i < line.size(); ++i) {
      if (line[i] == '\\' && in_text)
        ++i;
      else if (line[i] == '"')
        in_text = !in_text;
      else if (line[i] == '#' && !in_text) {
        comment = i;
        break;
      }
    }
    static const QRegularExpression kTables(R"(^\s*\[.*\]\s*$)");
    static const QRegularExpression kKeys(R"(([A-Za-z0-9_.-]+)\s*=)");
    static const QRegularExpression kTexts(R"re("([^"\\]|\\.)*")re");
    const auto code = line.left(comment);
    if (kTables.match(code).hasMatch() && !code.contains('=')) {
      setFormat(0, comment, table_);
    } else {
      for (auto found = kKeys.globalMatch(code); found.hasNext();) {
        const auto match = found.next();
        setFormat(match.capturedStart(1), match.capturedLength(1), key_);
      }
      for (auto found = kTexts.globalMatch(code); found.hasNext();) {
        const auto match = found.next();
        setFormat(match.capturedStart(), match.capturedLength(), value_);
      }
    }
    if (comment < line.size()) setFormat(comment, line.size() - comment, comment_);
  }

 private:
  QTextCharFormat table_, key_, value_, comment_;
};

QTextEdit::ExtraSelection whole_line(QTextCursor cursor, const QColor& color) {
  QTextEdit::ExtraSelection line;
  cursor.clearSelection();
  line.cursor = cursor;
  line.format.setBackground(color);
  line.format.setProperty(QTextFormat::FullWidthSelection, true);
  return line;
}

}  // namespace

TomlEditor::TomlEditor(QWidget* parent) : QPlainTextEdit(parent), numbers_(new LineNumbers(*this)) {
  QFont font("DejaVu Sans Mono");
  font.setStyleHint(QFont::Monospace);
  font.setPointSizeF(0.09 * scaled(100));
  setFont(font);
  setTabChangesFocus(true);
  new TomlColors(document());
  connect(this, &QPlainTextEdit::blockCountChanged, this, &TomlEditor::lay_out_numbers);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& area, int dy) {
    if (dy != 0)
      numbers_->scroll(0, dy);
    else
      numbers_->update(0, area.y(), numbers_->width(), area.height());
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &TomlEditor::refresh_marks);
  lay_out_numbers();
}

void TomlEditor::show_text(const QString& text) {
  marked_.reset();
  setPlainText(text);
}

void TomlEditor::replace_text(const QString& text) {
  QTextCursor cursor(document());
  cursor.select(QTextCursor::Document);
  cursor.insertText(text);
}

void TomlEditor::mark_line(std::optional<int> line) {
  if (line == marked_) return;
  marked_ = line;
  refresh_marks();
  numbers_->update();
}

void TomlEditor::go_to_line(int line) {
  const auto block = document()->findBlockByNumber(std::max(1, line) - 1);
  if (block.isValid()) {
    setTextCursor(QTextCursor(block));
    centerCursor();
  }
  setFocus();
}

void TomlEditor::select_name() {
  static const QRegularExpression kName(R"re(^name\s*=\s*"((?:[^"\\]|\\.)*)")re");
  for (auto block = document()->begin(); block.isValid(); block = block.next()) {
    const auto match = kName.match(block.text());
    if (!match.hasMatch()) continue;
    QTextCursor cursor(block);
    cursor.setPosition(block.position() + match.capturedStart(1));
    cursor.setPosition(block.position() + match.capturedEnd(1), QTextCursor::KeepAnchor);
    setTextCursor(cursor);
    setFocus();
    return;
  }
}

void TomlEditor::refresh_marks() {
  QList<QTextEdit::ExtraSelection> marks;
  if (!isReadOnly()) marks << whole_line(textCursor(), kCurrentLine);
  if (marked_)
    if (const auto block = document()->findBlockByNumber(*marked_ - 1); block.isValid())
      marks << whole_line(QTextCursor(block), kErrorLine);
  setExtraSelections(marks);
  numbers_->update();
}

int TomlEditor::numbers_width() const {
  constexpr int kAround_px = 22;
  const int digits = std::max(2, static_cast<int>(QString::number(blockCount()).size()));
  return kAround_px + digits * fontMetrics().horizontalAdvance('9');
}

void TomlEditor::lay_out_numbers() {
  setViewportMargins(numbers_width(), 0, 0, 0);
  const auto area = contentsRect();
  numbers_->setGeometry(area.left(), area.top(), numbers_width(), area.height());
}

void TomlEditor::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  lay_out_numbers();
}

void TomlEditor::paint_numbers(QPaintEvent* event) {
  QPainter painter(numbers_);
  painter.fillRect(event->rect(), kStrip);
  painter.setFont(font());
  constexpr int kRight_px = 8;
  for (auto block = firstVisibleBlock(); block.isValid(); block = block.next()) {
    const auto place = blockBoundingGeometry(block).translated(contentOffset());
    if (place.top() > event->rect().bottom()) break;
    const int number = block.blockNumber() + 1;
    const bool marked = number == marked_;
    const double height = block.layout()->lineAt(0).height();  // a long line is wrapped
    const QRectF row(0, place.top(), numbers_->width() - kRight_px, height);
    painter.setPen(marked ? look::kFault : look::kQuietText);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, QString::number(number));
    if (marked)  // not by colour alone
      painter.drawText(QRectF(2, place.top(), kRight_px * 2, height), Qt::AlignVCenter,
                       QStringLiteral("▸"));
  }
}

}  // namespace isograsp::gui
