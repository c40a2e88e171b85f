// SPDX-License-Identifier: GPL-3.0-or-later
// People over weeks: the form of the day, practice, and courses.
#include "virtual_patient/course.hpp"

#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_patient/people.hpp"

namespace isograsp::virtual_patient::course_test {
namespace {

using test::kPatients;
using test::shipped;

Course course(const std::string& name) {
  const std::string path = kPatients + "/courses/" + name + ".toml";
  const auto text = read_text(path);
  EXPECT_TRUE(text) << path;
  const auto read = parse_course(*text, path);
  EXPECT_TRUE(read) << read.error().message();
  return *read;
}

constexpr int kDays = 200;

/// Mean over seeds of a trait on one day.
double mean_on(const Course& of, const PatientTraits& patient, double PatientTraits::*trait,
               std::uint64_t day) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= kDays; ++seed)
    sum += course_traits(of, patient, day, seed).*trait;
  return sum / kDays;
}

TEST(Days, MaximaOfTwoHundredDaysVaryAsThePersonSays) {
  for (const std::string& name : test::every(test::names_in(kPatients))) {
    const PatientTraits traits = shipped(name);
    if (traits.day_cv == 0.0) continue;
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t day = 0; day < kDays; ++day) {
      const double maximum_N = on_day(traits, day_seed(7, day)).maximum_force_N;
      sum += maximum_N;
      squares += maximum_N * maximum_N;
    }
    const double mean_N = sum / kDays;
    const double cv = std::sqrt((squares - kDays * mean_N * mean_N) / (kDays - 1)) / mean_N;
    EXPECT_GE(cv, 0.10) << name;
    EXPECT_LE(cv, 0.20) << name;
    // The SD of 200 values has a standard error of 5 %, their mean one of cv / 14: 3.5 of these.
    EXPECT_WITHIN(cv, traits.day_cv, 0.175 * traits.day_cv) << name;
    EXPECT_WITHIN(mean_N, traits.maximum_force_N, 0.25 * traits.day_cv * traits.maximum_force_N);
  }
}

TEST(Days, TheSameDayIsTheSamePersonAndAnotherIsNot) {
  const PatientTraits traits = shipped("moderate");
  EXPECT_EQ(on_day(traits, day_seed(3, 5)), on_day(traits, day_seed(3, 5)));
  EXPECT_NE(on_day(traits, day_seed(3, 5)), on_day(traits, day_seed(3, 6)));
  EXPECT_NE(on_day(traits, day_seed(3, 5)), on_day(traits, day_seed(4, 5)));
}

TEST(Days, WithoutVariationEveryDayIsTheSame) {
  EXPECT_EQ(on_day(shipped("paretic"), day_seed(3, 5)), shipped("paretic"));
}

TEST(Practice, ImprovesSkillMonotonicallyTowardsItsGainAndLeavesStrengthAlone) {
  const PatientTraits traits = shipped("moderate");
  EXPECT_EQ(practised(traits, 0.0), traits);
  double before = traits.force_cv;
  for (int session = 1; session < 10; ++session) {
    const double now = practised(traits, session).force_cv;
    EXPECT_LT(now, before);
    before = now;
  }
  const PatientTraits master = practised(traits, 1e6);
  EXPECT_WITHIN(master.force_cv, traits.force_cv * (1.0 - traits.practice_gain), 1e-12);
  EXPECT_GT(master.prediction, traits.prediction);
  EXPECT_EQ(master.maximum_force_N, traits.maximum_force_N);
  EXPECT_EQ(master.resting_force_N, traits.resting_force_N);
}

TEST(Courses, RecoveryRisesByItsFormula) {
  const PatientTraits patient = shipped("moderate");
  const Course recovery = course("recovery");
  double before_N = 0.0;
  for (int day = 0; day <= 180; ++day) {
    const double now_N = course_mean(recovery, patient, day).maximum_force_N;
    EXPECT_GT(now_N, before_N);
    EXPECT_WITHIN(now_N, 12.0 + 0.6 * (1.0 - std::exp(-day / 35.0)) * (60.0 - 12.0), 1e-9);
    before_N = now_N;
  }
  EXPECT_GT(mean_on(recovery, patient, &PatientTraits::maximum_force_N, 90), 30.0);
}

TEST(Courses, APlateauIsFlat) {
  const PatientTraits patient = shipped("moderate");
  const Course plateau = course("plateau");
  for (int day = 0; day <= 180; day += 10) {
    EXPECT_EQ(course_mean(plateau, patient, day), patient);
    // Three standard errors of 200 days of 15 %.
    EXPECT_WITHIN(
        mean_on(plateau, patient, &PatientTraits::maximum_force_N, static_cast<std::uint64_t>(day)),
        12.0, 3.0 * 0.15 * 12.0 / std::sqrt(kDays));
  }
}

