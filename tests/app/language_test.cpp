// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of the command line in the language that is asked for; what machines read is the same.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/command.hpp"

namespace isograsp::app::language_test {
namespace {

using test::CommandResult;

/// A program that knows of no other language than the test says.
CommandResult isograsp_in(const std::string& environment, const std::string& arguments) {
  return test::run("env -u LC_ALL -u LC_MESSAGES -u LANGUAGE LANG=C " + environment +
                   " \"" ISOGRASP_EXECUTABLE "\" " + arguments);
}

class CommandsInALanguage : public ::testing::Test {
 protected:
  /// A command that fails: the folder for its output is not there.
  [[nodiscard]] CommandResult failing(const std::string& environment,
                                      const std::string& option) const {
    return isograsp_in("XDG_CONFIG_HOME=" + folder_.path("config") + " " + environment,
                       "export --db " + folder_.path("none.db") + " --format csv --out " +
                           folder_.path("out") + option);
  }
  void set_in_the_windows(const std::string& code) {
    std::filesystem::create_directory(folder_.path("config"));
    folder_.write("config/isograsp.ini", "[General]\nlanguage=" + code + "\n");
  }

  test::TemporaryFolder folder_;
  const std::string english_ = "does not exist";
  const std::string german_ = "gibt es nicht";
  const std::string french_ = "n’existe pas";
};

TEST_F(CommandsInALanguage, SayWhatIsWrongInIt) {
  const auto english = failing("", "");
  EXPECT_NE(english.err.find(english_), std::string::npos) << english.err;
  const auto german = failing("", " --language de");
  EXPECT_NE(german.err.find(german_), std::string::npos) << german.err;
  EXPECT_NE(german.err.find(folder_.path("none.db")), std::string::npos) << german.err;
  const auto french = failing("", " --language=fr");
  EXPECT_NE(french.err.find(french_), std::string::npos) << french.err;
  EXPECT_EQ(german.status, english.status);
  EXPECT_EQ(french.status, english.status);
}

TEST_F(CommandsInALanguage, TakeTheDesktopsThenTheClinicsThenTheOneThatIsAskedFor) {
  EXPECT_NE(failing("LANG=de_CH.UTF-8", "").err.find(german_), std::string::npos);
  set_in_the_windows("fr");
  EXPECT_NE(failing("LANG=de_CH.UTF-8", "").err.find(french_), std::string::npos);
  EXPECT_NE(failing("LANG=de_CH.UTF-8", " --language en").err.find(english_), std::string::npos);
  set_in_the_windows("system");
  EXPECT_NE(failing("LANG=de_CH.UTF-8", "").err.find(german_), std::string::npos);
}

TEST_F(CommandsInALanguage, SayWhatTheyHaveDone) {
  const auto say = [&](const std::string& language, const std::string& command) {
    return isograsp_in("XDG_CONFIG_HOME=" + folder_.path("config"),
                       "--language " + language + " " + command);
  };
  const std::string path = folder_.path("clinic.db");
  const auto made = say("de", "db init " + path);
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.out.find(path + ": angelegt, Format "), 0U) << made.out;
  EXPECT_EQ(say("fr", "db check " + path).out, path + " : intact\n");
  EXPECT_EQ(say("en", "db check " + path).out, path + ": sound\n");
  const auto stats = say("de", "db stats " + path).out;
  EXPECT_NE(stats.find("0 Patienten, 0 Sitzungen, 0 Versuche"), std::string::npos) << stats;
  EXPECT_NE(stats.find("0,00 Minuten aufgezeichnet"), std::string::npos) << stats;
  const auto json = "db stats --json " + path;
  EXPECT_EQ(say("de", json).out, say("en", json).out) << "that is for machines";
}

TEST_F(CommandsInALanguage, RefuseOneThatThereIsNot) {
  const auto refused = failing("", " --language tlh");
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err,
            "isograsp: error: --language: 'tlh' is no language that is there; give one of: en, de, "
            "fr\n");
  EXPECT_EQ(failing("", " --language").status, 2);
}

TEST_F(CommandsInALanguage, WriteTheSameForMachines) {
  const std::string grasp =
      "grasp --json --scene " ISOGRASP_SOURCE_DIR "/library/scenes/planar_block.toml";
  const auto english = isograsp_in("", grasp);
  EXPECT_EQ(english.status, 0) << english.err;
  EXPECT_FALSE(english.out.empty());
  const auto time_free = [](std::string text) { return text.substr(0, text.find("cost_ns")); };
  EXPECT_EQ(time_free(isograsp_in("", "--language de " + grasp).out), time_free(english.out));
}

}  // namespace
}  // namespace isograsp::app::language_test
