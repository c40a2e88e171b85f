// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's page of one patient, by mouse and by key, without a display.
#include "gui/record_pages/patient_page.hpp"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>

#include "qt_test.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::patient_page_test {
namespace {

class PatientPageTest : public QtTest {
 protected:
  PatientPageTest() {
    auto store = storage::open_store(path_, storage::OpenMode::scratch);
    EXPECT_TRUE(store.ok());
    add_course(**store, "P-1", true);
    EXPECT_TRUE((*store)->add_patient("P-2").ok());
    store->reset();
    clinic_ = std::make_unique<Clinic>(path_);
    host_.resize(1180, 640);
    page_ = new PatientPage(*clinic_, ISOGRASP_SOURCE_DIR "/library", &host_);
    page_->resize(host_.size());
    host_.show();
    clinic_->open();
    EXPECT_TRUE(wait_until([&] { return clinic_->is_open(); }));
  }
  ~PatientPageTest() override { delete page_; }  // before the clinic

  void show(const char* code) {
    page_->show_patient(code);
    ASSERT_TRUE(wait_until([&] { return !page_->loading(); }));
  }
  void open(int session, int trial) {
    page_->open_trial(session, trial);
    ASSERT_TRUE(wait_until([&] { return !page_->loading(); }));
  }
  template <class Widget>
  Widget& find(const char* name) {
    return widget_called<Widget>(name, *page_);
  }
  [[nodiscard]] static QString all_text(const QTableWidget& table) {
    QStringList texts;
    for (int row = 0; row < table.rowCount(); ++row)
      for (int column = 0; column < table.columnCount(); ++column)
        if (const auto* item = table.item(row, column)) texts << item->text();
    return texts.join("|");
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path("clinic.db");
  std::unique_ptr<Clinic> clinic_;
  QWidget host_;
  PatientPage* page_ = nullptr;
};

TEST_F(PatientPageTest, SaysThatItLoadsAndThenShowsTheNewestSessionFirst) {
  page_->show_patient("P-1");
  EXPECT_TRUE(page_->loading());
  EXPECT_TRUE(find<QLabel>("patient_summary").text().startsWith("Loading"));
  ASSERT_TRUE(wait_until([&] { return !page_->loading(); }));
  auto& sessions = find<QListWidget>("course_sessions");
  ASSERT_EQ(sessions.count(), 6);
  EXPECT_EQ(sessions.currentRow(), 0);
  EXPECT_TRUE(sessions.item(0)->text().startsWith("2026-04-08"));
  const auto said = sessions.item(0)->data(Qt::AccessibleTextRole).toString();
  EXPECT_TRUE(said.contains("SIMULATED")) << said.toStdString();
  EXPECT_TRUE(said.contains("1 not completed")) << said.toStdString();
  EXPECT_EQ(find<QListWidget>("course_trials").count(), 8);
  QTest::keyClick(&sessions, Qt::Key_Down);
  EXPECT_EQ(find<QListWidget>("course_trials").count(), 7);
  EXPECT_GT(page_->trend_grid().trends().size(), 5U);
}

TEST_F(PatientPageTest, NothingOfOnePatientStaysForTheNext) {
  show("P-1");
  open(5, 4);
  show("P-2");
  EXPECT_EQ(find<QListWidget>("course_sessions").count(), 0);
  EXPECT_EQ(find<QListWidget>("course_trials").count(), 0);
  EXPECT_TRUE(page_->trend_grid().trends().empty());
  EXPECT_EQ(find<QTableWidget>("compare_table").rowCount(), 0);
  page_->show_view(PatientPage::View::trial);
  EXPECT_FALSE(find<QWidget>("trial_plot").isVisible());
  show("P-9");
  EXPECT_TRUE(find<QLabel>("patient_summary").text().contains("no patient P-9"));
}

TEST_F(PatientPageTest, APrimaryMeasureSaysItsVerdictOnItsTileAndInTheLargePicture) {
  {
    auto store = storage::open_store(path_, storage::OpenMode::existing).value();
    const storage::RowId id = store->find_patient("P-1").value()->id;
    ASSERT_TRUE(
        store
            ->add_primary_measure(id, {0, "Maximum grip force", Hand::right, "maximum_force",
                                       "grip", "2026-03-01T00:00:00Z", "T7"})
            .ok());
    ASSERT_TRUE(store->set_profile(id, {storage::Side::right, {}, "", "", ""}).ok());
  }
  show("P-1");
  auto& grid = page_->trend_grid();
  if (const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES"); !folder.isEmpty()) {
    QDir().mkpath(folder);
    EXPECT_TRUE(page_->grab().save(folder + "/patient_verdict.png"));
  }
  int with_verdict = 0;
  for (std::size_t i = 0; i < grid.trends().size(); ++i) {
    const auto& trend = grid.trends()[i];
    if (trend.remark.isEmpty()) continue;
    ++with_verdict;
    EXPECT_EQ(i, 0U) << "what is judged comes first";
    EXPECT_EQ(trend.source.measure, "maximum_force");
    EXPECT_EQ(trend.remark, "Cannot be judged yet: 0 of 10 stable people");
    EXPECT_TRUE(grid.tile(i)->accessibleName().contains(trend.remark));
    grid.open_large(i);
    bool said = false;
    for (const auto* label : grid.findChildren<QLabel*>())
      said = said || (label->isVisible() && label->text().contains(trend.remark));
    EXPECT_TRUE(said);
  }
  EXPECT_EQ(with_verdict, 1);
}

TEST_F(PatientPageTest, ALaterWishOvertakesAnEarlierOne) {
  page_->show_patient("P-1");
  page_->show_patient("P-2");
  ASSERT_TRUE(wait_until([&] { return !page_->loading(); }));
  EXPECT_EQ(page_->course()->code, "P-2");
}

TEST_F(PatientPageTest, EnterOnATrialOpensItWithItsMeasuresAndFacts) {
  show("P-1");
  auto& trials = find<QListWidget>("course_trials");
  trials.setCurrentRow(4);
  QTest::keyClick(&trials, Qt::Key_Return);
  ASSERT_TRUE(page_->loading());
  EXPECT_TRUE(find<QLabel>("trial_warning").text().startsWith("Loading"));
  ASSERT_TRUE(wait_until([&] { return !page_->loading(); }));
  EXPECT_FALSE(find<QLabel>("trial_warning").isVisible());
  const auto known = all_text(find<QTableWidget>("trial_about"));
  for (const char* word : {"Tracking error", "Task version", "Seed", "Counts as", "SIMULATED",
                           "Sensors and bus", "Index: lost 2"})
    EXPECT_TRUE(known.contains(word)) << word << " in " << known.toStdString();
  EXPECT_TRUE(find<QLabel>("trial_reading").text().contains("Target"));
}

TEST_F(PatientPageTest, SpacePlaysPausesAndTheCursorFollows) {
  show("P-1");
  open(5, 4);
  auto& play = find<QPushButton>("trial_play");
  auto& slider = find<QSlider>("trial_slider");
  auto& speed = find<QComboBox>("trial_speed");
  QTest::keyClick(&slider, Qt::Key_Plus);
  EXPECT_EQ(speed.currentData().toDouble(), 2.0);
  QTest::keyClick(&slider, Qt::Key_Space);
  EXPECT_EQ(play.text(), "Pause");
  ASSERT_TRUE(wait_until([&] { return slider.value() > 300; }));
  QTest::keyClick(&play, Qt::Key_Space);
  EXPECT_EQ(play.text(), "Play");
  const int at = slider.value();
  QTest::qWait(80);
  EXPECT_EQ(slider.value(), at);
  QTest::keyClick(&slider, Qt::Key_Right);
  EXPECT_EQ(slider.value(), at + 100);
  auto& plot = find<QWidget>("trial_plot");
  QTest::keyClick(&plot, Qt::Key_End);
  EXPECT_EQ(slider.value(), slider.maximum());
  QTest::keyClick(&plot, Qt::Key_Left);
  EXPECT_EQ(slider.value(), slider.maximum() - 10) << "a sample of 10 ms";
  QTest::keyClick(&plot, Qt::Key_Space);
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_EQ(slider.value(), 0);
}

TEST_F(PatientPageTest, AHiddenReplayStands) {
  show("P-1");
  open(5, 4);
  QTest::keyClick(&find<QSlider>("trial_slider"), Qt::Key_Space);
  page_->show_view(PatientPage::View::trends);
  EXPECT_EQ(find<QPushButton>("trial_play").text(), "Play");
}

TEST_F(PatientPageTest, WithoutOpenGlThePathIsDrawnFlatAndSaysWhy) {
  if (QGuiApplication::platformName() != "offscreen") GTEST_SKIP() << "there may be OpenGL";
  show("P-1");
  open(5, 6);
  auto* flat = page_->findChild<ObjectPathView*>();
  ASSERT_NE(flat, nullptr);
  EXPECT_TRUE(flat->isVisible());
  bool told = false;
  for (const auto* label : page_->findChildren<QLabel*>())
    told = told || (label->isVisible() && label->text().contains("OpenGL"));
  EXPECT_TRUE(told);
  const auto before = flat->grab().toImage();
  find<QSlider>("trial_slider").setValue(find<QSlider>("trial_slider").maximum() / 2);
  EXPECT_NE(flat->grab().toImage(), before) << "the object has moved";
  open(5, 4);
  EXPECT_FALSE(flat->isVisible()) << "a force task has no object";
}

TEST_F(PatientPageTest, AnyRecordedChannelCanBeDrawn) {
  show("P-1");
  open(5, 6);
  auto& set = find<QComboBox>("trial_curves");
  set.setCurrentIndex(set.count() - 1);
  auto& channels = find<QListWidget>("trial_channels");
  EXPECT_TRUE(channels.isVisible());
  for (int row = 0; row < channels.count(); ++row) {
    const auto name = channels.item(row)->text();
    channels.item(row)->setCheckState(Qt::Checked);
    EXPECT_TRUE(find<QLabel>("trial_reading").text().contains(name)) << name.toStdString();
  }
}

TEST_F(PatientPageTest, ArrowsWalkThroughTheTrendsAndEnterEnlargesOne) {
  show("P-1");
  page_->show_view(PatientPage::View::trends);
  auto& grid = page_->trend_grid();
  auto* first = grid.tile(0);
  EXPECT_EQ(first->focusPolicy(), Qt::StrongFocus);
  QTest::keyClick(first, Qt::Key_Right);
  EXPECT_EQ(first->focusPolicy(), Qt::ClickFocus) << "the Tab key reaches one picture only";
  EXPECT_EQ(grid.tile(1)->focusPolicy(), Qt::StrongFocus);
  QTest::keyClick(grid.tile(1), Qt::Key_Return);
  auto& back = find<QPushButton>("trend_back");
  EXPECT_TRUE(back.isVisible());
  QTest::keyClick(&back, Qt::Key_Escape);
  EXPECT_FALSE(back.isVisible());
  QTest::mouseClick(grid.tile(2), Qt::LeftButton);
  EXPECT_TRUE(back.isVisible());
}

TEST_F(PatientPageTest, TwoSessionsAreComparedWithNAndUnit) {
  show("P-1");
  page_->show_view(PatientPage::View::comparison);
  auto& table = find<QTableWidget>("compare_table");
  const auto text = all_text(table);
  EXPECT_GT(table.rowCount(), 3);
  EXPECT_TRUE(text.contains("(n 2)")) << text.toStdString();
  EXPECT_TRUE(text.contains(" N")) << text.toStdString();
  const int few = table.rowCount();
  find<QAbstractButton>("compare_all").click();
  EXPECT_GT(table.rowCount(), few);
  auto& a = find<QComboBox>("compare_a");
  a.setCurrentIndex(find<QComboBox>("compare_b").currentIndex());
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_TRUE(find<QLabel>("compare_remark").text().contains("one session twice"));
}

TEST_F(PatientPageTest, EveryFocusableWidgetHasANameAndAKeyOrArrowHint) {
  show("P-1");
  open(5, 6);
  int seen = 0;
  for (auto* widget : every(page_->findChildren<QWidget*>())) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith("qt_")) continue;
    if (qobject_cast<QComboBox*>(widget->parentWidget()) != nullptr) continue;
    if (widget->inherits("QHeaderView") || widget->inherits("QTableCornerButton") ||
        widget->inherits("QComboBoxListView") || widget->inherits("QComboBoxPrivateContainer") ||
        widget->inherits("QLabel"))
      continue;
    ++seen;
    const auto what = widget->objectName().toStdString() + " " + widget->metaObject()->className();
    EXPECT_FALSE(widget->objectName().isEmpty()) << what;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << what;
    const auto tip = widget->toolTip();
    EXPECT_TRUE(tip.contains("(F") || tip.contains("arrow") || tip.contains("Space") ||
                tip.contains("Escape") || tip.contains("(keys"))
        << what << ": " << tip.toStdString();
  }
  EXPECT_GE(seen, 15);
}

TEST_F(PatientPageTest, FitsTheSmallestScreen) {
  show("P-1");
  open(5, 6);
  for (const auto view :
       {PatientPage::View::trends, PatientPage::View::comparison, PatientPage::View::trial}) {
    page_->show_view(view);
    EXPECT_LE(page_->minimumSizeHint().width(), 1180);
    EXPECT_LE(page_->minimumSizeHint().height(), 640);
  }
}

}  // namespace
}  // namespace isograsp::gui::test::patient_page_test
