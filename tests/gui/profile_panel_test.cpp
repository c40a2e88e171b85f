// SPDX-License-Identifier: GPL-3.0-or-later
// The form about a patient: what is typed is stored by itself, what makes no sense is refused in
// words, and nothing that was typed about one person gets to another.
#include "gui/record_pages/profile_panel.hpp"

#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSignalSpy>
#include <QTableWidget>
#include <memory>
#include <set>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "qt_test.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::profile_panel_test {
namespace {

constexpr const char* kOne = "P-0427";
constexpr const char* kOther = "P-0815";

QString iso_days_ago(int days) {
  return QDate::currentDate().addDays(-days).toString(Qt::ISODate);
}

class ProfileForm : public QtTest {
 protected:
  ProfileForm() {
    auto made = storage::open_store(database_, storage::OpenMode::create);
    EXPECT_TRUE(made.ok());
    for (const char* code : {kOne, kOther}) EXPECT_TRUE((*made)->add_patient(code).ok());
    made->reset();
    clinic_ = std::make_unique<Clinic>(database_);
    file_ = std::make_unique<PersonFile>(*clinic_);
    panel_ = std::make_unique<ProfilePanel>(*clinic_, *file_);
    panel_->setMinimumSize(400, 400);  // a window of its own, which no platform need be told of
    panel_->resize(800, 700);
    panel_->show();
    panel_->show_patient(kOne);  // before the database is open: it is read as soon as it is
    clinic_->open();
    EXPECT_TRUE(ready());
  }

  bool ready() {
    return wait_until([&] { return find<QWidget>("goals").isEnabled(); });
  }
  void show(const char* code) {
    panel_->show_patient(code);
    ASSERT_TRUE(ready());
  }
  template <class Widget>
  Widget& find(const char* name) const {
    return widget_called<Widget>(name, *panel_);
  }
  void press(const char* name) const {
    auto& button = find<QPushButton>(name);
    ASSERT_TRUE(button.isEnabled()) << name;
    button.click();
  }
  /// Replaces what stands in a line.
  void type(const char* name, const QString& text) const {
    auto& line = find<QLineEdit>(name);
    line.selectAll();
    if (text.isEmpty()) QTest::keyClick(&line, Qt::Key_Delete);
    QTest::keyClicks(&line, text);
  }
  QString words(const char* name) const {
    const auto& label = find<QLabel>(name);
    return label.isHidden() ? QString() : label.text();
  }
  bool saved() {
    return wait_until([&] { return words("profile_state").startsWith("Saved"); });
  }
  bool rows(const char* name, int count) {
    return wait_until([&] { return find<QTableWidget>(name).rowCount() == count; }) && saved();
  }
  static QStringList row_of(const QTableWidget& table, int row) {
    QStringList texts;
    for (int column = 0; column < table.columnCount(); ++column)
      texts.append(table.item(row, column)->text());
    return texts;
  }

  void take_picture(int width, int height, const char* state) const {
    if (qEnvironmentVariableIsEmpty("ISOGRASP_TEST_PICTURES")) return;
    panel_->resize(width, height);
    keep_picture(*panel_, QStringLiteral("profile_%1_%2").arg(state).arg(width));
  }

