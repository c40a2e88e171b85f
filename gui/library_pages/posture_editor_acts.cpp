// SPDX-License-Identifier: GPL-3.0-or-later
// What the form of postures shows of a file, and what its acts make of it.
#include <QLocale>
#include <QSignalBlocker>
#include <algorithm>
#include <numbers>
#include <utility>

#include "gui/arm_pages/arm_words.hpp"
#include "gui/library_pages/posture_editor.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "session/arm/arm_rig.hpp"

namespace isograsp::gui {

namespace {

constexpr double kDegree_rad = std::numbers::pi / 180.0;
constexpr double kMm_m = 1e-3;

bool is_of_an_arm(const Postures& postures) {
  return postures.chain.size() == session::kArmChain.size();
}

/// Of a segment of the chain, in words where the chain is that of an arm.
QString words_of_segment(const Postures& postures, std::size_t k) {
  return is_of_an_arm(postures) ? segment_title(session::kArmChain[k])
                                : QString::fromStdString(postures.chain[k]);
}

QString words_of_link(const Postures& postures, std::size_t l) {
  if (is_of_an_arm(postures)) return link_title(static_cast<ArmLink>(l));
  return QStringLiteral("%1 → %2").arg(words_of_segment(postures, l),
                                       words_of_segment(postures, l + 1));
}

}  // namespace

void PostureEditor::show_file(const PostureFile& file, bool editable, bool changed) {
  const bool other_chain = file.postures.chain != file_.postures.chain;
  file_ = file;
  editable_ = editable;
  chosen_ = std::min(chosen_, file_.postures.postures.size() - 1);
  if (other_chain) fill_links();
  fill_list();
  series_->setVisible(editable && changed);
  refresh();
  Q_EMIT shown_changed();
}

void PostureEditor::select_name() {
  file_name_->setFocus();
  file_name_->selectAll();
}

void PostureEditor::choose(std::size_t index) {
  if (index == chosen_) return;
  chosen_ = index;
  list_->setCurrentRow(static_cast<int>(index));
  refresh();
  Q_EMIT shown_changed();
}

std::size_t PostureEditor::segment_of_axes() const {
  return link() + (axes() == EditAxes::own ? 1 : 0);
}

void PostureEditor::fill_list() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const Posture& one : file_.postures.postures) {
    const bool initial = list_->count() == 0;
    const auto name = QString::fromStdString(one.name);
    auto* item = new QListWidgetItem(
        initial ? tr("%1 – all others are seen from it").arg(name) : name, list_);
    item->setSizeHint({0, scaled(kRow_px)});
  }
  list_->setCurrentRow(static_cast<int>(chosen_));
}

void PostureEditor::fill_links() {
  {
    const QSignalBlocker quiet(link_);
    link_->clear();
    for (std::size_t l = 0; l + 1 < file_.postures.chain.size(); ++l)
      link_->addItem(words_of_link(file_.postures, l));
  }
  fill_axes();
}

void PostureEditor::fill_axes() {
  const QSignalBlocker quiet(axes_);
  const int before = std::max(0, axes_->currentIndex());
  axes_->clear();
  axes_->addItem(words_of_segment(file_.postures, link() + 1));
  axes_->addItem(words_of_segment(file_.postures, link()));
  axes_->setCurrentIndex(before);
}

void PostureEditor::refresh() {
  const bool initial = chosen_ == 0;
  const auto show = [](QLineEdit* field, const std::string& words) {
    const auto text = QString::fromStdString(words);
    if (field->text() != text) field->setText(text);
  };
  show(file_name_, file_.postures.name);
  show(name_, posture().name);
  for (QLineEdit* field : {file_name_, name_}) field->setReadOnly(!editable_);
  for (QPushButton* button : steps_) button->setEnabled(editable_);
  duplicate_->setEnabled(editable_);
  remove_->setEnabled(editable_ && !initial);
  new_one_->setEnabled(editable_ && !initial);
  this_one_->setEnabled(editable_ && !initial);
  changes_->setText(changes_in_words());
}

/// "From the initial posture: forearm 40°, 3 mm · wrist 0°, 0 mm …"
QString PostureEditor::changes_in_words() const {
  if (chosen_ == 0) return tr("The initial posture: the arm is held so before the work.");
  QStringList links;
  const auto changes = changes_from(file_.postures.postures.front(), posture());
  for (std::size_t l = 0; l < changes.size(); ++l)
    links << tr("%1 %2°, %3 mm")
                 .arg(words_of_link(file_.postures, l),
                      QLocale().toString(changes[l].angle_rad / kDegree_rad, 'f', 1),
                      QLocale().toString(changes[l].distance_m / kMm_m, 'f', 1));
  return tr("From the initial posture: %1").arg(links.join(QStringLiteral("  ·  ")));
}

std::size_t PostureEditor::link() const {
  return static_cast<std::size_t>(std::max(0, link_->currentIndex()));
}

EditAxes PostureEditor::axes() const {
  return axes_->currentIndex() == 1 ? EditAxes::before : EditAxes::own;
}

void PostureEditor::change_link(bool turn, EditAxis axis, int sign) {
  const Pose T = turn ? turn_about(axis, sign * kDegree_rad * angle_deg_->value())
                      : shift_along(axis, sign * kMm_m * way_mm_->value());
  put(with_link_changed(posture(), link(), T, axes()));
}

void PostureEditor::go_part_of_the_way(bool as_new) {
  constexpr double kPercent = 100.0;
  Posture part =
      part_of_the_way(file_.postures.postures.front(), posture(), way_percent_->value() / kPercent);
  if (!as_new) return put(std::move(part));
  part.name += " " + std::to_string(way_percent_->value());
  put(with_added(file_.postures, chosen_, std::move(part)), chosen_ + 1);
}

void PostureEditor::duplicate() {
  put(with_added(file_.postures, chosen_, posture()), chosen_ + 1);
}

void PostureEditor::remove() {
  if (!editable_) return;
  put(without(file_.postures, chosen_), chosen_ - (chosen_ > 0 ? 1 : 0));
}

void PostureEditor::rename() {
  const auto name = name_->text().trimmed().toStdString();
  if (!editable_ || name == posture().name) return;
  put(with_renamed(file_.postures, chosen_, name), chosen_);
}

void PostureEditor::rename_file() {
  const auto name = file_name_->text().trimmed().toStdString();
  if (!editable_ || name == file_.postures.name) return;
  Postures renamed = file_.postures;
  renamed.name = name;
  put(std::move(renamed), chosen_);
}

void PostureEditor::put(Posture changed) {
  Postures postures = file_.postures;
  postures.postures[chosen_] = std::move(changed);
  put(std::move(postures), chosen_);
}

void PostureEditor::put(Postures postures, std::size_t chosen) {
  chosen_ = chosen;
  Q_EMIT edited({file_.head, std::move(postures)});
}

void PostureEditor::put(const Result<Postures>& postures, std::size_t chosen) {
  if (postures) return put(*postures, chosen);
  Q_EMIT refused(translated(postures.error()));
  refresh();  // a name that was refused goes
}

}  // namespace isograsp::gui
