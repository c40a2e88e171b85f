// SPDX-License-Identifier: GPL-3.0-or-later
// The library page in the therapist's window: errors as one types, previews, own files that appear
// in the session's list, nothing typed is lost.
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTextBlock>
#include <algorithm>
#include <filesystem>

#include "core/files.hpp"
#include "gui/library_pages/library_preview.hpp"
#include "gui/library_pages/library_view.hpp"
#include "gui/look/toml_editor.hpp"
#include "gui/presenter/next_words.hpp"
#include "operator.hpp"
#include "session/library/library.hpp"
#include "short_library.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::library_page_test {
namespace {

const std::string kShipped = std::string(ISOGRASP_SOURCE_DIR) + "/library";

LibraryPreview preview(LibraryKind kind, const std::string& file) {
  const auto path = kShipped + "/" + std::string(folder_of(kind)) + "/" + file;
  return preview_of(kind, read_text(path).value(), path, kShipped);
}

TEST(LibraryPreview, OfAForceTaskIsItsTargetInTheUnitOfItsScale) {
  const auto sine = preview(LibraryKind::tasks, "grip_sine.toml");
  ASSERT_TRUE(sine.curve.has_value());
  EXPECT_TRUE(sine.curve->axis.contains("% of the maximum"));
  double least = 1e9;
  double most = -1e9;
  for (const double value : sine.curve->values) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  constexpr double kSampled = 0.05;  // % : the curve's samples need not hit the very top
  EXPECT_WITHIN(least, 10.0, kSampled);
  EXPECT_WITHIN(most, 30.0, kSampled);
  EXPECT_WITHIN(sine.curve->period_s * static_cast<double>(sine.curve->values.size()), 32.0, 0.1);
  const auto sense = preview(LibraryKind::tasks, "force_sense.toml");
  ASSERT_TRUE(sense.curve.has_value());
  EXPECT_TRUE(std::any_of(sense.curve->hidden.begin(), sense.curve->hidden.end(), [](bool hidden) {
    return hidden;
  })) << "the force is made again without seeing it";
}

TEST(LibraryPreview, OfEveryShippedFileSaysSomething) {
  const LibraryFiles files(kShipped, kShipped + "/no/own");
  for (const auto kind :
       {LibraryKind::tasks, LibraryKind::scenes, LibraryKind::protocols, LibraryKind::postures})
    for (const auto& entry : every(files.list(kind))) {
      const auto shown = preview_of(kind, files.read(entry).value(), entry.path, kShipped);
      EXPECT_EQ(shown.title.toStdString(), entry.name);
      EXPECT_FALSE(shown.facts.empty()) << entry.path;
      EXPECT_TRUE(shown.sketch.has_value() || kind != LibraryKind::scenes) << entry.path;
      EXPECT_EQ(shown.steps.empty(), kind != LibraryKind::protocols) << entry.path;
    }
}

TEST(LibraryPreview, OfAProtocolHasStepsWhoseDurationsAddUpToThatOfTheWhole) {
  const auto path = kShipped + "/protocols/battery.toml";
  const auto whole = session::read_protocol(path, kShipped).value().duration();
  tasks::Duration sum;
  for (const auto& step : preview(LibraryKind::protocols, "battery.toml").steps) {
    sum.nominal_s += step.duration.nominal_s;
    sum.worst_s += step.duration.worst_s;
  }
  constexpr double kRounding_s = 1e-6;
  EXPECT_WITHIN(sum.nominal_s, whole.nominal_s, kRounding_s);
  EXPECT_WITHIN(sum.worst_s, whole.worst_s, kRounding_s);
}

TEST(LibraryPreview, OfASceneWithPadsIsWhatTheyCoverAndWhyTheirRaysEnd) {
  const auto block = preview(LibraryKind::scenes, "slim_block.toml");
  ASSERT_EQ(block.patches.size(), 3U);
  const auto ended = [&](std::size_t pad, RayStop stop) {
    const auto& stops = block.patches[pad].stops;
    return std::count(stops.begin(), stops.end(), stop);
  };
  EXPECT_EQ(ended(0, RayStop::length), 64) << "the thumb lies in the middle of its face";
  EXPECT_TRUE(block.patches[0].words.contains("middle: 0.00 mm along the tangent, 0.00 mm across"))
      << block.patches[0].words.toStdString();
  for (const std::size_t pad : {1U, 2U}) {
    EXPECT_EQ(ended(pad, RayStop::edge), 13);
    EXPECT_EQ(ended(pad, RayStop::length), 51);
    const auto& patch = block.patches[pad];
    EXPECT_EQ(patch.outline.size(), 64);
    constexpr double kRounding_m = 1e-9;
    const QRectF object =
        patch.object.boundingRect().adjusted(-kRounding_m, -kRounding_m, kRounding_m, kRounding_m);
    for (const QPointF& p : patch.outline) EXPECT_TRUE(object.contains(p));
    // The index reaches over the upper edge, the middle finger over the lower one: x is up.
    EXPECT_LT((pad == 1 ? 1.0 : -1.0) * patch.centroid.x(), -1e-4);
    EXPECT_TRUE(patch.words.contains("13 stop at an edge")) << patch.words.toStdString();
    EXPECT_TRUE(patch.words.contains("51 reach the end of the pad"));
    EXPECT_TRUE(patch.words.contains("3.32 N mm")) << patch.words.toStdString();
    EXPECT_TRUE(patch.words.contains("covers 119 of the 130 mm²")) << patch.words.toStdString();
  }
}

TEST(LibraryPreview, OfARoundObjectIsItsOutlineAsThePadLooksAtIt) {
  const std::string text =
      "format = \"isograsp-scene-1\"\nname = \"round\"\n[object]\nshape = \"SHAPE\"\nsize_m = "
      "SIZE\n"
      "mass_kg = 0.3\n[dynamics]\nfree = [\"x\"]\nstiffness = [1, 1, 1, 1, 1, 1]\n"
      "damping = [1, 1, 1, 1, 1, 1]\n[[contact]]\nfinger = \"index\"\nposition_m = [-0.02, 0, 0]\n"
      "normal = [1, 0, 0]\ntangent = [0, 1, 0]\nmodel = \"pad\"\nfriction = 0.3\n"
      "patch = {semi_axes_m = [0.0075, 0.0075]}\n";
  const auto shown = [&](const std::string& shape, const std::string& size) {
    std::string one = text;
    one.replace(one.find("SHAPE"), 5, shape);
    one.replace(one.find("SIZE"), 4, size);
    return preview_of(LibraryKind::scenes, one, "round.toml", kShipped);
  };
  const auto ball = shown("sphere", "[0.04]");
  ASSERT_EQ(ball.patches.size(), 1U);
  EXPECT_TRUE(ball.patches[0].words.contains("64 stop where friction no longer holds"));
  const QRectF round = ball.patches[0].object.boundingRect();
  constexpr double kCorners_m = 1e-4;  // a circle of 48 corners
  EXPECT_WITHIN(round.width(), 0.04, kCorners_m);
  EXPECT_WITHIN(round.height(), 0.04, kCorners_m);
  const auto rod = shown("cylinder", "[0.04, 0.1]");
  ASSERT_EQ(rod.patches.size(), 1U);
  const QRectF beside = rod.patches[0].object.boundingRect();
  EXPECT_WITHIN(beside.width(), 0.04, kCorners_m) << "tangent, across the axis";
  EXPECT_WITHIN(beside.height(), 0.1, kCorners_m) << "along the axis";
}

TEST(LibraryPreview, OfTwoHandsShowsWhoPressesWhere) {
  const auto tray = preview(LibraryKind::scenes, "tray.toml");
  ASSERT_TRUE(tray.sketch.has_value());
  ASSERT_EQ(tray.sketch->touches.size(), 2U);
  EXPECT_EQ(tray.sketch->touches[0].letters, "L");
  EXPECT_EQ(tray.sketch->touches[1].letters, "R");
  EXPECT_LT(tray.sketch->touches[0].place.x(), tray.sketch->touches[1].place.x());
  EXPECT_TRUE(tray.patches.empty());
}

class LibraryPageTest : public QtTest {
 protected:
  LibraryPageTest() { start(); }
  ~LibraryPageTest() override {
    if (windows_ == nullptr) return;
    windows_->presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_->presenter().state().busy(); }));
  }

  void start() {
    windows_ = std::make_unique<Windows>(
        settling_soon({folder_.path("clinic.db"), "sim://healthy?seed=7", library_, "test"}));
    operator_ = std::make_unique<Operator>(*windows_);
    windows_->therapist().show();
    ASSERT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
    windows_->therapist().show_page(TherapistWindow::Page::library);
    ASSERT_TRUE(wait_until([&] { return !editor().toPlainText().isEmpty(); }));
  }
  [[nodiscard]] TomlEditor& editor() { return operator_->find<TomlEditor>("library_editor"); }
  [[nodiscard]] QListWidget& list() { return operator_->find<QListWidget>("library_list"); }
  [[nodiscard]] QString problem() { return operator_->find<QLabel>("library_problem").text(); }
  [[nodiscard]] QString title() { return operator_->find<QLabel>("library_name").text(); }
  bool button(const char* name) { return operator_->find<QPushButton>(name).isEnabled(); }

  void choose(const QString& name) {
    const auto row_of = [&] {
      for (int row = 0; row < list().count(); ++row)
        if (list().item(row)->data(Qt::AccessibleTextRole).toString().startsWith(name)) return row;
      return -1;
    };
    ASSERT_TRUE(wait_until([&] { return row_of() >= 0; })) << name.toStdString();
    list().setCurrentRow(row_of());
    ASSERT_TRUE(wait_until([&] { return title() == name && problem().contains("✓"); }));
  }
  /// A duplicate of the shipped task, open in the editor.
  void duplicate(const QString& name = "Grip force, sine") {
    choose(name);
    operator_->press("library_duplicate");
    ASSERT_TRUE(wait_until(
        [&] { return title() == name + " (copy)" && editor().textCursor().hasSelection(); }));
    ASSERT_TRUE(wait_until([&] { return session_offers(name.toStdString() + " (copy)"); }));
  }
  /// As if typed: `from` is replaced by `to`.
  void type(const QString& from, const QString& to) {
    ASSERT_TRUE(editor().find(from) ||
                (editor().moveCursor(QTextCursor::Start), editor().find(from)))
        << from.toStdString();
    QTest::keyClicks(&editor(), to);
  }
  void save() {
    ASSERT_TRUE(wait_until([&] { return button("library_save"); })) << problem().toStdString();
    operator_->press("library_save");
    ASSERT_TRUE(wait_until([&] { return remark().startsWith("Saved"); })) << remark().toStdString();
  }
  void keep(const char* name) { keep_pictures_of_both_sizes(windows_->therapist(), name); }
  [[nodiscard]] QString remark() { return operator_->find<QLabel>("library_remark").text(); }
  [[nodiscard]] bool session_offers(const std::string& name) {
    const auto& tasks = windows_->presenter().state().library.tasks;
    return std::any_of(tasks.begin(), tasks.end(),
                       [&](const tasks::TaskSpec& task) { return task.name == name; });
  }

  TemporaryFolder folder_;
  std::string library_ = make_short_library(folder_);
  std::unique_ptr<Windows> windows_;
  std::unique_ptr<Operator> operator_;
};

