// SPDX-License-Identifier: GPL-3.0-or-later
// What the windows cost (scripts/window_rate): pictures a second with the live plots on, and how
// late frames are with both windows, and with none.
//   gui_window_rate              prints a table
//   gui_window_rate start        ends as soon as the therapist can work: its time is the start
#include <QWindow>
#include <cstdio>
#include <cstring>

#include "operator.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test {
namespace {

constexpr const char* kDevice = "sim://healthy?seed=7";
constexpr const char* kHand = "sim://hand?user=healthy&seed=7";
constexpr const char* kSine_s = "30";

/// Of the last trials of the newest session: what was stored of their frames.
void print_lateness(const std::string& database, const char* with) {
  auto store = storage::open_store(database, storage::OpenMode::read_only);
  const auto session = (*store)->recent_sessions(1)->front();
  for (const auto& trial : *(*store)->trials(session.id)) {
    if (trial.samples < 1000) continue;
    const auto of_lateness = [&](const char* key) {
      const auto& json = trial.timing_json;
      const auto place = json.find(key, json.find("\"lateness\""));
      return std::strtod(json.c_str() + json.find(':', place) + 1, nullptr) * 1e3;
    };
    std::printf("| %s | %s | %lld | %.3f | %.3f | %.3f | %.3f |\n", with, trial.task_name.c_str(),
                static_cast<long long>(trial.samples), of_lateness("\"median_s\""),
                of_lateness("\"p99_s\""), of_lateness("\"p999_s\""), of_lateness("\"max_s\""));
  }
}

/// As the program waits: until the next event, not for a while in between as tests do.
void run_until(const std::function<bool()>& over) {
  while (!over()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

struct Pictures {
  const char* page;
  double per_second;
  double each_ms;
};

/// What the patient's screen costs while something is done.
class Watch {
 public:
  Watch(Windows& windows, bool shown) : windows_(windows), shown_(shown) {}

  void measure(const char* page, const std::function<bool()>& over) {
    const auto before = shown_ ? windows_.patient()->rate() : PatientWindow::Rate{};
    QElapsedTimer timer;
    timer.start();
    run_until([&] { return over() || timer.elapsed() > 1000 * kLongest_s; });
    if (!shown_) return;
    const auto after = windows_.patient()->rate();
    const auto count = static_cast<double>(after.pictures - before.pictures);
    const double drawing_s = after.mean_s * static_cast<double>(after.pictures) -
                             before.mean_s * static_cast<double>(before.pictures);
    pictures_.push_back(
        {page, count / (static_cast<double>(timer.elapsed()) * 1e-3), drawing_s / count * 1e3});
  }
  /// From the press to its end, or for kLongest_s.
  void measure_trial(const char* page) {
    auto& presenter = windows_.presenter();
    presenter.trials().start();
    EXPECT_TRUE(
        wait_until([&] { return presenter.state().snapshot().stage == session::Stage::trial; }));
    measure(page, [&] { return !presenter.flow().view().may_stop; });
    presenter.trials().stop();
    EXPECT_TRUE(wait_until([&] { return presenter.flow().view().may_choose_task; }));
  }
  [[nodiscard]] const std::vector<Pictures>& pictures() const noexcept { return pictures_; }

 private:
  static constexpr int kLongest_s = 40;

  Windows& windows_;
  bool shown_;
  std::vector<Pictures> pictures_;
};

void open_windows(Windows& windows, bool shown) {
  windows.show();
  if (shown) windows.show_patient_screen();
  EXPECT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
}
void end_session(Windows& windows) {
  windows.presenter().connecting().end_session();
  EXPECT_TRUE(wait_until([&] { return !windows.presenter().state().busy(); }));
}

/// One session with a sine and an object; the same whether the windows are shown.
std::vector<Pictures> work(const std::string& database, const std::string& library, bool shown) {
  Windows windows(settling_soon({database, kDevice, library, "rate"}));
  const Operator therapist(windows);
  open_windows(windows, shown);
  therapist.prepare(kDevice);
  therapist.strap_in();
  therapist.run_task();  // rest
  therapist.run_task();  // maximum
  if (!shown) windows.therapist().hide();
  Watch watch(windows, shown);
  watch.measure_trial("force that follows a line");
  therapist.choose_task("pose_targets");
  watch.measure_trial("object in 3D");
  end_session(windows);
  return watch.pictures();
}

/// One session with a tracked hand that places objects, the physics of its grasp included.
std::vector<Pictures> work_of_hand(const std::string& database, const std::string& library,
                                   bool shown) {
  Windows windows({database, kHand, library, "rate"});
  const Operator therapist(windows);
  const FlowView& view = windows.presenter().flow().view();
  open_windows(windows, shown);
  therapist.prepare_person();
  therapist.press("connect");
  EXPECT_TRUE(wait_until([&] { return view.may_zero; })) << view.sentence;
  therapist.press("entry_test");
  EXPECT_TRUE(wait_until([&] { return view.may_start; })) << view.sentence;
  if (!shown) windows.therapist().hide();
  Watch watch(windows, shown);
  watch.measure_trial("tracked hand and its object in 3D");
  end_session(windows);
  return watch.pictures();
}

int compare() {
  const TemporaryFolder folder;
  const TemporaryFolder folder_of_hand;
  const auto library = make_short_library(folder, kSine_s);
  const auto library_of_hand = make_hand_library(folder_of_hand, 6);
  const auto with = folder.path("with.db");
  const auto without = folder.path("without.db");
  const auto hand_with = folder.path("hand_with.db");
  const auto hand_without = folder.path("hand_without.db");
  auto pictures = work(with, library, true);
  for (const auto& page : work_of_hand(hand_with, library_of_hand, true)) pictures.push_back(page);
  work(without, library, false);
  work_of_hand(hand_without, library_of_hand, false);
  std::printf(
      "| patient's screen, live plots beside it | pictures/s | each drawn in, ms |\n"
      "|---|---|---|\n");
  for (const auto& page : pictures)
    std::printf("| %s | %.1f | %.1f |\n", page.page, page.per_second, page.each_ms);
  std::printf(
      "\n| windows | task | frames | late, median ms | 99 %% | 99.9 %% | largest |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const auto& database : {with, hand_with}) print_lateness(database, "both");
  for (const auto& database : {without, hand_without}) print_lateness(database, "none");
  return ::testing::Test::HasFailure() ? 1 : 0;
}

/// Returns when the window is there, the database is open and a press would be taken.
int start() {
  TemporaryFolder folder;
  Windows windows({folder.path("clinic.db"), "", ISOGRASP_SOURCE_DIR "/library", "rate"});
  windows.show();
  const auto& window = windows.therapist();
  const auto usable = [&] {
    return windows.clinic().is_open() && window.windowHandle() != nullptr &&
           window.windowHandle()->isExposed();
  };
  while (!usable()) QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
  QApplication::processEvents();
  return 0;
}

}  // namespace
}  // namespace isograsp::gui::test

int main(int argc, char** argv) {
  ::testing::InitGoogleTest();
  isograsp::gui::test::application();
  return argc > 1 && std::strcmp(argv[1], "start") == 0 ? isograsp::gui::test::start()
                                                        : isograsp::gui::test::compare();
}
