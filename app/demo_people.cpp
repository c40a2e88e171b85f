// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/demo_people.hpp"

#include <array>
#include <charconv>

#include "core/csv.hpp"
#include "core/time.hpp"

namespace isograsp::app {

namespace {

constexpr const char* kClinician = "Dr Example";

// Protocols of the visits: short ones, so that the clinic is made in seconds.
constexpr const char* kStrength = R"(format = "isograsp-protocol-1"
name = "Strength"

[[step]]
kind = "instrument_zero"

[[step]]
kind = "task"
task = "resting_force.toml"

[[step]]
kind = "task"
task = "maximum_grip.toml"
)";
const std::string kStrengthAndRelease = std::string(kStrength) + R"(
[[step]]
kind = "task"
task = "let_go_short.toml"
)";
const std::string kVisit = kStrengthAndRelease + R"(
[[step]]
kind = "task"
task = "grip_sine.toml"

[[step]]
kind = "task"
task = "two_target.toml"
)";

/// Days and times before the moment at which the clinic is made.
class Calendar {
 public:
  explicit Calendar(const std::string& now_utc) : now_(time_of_utc(now_utc).value_or(0)) {}
  [[nodiscard]] std::string date(int days_ago) const {
    constexpr std::size_t kDateLength = 10;
    return utc_text(now_ - days_ago * kDay_s).substr(0, kDateLength);
  }
  [[nodiscard]] std::string at(int days_ago, const char* time) const {
    return date(days_ago) + "T" + time + "Z";
  }
  [[nodiscard]] std::string minutes_ago(int minutes) const {
    constexpr std::time_t kMinute_s = 60;
    return utc_text(now_ - minutes * kMinute_s);
  }
  [[nodiscard]] int birth_year(int age) const {
    int year = 0;
    const std::string today = date(0);
    std::from_chars(today.data(), today.data() + 4, year);
    return year - age;
  }

 private:
  static constexpr std::time_t kDay_s = 86400;
  std::time_t now_;
};

constexpr const char* kMorning = "09:00:00";
constexpr const char* kAfterVisit = "10:30:00";

/// Somebody of the library on a course.
struct Simulated {
  const char* person;
  const char* course;
  double strength = 1.0;
  int seed = 1;
};
std::string device_of(const Simulated& who, int day) {
  std::string uri = std::string("sim://") + who.person + "?seed=" + std::to_string(who.seed) +
                    "&strength=" + format_number(who.strength) + "&day=" + std::to_string(day);
  if (*who.course != '\0') uri += std::string("&course=") + who.course;
  return uri;
}

/// Visits on these days of a course whose first day lies `began` days ago.
std::vector<DemoVisit> visits_on(const Calendar& calendar, const Simulated& who, Hand hand,
                                 int began, const std::vector<int>& days,
                                 const std::string& protocol) {
  std::vector<DemoVisit> visits;
  for (const int day : days)
    visits.push_back(
        {calendar.at(began - day, kMorning), "visit", protocol, hand, device_of(who, day)});
  return visits;
}

storage::PrimaryMeasure primary(const std::string& task, Hand hand, const std::string& measure,
                                const std::string& channel, const std::string& chosen_utc) {
  return {0, task, hand, measure, channel, chosen_utc, kClinician};
}
storage::PrimaryMeasure grip_strength(Hand hand, const std::string& chosen_utc) {
  return primary("Maximum grip force", hand, "maximum_force", "grip", chosen_utc);
}
storage::PrimaryMeasure release_time(Hand hand, const std::string& chosen_utc) {
  return primary("Let go, short", hand, "release_time", "grip", chosen_utc);
}

std::string numbered(const std::string& prefix, int number) {
  const std::string text = std::to_string(number);
  return prefix + (text.size() < 2 ? "0" : "") + text;
}

constexpr int kBetterBegan = 58;  // days ago
constexpr Simulated kBetter{"moderate", "rehabilitation", 1.0, 12};

/// After a stroke: baseline of a week, then therapy.
DemoPerson better(const Calendar& calendar) {
  DemoPerson person;
  person.code = "DEMO-01";
  person.profile = {storage::Side::right,
                    Hand::right,
                    calendar.date(kBetterBegan + 40),
                    "Lives alone on the second floor. Comes on Mondays.",
                    "Hold a cup of tea without spilling, open the front door with the key",
                    storage::Sex::female,
                    calendar.birth_year(64)};
  person.visits = visits_on(calendar, kBetter, Hand::right, kBetterBegan,
                            {0, 6, 14, 22, 30, 38, 46, 54}, kVisit);
  for (std::size_t i = 0; i < person.visits.size(); ++i)
    person.visits[i].rating = Rating{7 - static_cast<int>(i) / 2, i < 3 ? 2 : 1};
  // The other hand, once.
  constexpr Simulated kOther{"healthy", "", 0.9, 13};
  auto other = visits_on(calendar, kOther, Hand::left, kBetterBegan, {55}, kVisit);
  person.visits.push_back(other.front());
  person.treatments = {{0, calendar.date(kBetterBegan - 8), "therapy", "task training, daily"},
                       {0, calendar.date(kBetterBegan - 26), "orthosis", "wrist, at night"}};
  person.scores = {{0, calendar.date(kBetterBegan), "ARAT", 27.0, "right"},
                   {0, calendar.date(kBetterBegan), "FMA-UE", 38.0, "right"},
                   {0, calendar.date(5), "ARAT", 39.0, "right"},
                   {0, calendar.date(5), "FMA-UE", 47.0, "right"}};
  const auto chosen = calendar.at(kBetterBegan - 6, kAfterVisit);
  person.primaries = {grip_strength(Hand::right, chosen), release_time(Hand::right, chosen),
                      primary("Grip force, sine", Hand::right, "relative_rmse", "force", chosen)};
  return person;
}