TEST_F(LibraryPageTest, ShippedFilesAreReadOnlyAndSayHowToChangeThem) {
  choose("Grip force, sine");
  EXPECT_TRUE(editor().isReadOnly());
  EXPECT_FALSE(button("library_save"));
  EXPECT_FALSE(button("library_remove"));
  EXPECT_TRUE(button("library_duplicate"));
  EXPECT_TRUE(operator_->find<QLabel>("library_place").text().contains("Duplicate"));
  EXPECT_TRUE(operator_->find<TargetCurve>("library_curve").isVisible());
  keep("library_task");
}

TEST_F(LibraryPageTest, ADuplicateIsOpenWithItsNameSelectedAndAppearsInTheSession) {
  duplicate();
  EXPECT_FALSE(editor().isReadOnly());
  EXPECT_EQ(editor().textCursor().selectedText(), "Grip force, sine (copy)");
  QTest::keyClicks(&editor(), "My sine");
  save();
  ASSERT_TRUE(wait_until([&] { return session_offers("My sine"); }));
  EXPECT_FALSE(session_offers("Grip force, sine (copy)"));
  EXPECT_TRUE(wait_until([&] { return title() == "My sine"; }));
  auto& tasks = operator_->find<QListWidget>("tasks");
  EXPECT_EQ(tasks.findItems("My sine", Qt::MatchContains).size(), 1)
      << "also in the list of the session page";
}