  /// Another program's look at the file.
  std::unique_ptr<storage::SessionStore> store() const {
    return storage::open_store(database_, storage::OpenMode::read_only).value();
  }
  storage::PatientProfile stored(const char* code = kOne) const {
    const auto reader = store();
    return reader->profile(reader->find_patient(code).value()->id).value();
  }
  std::vector<storage::TreatmentMark> stored_marks(const char* code = kOne) const {
    const auto reader = store();
    return reader->treatment_marks(reader->find_patient(code).value()->id).value();
  }
  std::vector<storage::ClinicalScore> stored_scores(const char* code = kOne) const {
    const auto reader = store();
    return reader->clinical_scores(reader->find_patient(code).value()->id).value();
  }

  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
  std::unique_ptr<Clinic> clinic_;
  std::unique_ptr<PersonFile> file_;
  std::unique_ptr<ProfilePanel> panel_;
};

TEST_F(ProfileForm, NothingIsToldBeforehand) {
  for (const char* name :
       {"affected_left", "affected_right", "affected_both", "affected_none", "dominant_left",
        "dominant_right", "sex_female", "sex_male", "sex_other"})
    EXPECT_FALSE(find<QPushButton>(name).isChecked()) << name;
  EXPECT_EQ(find<QLineEdit>("onset").text(), "");
  EXPECT_EQ(find<QLineEdit>("birth_year").text(), "");
  EXPECT_EQ(words("profile_title"), kOne);
  EXPECT_EQ(words("profile_state"), "");
}

TEST_F(ProfileForm, WhatIsToldIsStoredAndComesBackInAnotherForm) {
  press("affected_left");
  press("dominant_right");
  press("sex_female");
  type("birth_year", "1957");
  type("onset", iso_days_ago(10));
  QTest::keyClicks(&find<QPlainTextEdit>("goals"), "button a shirt");
  QTest::keyClicks(&find<QPlainTextEdit>("notes"), "tires soon");
  panel_->store_now();
  ASSERT_TRUE(saved());
  const storage::PatientProfile told{storage::Side::left,
                                     Hand::right,
                                     iso_days_ago(10).toStdString(),
                                     "tires soon",
                                     "button a shirt",
                                     storage::Sex::female,
                                     1957};
  EXPECT_EQ(stored(), told);
  EXPECT_EQ(stored(kOther), storage::PatientProfile{});
  EXPECT_EQ(words("onset_remark"), "10 days since the onset.");

  ProfilePanel second(*clinic_, *file_);
  second.show_patient(kOne);
  ASSERT_TRUE(wait_until([&] { return second.findChild<QWidget*>("goals")->isEnabled(); }));
  EXPECT_TRUE(second.findChild<QPushButton*>("affected_left")->isChecked());
  EXPECT_TRUE(second.findChild<QPushButton*>("dominant_right")->isChecked());
  EXPECT_TRUE(second.findChild<QPushButton*>("sex_female")->isChecked());
  EXPECT_EQ(second.findChild<QLineEdit*>("birth_year")->text(), "1957");
  EXPECT_EQ(second.findChild<QLineEdit*>("onset")->text(), iso_days_ago(10));
  EXPECT_EQ(second.findChild<QPlainTextEdit*>("goals")->toPlainText(), "button a shirt");
  EXPECT_EQ(second.findChild<QPlainTextEdit*>("notes")->toPlainText(), "tires soon");
}

TEST_F(ProfileForm, AYearThatNobodyWasBornInIsNotStored) {
  type("birth_year", "1957");
  ASSERT_TRUE(saved());
  for (const QString wrong : {"1899", "2999", "57", "soon"}) {
    type("birth_year", wrong);
    QTest::keyClick(&find<QLineEdit>("birth_year"), Qt::Key_Return);
    ASSERT_TRUE(saved());
    EXPECT_TRUE(words("birth_year_remark").startsWith("⚠ Not stored.")) << wrong.toStdString();
    EXPECT_EQ(words("profile_state"), "Saved, but for the year of birth");
    EXPECT_EQ(stored().birth_year, 1957);
  }
  type("birth_year", "");
  QTest::keyClick(&find<QLineEdit>("birth_year"), Qt::Key_Return);
  ASSERT_TRUE(saved());
  EXPECT_FALSE(stored().birth_year.has_value()) << "not known is an answer";
}

TEST_F(ProfileForm, TypingIsStoredByItselfAfterASecond) {
  QTest::keyClicks(&find<QPlainTextEdit>("notes"), "abc");
  EXPECT_EQ(words("profile_state"), "Saving …");
  EXPECT_EQ(stored().notes, "") << "not with every key";
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().notes, "abc");
}

TEST_F(ProfileForm, LeavingAFieldStoresItAtOnce) {
  auto& notes = find<QPlainTextEdit>("notes");
  QApplication::setActiveWindow(panel_.get());
  notes.setFocus();
  QTest::keyClicks(&notes, "abc");
  QSignalSpy added(clinic_.get(), &Clinic::patient_added);
  find<QPlainTextEdit>("goals").setFocus();
  clinic_->add_patient();  // the worker does one thing after the other
  ASSERT_TRUE(wait_until([&] { return !added.empty(); }));
  EXPECT_EQ(stored().notes, "abc");
}