/// Multiple sclerosis: no change for a month, then a relapse.
DemoPerson worse(const Calendar& calendar) {
  constexpr int kBegan = 44;
  constexpr Simulated kWho{"mild", "relapse", 0.9, 12};
  DemoPerson person;
  person.code = "DEMO-02";
  person.profile = {storage::Side::left,
                    Hand::right,
                    calendar.date(2200),
                    "",
                    "Button a shirt with both hands",
                    storage::Sex::male,
                    calendar.birth_year(47)};
  person.visits = visits_on(calendar, kWho, Hand::left, kBegan, {0, 7, 14, 21, 28, 35, 42},
                            kStrengthAndRelease);
  person.treatments = {{0, calendar.date(kBegan - 36), "drug", "methylprednisolone, five days"}};
  person.scores = {{0, calendar.date(kBegan), "BBT", 44.0, "left"},
                   {0, calendar.date(kBegan - 42), "BBT", 31.0, "left"}};
  const auto chosen = calendar.at(kBegan - 7, kAfterVisit);
  person.primaries = {grip_strength(Hand::left, chosen)};
  return person;
}

/// A hand that lets go slowly, treated with botulinum toxin a week ago.
DemoPerson treated(const Calendar& calendar) {
  constexpr int kBegan = 41;
  constexpr Simulated kWho{"opening_loss", "botulinum", 0.9, 6};
  DemoPerson person;
  person.code = "DEMO-03";
  person.profile = {storage::Side::right,
                    Hand::right,
                    calendar.date(900),
                    "",
                    "Put down a glass without knocking it over",
                    storage::Sex::female,
                    calendar.birth_year(58)};
  person.visits =
      visits_on(calendar, kWho, Hand::right, kBegan, {0, 7, 14, 21, 40}, kStrengthAndRelease);
  person.treatments = {{0, calendar.date(kBegan - 28), "botulinum_toxin", "finger flexors, 50 U"}};
  person.scores = {{0, calendar.date(kBegan), "MAS", 3.0, "finger flexors"},
                   {0, calendar.date(1), "MAS", 1.5, "finger flexors"}};
  const auto chosen = calendar.at(kBegan - 7, kAfterVisit);
  person.primaries = {release_time(Hand::right, chosen), grip_strength(Hand::right, chosen)};
  return person;
}

/// New: two visits, and a battery that was broken off today.
DemoPerson interrupted(const Calendar& calendar) {
  constexpr int kBegan = 7;
  constexpr Simulated kWho{"moderate", "plateau", 1.2, 41};
  constexpr int kMaxima = 3;  // step of the battery
  DemoPerson person;
  person.code = "DEMO-04";
  person.profile = {storage::Side::right,        Hand::right,        calendar.date(60),      "",
                    "Write with the right hand", storage::Sex::male, calendar.birth_year(71)};
  person.visits = visits_on(calendar, kWho, Hand::right, kBegan, {0, 3}, kStrengthAndRelease);
  person.visits.push_back(
      {calendar.minutes_ago(40), "battery", "", Hand::right, device_of(kWho, kBegan), kMaxima});
  person.scores = {{0, calendar.date(kBegan), "NHPT", 74.0, "right"}};
  person.primaries = {grip_strength(Hand::right, calendar.at(kBegan, kAfterVisit))};
  return person;
}

/// People who do not change in a clinician's judgement: the measurement error is computed from
/// them.
std::vector<DemoGroup> stable_people(const Calendar& calendar) {
  constexpr int kPeople = 12;
  constexpr int kBegan = 20;
  constexpr int kSeed = 514;
  std::vector<DemoGroup> groups(2);
  for (int i = 0; i < kPeople; ++i) {
    const Simulated who{"moderate", "plateau", 0.7 + 0.12 * i, kSeed + i};
    DemoPerson person;
    person.code = numbered("STABLE-", i + 1);
    const Hand hand = i % 3 == 0 ? Hand::left : Hand::right;
    person.profile = {hand == Hand::left ? storage::Side::left : storage::Side::right,
                      Hand::right,
                      calendar.date(700 + 90 * i),
                      "",
                      "",
                      i % 2 == 0 ? storage::Sex::female : storage::Sex::male,
                      calendar.birth_year(45 + 3 * i)};
    person.visits = visits_on(calendar, who, hand, kBegan, {0, 4}, kStrengthAndRelease);
    person.stable = storage::StablePeriod{0,
                                          calendar.date(kBegan + 1),
                                          calendar.date(kBegan - 5),
                                          calendar.at(kBegan - 5, kAfterVisit),
                                          kClinician,
                                          "more than a year after the onset, no new treatment"};
    groups[static_cast<std::size_t>(i) % groups.size()].push_back(std::move(person));
  }
  return groups;
}