TEST_F(LibraryPageTest, TheReadersOwnErrorIsShownWithItsLineAsOneTypes) {
  duplicate();
  type("kind = ", "knd = ");
  ASSERT_TRUE(wait_until([&] { return problem().contains("⚠"); }));
  EXPECT_FALSE(button("library_save")) << "a text that cannot be read is no file";
  const auto spec = tasks::parse_task(editor().toPlainText().toStdString(), "x");
  ASSERT_FALSE(spec.ok());
  EXPECT_TRUE(
      problem().contains(QString::fromStdString(english(spec.error().what)).toHtmlEscaped()));
  type("knd = ", "kind = ");
  ASSERT_TRUE(wait_until([&] { return problem().contains("✓"); }));
  EXPECT_FALSE(editor().marked_line());
  type("most_fraction = 0.3", "most_fraction = oops");
  ASSERT_TRUE(wait_until([&] { return editor().marked_line().has_value(); }));
  const auto line = editor().document()->findBlockByNumber(*editor().marked_line() - 1).text();
  EXPECT_TRUE(line.contains("oops")) << line.toStdString();
  keep("library_error");
  editor().moveCursor(QTextCursor::Start);
  operator_->press("library_go_to");
  EXPECT_EQ(editor().textCursor().blockNumber() + 1, editor().marked_line());
}

