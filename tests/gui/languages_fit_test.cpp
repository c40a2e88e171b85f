// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's window in every language on the smallest screen, with usual and with the largest
// letters: no text is cut off, mnemonics are told apart, and tooltips name the keys that there are.
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>

#include "cut_texts.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/record_pages/patient_page.hpp"
#include "gui/session_pages/state_light.hpp"
#include "gui/session_pages/step_section.hpp"
#include "operator.hpp"
#include "short_library.hpp"
#include "spoken.hpp"
#include "storage/access/open_store.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/every.hpp"
#include "tests/support/every_language.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::languages_fit_test {
namespace {

class FilledWindow : public QtTest {
 protected:
  FilledWindow(const std::string& language, int letters_percent) : spoken_(language.c_str()) {
    auto store = storage::open_store(path_, storage::OpenMode::create);
    EXPECT_TRUE(store.ok());
    add_course(**store, "P-1", true);
    store->reset();
    GuiConfig config{path_, "", ISOGRASP_SOURCE_DIR "/library", "test"};
    config.settings =
        folder_.write("isograsp.ini", "[General]\nlanguage=" + language +
                                          "\nfont_percent=" + std::to_string(letters_percent));
    windows_ = std::make_unique<Windows>(config);
    windows_->therapist().resize(1280, 720);
    windows_->therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_->clinic().is_open(); }));
    windows_->presenter().choices().choose_patient("P-1");
  }
  ~FilledWindow() override {
    windows_.reset();
    dress(*qApp);
  }

  /// Every page with all that may appear on it: steps opened, questions asked.
  void on_every_page(const std::function<void(QWidget&, const std::string&)>& look) {
    auto& window = windows_->therapist();
    auto& pages = *window.findChild<QStackedWidget*>("pages");
    for (int i = 0; i < pages.count(); ++i) {
      window.show_page(static_cast<TherapistWindow::Page>(i));
      if (i == static_cast<int>(TherapistWindow::Page::patient)) {
        auto* course = window.findChild<PatientPage*>();
        EXPECT_TRUE(wait_until([&] { return !course->loading(); }));
      }
      const auto name = "page " + std::to_string(i + 1);
      look(window, name);
      for (auto* tabs : pages.widget(i)->findChildren<QTabWidget*>())
        for (int tab = 0; tab < tabs->count(); ++tab) {
          tabs->setCurrentIndex(tab);
          EXPECT_TRUE(laid_out(window));
          look(window, name + ", tab " + std::to_string(tab + 1));
        }
      for (auto* section : pages.widget(i)->findChildren<StepSection*>()) {
        section->open(true);
        EXPECT_TRUE(laid_out(window));
        look(window,
             name + ", " + section->findChild<QAbstractButton*>()->objectName().toStdString());
        section->open(false);
      }
    }
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path("clinic.db");
  Spoken spoken_;
  std::unique_ptr<Windows> windows_;
};

class EveryPage : public FilledWindow, public ::testing::WithParamInterface<const char*> {
 protected:
  EveryPage() : FilledWindow(GetParam(), 100) {}
};
INSTANTIATE_TEST_SUITE_P(, EveryPage, ::testing::ValuesIn(test::every_language()),
                         test::code_of_language);

class LargestLetters : public FilledWindow, public ::testing::WithParamInterface<const char*> {
 protected:
  LargestLetters() : FilledWindow(GetParam(), 200) {}
};
INSTANTIATE_TEST_SUITE_P(, LargestLetters, ::testing::ValuesIn(test::every_language()),
                         test::code_of_language);

/// With an arm seen by cameras the page of a session looks different.
class ArmPage : public FilledWindow, public ::testing::WithParamInterface<const char*> {
 protected:
  ArmPage() : FilledWindow(GetParam(), 100) {
    windows_->presenter().choices().choose_device("sim://arm?patient=healthy&seed=7");
    windows_->therapist().show_page(TherapistWindow::Page::session);
  }
};
INSTANTIATE_TEST_SUITE_P(, ArmPage, ::testing::ValuesIn(test::every_language()),
                         test::code_of_language);

TEST_P(ArmPage, CutsNoTextOff) {
  auto& window = windows_->therapist();
  auto& page = *window.findChild<QStackedWidget*>("pages")->currentWidget();
  int seen = 0;
  for (auto* section : page.findChildren<StepSection*>()) {
    section->open(true);
    show_hidden_controls(page);
    EXPECT_TRUE(laid_out(window));
    EXPECT_EQ(cut_texts(window, "session", seen), std::set<std::string>{});
    section->open(false);
  }
  EXPECT_TRUE(widget_called<QWidget>("arm_views", window).isVisible());
  keep_picture(window, QStringLiteral("arm_page_%1").arg(GetParam()));
  EXPECT_GT(seen, 100);
}

