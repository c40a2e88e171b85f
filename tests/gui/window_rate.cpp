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
constexpr const char* kSine_s = "30";
constexpr int kObject_s = 30;

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

/// One session with a sine and an object; the same whether the windows are shown.
std::vector<Pictures> work(const std::string& database, const std::string& library, bool shown) {
  Windows windows(settling_soon({database, kDevice, library, "rate"}));
  const Operator therapist(windows);
  windows.show();
  if (shown) windows.show_patient_screen();
  EXPECT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  therapist.prepare(kDevice);
  therapist.strap_in();
  therapist.run_task();  // rest
  therapist.run_task();  // maximum
  if (!shown) windows.therapist().hide();
  auto& presenter = windows.presenter();
  std::vector<Pictures> pictures;
  const auto measure = [&](const char* page, const std::function<bool()>& over) {
    const auto before = shown ? windows.patient()->rate() : PatientWindow::Rate{};
    QElapsedTimer timer;
    timer.start();
    run_until(over);
    if (!shown) return;
    const auto after = windows.patient()->rate();
    const auto count = static_cast<double>(after.pictures - before.pictures);
    const double drawing_s = after.mean_s * static_cast<double>(after.pictures) -
                             before.mean_s * static_cast<double>(before.pictures);
    pictures.push_back(
        {page, count / (static_cast<double>(timer.elapsed()) * 1e-3), drawing_s / count * 1e3});
  };
  const auto begin = [&] {
    presenter.trials().start();
    EXPECT_TRUE(
        wait_until([&] { return presenter.state().snapshot().stage == session::Stage::trial; }));
  };
  begin();
  measure("force that follows a line", [&] { return !presenter.flow().view().may_stop; });
  EXPECT_TRUE(wait_until([&] { return presenter.flow().view().may_choose_task; }));
  therapist.choose_task("pose_targets");
  begin();
  QElapsedTimer timer;
  timer.start();
  measure("object in 3D",
          [&] { return !presenter.flow().view().may_stop || timer.elapsed() > 1000 * kObject_s; });
  presenter.trials().stop();
  presenter.connecting().end_session();
  EXPECT_TRUE(wait_until([&] { return !presenter.state().busy(); }));
  return pictures;
}

int compare() {
  TemporaryFolder folder;
  const auto library = make_short_library(folder, kSine_s);
  const auto with = folder.path("with.db");
  const auto without = folder.path("without.db");
  const auto pictures = work(with, library, true);
  work(without, library, false);
  std::printf(
      "| patient's screen, live plots beside it | pictures/s | each drawn in, ms |\n"
      "|---|---|---|\n");
  for (const auto& page : pictures)
    std::printf("| %s | %.1f | %.1f |\n", page.page, page.per_second, page.each_ms);
  std::printf(
      "\n| windows | task | frames | late, median ms | 99 %% | 99.9 %% | largest |\n"
      "|---|---|---|---|---|---|---|\n");
  print_lateness(with, "both");
  print_lateness(without, "none");
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
