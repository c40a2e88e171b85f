// SPDX-License-Identifier: GPL-3.0-or-later
// Easier and harder in the therapist's window.
#include <algorithm>

#include "operator.hpp"
#include "short_library.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::difficulty_test {
namespace {

class Difficulty : public QtTest {
 protected:
  Difficulty() {
    windows_.therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  }
  ~Difficulty() override {
    presenter_.connecting().end_session();
    EXPECT_TRUE(wait_until([&] { return !presenter_.state().busy(); }));
  }

  /// A new session, and in it the first task of the library whose difficulty can be chosen.
  void begin() {
    const auto place = first_task(presenter_.state().library.tasks,
                                  [](const auto& task) { return task.difficulty.has_value(); });
    ASSERT_TRUE(place);
    operator_.prepare("sim://healthy?seed=7");
    presenter_.tasks().choose(*place);
    ASSERT_TRUE(presenter_.tasks().difficulty());
  }

  TemporaryFolder folder_;
  Windows windows_{
      settling_soon({folder_.path("clinic.db"), "", make_short_library(folder_), "test"})};
  Operator operator_{windows_};
  SessionPresenter& presenter_ = windows_.presenter();
};

TEST_F(Difficulty, ThatWasChosenForOnePersonEndsWithTheSession) {
  begin();
  const double usual = *presenter_.tasks().difficulty();
  operator_.press("harder");
  EXPECT_GT(*presenter_.tasks().difficulty(), usual);
  operator_.disconnect();
  begin();  // for somebody else
  EXPECT_EQ(*presenter_.tasks().difficulty(), usual);
}

}  // namespace
}  // namespace isograsp::gui::test::difficulty_test
