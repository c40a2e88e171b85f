// SPDX-License-Identifier: GPL-3.0-or-later
// Postures on the library page: a form in the place of their text, whose acts are as safe as
// typing: shipped files stay, Undo takes back, what is saved is what was shown. And postures of the
// arm that is connected.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <filesystem>
#include <numbers>

#include "core/files.hpp"
#include "gui/arm_pages/arm_views.hpp"
#include "gui/library/posture_file.hpp"
#include "gui/library_pages/posture_editor.hpp"
#include "gui/look/toml_editor.hpp"
#include "kinematics/posture_edit.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::posture_page_test {
namespace {

using isograsp::test::must;

constexpr double kDegree_rad = std::numbers::pi / 180.0;
constexpr double kRounding = 1e-12;
const QString kScrew = "Turning a light bulb (made by calculation, not recorded from a person)";

class PosturePage : public QtTest {
 protected:
  PosturePage()
      : windows_(GuiConfig{folder_.path("clinic.db"), "", make_arm_library(folder_), "test"}) {
    windows_.show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
    look_at_postures();
  }
  ~PosturePage() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  void look_at_postures() {
    windows_.therapist().show_page(TherapistWindow::Page::library);
    operator_.press("library_postures");
    ASSERT_TRUE(wait_until([&] { return list().isVisible() && list().count() > 1; }));
  }
  [[nodiscard]] QListWidget& list() { return operator_.find<QListWidget>("posture_list"); }
  [[nodiscard]] TomlEditor& text() { return operator_.find<TomlEditor>("library_editor"); }
  [[nodiscard]] bool enabled(const char* name) { return operator_.find<QWidget>(name).isEnabled(); }
  [[nodiscard]] QString label(const char* name) { return operator_.find<QLabel>(name).text(); }
  [[nodiscard]] std::string path() { return label("library_place").toStdString(); }
  /// As it stands in the text.
  [[nodiscard]] Postures now() {
    return must(parse_postures(text().toPlainText().toStdString(), "now.toml"));
  }
  /// The list may still be read when it is asked for: then it is asked again.
  void open_file(const QString& name) {
    auto& files = operator_.find<QListWidget>("library_list");
    const auto open = [&] {
      for (int row = 0; row < files.count(); ++row)
        if (files.item(row)->data(Qt::AccessibleTextRole).toString() == name)
          files.setCurrentRow(row);
      return label("library_name") == name && label("library_problem").contains("✓");
    };
    ASSERT_TRUE(wait_until(open)) << label("library_name").toStdString();
  }
  /// A duplicate of the screw postures, its second posture chosen.
  void duplicate() {
    open_file(kScrew);
    operator_.press("library_duplicate");
    ASSERT_TRUE(wait_until([&] { return enabled("posture_turn_x_on"); }));
    list().setCurrentRow(1);
  }
  void save() {
    ASSERT_TRUE(wait_until([&] { return enabled("library_save"); }))
        << label("library_problem").toStdString();
    operator_.press("library_save");
    ASSERT_TRUE(wait_until([&] { return label("library_remark").startsWith("Saved"); }))
        << label("library_remark").toStdString();
  }
  void keep(const char* name) { keep_pictures_of_both_sizes(windows_.therapist(), name); }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
};

TEST_F(PosturePage, ShippedPosturesAreLookedAtAndNotChanged) {
  open_file(kScrew);
  EXPECT_TRUE(operator_.find<ArmViews>("posture_sides").isVisible());
  EXPECT_FALSE(text().isVisible()) << "the form is in its place";
  ASSERT_EQ(list().count(), 3);
  list().setCurrentRow(2);
  EXPECT_EQ(label("posture_view_title"), "screw");
  EXPECT_TRUE(label("posture_changes").contains("Forearm"))
      << label("posture_changes").toStdString();
  for (const char* name : {"posture_turn_x_on", "posture_duplicate", "posture_remove",
                           "posture_part", "posture_part_new", "library_save"})
    EXPECT_FALSE(enabled(name)) << name;
  const auto before = text().toPlainText();
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_X);
  EXPECT_EQ(text().toPlainText(), before);
  EXPECT_FALSE(operator_.find<QPushButton>("posture_record").isVisible()) << "no arm is connected";
}

