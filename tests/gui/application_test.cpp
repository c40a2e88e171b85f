// SPDX-License-Identifier: GPL-3.0-or-later
// Without a display the program says so and ends; it does not crash.
#include "gui/application.hpp"

#include "qt_test.hpp"

namespace isograsp::gui::test::application_test {
namespace {

/// Sets a variable of the environment until the end of the test; an empty value removes it.
class Variable {
 public:
  Variable(const char* name, const QByteArray& value) : name_(name), before_(qgetenv(name)) {
    set(value);
  }
  ~Variable() { set(before_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const QByteArray& value) {
    if (value.isEmpty())
      qunsetenv(name_);
    else
      qputenv(name_, value);
  }
  const char* name_;
  QByteArray before_;
};

class Display : public QtTest {
 protected:
  Variable platform_{"QT_QPA_PLATFORM", ""};
  Variable wayland_{"WAYLAND_DISPLAY", ""};
};

TEST_F(Display, NoneIsAnErrorWithARemedy) {
  const Variable display("DISPLAY", "");
  const auto done = run_application({});
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, Error::Code::failed);
  EXPECT_FALSE(done.error().remedy.empty());
}

TEST_F(Display, OneThatCannotBeReachedIsAnErrorThatNamesIt) {
  const Variable display("DISPLAY", ":987");
  const auto done = run_application({});
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, Error::Code::failed);
  EXPECT_NE(done.error().message().find(":987"), std::string::npos);
  EXPECT_FALSE(done.error().remedy.empty());
}

}  // namespace
}  // namespace isograsp::gui::test::application_test
