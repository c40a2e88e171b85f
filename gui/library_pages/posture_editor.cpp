// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/posture_editor.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "gui/look/choice_box.hpp"
#include "gui/look/form_fields.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr std::array<const char*, kEditAxisCount> kAxisNames{"x", "y", "z"};

/// What a key does.
struct StepKey {
  const char* key;
  bool turn;
  EditAxis axis;
  int sign;
};
constexpr std::array<StepKey, 12> kStepKeys{{{"X", true, EditAxis::x, 1},
                                             {"Shift+X", true, EditAxis::x, -1},
                                             {"Y", true, EditAxis::y, 1},
                                             {"Shift+Y", true, EditAxis::y, -1},
                                             {"Z", true, EditAxis::z, 1},
                                             {"Shift+Z", true, EditAxis::z, -1},
                                             {"Ctrl+Right", false, EditAxis::x, 1},
                                             {"Ctrl+Left", false, EditAxis::x, -1},
                                             {"Ctrl+Up", false, EditAxis::y, 1},
                                             {"Ctrl+Down", false, EditAxis::y, -1},
                                             {"Ctrl+PgUp", false, EditAxis::z, 1},
                                             {"Ctrl+PgDown", false, EditAxis::z, -1}}};

QString key_of(bool turn, EditAxis axis, int sign) {
  for (const StepKey& step : kStepKeys)
    if (step.turn == turn && step.axis == axis && step.sign == sign)
      return key_words(QLatin1String(step.key));
  return {};
}

QPushButton* named_button(const QString& text, const QString& name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  return button;
}

}  // namespace

PostureEditor::PostureEditor(QWidget* parent) : QWidget(parent) {
  setObjectName("posture_editor");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  make_list(*column);
  make_link(*column);
  make_steps(*column);
  make_way(*column);
  changes_ = new QLabel;
  changes_->setObjectName("posture_changes");
  changes_->setProperty("role", "quiet");
  changes_->setWordWrap(true);
  series_ = new QLabel(
      tr("Changed postures are another series: what is measured with them is not compared with "
         "what was measured before."));
  series_->setObjectName("posture_series");
  series_->setWordWrap(true);
  column->addWidget(changes_);
  column->addWidget(series_);
  make_recording(*column);
  add_keys(*list_);
  setFocusProxy(list_);
}

void PostureEditor::make_list(QVBoxLayout& column) {
  file_name_ = new QLineEdit;
  file_name_->setObjectName("posture_file_name");
  describe(*file_name_, tr("Name of the file"), tr("For people; Enter takes it (Tab)"));
  connect(file_name_, &QLineEdit::editingFinished, this, &PostureEditor::rename_file);
  list_ = new QListWidget;
  list_->setObjectName("posture_list");
  take_rest(*list_, 4 * kRow_px);
  describe(
      *list_, tr("Postures of the file"),
      tr("Arrow keys choose one; X, Y and Z turn its link, with Shift the other way; Ctrl with "
         "arrow and page keys moves it"));
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) choose(static_cast<std::size_t>(row));
  });
  duplicate_ = named_button(tr("Copy"), "posture_duplicate");
  describe(*duplicate_, tr("Copy the posture"), tr("The same posture once more (Tab, then space)"));
  remove_ = named_button(tr("Delete"), "posture_remove");
  describe(*remove_, tr("Delete the posture"),
           tr("Takes it out of the file; Undo brings it back (Delete)"));
  name_ = new QLineEdit;
  name_->setObjectName("posture_name");
  describe(*name_, tr("Name of the posture"), tr("Tasks call it by that; Enter takes it (Tab)"));
  connect(duplicate_, &QPushButton::clicked, this, &PostureEditor::duplicate);
  connect(remove_, &QPushButton::clicked, this, &PostureEditor::remove);
  connect(name_, &QLineEdit::editingFinished, this, &PostureEditor::rename);
  add_key(list_, "Delete", [this] { remove(); });
  auto* acts = new QHBoxLayout;
  acts->setSpacing(6);
  acts->addWidget(caption(tr("Posture"), name_));
  acts->addWidget(name_, 1);
  acts->addWidget(duplicate_);
  acts->addWidget(remove_);
  auto* file = new QHBoxLayout;
  file->setSpacing(6);
  file->addWidget(caption(tr("File"), file_name_));
  file->addWidget(file_name_, 1);
  column.addLayout(file);
  column.addWidget(list_, 1);
  column.addLayout(acts);
}

void PostureEditor::make_link(QVBoxLayout& column) {
  link_ = new ChoiceBox;
  link_->setObjectName("posture_link");
  describe(*link_, tr("What turns"), tr("What lies beyond it goes along (arrow keys)"));
  axes_ = new ChoiceBox;
  axes_->setObjectName("posture_axes");
  describe(*axes_, tr("About whose axes"),
           tr("They are drawn in the picture, at the origin about which is turned (arrow keys)"));
  connect(link_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    fill_axes();
    Q_EMIT shown_changed();
  });
  connect(axes_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &PostureEditor::shown_changed);
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  row->addWidget(caption(tr("Change"), link_));
  row->addWidget(link_, 1);
  row->addWidget(caption(tr("axes of"), axes_));
  row->addWidget(axes_, 1);
  column.addLayout(row);
}