TEST_F(LibraryPageTest, ANameThatAnotherFileBearsIsRefusedAsOneTypes) {
  duplicate();
  QTest::keyClicks(&editor(), "Resting force");
  ASSERT_TRUE(wait_until([&] { return problem().contains("name"); }));
  EXPECT_FALSE(button("library_save"));
}

TEST_F(LibraryPageTest, RevertShowsWhatWasSavedAndUndoBringsTheTextBack) {
  duplicate();
  const auto saved = editor().toPlainText();
  type("duration_s = 5", "duration_s = 7");
  const auto typed = editor().toPlainText();
  operator_->press("library_revert");
  ASSERT_TRUE(wait_until([&] { return editor().toPlainText() == saved; }));
  operator_->press("library_undo");
  EXPECT_EQ(editor().toPlainText(), typed);
  operator_->press("library_redo");
  EXPECT_EQ(editor().toPlainText(), saved);
}

TEST_F(LibraryPageTest, WhatWasTypedIsThereAgainAfterTheProgramHasEnded) {
  duplicate();
  type("duration_s = 5", "duration_s = 7");
  const auto typed = editor().toPlainText();
  operator_.reset();
  windows_.reset();
  start();
  ASSERT_TRUE(wait_until([&] { return editor().toPlainText() == typed; }));
  EXPECT_TRUE(remark().contains("unsaved"));
  EXPECT_TRUE(list().item(1)->text().contains("●"));
  operator_->press("library_revert");
  ASSERT_TRUE(wait_until([&] { return editor().toPlainText().contains("duration_s = 5"); }));
}

TEST_F(LibraryPageTest, AFileWithOtherLineEndsIsNotUnsaved) {
  duplicate();
  const auto path = operator_->find<QLabel>("library_place").text().toStdString();
  auto text = QString::fromStdString(read_text(path).value());
  text.replace("\n", "\r\n").replace("\"Grip force, sine (copy)\"", "\"Sine\u00a0A\"");
  ASSERT_TRUE(write_text(path, text.toStdString()).ok());
  operator_.reset();
  windows_.reset();
  start();
  ASSERT_TRUE(wait_until([&] { return title() == QString("Sine\u00a0A"); }))
      << title().toStdString();
  ASSERT_TRUE(wait_until([&] { return problem().contains("✓"); }));
  EXPECT_FALSE(button("library_revert"));
  type("duration_s = 5", "duration_s = 7");
  save();
  EXPECT_FALSE(button("library_revert"));
}

