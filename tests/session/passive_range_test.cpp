// SPDX-License-Identifier: GPL-3.0-or-later
// No target lies beyond the passive range that the screening of an arm gave, and what is said of
// the way that fits fits.
#include "session/arm/passive_range.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::session::passive_range_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";
constexpr double kDegree_rad = std::numbers::pi / 180.0;

Postures postures() {
  const std::string file = kLibrary + "/postures/forearm_and_wrist.toml";
  return test::must(parse_postures(test::must(read_text(file)), file));
}
std::array<RigLink, kArmLinkCount> links() {
  const auto rig = test::must(ArmRig::read(kLibrary + "/rigs/kurillo15.toml", Hand::right));
  return rig.links;
}
tasks::TaskSpec task(int way_percent, const std::string& posture = "pronation") {
  return test::must(tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"Turn\"\ninstruction = \"Turn it.\"\n"
      "kind = \"pose_matching\"\npostures = \"forearm_and_wrist\"\nsequence = [\"" +
          posture + "\"]\nhold_s = 0.3\nway_percent = " + std::to_string(way_percent) + "\n",
      "turn.toml"));
}
PassiveLimit forearm(double least_deg, double most_deg) {
  return {{ArmLink::forearm, 3}, kDegree_rad * least_deg, kDegree_rad * most_deg};
}
Result<void> screened(const tasks::TaskSpec& spec, const tasks::ArmScreening& screening,
                      tasks::Effort allowed = tasks::Effort::maximum) {
  const Postures library = postures();
  return check_screening(spec, &library, links(), allowed, screening);
}
Result<void> checked(const tasks::TaskSpec& spec, const std::vector<PassiveLimit>& limits,
                     tasks::Effort allowed = tasks::Effort::maximum) {
  return screened(spec, {limits, std::nullopt}, allowed);
}
/// After a screening, where this part of the way was done before; negative: nothing was.
Result<void> after(double way_done, const tasks::TaskSpec& spec) {
  std::map<std::string, double> done;
  if (way_done >= 0.0) done["forearm_and_wrist"] = way_done;
  return screened(spec, {{}, done});
}

// The library starts 20 degrees pronated; "pronation" turns 40 further, "supination" 50 back.

TEST(PassiveRange, ATargetBeyondItIsRefusedOneWithinItIsNot) {
  EXPECT_TRUE(checked(task(100), {}).ok()) << "nothing was entered";
  EXPECT_TRUE(checked(task(100), {forearm(-80, 61)}).ok());
  EXPECT_FALSE(checked(task(100), {forearm(-80, 59)}).ok());
  EXPECT_TRUE(checked(task(100, "supination"), {forearm(-31, 59)}).ok())
      << "only what the task asks counts";
  EXPECT_FALSE(checked(task(100, "supination"), {forearm(-29, 59)}).ok());
  EXPECT_TRUE(checked(task(100), {{{ArmLink::wrist, 1}, -kDegree_rad * 20, 0.0}}).ok())
      << "the wrist stays";
  EXPECT_FALSE(checked(task(100, "flexion"), {{{ArmLink::wrist, 1}, -1.0, 0.0}}).ok());
}

TEST(PassiveRange, ThePartOfTheWayThatIsNamedFitsAndOnePerCentMoreDoesNot) {
  for (const int most_deg : {25, 40, 55}) {
    const auto refused = checked(task(100), {forearm(-80, most_deg)});
    ASSERT_FALSE(refused.ok()) << most_deg;
    std::smatch percent;
    const std::string message = refused.error().message();
    ASSERT_TRUE(std::regex_search(message, percent, std::regex("([0-9]+) % of the way fit")))
        << message;
    const int fits = std::stoi(percent[1]);
    EXPECT_TRUE(checked(task(fits), {forearm(-80, most_deg)}).ok()) << message;
    EXPECT_FALSE(checked(task(fits + 1), {forearm(-80, most_deg)}).ok()) << message;
  }
  const auto never = checked(task(100), {forearm(-80, 10)});
  ASSERT_FALSE(never.ok());
  EXPECT_NE(never.error().message().find("not even its start"), std::string::npos)
      << never.error().message();
}