/// How much, and for each axis one step back and one forward.
void PostureEditor::make_steps(QVBoxLayout& column) {
  constexpr double kMostTurn_deg = 180.0;
  constexpr double kMostMove_mm = 500.0;
  constexpr double kUsual = 5.0;
  const auto make_amount = [](const QString& name, const QString& unit, double most) {
    auto* amount = new QDoubleSpinBox;
    amount->setObjectName(name);
    amount->setDecimals(1);
    amount->setRange(0.1, most);
    amount->setValue(kUsual);
    amount->setSuffix(unit);
    amount->setButtonSymbols(QAbstractSpinBox::NoButtons);
    return amount;
  };
  angle_deg_ = make_amount("posture_angle", tr("°"), kMostTurn_deg);
  describe(*angle_deg_, tr("Turn by, in degrees"), tr("One step of a turn (arrow keys)"));
  way_mm_ = make_amount("posture_way", tr(" mm"), kMostMove_mm);
  describe(*way_mm_, tr("Move by, in millimetres"), tr("One step of a move (arrow keys)"));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);
  grid->addWidget(caption(tr("Turn by"), angle_deg_), 0, 0);
  grid->addWidget(caption(tr("Move by"), way_mm_), 1, 0);
  grid->addWidget(angle_deg_, 0, 1);
  grid->addWidget(way_mm_, 1, 1);
  for (int row = 0; row < 2; ++row)
    for (std::size_t a = 0; a < kEditAxisCount; ++a) {
      const bool turn = row == 0;
      const auto axis = static_cast<EditAxis>(a);
      const auto letter = QLatin1String(kAxisNames[a]);
      for (const int sign : {-1, 1}) {
        const auto sign_word = sign < 0 ? QStringLiteral("−") : QStringLiteral("+");
        auto* step =
            named_button(sign_word + letter,
                         QStringLiteral("posture_%1_%2_%3")
                             .arg(turn ? QStringLiteral("turn") : QStringLiteral("move"), letter,
                                  sign < 0 ? QStringLiteral("back") : QStringLiteral("on")));
        step->setProperty("tight", true);
        const auto name = turn ? tr("Turn about %1, %2").arg(letter, sign_word)
                               : tr("Move along %1, %2").arg(letter, sign_word);
        describe(*step, name, tr("%1 (%2)").arg(name, key_of(turn, axis, sign)));
        connect(step, &QPushButton::clicked, this,
                [this, turn, axis, sign] { change_link(turn, axis, sign); });
        grid->addWidget(step, row, 2 + 2 * static_cast<int>(a) + (sign < 0 ? 0 : 1));
        steps_.push_back(step);
      }
    }
  for (int c = 1; c < grid->columnCount(); ++c) grid->setColumnStretch(c, c == 1 ? 3 : 2);
  column.addLayout(grid);
}

void PostureEditor::make_way(QVBoxLayout& column) {
  constexpr int kHalf_percent = 50;
  way_percent_ = new QSpinBox;
  way_percent_->setObjectName("posture_percent");
  way_percent_->setRange(0, 100);
  way_percent_->setValue(kHalf_percent);
  way_percent_->setSuffix(tr(" %"));
  way_percent_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  describe(*way_percent_, tr("Part of the way from the initial posture, in per cent"),
           tr("0 is the initial posture, 100 this one (arrow keys)"));
  new_one_ = named_button(tr("New"), "posture_part_new");
  describe(*new_one_, tr("A new posture so far on the way"),
           tr("Adds a posture so far on the way to this one; this one stays (Tab, then space)"));
  this_one_ = named_button(tr("Shorten"), "posture_part");
  describe(*this_one_, tr("Shorten this posture to so much of its way"),
           tr("Takes this posture back to so much of its way (Tab, then space)"));
  connect(new_one_, &QPushButton::clicked, this, [this] { go_part_of_the_way(true); });
  connect(this_one_, &QPushButton::clicked, this, [this] { go_part_of_the_way(false); });
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  row->addWidget(caption(tr("Way from the initial one"), way_percent_));
  row->addWidget(way_percent_, 1);
  row->addWidget(new_one_);
  row->addWidget(this_one_);
  column.addLayout(row);
}

void PostureEditor::make_recording(QVBoxLayout& column) {
  record_ = new QPushButton;
  record_->setObjectName("posture_record");
  record_progress_ = new QProgressBar;
  record_progress_->setObjectName("posture_record_progress");
  record_progress_->setRange(0, 100);
  describe(*record_progress_, tr("Recording the arm"), tr("The arm is held still for a second"));
  connect(record_, &QPushButton::clicked, this, &PostureEditor::record_pressed);
  column.addWidget(record_);
  column.addWidget(record_progress_);
  show_recording({});
}

void PostureEditor::show_recording(const Recording& recording) {
  record_->setVisible(recording.offered);
  record_progress_->setVisible(recording.running);
  record_progress_->setValue(static_cast<int>(std::lround(100.0 * recording.progress)));
  record_->setEnabled(recording.possible || recording.running);
  record_->setText(recording.running          ? tr("Stop recording")
                   : recording.into_this_file ? tr("Record the arm: next posture")
                                              : tr("Record the arm: new file"));
  describe(*record_, record_->text(),
           recording.into_this_file
               ? tr("The arm is held still for a second, as guided; the same markers as in this "
                    "file (Tab, then space)")
               : tr("The arm is held still for a second and becomes the initial posture of a new "
                    "file: postures of one arm with other markers do not fit together (Tab, then "
                    "space)"));
}

void PostureEditor::add_keys(QWidget& widget) {
  for (const StepKey& step : kStepKeys)
    add_key(&widget, QLatin1String(step.key), [this, step] {
      if (editable_) change_link(step.turn, step.axis, step.sign);
    });
}

void PostureEditor::act_on(int key, Qt::KeyboardModifiers modifiers) {
  for (const StepKey& step : kStepKeys)
    if (editable_ && QKeySequence(QLatin1String(step.key))[0] ==
                         (key | static_cast<int>(modifiers & ~Qt::KeypadModifier)))
      return change_link(step.turn, step.axis, step.sign);
}

}  // namespace isograsp::gui
