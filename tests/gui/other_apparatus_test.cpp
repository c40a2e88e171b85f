// SPDX-License-Identifier: GPL-3.0-or-later
// An apparatus that is no platform in the windows: its own steps, its pauses, its trial.
#include <filesystem>

#include "operator.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/dynamometer.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::other_apparatus_test {
namespace {

using namespace test;

/// A minute of steady pressing; every two seconds out of sight for a while.
std::string handle(const TemporaryFolder& folder) {
  std::string text = "t_s,force_N\n";
  for (int k = 0; k < 6000; ++k)
    text += std::to_string(0.01 * k) + (k % 200 < 150 ? ",20\n" : ",\n");
  return "handle://" + folder.write("forces.csv", text) + "?live=1";
}

std::string handles_library(const TemporaryFolder& folder) {
  std::filesystem::create_directories(folder.path("library/tasks"));
  static_cast<void>(folder.write(
      "library/tasks/handling.toml",
      "format = \"isograsp-task-1\"\nname = \"Free handling\"\ninstruction = \"Press.\"\n"
      "version = 1\nkind = \"observe\"\nduration_s = 3\n"));
  std::filesystem::create_directories(folder.path("library/protocols"));
  static_cast<void>(folder.write(
      "library/protocols/session.toml",
      "format = \"isograsp-protocol-1\"\nname = \"Handling\"\n[[step]]\nkind = \"task\"\n"
      "task = \"handling.toml\"\n"));
  return folder.path("library");
}

class HandleInWindows : public QtTest {
 protected:
  explicit HandleInWindows(const char* more = "")
      : windows_([&] {
          GuiConfig config{folder_.path("clinic.db"), handle(folder_) + more,
                           handles_library(folder_), "test"};
          config.apparatuses = apparatuses_with_handle();
          return config;
        }()) {
    windows_.show();
  }
  ~HandleInWindows() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }
  const FlowView& view() { return windows_.presenter().flow().view(); }
  StepState state(Step step) { return view().steps[static_cast<std::size_t>(step)]; }
  bool is_there(Step step) {
    const auto name = QStringLiteral("section_%1").arg(static_cast<int>(step) + 1);
    return operator_.find<QAbstractButton>(qPrintable(name)).isVisible();
  }
  void connect() {
    operator_.prepare_person();
    windows_.presenter().choices().choose_protocol(0);
    EXPECT_TRUE(is_there(Step::zero)) << "nobody knows yet what the device asks for";
    operator_.press("connect");
    ASSERT_TRUE(wait_until([&] {
      return windows_.presenter().state().session_open() &&
             view().situation != Situation::wait_for_forces;
    })) << view().sentence;
  }

  TemporaryFolder folder_;
  Windows windows_;
  Operator operator_{windows_};
};

TEST_F(HandleInWindows, HasItsOwnStepsAndOutOfSightItsTrialWaitsWithoutAFault) {
  connect();
  EXPECT_EQ(state(Step::zero), StepState::absent);
  EXPECT_EQ(state(Step::rest), StepState::absent);
  EXPECT_FALSE(is_there(Step::zero));
  EXPECT_FALSE(is_there(Step::rest));
  EXPECT_EQ(view().next(), Step::work) << view().sentence;
  operator_.press("start");
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::goes_on_by_itself; }))
      << view().sentence;
  EXPECT_NE(view().mood, Mood::fault);
  EXPECT_EQ(view().device_mood, Mood::ready);
  const auto picture = windows_.presenter().patient_view().picture(0.2);
  EXPECT_NE(picture.notice, PatientPicture::Notice::fault);
  ASSERT_TRUE(wait_until([&] { return view().situation == Situation::protocol_over; }))
      << view().sentence;
  windows_.presenter().connecting().end_session();
  ASSERT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  EXPECT_TRUE(is_there(Step::zero)) << "of the next device nothing is known";
  const auto store =
      storage::open_store(folder_.path("clinic.db"), storage::OpenMode::read_only).value();
  const auto session = store->recent_sessions(1).value().at(0);
  EXPECT_EQ(store->trials(session.id).value().at(0).status, storage::TrialStatus::completed);
}

class HandleWithZero : public HandleInWindows {
 protected:
  HandleWithZero() : HandleInWindows("&zero=1") {}
};

TEST_F(HandleWithZero, AsksForItsZeroAndForNoStrappedHand) {
  connect();
  EXPECT_EQ(view().next(), Step::zero) << view().sentence;
  EXPECT_TRUE(is_there(Step::zero));
  EXPECT_FALSE(is_there(Step::rest));
  operator_.press("zero");
  ASSERT_TRUE(wait_until([&] { return view().next() == Step::work; })) << view().sentence;
  EXPECT_EQ(state(Step::zero), StepState::done);
}

}  // namespace
}  // namespace isograsp::gui::other_apparatus_test