/// So it does with both hands, each on a platform.
class BothPage : public FilledWindow, public ::testing::WithParamInterface<const char*> {
 protected:
  BothPage() : FilledWindow(GetParam(), 100) {
    windows_->presenter().choices().choose_both_hands();
    windows_->therapist().show_page(TherapistWindow::Page::session);
  }
};
INSTANTIATE_TEST_SUITE_P(, BothPage, ::testing::ValuesIn(test::every_language()),
                         test::code_of_language);

TEST_P(BothPage, CutsNoTextOff) {
  auto& window = windows_->therapist();
  auto& page = *window.findChild<QStackedWidget*>("pages")->currentWidget();
  int seen = 0;
  for (auto* section : page.findChildren<StepSection*>()) {
    section->open(true);
    show_hidden_controls(page);
    EXPECT_TRUE(laid_out(window));
    EXPECT_EQ(cut_texts(window, "session", seen), std::set<std::string>{});
    section->open(false);
  }
  EXPECT_TRUE(widget_called<QWidget>("platforms_left", window)
                  .isVisibleTo(widget_called<QWidget>("platforms_left", window).parentWidget()));
  EXPECT_GT(seen, 100);
}

/// The form of postures stands in the place of a text.
class PosturesOfTheLibrary : public FilledWindow,
                             public ::testing::WithParamInterface<const char*> {
 protected:
  PosturesOfTheLibrary() : FilledWindow(GetParam(), 100) {
    windows_->therapist().show_page(TherapistWindow::Page::library);
  }
};
INSTANTIATE_TEST_SUITE_P(, PosturesOfTheLibrary, ::testing::ValuesIn(test::every_language()),
                         test::code_of_language);

TEST_P(PosturesOfTheLibrary, CutNoTextOff) {
  auto& window = windows_->therapist();
  widget_called<QPushButton>("library_postures", window).click();
  auto& list = widget_called<QListWidget>("posture_list", window);
  ASSERT_TRUE(wait_until([&] { return list.isVisible() && list.count() > 1; }));
  widget_called<QPushButton>("library_duplicate", window).click();
  auto& turn = widget_called<QPushButton>("posture_turn_x_on", window);
  ASSERT_TRUE(wait_until([&] { return turn.isEnabled(); }));
  list.setCurrentRow(7);
  turn.click();
  ASSERT_TRUE(
      wait_until([&] { return widget_called<QPushButton>("library_save", window).isEnabled(); }));
  keep_pictures_of_both_sizes(window, QStringLiteral("postures_%1").arg(GetParam()));
  int seen = 0;
  show_hidden_controls(widget_called<QWidget>("posture_editor", window));
  EXPECT_TRUE(laid_out(window));
  EXPECT_EQ(cut_texts(window, "postures", seen), std::set<std::string>{});
  EXPECT_GT(seen, 40);
}

TEST_P(EveryPage, CutsNoTextOff) {
  std::set<std::string> cut;
  int seen = 0;
  on_every_page([&](QWidget& window, const std::string& page) {
    show_hidden_controls(*window.findChild<QStackedWidget*>("pages")->currentWidget());
    EXPECT_TRUE(laid_out(window));
    EXPECT_LE(window.width(), 1280) << page;
    cut.merge(cut_texts(window, page, seen));
  });
  EXPECT_GE(seen, 200);
  for (const auto& text : cut) ADD_FAILURE() << text;
}

TEST_P(LargestLetters, CutNoTextOffAndNobodyScrollsSideways) {
  std::set<std::string> cut;
  int seen = 0;
  on_every_page([&](QWidget& window, const std::string& page) {
    EXPECT_LE(window.width(), 1280) << page;
    auto* area =
        qobject_cast<QScrollArea*>(window.findChild<QStackedWidget*>("pages")->currentWidget());
    ASSERT_NE(area, nullptr);
    const int beyond_px = area->horizontalScrollBar()->maximum();
    std::string wide = page + " is " + std::to_string(beyond_px) + " px too wide:";
    for (const auto* widget : area->widget()->findChildren<QWidget*>())
      if (widget->minimumSizeHint().width() > area->viewport()->width())
        wide += std::string(" ") + widget->metaObject()->className() + " " +
                widget->objectName().toStdString();
    if (beyond_px > 0) cut.insert(wide);
    cut.merge(cut_texts(window, page, seen));
  });
  EXPECT_GE(seen, 200);
  for (const auto& text : cut) ADD_FAILURE() << text;
}