TEST_F(PosturePage, ALinkIsTurnedAndMovedByTheFieldsAndByKeys) {
  duplicate();
  const Postures before = now();
  operator_.find<QComboBox>("posture_link").setCurrentIndex(1);
  operator_.find<QDoubleSpinBox>("posture_angle").setValue(12.5);
  operator_.find<QDoubleSpinBox>("posture_way").setValue(4.0);
  operator_.press("posture_turn_y_on");
  const Posture turned = with_link_changed(
      before.postures[1], 1, turn_about(EditAxis::y, 12.5 * kDegree_rad), EditAxes::own);
  EXPECT_WITHIN(angle_between(now().postures[1].X_L[1].q, turned.X_L[1].q), 0.0, kRounding);
  EXPECT_EQ(now().postures[1].X_L[1].p, before.postures[1].X_L[1].p);
  EXPECT_EQ(now().postures[1].X_L[0].q.coeffs(), before.postures[1].X_L[0].q.coeffs());
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Y, Qt::ShiftModifier);
  EXPECT_WITHIN(angle_between(now().postures[1].X_L[1].q, before.postures[1].X_L[1].q), 0.0,
                kRounding)
      << "the same way back";
  operator_.find<QComboBox>("posture_axes").setCurrentIndex(1);
  auto& sides = operator_.find<ArmViews>("posture_sides");
  sides.setFocus();
  QTest::keyClick(&sides, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_WITHIN(
      (now().postures[1].X_L[1].p - before.postures[1].X_L[1].p - Vec3(0, 0.004, 0)).norm(), 0.0,
      kRounding)
      << "along the axes of the forearm, in its own frame";
  EXPECT_TRUE(operator_.find<QLabel>("posture_series").isVisible());
  keep("library_postures");
}

TEST_F(PosturePage, UndoTakesBackEveryActAndRevertAllOfThem) {
  duplicate();
  const auto before = text().toPlainText();
  operator_.press("posture_turn_z_back");
  const auto turned = text().toPlainText();
  operator_.press("posture_duplicate");
  EXPECT_EQ(list().count(), 4);
  operator_.press("library_undo");
  EXPECT_EQ(list().count(), 3);
  EXPECT_EQ(text().toPlainText(), turned);
  operator_.press("library_undo");
  EXPECT_EQ(text().toPlainText(), before);
  operator_.press("library_redo");
  EXPECT_EQ(text().toPlainText(), turned);
  operator_.press("library_revert");
  ASSERT_TRUE(wait_until([&] { return text().toPlainText() == before; }));
  EXPECT_FALSE(operator_.find<QLabel>("posture_series").isVisible());
}

TEST_F(PosturePage, PosturesAreShortenedCopiedNamedAndDeleted) {
  duplicate();
  const Postures before = now();
  operator_.find<QSpinBox>("posture_percent").setValue(50);
  operator_.press("posture_part_new");
  ASSERT_EQ(list().count(), 4);
  EXPECT_EQ(list().currentRow(), 2) << "the new one, behind the one it is made of";
  EXPECT_EQ(now().postures[2].name, "unscrew 50");
  const auto whole = changes_from(before.postures[0], before.postures[1]);
  const auto half = changes_from(before.postures[0], now().postures[2]);
  for (std::size_t l = 0; l < whole.size(); ++l)
    EXPECT_WITHIN(half[l].angle_rad, 0.5 * whole[l].angle_rad, kRounding);
  EXPECT_EQ(now().postures[1].X_L[0].q.coeffs(), before.postures[1].X_L[0].q.coeffs());
  operator_.press("posture_duplicate");
  EXPECT_EQ(now().postures[3].name, "unscrew 50 2");
  auto& name = operator_.find<QLineEdit>("posture_name");
  name.setFocus();
  name.selectAll();
  QTest::keyClicks(&name, "half way");
  QTest::keyClick(&name, Qt::Key_Return);
  EXPECT_EQ(now().postures[3].name, "half way");
  name.selectAll();
  QTest::keyClicks(&name, "screw");
  QTest::keyClick(&name, Qt::Key_Return);
  EXPECT_EQ(now().postures[3].name, "half way");
  EXPECT_TRUE(label("library_remark").contains("screw")) << label("library_remark").toStdString();
  EXPECT_EQ(name.text(), "half way") << "a name that was refused goes";
  operator_.press("posture_remove");
  EXPECT_EQ(list().count(), 4);
  list().setCurrentRow(0);
  EXPECT_FALSE(enabled("posture_remove")) << "all others are seen from it";
}

