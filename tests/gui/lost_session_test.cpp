// SPDX-License-Identifier: GPL-3.0-or-later
// A session that cannot be stored to its end is told of, also to somebody who is about to leave.
#include <cstdlib>
#include <filesystem>

#include "operator.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::lost_session_test {
namespace {

namespace fs = std::filesystem;
using namespace test;

class LostSession : public QtTest {
 protected:
  LostSession() {
    setenv("XDG_STATE_HOME", folder_.path("state").c_str(), 1);
    windows_.show();
  }
  ~LostSession() override {
    windows_.presenter().connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
    unsetenv("XDG_STATE_HOME");
  }

  TemporaryFolder folder_;
  Windows windows_{
      {folder_.path("clinic.db"), "sim://healthy?seed=7", ISOGRASP_SOURCE_DIR "/library", "test"}};
  Operator operator_{windows_};
};

TEST_F(LostSession, FoundWhileTheWindowClosesKeepsItOpenUntilItWasSeen) {
  operator_.prepare("sim://healthy?seed=7");
  fs::rename(folder_.path("clinic.db"), folder_.path("away.db"));
  windows_.therapist().close();
  ASSERT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  EXPECT_TRUE(windows_.therapist().isVisible());
  const auto words = operator_.find<QLabel>("sentence").text().toStdString();
  EXPECT_NE(words.find("was deleted or moved away"), std::string::npos) << words;
  const auto& remedy = operator_.find<QLabel>("fault_remedy");
  EXPECT_TRUE(remedy.isVisible()) << "on whatever page";
  EXPECT_TRUE(remedy.text().contains("isograsp db rescue")) << remedy.text().toStdString();
  ASSERT_TRUE(windows_.presenter().state().connection.lost);
  windows_.therapist().close();
  EXPECT_FALSE(windows_.therapist().isVisible()) << "seen now";
}

TEST_F(LostSession, ASoundOneLetsTheWindowGo) {
  operator_.prepare("sim://healthy?seed=7");
  windows_.therapist().close();
  ASSERT_TRUE(wait_until([&] { return !windows_.therapist().isVisible(); }));
  EXPECT_FALSE(windows_.presenter().state().connection.lost);
}

}  // namespace
}  // namespace isograsp::gui::lost_session_test