TEST(PassiveRange, WhereASmallRangeIsAllowedHalfOfTheWayIsTheMostAndNoMovementIsNone) {
  EXPECT_TRUE(checked(task(50), {}, tasks::Effort::comfortable).ok());
  EXPECT_FALSE(checked(task(51), {}, tasks::Effort::comfortable).ok());
  EXPECT_FALSE(checked(task(10), {}, tasks::Effort::none).ok());
}

TEST(Stages, FiftySeventyFiveAndHundredPerCentComeEachOnlyAfterTheOneBefore) {
  EXPECT_TRUE(after(-1, task(50)));
  for (const int percent : {51, 75, 76, 100}) EXPECT_FALSE(after(-1, task(percent))) << percent;
  EXPECT_FALSE(after(0.49, task(75)));
  EXPECT_TRUE(after(0.5, task(75)));
  EXPECT_FALSE(after(0.74, task(100)));
  EXPECT_TRUE(after(0.75, task(100)));
  EXPECT_TRUE(after(1.0, task(100)));
  const auto refused = after(0.5, task(100));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "way_percent");
  EXPECT_NE(refused.error().message().find("way_percent = 75 first"), std::string::npos)
      << refused.error().message();
  EXPECT_FALSE(screened(task(75), {{}, std::map<std::string, double>{{"screw", 1.0}}}))
      << "other postures are another way";
  EXPECT_TRUE(screened(task(100), {})) << "nobody was screened";
}

TEST(Stages, AreCountedWithinASessionAndFromOneDayToTheNext) {
  const test::TemporaryFolder folder;
  const auto on = [&](const std::string& steps, const std::string& patient) {
    const std::string file = folder.write("steps.toml",
                                          "format = \"isograsp-protocol-1\"\nname = \"Steps\"\n"
                                          "[[step]]\nkind = \"start_posture\"\n" +
                                              steps);
    const auto protocol = test::must(read_protocol(file, kLibrary));
    SessionConfig config;
    config.database = folder.path("clinic.db");
    config.create_database = true;
    config.patient_code = patient;
    config.device_uri = "sim://arm?patient=healthy&seed=3";
    config.library = kLibrary;
    config.virtual_time = true;
    config.allowed = tasks::Effort::maximum;
    auto open = test::must(Session::open(config));
    auto result = test::must(run_protocol(*open, protocol, {}));
    open->close();
    return result;
  };
  const auto step = [](const std::string& name) {
    return "[[step]]\nkind = \"task\"\ntask = \"" + name + ".toml\"\nrest_s = 60\n";
  };
  const auto whole = on(step("arm_screw"), "A-1");
  ASSERT_EQ(whole.left_out.size(), 1u);
  EXPECT_NE(english(whole.left_out[0]).find("75 % of it"), std::string::npos)
      << english(whole.left_out[0]);
  const auto staged = on(step("arm_screw_half") + step("arm_screw_three_quarters"), "A-1");
  EXPECT_TRUE(staged.left_out.empty()) << "within a session";
  EXPECT_TRUE(on(step("arm_screw"), "A-1").left_out.empty()) << "the next one knows";
  EXPECT_EQ(on(step("arm_screw"), "A-2").left_out.size(), 1u) << "of another person";
}

TEST(PassiveRange, IsTypedInDegreesAndWhatIsNoneIsRefused) {
  const auto typed = test::must(passive_limit_from("forearm_a3=-40:60.5"));
  EXPECT_EQ(typed.angle, (LinkAngle{ArmLink::forearm, 3}));
  EXPECT_DOUBLE_EQ(typed.least_rad, -40 * kDegree_rad);
  EXPECT_DOUBLE_EQ(typed.most_rad, 60.5 * kDegree_rad);
  for (const char* text : {"", "forearm_a3", "forearm_a3=", "forearm_a3=1", "forearm_a3=60:-40",
                           "forearm_a4=-1:1", "elbow_a1=-1:1", "forearm_a3=x:1", "forearm_a3:1=2",
                           "forearm_a3=-181:0", "forearm_a3=nan:1"})
    EXPECT_FALSE(passive_limit_from(text)) << text;
}