TEST_P(LargestLetters, FitIntoTheRowsOfListsAndTheFieldsOfChoices) {
  std::set<std::string> cut;
  int lists = 0;
  int choices = 0;
  on_every_page([&](QWidget& window, const std::string& page) {
    for (auto* list : window.findChildren<QListWidget*>()) {
      if (!list->isVisible() || list->count() == 0) continue;
      ++lists;
      const int row_px = list->sizeHintForRow(0);
      const auto name = page + ": " + list->objectName().toStdString();
      if (row_px < list->fontMetrics().height()) cut.insert(name + ", rows are too low");
      constexpr int kLeastRows = 2;
      if (list->viewport()->height() < std::min(list->count(), kLeastRows) * row_px)
        cut.insert(name + ", shows no two rows");
    }
    for (auto* choice : window.findChildren<QComboBox*>()) {
      // A choice of very long names shows their beginning and tells all of it when it is open.
      if (!choice->isVisible() ||
          choice->sizeAdjustPolicy() == QComboBox::AdjustToMinimumContentsLengthWithIcon)
        continue;
      ++choices;
      if (choice->minimumSizeHint().width() > choice->width())
        cut.insert(page + ": " + choice->currentText().toStdString());
    }
  });
  EXPECT_GE(lists, 5);
  EXPECT_GE(choices, 5);
  for (const auto& text : cut) ADD_FAILURE() << text;
}

/// Of an empty choice, as it is painted.
int arrow_width_px() {
  ChoiceBox box;
  box.resize(scaled(200), scaled(40));
  const QImage picture = box.grab().toImage();
  const int border_px = 4;
  int first = picture.width();
  int last = -1;
  for (int x = border_px; x < picture.width() - border_px; ++x)
    for (int y = border_px; y < picture.height() - border_px; ++y)
      if (qGray(picture.pixel(x, y)) < qGray(look::kQuietText.rgb())) {
        first = std::min(first, x);
        last = x;
      }
  EXPECT_GE(last, first) << "no arrow";
  return last - first + 1;
}

TEST_P(LargestLetters, ComeWithLargeSigns) {
  auto& window = windows_->therapist();
  constexpr int kUsual_px = 28;
  int largest_px = 0;
  for (const auto* light : window.findChildren<StateLight*>())
    largest_px = std::max(largest_px, light->width());
  EXPECT_EQ(largest_px, 2 * kUsual_px);
  const auto indicator_px = [](QStyle::PixelMetric size) {
    return qApp->style()->pixelMetric(size);
  };
  const int large_px = indicator_px(QStyle::PM_IndicatorWidth);
  const int large_arrow_px = arrow_width_px();
  dress(*qApp, 100);
  EXPECT_EQ(large_px, 2 * indicator_px(QStyle::PM_IndicatorWidth));
  EXPECT_GE(large_arrow_px, 1.7 * arrow_width_px()) << "of a choice";
}

TEST_P(EveryPage, GivesEachMnemonicOnceAndNamesItInTheTooltip) {
  static const QRegularExpression kAlt("Alt\\+([A-Z0-9])\\b");
  int named = 0;
  on_every_page([&](QWidget& window, const std::string& page) {
    std::map<QString, std::string> used;
    const auto take = [&](const QString& key, const std::string& by) {
      const auto [other, once] = used.emplace(key, by);
      EXPECT_TRUE(once) << page << ": " << key.toStdString() << " of " << by << " and "
                        << other->second;
    };
    const auto visible_or_ready = [](const QWidget& widget) {
      // A hidden question belongs to the page as soon as it is asked.
      return widget.isVisible() ||
             (widget.parentWidget() != nullptr && widget.parentWidget()->isVisible());
    };
    for (auto* widget : window.findChildren<QWidget*>()) {
      if (!visible_or_ready(*widget)) continue;
      const auto key = QKeySequence::mnemonic(widget->property("text").toString());
      if (key.isEmpty()) continue;
      take(key.toString(), widget->property("text").toString().toStdString());
    }
    // Fields without a label of their own have a fixed key.
    auto* shown_page = window.findChild<QStackedWidget*>("pages")->currentWidget();
    for (const auto* shortcut : shown_page->findChildren<QShortcut*>()) {
      const auto key = shortcut->key().toString();
      const auto* owner = qobject_cast<QWidget*>(shortcut->parent());
      if (kAlt.match(key).hasMatch() && owner != nullptr && visible_or_ready(*owner))
        take(key, owner->objectName().toStdString());
    }
    for (auto* widget : every(window.findChildren<QWidget*>())) {
      const auto found = kAlt.match(widget->toolTip());
      if (!found.hasMatch() || !widget->isVisible()) continue;
      const auto key = found.captured();
      if (key.at(4).isDigit()) continue;  // of a step
      ++named;
      EXPECT_TRUE(used.count(key) > 0)
          << page << ": no " << key.toStdString() << " for " << widget->toolTip().toStdString();
    }
  });
  EXPECT_GE(named, 10);
}

}  // namespace
}  // namespace isograsp::gui::test::languages_fit_test