TEST_F(ProfileForm, PressingTheChosenSideAgainTakesItBack) {
  press("affected_both");
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().affected, storage::Side::both);
  press("affected_none");
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().affected, storage::Side::none);
  EXPECT_FALSE(find<QPushButton>("affected_both").isChecked());
  press("affected_none");
  ASSERT_TRUE(saved());
  EXPECT_FALSE(stored().affected.has_value());
  EXPECT_FALSE(find<QPushButton>("affected_none").isChecked());
}

TEST_F(ProfileForm, AWrongOnsetIsRefusedInWordsAndLosesNothing) {
  type("onset", "2024-02-29");
  press("affected_left");
  ASSERT_TRUE(saved());
  for (const QString& wrong : {QString("2025-02-29"), QString("soon"), QString("3/5/2025"),
                               iso_days_ago(-3), QString("0025-01-01")}) {
    type("onset", wrong);
    QTest::keyClick(&find<QLineEdit>("onset"), Qt::Key_Return);
    ASSERT_TRUE(saved());
    EXPECT_TRUE(words("onset_remark").startsWith("⚠ Not stored.")) << wrong.toStdString();
    EXPECT_EQ(words("profile_state"), "Saved, but for the onset");
    EXPECT_EQ(find<QLineEdit>("onset").text(), wrong) << "to be mended, not typed again";
    EXPECT_EQ(stored().onset_date, "2024-02-29");
    EXPECT_EQ(stored().affected, storage::Side::left);
  }
  type("onset", "");
  panel_->store_now();
  ASSERT_TRUE(saved());
  EXPECT_EQ(words("onset_remark"), "");
  EXPECT_EQ(stored().onset_date, "") << "not known is an answer";
}

TEST_F(ProfileForm, HalfADateIsNotStored) {
  type("onset", "2025-02-2");
  QTest::keyClicks(&find<QPlainTextEdit>("notes"), "x");
  ASSERT_TRUE(saved()) << "a second after the last key";
  EXPECT_EQ(stored().notes, "x");
  EXPECT_EQ(stored().onset_date, "") << "it may become the 29th";
  QTest::keyClicks(&find<QLineEdit>("onset"), "8");
  show(kOther);
  EXPECT_EQ(stored().onset_date, "2025-02-28") << "what stands there when the form is left";
}

TEST_F(ProfileForm, AWholeDateIsStoredAfterASecond) {
  type("onset", "2025-02-28");
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().onset_date, "2025-02-28");
  QTest::keyClick(&find<QLineEdit>("onset"), Qt::Key_Up);
  ASSERT_TRUE(wait_until([&] { return words("profile_state") == "Saving …"; }));
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().onset_date, "2025-03-01");
}

TEST_F(ProfileForm, ADateMayBeTypedAsPeopleWriteIt) {
  for (const char* way : {"2024-3-5", "5.3.2024", "05. 03. 2024", " 2024-03-05 "}) {
    type("onset", way);
    QTest::keyClick(&find<QLineEdit>("onset"), Qt::Key_Return);
    EXPECT_EQ(find<QLineEdit>("onset").text(), "2024-03-05") << way;
  }
  QTest::keyClick(&find<QLineEdit>("onset"), Qt::Key_Down);
  EXPECT_EQ(find<QLineEdit>("onset").text(), "2024-03-04");
  for (int i = 0; i < 4; ++i) QTest::keyClick(&find<QLineEdit>("onset"), Qt::Key_Down);
  EXPECT_EQ(find<QLineEdit>("onset").text(), "2024-02-29");
  panel_->store_now();
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().onset_date, "2024-02-29");
}