/// Women in their sixties: what the first patient is compared with.
DemoGroup healthy_people(const Calendar& calendar) {
  constexpr int kPeople = 22;
  constexpr int kSeed = 600;
  constexpr int kStep = 9;  // has no factor in common with their number
  DemoGroup group;
  for (int i = 0; i < kPeople; ++i) {
    const double strength = 0.8 + 0.6 * ((i * kStep) % kPeople) / (kPeople - 1.0);
    DemoPerson person;
    person.code = numbered("HEALTHY-", i + 1);
    person.profile = {storage::Side::none,
                      Hand::right,
                      "",
                      "",
                      "",
                      storage::Sex::female,
                      calendar.birth_year(61 + i % 8)};
    person.visits = visits_on(calendar, {"healthy", "", strength, kSeed + i}, Hand::right,
                              90 - 2 * i, {0}, kStrengthAndRelease);
    group.push_back(std::move(person));
  }
  return group;
}

struct Enrolled {
  const char* person;
  const char* course;
  const char* goal;
};
constexpr std::array<Enrolled, 12> kEnrolled{
    {{"mild", "rehabilitation", "Play the piano again"},
     {"moderate", "rehabilitation", "Cut bread"},
     {"severe", "rehabilitation", "Hold the banister"},
     {"spastic", "botulinum", "Let go of the door handle at once"},
     {"opening_loss", "rehabilitation", "Put the hand round a bottle"},
     {"direction_error", "plateau", "Turn a key"},
     {"arm_push", "plateau", "Eat with a fork"},
     {"sensory_loss", "rehabilitation", "Find coins in the pocket"},
     {"inattention", "plateau", "Peel potatoes"},
     {"fatiguing", "loosened_strap", "Carry the shopping home"},
     {"moderate", "decline", "Keep writing letters"},
     {"slow_wander", "plateau", "Thread a needle"}}};

/// Twenty training sessions over two months.
DemoPerson in_training(const Calendar& calendar, int number) {
  constexpr int kVisits = 20;
  constexpr int kDaysBetween = 3;
  constexpr int kBegan = 60;
  constexpr int kSeedsPerPerson = 1000;
  const Enrolled& enrolled = kEnrolled[static_cast<std::size_t>(number - 1)];
  const Simulated who{enrolled.person, enrolled.course, 1.0, kSeedsPerPerson * number};
  DemoPerson person;
  person.code = numbered("CLINIC-", number);
  person.profile = {storage::Side::right,
                    Hand::right,
                    calendar.date(kBegan + 30 + 11 * number),
                    "",
                    enrolled.goal,
                    number % 2 == 0 ? storage::Sex::female : storage::Sex::male,
                    calendar.birth_year(40 + 3 * number)};
  for (int visit = 0; visit < kVisits; ++visit) {
    const int day = kDaysBetween * visit;
    person.visits.push_back(
        {calendar.at(kBegan - day, kMorning), "training", "", Hand::right, device_of(who, day)});
  }
  if (std::string(enrolled.course) == "botulinum")
    person.treatments = {{0, calendar.date(kBegan - 28), "botulinum_toxin", "finger flexors"}};
  if (std::string(enrolled.course) == "rehabilitation")
    person.treatments = {{0, calendar.date(kBegan - 7), "therapy", "task training, daily"}};
  person.primaries = {grip_strength(Hand::right, calendar.at(kBegan, kAfterVisit))};
  return person;
}

}  // namespace

std::vector<DemoGroup> small_clinic(const std::string& now_utc) {
  const Calendar calendar(now_utc);
  std::vector<DemoGroup> groups{{better(calendar)},
                                {worse(calendar), treated(calendar), interrupted(calendar)}};
  for (auto& group : stable_people(calendar)) groups.push_back(std::move(group));
  groups.push_back(healthy_people(calendar));
  return groups;
}

std::vector<DemoGroup> large_clinic(const std::string& now_utc) {
  const Calendar calendar(now_utc);
  auto groups = small_clinic(now_utc);
  for (int number = 1; number <= static_cast<int>(kEnrolled.size()); ++number)
    groups.push_back({in_training(calendar, number)});
  return groups;
}

DemoVisit demo_visit_of_today(const std::string& now_utc) {
  return {now_utc, "demonstration", "", Hand::right, device_of(kBetter, kBetterBegan),
          -1,      Rating{3, 0}};
}

}  // namespace isograsp::app
