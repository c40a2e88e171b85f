// SPDX-License-Identifier: GPL-3.0-or-later
// Primary measures and stable times in the form about a patient.
#include "gui/record_pages/change_cards.hpp"

#include <QSignalSpy>
#include <QTableWidget>

#include "gui/record_pages/profile_panel.hpp"
#include "qt_test.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::change_cards_test {
namespace {

class ChangeForm : public QtTest {
 protected:
  ChangeForm() {
    auto store = storage::open_store(database_, storage::OpenMode::create);
    EXPECT_TRUE(store.ok());
    add_session(**store, "P-1", {});
    EXPECT_TRUE((*store)->add_patient("P-2").ok());
    store->reset();
    clinic_ = std::make_unique<Clinic>(database_);
    file_ = std::make_unique<PersonFile>(*clinic_);
    panel_ = std::make_unique<ProfilePanel>(*clinic_, *file_);
    panel_->setMinimumSize(400, 400);
    panel_->resize(900, 860);
    panel_->show();
    clinic_->open();
    panel_->show_patient("P-1");
    EXPECT_TRUE(wait_until([&] { return find<QComboBox>("primary_measure").count() > 0; }));
  }

  template <class Widget>
  Widget& find(const char* name) const {
    return widget_called<Widget>(name, *panel_);
  }
  void type(const char* name, const QString& text) const {
    auto& line = find<QLineEdit>(name);
    line.selectAll();
    QTest::keyClicks(&line, text);
  }
  void press(const char* name) const { find<QPushButton>(name).click(); }
  QString words(const char* name) const { return find<QLabel>(name).text(); }
  bool rows(const char* name, int count) {
    return wait_until([&] {
      return find<QTableWidget>(name).rowCount() == count &&
             words("profile_state").startsWith("Saved");
    });
  }
  std::vector<storage::PrimaryMeasure> stored_primaries() const {
    const auto reader = storage::open_store(database_, storage::OpenMode::read_only).value();
    return reader->primary_measures(reader->find_patient("P-1").value()->id).value();
  }
  std::vector<storage::StablePeriod> stored_periods() const {
    const auto reader = storage::open_store(database_, storage::OpenMode::read_only).value();
    return reader->stable_periods(reader->find_patient("P-1").value()->id).value();
  }
  void take_picture(const char* state) const {
    keep_picture(*panel_, QStringLiteral("change_%1").arg(state));
  }

  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
  std::unique_ptr<Clinic> clinic_;
  std::unique_ptr<PersonFile> file_;
  std::unique_ptr<ProfilePanel> panel_;
};

TEST_F(ChangeForm, AMeasureIsChosenByNameWithWhoAndWhen) {
  auto& measures = find<QComboBox>("primary_measure");
  EXPECT_EQ(measures.itemText(0), "Maximum grip above rest · Maximum grip force, right hand");
  press("primary_add");
  EXPECT_EQ(words("primary_remark"), "⚠ Not added. Say who chooses it.");
  EXPECT_TRUE(stored_primaries().empty());
  type("primary_by", "Therapist 7");
  press("primary_add");
  ASSERT_TRUE(rows("primary_list", 1));
  const auto stored = stored_primaries();
  ASSERT_EQ(stored.size(), 1U);
  EXPECT_EQ(stored[0].measure, "maximum_force");
  EXPECT_EQ(stored[0].chosen_by, "Therapist 7");
  EXPECT_GT(stored[0].chosen_utc, "2026-06-01");
  press("primary_add");
  EXPECT_EQ(words("primary_remark"), "⚠ Not added. This measure is chosen already.");
}

TEST_F(ChangeForm, OnlyMeasuresOfWhichMoreIsBetterOrWorseCanBeChosen) {
  const auto& measures = find<QComboBox>("primary_measure");
  ASSERT_GT(measures.count(), 4);
  for (int i = 0; i < measures.count(); ++i)
    EXPECT_FALSE(measures.itemText(i).startsWith("Comfortable")) << i;
}

TEST_F(ChangeForm, AFifthMeasureCannotBeAddedUntilOneIsRemoved) {
  type("primary_by", "T7");
  for (int i = 0; i < 4; ++i) {
    find<QComboBox>("primary_measure").setCurrentIndex(i);
    press("primary_add");
    ASSERT_TRUE(rows("primary_list", i + 1));
  }
  take_picture("four");
  EXPECT_FALSE(find<QPushButton>("primary_add").isEnabled());
  EXPECT_TRUE(words("primary_remark").startsWith("Four are chosen."));
  const auto before = stored_primaries();
  find<QTableWidget>("primary_list").selectRow(0);
  press("primary_remove");
  ASSERT_TRUE(rows("primary_list", 3));
  EXPECT_TRUE(find<QPushButton>("primary_add").isEnabled());
  press("primary_undo");
  ASSERT_TRUE(rows("primary_list", 4));
  for (const auto& primary : every(stored_primaries()))
    EXPECT_TRUE(std::any_of(before.begin(), before.end(), [&](const auto& one) {
      return one.measure == primary.measure && one.chosen_utc == primary.chosen_utc;
    })) << "it comes back with the time at which it was chosen";
}

TEST_F(ChangeForm, StableTimesAreAddedRemovedAndBroughtBack) {
  type("stable_from", "2026-02-01");
  type("stable_until", "2026-02-20");
  type("stable_by", "Dr 3");
  type("stable_text", "plateau");
  press("stable_add");
  ASSERT_TRUE(rows("stable_list", 1));
  ASSERT_EQ(stored_periods().size(), 1U);
  const auto stored = stored_periods()[0];
  EXPECT_EQ(stored.from_date, "2026-02-01");
  EXPECT_EQ(stored.until_date, "2026-02-20");
  EXPECT_EQ(stored.judged_by, "Dr 3");
  EXPECT_EQ(stored.text, "plateau");
  take_picture("stable");
  find<QTableWidget>("stable_list").selectRow(0);
  press("stable_remove");
  ASSERT_TRUE(rows("stable_list", 0));
  EXPECT_TRUE(stored_periods().empty());
  press("stable_undo");
  ASSERT_TRUE(rows("stable_list", 1));
  EXPECT_EQ(stored_periods()[0].judged_utc, stored.judged_utc);
}

TEST_F(ChangeForm, AStableTimeThatMakesNoSenseIsRefusedInWords) {
  type("stable_from", "2026-02-10");
  type("stable_until", "2026-02-01");
  press("stable_add");
  EXPECT_EQ(words("stable_remark"), "⚠ Not added. The last day is before the first.");
  type("stable_until", "2026-02-20");
  press("stable_add");
  EXPECT_EQ(words("stable_remark"), "⚠ Not added. Say which clinician judges so.");
  type("stable_by", "Dr 3");
  press("stable_add");
  ASSERT_TRUE(rows("stable_list", 1));
  type("stable_from", "2026-02-15");
  type("stable_until", "2026-02-28");
  press("stable_add");
  EXPECT_EQ(words("stable_remark"),
            "⚠ Not added. It overlaps the time from 2026-02-10 until 2026-02-20.");
  EXPECT_EQ(stored_periods().size(), 1U);
}

TEST_F(ChangeForm, NothingOfOnePersonStaysForTheNext) {
  type("primary_by", "T7");
  press("primary_add");
  ASSERT_TRUE(rows("primary_list", 1));
  type("stable_text", "half-typed");
  panel_->show_patient("P-2");
  ASSERT_TRUE(wait_until([&] { return find<QWidget>("goals").isEnabled(); }));
  EXPECT_EQ(find<QTableWidget>("primary_list").rowCount(), 0);
  EXPECT_EQ(find<QComboBox>("primary_measure").count(), 0);
  EXPECT_EQ(words("primary_remark"), "Measures can be chosen from the first assessment on.");
  EXPECT_EQ(find<QLineEdit>("stable_text").text(), "");
  EXPECT_EQ(find<QLineEdit>("primary_by").text(), "T7") << "the therapist is the same";
}

}  // namespace
}  // namespace isograsp::gui::test::change_cards_test