TEST_F(ProfileForm, TreatmentsAreAddedRemovedAndBroughtBack) {
  type("treatment_date", "2026-03-05");
  find<QComboBox>("treatment_kind").setCurrentIndex(0);
  type("treatment_text", "FDS 100 U");
  press("treatment_add");
  ASSERT_TRUE(rows("treatment_list", 1));
  type("treatment_date", "2026-01-05");
  find<QComboBox>("treatment_kind").setCurrentIndex(2);
  QTest::keyClick(&find<QLineEdit>("treatment_text"), Qt::Key_Return);
  ASSERT_TRUE(rows("treatment_list", 2));
  auto& list = find<QTableWidget>("treatment_list");
  EXPECT_EQ(row_of(list, 0), (QStringList{"2026-01-05", "Orthosis", ""}));
  EXPECT_EQ(row_of(list, 1), (QStringList{"2026-03-05", "Botulinum toxin", "FDS 100 U"}));
  const auto both = stored_marks();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].kind, "botulinum_toxin");

  list.selectRow(1);
  press("treatment_remove");
  ASSERT_TRUE(rows("treatment_list", 1));
  list.selectRow(0);
  press("treatment_remove");
  ASSERT_TRUE(rows("treatment_list", 0));
  EXPECT_TRUE(stored_marks().empty());
  press("treatment_undo");
  ASSERT_TRUE(rows("treatment_list", 1));
  EXPECT_EQ(stored_marks().at(0).on_date, "2026-01-05") << "what was removed last comes first";
  press("treatment_undo");
  ASSERT_TRUE(rows("treatment_list", 2));
  const auto back = stored_marks();
  EXPECT_EQ(back[1].on_date, "2026-03-05");
  EXPECT_EQ(back[1].text, "FDS 100 U");
  EXPECT_TRUE(find<QPushButton>("treatment_undo").isHidden());
}

TEST_F(ProfileForm, ScoresAreAddedRemovedAndBroughtBack) {
  type("score_date", "2026-03-05");
  find<QComboBox>("score_scale").setCurrentText("MAS");
  type("score_value", "1+");
  type("score_text", "FDS");
  press("score_add");
  ASSERT_TRUE(rows("score_list", 1));
  find<QComboBox>("score_scale").setCurrentText("NHPT");
  type("score_value", "31,5");
  press("score_add");
  ASSERT_TRUE(rows("score_list", 2));
  auto& list = find<QTableWidget>("score_list");
  EXPECT_EQ(row_of(list, 0), (QStringList{"2026-03-05", "MAS", "1+", "FDS"}));
  EXPECT_EQ(row_of(list, 1), (QStringList{"2026-03-05", "NHPT", "31.5 s", ""}));
  EXPECT_EQ(stored_scores().at(0).value, 1.5);
  EXPECT_EQ(stored_scores().at(1).value, 31.5);
  list.selectRow(0);
  press("score_remove");
  ASSERT_TRUE(rows("score_list", 1));
  EXPECT_EQ(stored_scores().size(), 1U);
  press("score_undo");
  ASSERT_TRUE(rows("score_list", 2));
  EXPECT_EQ(stored_scores().size(), 2U);
}

TEST_F(ProfileForm, AnImpossibleScoreIsRefusedInWordsAndStaysToBeMended) {
  EXPECT_EQ(words("score_remark"), "Action Research Arm Test: 0 to 57") << "said beforehand";
  for (const char* wrong : {"58", "-1", "many", ""}) {
    type("score_date", "2026-03-05");
    type("score_value", wrong);
    type("score_text", "right arm");
    press("score_add");
    EXPECT_TRUE(words("score_remark").startsWith("⚠ Not added.")) << wrong;
    EXPECT_EQ(find<QLineEdit>("score_value").text(), wrong);
    EXPECT_EQ(find<QLineEdit>("score_text").text(), "right arm");
  }
  type("score_value", "58");
  press("score_add");
  EXPECT_EQ(words("score_remark"),
            "⚠ Not added. 58 is not possible. Action Research Arm Test: 0 to 57.");
  type("score_date", iso_days_ago(-1));
  type("score_value", "57");
  press("score_add");
  EXPECT_TRUE(words("score_remark").contains("has not come yet")) << "a day to come";
  EXPECT_EQ(find<QLineEdit>("score_value").text(), "57");
  type("score_date", "2026-03-05");
  press("score_add");
  ASSERT_TRUE(rows("score_list", 1));
  EXPECT_EQ(stored_scores().at(0).value, 57.0);
  EXPECT_EQ(stored_scores().at(0).text, "right arm");
}

TEST_F(ProfileForm, AWrongDayOfATreatmentIsRefusedInWordsAndLosesNothing) {
  type("treatment_date", "2026-02-30");
  type("treatment_text", "splint");
  press("treatment_add");
  EXPECT_TRUE(words("treatment_remark").startsWith("⚠ Not added. “2026-02-30”"));
  EXPECT_EQ(find<QLineEdit>("treatment_text").text(), "splint");
  EXPECT_TRUE(stored_marks().empty());
}