TEST(PassiveRange, HoldsOnInTheSessionThatResumes) {
  const test::TemporaryFolder folder;
  const auto config = [&](bool resume) {
    SessionConfig of;
    of.database = folder.path("clinic.db");
    of.create_database = true;
    of.patient_code = "A-1";
    of.device_uri = "sim://arm?patient=healthy&seed=3";
    of.library = kLibrary;
    of.virtual_time = true;
    const std::string file = kLibrary + "/protocols/arm_assessment.toml";
    of.protocol_name = "Arm";
    of.protocol_text = test::must(read_text(file));
    of.resume = resume;
    return of;
  };
  const std::vector<PassiveLimit> entered{forearm(-80, 25)};
  {
    SessionConfig first = config(false);
    first.answers = stored(entered);
    (void)test::must(Session::open(first));
  }
  for (int again = 0; again < 2; ++again) {
    const auto open = test::must(Session::open(config(true)));
    EXPECT_EQ(open->known().arm_screening.passive, entered) << again;
  }
  SessionConfig anew = config(true);
  anew.answers = stored(std::vector<PassiveLimit>{forearm(-10, 30)});
  EXPECT_EQ(test::must(Session::open(anew))->known().arm_screening.passive,
            (std::vector<PassiveLimit>{forearm(-10, 30)}))
      << "what is asked again replaces it";
}

TEST(PassiveRange, AnswersThatAreNoRangeAreRefusedByTheirName) {
  using Answers = std::vector<storage::SessionAnswer>;
  for (const Answers& answers : {Answers{{"screening", "passive_wrist_a1_least_deg", "-20"}},
                                 Answers{{"screening", "passive_wrist_a1_least_deg", "20"},
                                         {"screening", "passive_wrist_a1_most_deg", "20"}},
                                 Answers{{"screening", "passive_wrist_a1_least_deg", "nan"},
                                         {"screening", "passive_wrist_a1_most_deg", "20"}},
                                 Answers{{"screening", "passive_wrist_a1_least_deg", "-181"},
                                         {"screening", "passive_wrist_a1_most_deg", "20"}}}) {
    const auto limits = passive_limits_in(answers);
    ASSERT_FALSE(limits.ok());
    EXPECT_NE(limits.error().message().find("passive_wrist_a1"), std::string::npos)
        << limits.error().message();
  }
  const Answers elsewhere{{"posture", "passive_wrist_a1_least_deg", "x"}};
  EXPECT_TRUE(test::must(passive_limits_in(elsewhere)).empty());
}

/// Also: the same arm on another day, partly recovered, is opened.
TEST(PassiveRange, ASessionLeavesOutWhatLiesBeyondTheAnswersThatItBeganWith) {
  const test::TemporaryFolder folder;
  const std::string file = kLibrary + "/protocols/arm_assessment.toml";
  const auto protocol = test::must(read_protocol(file, kLibrary));
  SessionConfig config;
  config.database = folder.path("clinic.db");
  config.create_database = true;
  config.patient_code = "A-1";
  config.device_uri = "sim://arm?patient=healthy&seed=3&recovery=0.5&day=14";
  config.library = kLibrary;
  config.virtual_time = true;
  config.answers = stored(std::vector<PassiveLimit>{forearm(-80, 25)});
  auto open = test::must(Session::open(config));
  const auto result = test::must(run_protocol(*open, protocol, {}));
  ASSERT_FALSE(result.left_out.empty());
  for (const Text& why : test::every(result.left_out))
    EXPECT_NE(english(why).find("passive range"), std::string::npos) << english(why);
  EXPECT_FALSE(result.trials.empty()) << "what has no targets is done";
  open->close();
}

}  // namespace
}  // namespace isograsp::session::passive_range_test
