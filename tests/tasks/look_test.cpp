// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of training: which task has which, and that an assessment has none.
#include "tasks/looks/look.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tasks/protocol.hpp"
#include "tests/support/every.hpp"

namespace isograsp::tasks::look_test {
namespace {

std::string library_text(const std::string& name) {
  std::ifstream file(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks/" + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}
/// A line of the root table, which ends where the first other one begins.
std::string with_line(std::string text, const std::string& line) {
  return text.insert(text.find("\nversion") + 1, line + "\n");
}
std::string error_of(const std::string& text) {
  const auto spec = parse_task(text, "t.toml");
  return spec ? "" : spec.error().message();
}

TEST(Look, EveryTaskAsItsFileIsLooksPlain) {
  int training = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(ISOGRASP_SOURCE_DIR) + "/library/tasks")) {
    if (file.path().extension() != ".toml") continue;
    const auto spec = parse_task(library_text(file.path().filename()), file.path());
    ASSERT_TRUE(spec) << spec.error().message();
    EXPECT_EQ(spec->look, Look::plain) << file.path();
    if (!spec->difficulty) continue;
    ++training;
    const auto trained = at_level(*spec, 0.5);
    ASSERT_TRUE(trained) << trained.error().message();
    EXPECT_NE(trained->look, Look::plain) << file.path() << ": training has a look";
    EXPECT_EQ(trained->look, usual_look(spec->kind->wardrobe));
  }
  EXPECT_GE(training, 4);
}

TEST(Look, StandsInTheTextOfTheTrialAndSoInTheKeyOfItsSeries) {
  const auto spec = parse_task(library_text("grip_sine_training.toml"), "t.toml");
  ASSERT_TRUE(spec);
  const auto river = at_level(*spec, 0.5);
  const auto balloon = at_level(*spec, 0.5, Look::balloon);
  const auto plain = at_level(*spec, 0.5, Look::plain);
  ASSERT_TRUE(river && balloon && plain);
  EXPECT_NE(river->text, balloon->text);
  EXPECT_NE(river->text, plain->text);
  EXPECT_EQ(plain->look, Look::plain);
  EXPECT_EQ(parse_task(balloon->text, "stored")->look, Look::balloon);
  EXPECT_EQ(parse_task(river->text, "stored")->look, Look::river);
}

TEST(Look, OfATrialThatWasStoredBeforeLooksIsPlain) {
  const auto spec =
      parse_task(library_text("grip_sine_training.toml") + "\n[chosen]\nlevel = 0.5\n", "stored");
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->look, Look::plain);
}

TEST(Look, OfTheFileIsShownInTraining) {
  const auto spec = parse_task(
      with_line(library_text("grip_sine_training.toml"), "look = \"balloon\""), "t.toml");
  ASSERT_TRUE(spec) << spec.error().message();
  EXPECT_EQ(spec->look, Look::plain);
  EXPECT_EQ(at_level(*spec, 0.1)->look, Look::balloon);
}

TEST(Look, IsRefusedInAnAssessmentAndWhereItDoesNotFit) {
  EXPECT_NE(error_of(with_line(library_text("grip_sine.toml"), "look = \"river\""))
                .find("look: is for training only; an assessment always looks the same"),
            std::string::npos);
  EXPECT_NE(error_of(with_line(library_text("grip_sine_training.toml"), "look = \"cup\""))
                .find("look: 'cup' does not fit this kind of task"),
            std::string::npos);
  EXPECT_NE(error_of(with_line(library_text("grip_sine_training.toml"), "look = \"pony\""))
                .find("look: 'pony' is not known"),
            std::string::npos);
  const std::string step =
      "format = \"isograsp-protocol-1\"\nname = \"n\"\n[[step]]\nkind = \"task\"\n"
      "task = \"grip_sine_training.toml\"\nlook = \"river\"\n";
  const auto refused = parse_protocol(step, "p.toml");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("look: is for training only"), std::string::npos);
  const auto taken = parse_protocol(step + "adaptive = true\n", "p.toml");
  ASSERT_TRUE(taken) << taken.error().message();
  EXPECT_EQ(taken->steps[0].look, Look::river);
}

TEST(Look, EveryWardrobeThatKindsHaveIsFilled) {
  for (const KindFacts* kind : test::every(all_kinds())) {
    if (kind->wardrobe == Wardrobe::nothing) continue;
    EXPECT_NE(usual_look(kind->wardrobe), Look::plain) << kind->name;
    EXPECT_NE(kind->multiply, nullptr) << kind->name << " cannot be trained";
  }
  EXPECT_EQ(usual_look(Wardrobe::nothing), Look::plain);
}

TEST(Look, HasThreeLightsByDifficulty) {
  EXPECT_EQ(daylight_at(0.0), Daylight::morning);
  EXPECT_EQ(daylight_at(0.5), Daylight::day);
  EXPECT_EQ(daylight_at(1.0), Daylight::evening);
}

}  // namespace
}  // namespace isograsp::tasks::look_test