TEST_F(ProfileForm, NothingTypedAboutOnePersonGetsToAnother) {
  QTest::keyClicks(&find<QPlainTextEdit>("notes"), "of the first");
  type("treatment_text", "half-typed");
  type("score_value", "5");
  type("score_date", "2026-03-05");
  type("score_value", "6");
  press("score_add");
  ASSERT_TRUE(rows("score_list", 1));
  find<QTableWidget>("score_list").selectRow(0);
  press("score_remove");
  QTest::keyClicks(&find<QPlainTextEdit>("goals"), "quickly");
  show(kOther);  // within the second after the last key
  EXPECT_EQ(stored(kOne).notes, "of the first");
  EXPECT_EQ(stored(kOne).goals, "quickly");
  for (const char* name : {"notes", "goals"}) {
    auto& field = find<QPlainTextEdit>(name);
    EXPECT_EQ(field.toPlainText(), "");
    QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(field.toPlainText(), "") << "undo reaches no other person's text";
  }
  for (const char* name : {"treatment_text", "score_value", "onset"}) {
    auto& field = find<QLineEdit>(name);
    QTest::keyClick(&field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(field.text(), "") << name;
  }
  EXPECT_TRUE(find<QPushButton>("score_undo").isHidden());
  panel_->store_now();
  EXPECT_EQ(stored(kOther), storage::PatientProfile{});
  show(kOne);
  EXPECT_EQ(find<QPlainTextEdit>("notes").toPlainText(), "of the first");
}

TEST_F(ProfileForm, UndoInATextFieldIsStoredToo) {
  auto& notes = find<QPlainTextEdit>("notes");
  QTest::keyClicks(&notes, "abc");
  panel_->store_now();
  ASSERT_TRUE(saved());
  QTest::keyClick(&notes, Qt::Key_Z, Qt::ControlModifier);
  panel_->store_now();
  ASSERT_TRUE(saved());
  EXPECT_EQ(stored().notes, notes.toPlainText().toStdString());
  EXPECT_NE(notes.toPlainText(), "abc");
}

TEST_F(ProfileForm, ClosingTheFormStoresWhatWasTypedLast) {
  QTest::keyClicks(&find<QPlainTextEdit>("notes"), "last words");
  panel_.reset();
  file_.reset();
  clinic_.reset();
  EXPECT_EQ(stored().notes, "last words");
}

TEST_F(ProfileForm, WhatCannotBeStoredIsSaidKeptAndStoredByTryingAgain) {
  soci::session sql(soci::sqlite3, "db=\"" + database_ + "\"");
  const auto rename = [&](const char* from, const char* to) {
    for (const char* table : {"patient_profiles", "treatment_marks"})
      sql << std::string("ALTER TABLE ") + table + from + " RENAME TO " + table + to;
  };
  rename("", "_gone");
  QSignalSpy refused(file_.get(), &PersonFile::failed);
  QTest::keyClicks(&find<QPlainTextEdit>("notes"), "kept");
  type("treatment_text", "kept too");
  press("treatment_add");
  panel_->store_now();
  ASSERT_TRUE(wait_until([&] { return refused.size() == 2; }));
  EXPECT_TRUE(words("profile_state").startsWith("⚠ Not saved"));
  EXPECT_EQ(find<QPlainTextEdit>("notes").toPlainText(), "kept");
  rename("_gone", "");
  press("profile_again");
  ASSERT_TRUE(rows("treatment_list", 1));
  EXPECT_EQ(stored().notes, "kept");
  ASSERT_EQ(stored_marks().size(), 1U) << "once";
  EXPECT_EQ(stored_marks()[0].text, "kept too");
}

TEST_F(ProfileForm, NobodyIsShownWithoutACode) {
  panel_->show_patient("");
  EXPECT_EQ(words("profile_state"), "Choose a patient first.");
  EXPECT_FALSE(find<QWidget>("goals").isEnabled());
  EXPECT_FALSE(find<QPushButton>("score_add").isEnabled());
}

TEST_F(ProfileForm, EveryFocusableWidgetHasItsOwnNameATooltipAndAKey) {
  std::set<QString> names;
  for (auto* widget : every(panel_->findChildren<QWidget*>())) {
    if (widget->focusPolicy() == Qt::NoFocus) continue;
    if (widget->objectName().startsWith("qt_")) continue;  // parts of Qt's own widgets
    if (qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr) continue;
    if (widget->inherits("QComboBoxPrivateContainer") || widget->inherits("QHeaderView")) continue;
    if (widget->inherits("QComboBoxListView") || widget->inherits("QTableCornerButton")) continue;
    if (widget->inherits("QLabel") || widget->inherits("QLineEditIconButton")) continue;
    const auto what = widget->objectName().toStdString() + " " + widget->metaObject()->className();
    EXPECT_TRUE(names.insert(widget->objectName()).second) << what;
    EXPECT_FALSE(widget->objectName().isEmpty()) << what;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << what;
    EXPECT_TRUE(widget->toolTip().contains("Alt+") || widget->toolTip().contains("Ctrl+"))
        << what << " has no key: " << widget->toolTip().toStdString();
  }
  EXPECT_GE(names.size(), 20U) << "the walk must have found the widgets of the form";
}

TEST_F(ProfileForm, NoTwoActsShareAKey) {
  // Each card has its own Add, Remove and Undo: their keys are those of the card with the focus.
  std::set<std::pair<QWidget*, QString>> keys;
  for (auto* shortcut : every(panel_->findChildren<QShortcut*>()))
    EXPECT_TRUE(keys.emplace(shortcut->parentWidget(), shortcut->key().toString()).second)
        << shortcut->key().toString().toStdString();
  EXPECT_GE(keys.size(), 15U);
}

/// For looking at: ISOGRASP_TEST_PICTURES names the folder.
TEST_F(ProfileForm, FitsANarrowAndAWideWindow) {
  take_picture(420, 1000, "empty");
  press("affected_left");
  press("dominant_right");
  type("onset", iso_days_ago(43));
  find<QPlainTextEdit>("goals").setPlainText("Button a shirt without help; carry a cup of coffee.");
  for (const auto& [day, kind, text] :
       {std::tuple{"2026-02-02", 0, "FDS 100 U, FDP 50 U"}, std::tuple{"2026-02-16", 2, ""},
        std::tuple{"2026-03-02", 3, "Task-oriented training, five times a week"}}) {
    type("treatment_date", day);
    find<QComboBox>("treatment_kind").setCurrentIndex(kind);
    type("treatment_text", text);
    press("treatment_add");
  }
  for (const auto& [scale, value] :
       {std::pair{"ARAT", "23"}, std::pair{"FMA-UE", "31"}, std::pair{"NHPT", "58.4"}}) {
    find<QComboBox>("score_scale").setCurrentText(scale);
    type("score_value", value);
    press("score_add");
  }
  ASSERT_TRUE(rows("score_list", 3));
  find<QTableWidget>("treatment_list").selectRow(1);
  press("treatment_remove");
  ASSERT_TRUE(rows("treatment_list", 2));
  find<QComboBox>("score_scale").setCurrentText("ARAT");
  type("score_value", "58");
  press("score_add");
  for (const int width : {420, 800}) {
    panel_->resize(width, 720);
    ASSERT_TRUE(wait_until([&] { return find<QWidget>("page").width() <= width; }, 5))
        << find<QWidget>("page").width() << " at " << width << ", window " << panel_->width();
    ASSERT_TRUE(laid_out(*panel_));
    for (auto* widget : every(panel_->findChildren<QWidget*>())) {
      if (!widget->isVisible() || widget->objectName().isEmpty()) continue;
      if (widget->objectName().startsWith("qt_")) continue;
      const int right = widget->mapTo(panel_.get(), QPoint(widget->width(), 0)).x();
      EXPECT_LE(right, width) << widget->objectName().toStdString() << " at " << width;
    }
    for (auto* button : every(panel_->findChildren<QPushButton*>())) {
      if (!button->isVisible()) continue;
      EXPECT_GE(button->width(), button->fontMetrics().horizontalAdvance(button->text()) + 10)
          << button->objectName().toStdString() << " at " << width;
    }
    take_picture(width, width < 700 ? 1130 : 720, "filled");
  }
}

}  // namespace
}  // namespace isograsp::gui::test::profile_panel_test