TEST(Courses, DeclineFallsToHalf) {
  const PatientTraits patient = shipped("mild");
  const Course decline = course("decline");
  double before_N = 1e9;
  for (int day = 0; day <= 180; day += 5) {
    const double now_N = course_mean(decline, patient, day).maximum_force_N;
    EXPECT_LT(now_N, before_N);
    before_N = now_N;
  }
  EXPECT_WITHIN(before_N, 15.0, 1e-9);
  EXPECT_EQ(course_mean(decline, patient, 300).maximum_force_N, before_N);
}

TEST(Courses, BotulinumLowersToneForTwelveWeeksAndWearsOff) {
  const PatientTraits patient = shipped("spastic");
  const Course botulinum = course("botulinum");
  const auto on = [&](double day) { return course_mean(botulinum, patient, day); };
  EXPECT_EQ(on(27), patient);
  EXPECT_WITHIN(on(70).resting_force_N, 0.35 * patient.resting_force_N, 0.01);
  EXPECT_WITHIN(on(70).maximum_force_N, 0.8 * patient.maximum_force_N, 0.01);
  EXPECT_LT(on(111).resting_force_N, 0.36 * patient.resting_force_N);
  EXPECT_WITHIN(on(160).resting_force_N, patient.resting_force_N, 0.01);
}

TEST(Courses, ALooseStrapHoldsBadlyAtOnceAndIsFastenedAtOnce) {
  const PatientTraits patient = shipped("mild");
  const Course strap = course("loosened_strap");
  EXPECT_EQ(course_mean(strap, patient, 20.9), patient);
  EXPECT_WITHIN(course_mean(strap, patient, 21).opening_share, 0.3 * patient.opening_share, 1e-12);
  EXPECT_WITHIN(course_mean(strap, patient, 34).opening_share, 0.3 * patient.opening_share, 1e-12);
  EXPECT_EQ(course_mean(strap, patient, 35), patient);
  EXPECT_EQ(course_mean(strap, patient, 30).maximum_force_N, patient.maximum_force_N);
}

TEST(Courses, EveryCourseKeepsEveryPersonWithinTheRanges) {
  for (const std::string& name : test::every(test::names_in(kPatients + "/courses")))
    for (const std::string& who : test::every(test::names_in(kPatients)))
      for (std::uint64_t day = 0; day < 400; day += 20) {
        const PatientTraits traits = course_traits(course(name), shipped(who), day, 1);
        EXPECT_EQ(traits, clamped(traits)) << name << " " << who << " " << day;
      }
}

TEST(Courses, SameSeedSamePerson) {
  const Course recovery = course("recovery");
  const PatientTraits patient = shipped("severe");
  EXPECT_EQ(course_traits(recovery, patient, 30, 4), course_traits(recovery, patient, 30, 4));
  EXPECT_NE(course_traits(recovery, patient, 30, 4), course_traits(recovery, patient, 30, 5));
}

TEST(Courses, BadFilesSayWhere) {
  const std::string head =
      "format = \"isograsp-course-1\"\nname = \"x\"\ndescription = \"x\"\n"
      "days_between_sessions = 7\n[[change]]\n";
  const std::pair<const char*, const char*> bad[] = {
      {"shape = \"jump\"\nfrom_day = 0\ntime_days = 1\nrecovery = 1\n",
       "x.toml:6: change[1].shape: 'jump' is not known; write one of: approach, linear, during"},
      {"shape = \"linear\"\nfrom_day = 0\ntime_days = 0\nrecovery = 1\n",
       "x.toml:8: change[1].time_days: is out of range; write a value from 0.1 to 10000"},
      {"shape = \"linear\"\nfrom_day = 0\ntime_days = 1\n",
       "x.toml:6: change[1].shape: changes nothing; write a recovery or a factor"},
      {"shape = \"during\"\nfrom_day = 5\nuntil_day = 5\ntime_days = 1\nrecovery = 1\n",
       "x.toml:8: change[1].until_day: is not after from_day; write a later day"},
      {"shape = \"linear\"\nfrom_day = 0\ntime_days = 1\n[change.factor]\nforce_cv = 2\ncharm = "
       "2\n",
       "x.toml:11: change[1].factor.charm: unknown key; remove it or correct its spelling"},
  };
  for (const auto& [text, message] : bad) {
    const auto read = parse_course(head + text, "x.toml");
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().message(), message);
  }
}

}  // namespace
}  // namespace isograsp::virtual_patient::course_test