TEST_F(LibraryPageTest, WhatWasRemovedCanBeBroughtBack) {
  duplicate();
  const auto path = operator_->find<QLabel>("library_place").text().toStdString();
  operator_->press("library_remove");
  ASSERT_TRUE(wait_until([&] { return !session_offers("Grip force, sine (copy)"); }));
  EXPECT_FALSE(std::filesystem::exists(path));
  operator_->press("library_bring_back");
  ASSERT_TRUE(wait_until([&] { return session_offers("Grip force, sine (copy)"); }));
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(LibraryPageTest, ATaskThatATrialUsedIsKeptAndGetsTheNextVersion) {
  duplicate("Resting force");
  const auto path = operator_->find<QLabel>("library_place").text().toStdString();
  const auto used = read_text(path).value();
  operator_->prepare("sim://healthy?seed=7");
  ASSERT_TRUE(wait_until([&] { return windows_->presenter().flow().view().may_choose_task; }));
  const auto& tasks = windows_->presenter().state().library.tasks;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].name == "Resting force (copy)")
      windows_->presenter().tasks().choose(static_cast<int>(i));
  ASSERT_EQ(next_words(windows_->presenter().state()), "Resting force (copy)");
  operator_->strap_in();
  operator_->run_task();
  ASSERT_TRUE(
      wait_until([&] { return windows_->presenter().state().traces().last_trial.has_value(); }));
  ASSERT_EQ(windows_->presenter().state().traces().last_trial->trial.task_text, used);
  windows_->therapist().show_page(TherapistWindow::Page::library);
  type("duration_s = 1.5", "duration_s = 2");
  save();
  EXPECT_TRUE(remark().contains("version 2")) << remark().toStdString();
  keep("library_saved");
  EXPECT_TRUE(editor().toPlainText().contains("version = 2"));
  EXPECT_EQ(session::load_task(path)->version, 2);
  const auto history = folder_.path("clinic.library") + "/history/tasks/resting_force_copy-1.toml";
  EXPECT_EQ(read_text(history).value(), used);
  type("duration_s = 2", "duration_s = 3");
  save();
  EXPECT_EQ(session::load_task(path)->version, 2) << "no trial used the text that is replaced now";
}

TEST_F(LibraryPageTest, ScenesAndProtocolsShowWhatTheyAre) {
  operator_->press("library_scenes");
  ASSERT_TRUE(wait_until([&] {
    return operator_->find<ObjectSketch>("library_sketch").isVisible() && problem().contains("✓");
  }));
  choose("planar block");
  EXPECT_TRUE(operator_->find<QLabel>("library_facts").text().contains("ns per frame"));
  keep("library_scene");
  choose("slim block");
  EXPECT_TRUE(operator_->find<PatchSketch>("library_patches").isVisible());
  keep("library_patch");
  choose("tray");
  EXPECT_FALSE(operator_->find<PatchSketch>("library_patches").isVisible());
  keep("library_tray");
  operator_->press("library_protocols");
  auto& steps = operator_->find<QTableWidget>("library_steps");
  ASSERT_TRUE(wait_until([&] { return steps.isVisible() && steps.rowCount() > 1; }));
  keep("library_protocol");
  operator_->press("library_tasks");
  choose("Pick and place");
  keep("library_object");
}

TEST_F(LibraryPageTest, SearchFindsAFileByAnyPartOfItsName) {
  auto& search = operator_->find<QLineEdit>("library_search");
  QTest::keyClicks(&search, "mirrored");
  ASSERT_EQ(list().count(), 3) << "two headings and the task";
  search.clear();
  EXPECT_GT(list().count(), 30);
}

}  // namespace
}  // namespace isograsp::gui::test::library_page_test