TEST_F(PosturePage, WhatIsSavedIsReadBackToTheSameBitsAndNothingShippedChanges) {
  const auto shipped = windows_.presenter().state().config.library + "/postures/screw.toml";
  const auto original = must(read_text(shipped));
  duplicate();
  operator_.press("posture_turn_x_on");
  operator_.press("posture_move_z_back");
  const Postures shown = now();
  save();
  const Postures saved = must(parse_postures(must(read_text(path())), path()));
  ASSERT_EQ(saved.postures.size(), shown.postures.size());
  for (std::size_t j = 0; j < saved.postures.size(); ++j)
    for (std::size_t l = 0; l < 3; ++l) {
      EXPECT_EQ(saved.postures[j].X_L[l].p, shown.postures[j].X_L[l].p);
      EXPECT_EQ(saved.postures[j].X_L[l].q.coeffs(), shown.postures[j].X_L[l].q.coeffs());
    }
  EXPECT_EQ(must(read_text(shipped)), original);
  EXPECT_NE(path(), shipped);
}

TEST_F(PosturePage, AFileThatCannotBeReadIsShownAsItsTextWithTheError) {
  duplicate();
  const auto good = text().toPlainText();
  auto broken = good;
  text().replace_text(broken.replace("[[posture]]", "[[pose]]"));
  EXPECT_TRUE(text().isVisible());
  EXPECT_FALSE(list().isVisible());
  ASSERT_TRUE(wait_until([&] { return label("library_problem").contains("⚠"); }));
  operator_.press("library_undo");
  EXPECT_TRUE(list().isVisible());
  EXPECT_EQ(text().toPlainText(), good);
}

TEST_F(PosturePage, TheNameOfADuplicateIsTypedOverAtOnce) {
  duplicate();
  auto& name = operator_.find<QLineEdit>("posture_file_name");
  EXPECT_EQ(name.selectedText(), kScrew + " (copy)");
  QTest::keyClicks(&name, "Mine");
  QTest::keyClick(&name, Qt::Key_Return);
  EXPECT_EQ(now().name, "Mine");
  save();
  EXPECT_TRUE(wait_until([&] { return label("library_name") == "Mine"; }));
}

TEST_F(PosturePage, TheConnectedArmBecomesANewFileAndItsNextPosturesGoOnThere) {
  operator_.prepare_person();
  operator_.choose_device("sim://arm?patient=healthy&seed=7");
  operator_.answer_screening();
  operator_.press("connect");
  ASSERT_TRUE(wait_until([&] { return windows_.presenter().flow().view().may_zero; }));
  look_at_postures();
  open_file(kScrew);
  keep("library_postures_arm");
  EXPECT_TRUE(operator_.find<QPushButton>("posture_record").text().contains("new file"));
  operator_.press("posture_record");
  ASSERT_TRUE(wait_until([&] { return label("library_name") == "Recorded postures"; }))
      << label("library_remark").toStdString();
  ASSERT_TRUE(wait_until([&] {
    return operator_.find<QPushButton>("posture_record").text().contains("next posture");
  }));
  Postures recorded = must(parse_postures(must(read_text(path())), path()));
  EXPECT_EQ(recorded.chain, (std::vector<std::string>{"elbow", "forearm", "dorsum", "object"}));
  EXPECT_EQ(recorded.hand, Hand::right);
  ASSERT_EQ(recorded.postures.size(), 1U);
  operator_.press("posture_record");
  ASSERT_TRUE(wait_until([&] { return list().count() == 2; }))
      << label("library_remark").toStdString();
  EXPECT_TRUE(label("library_remark").contains("SD")) << label("library_remark").toStdString();
  recorded = now();
  // The arm rests: its second posture is the first but for what cameras and skin do to markers.
  constexpr double kStill_rad = 0.05;
  for (const LinkChange& change :
       isograsp::test::every(changes_from(recorded.postures[0], recorded.postures[1])))
    EXPECT_LT(change.angle_rad, kStill_rad);
  EXPECT_FALSE(windows_.presenter().state().snapshot().zeroed)
      << "it is not the start posture of the session";
  open_file(kScrew);
  EXPECT_TRUE(operator_.find<QPushButton>("posture_record").text().contains("new file"))
      << "postures of one arm do not fit those of another";
}

}  // namespace
}  // namespace isograsp::gui::test::posture_page_test
