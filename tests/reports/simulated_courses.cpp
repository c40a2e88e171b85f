// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reports/simulated_courses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/normal.hpp"

namespace isograsp::test {

namespace {

constexpr int kPerPool = 10;  ///< people who are judged
constexpr int kGap_days = 3;

/// A person: a level, and how much it varies from day to day.
struct Person {
  double level;
  double day_cv;
};
Person person_of(const Simulation& simulation, Random& random) {
  const auto& measure = simulation.measure;
  const double level =
      measure.least_level * std::pow(measure.most_level / measure.least_level, random.uniform());
  return {level, std::lerp(simulation.least_cv, simulation.most_cv, random.uniform())};
}

/// Of the logarithm 1; where the error is constant that of the middle level.
double unit_of(const SimulatedMeasure& measure) {
  return measure.constant ? std::sqrt(measure.least_level * measure.most_level) : 1.0;
}

/// What is measured on one day, with a true change of `shift`.
reports::AssessmentDay measured(const SimulatedMeasure& measure, const Person& person, int day,
                                double shift, Random& random) {
  reports::AssessmentDay one{static_cast<double>(day), {}, false};
  const double of_day = person.day_cv * normal(random);
  for (int trial = 0; trial < measure.trials; ++trial) {
    const double error =
        of_day + (measure.trial_cv > 0.0 ? measure.trial_cv * normal(random) : 0.0);
    one.trials.push_back(measure.constant ? person.level + shift + unit_of(measure) * error
                                          : person.level * std::exp(shift + error));
  }
  return one;
}

/// `wild` has random numbers of its own: the same people without outlying days are the same.
std::vector<reports::StableDays> stable_people(const Simulation& simulation,
                                               const Outlying& outlying, Random random,
                                               Random wild) {
  const double a = simulation.least_cv;
  const double b = simulation.most_cv;
  const double mean_sd = std::sqrt((a * a + a * b + b * b) / 3.0);
  const auto shift = [&] {
    const double side = wild.uniform() < 0.5 ? -1.0 : 1.0;
    if (wild.uniform() >= outlying.share) return 0.0;
    return side * outlying.size * mean_sd * unit_of(simulation.measure);
  };
  std::vector<reports::StableDays> stable;
  for (int number = 0; number < simulation.people; ++number) {
    const Person person = person_of(simulation, random);
    auto first = measured(simulation.measure, person, 0, shift(), random);
    auto second = measured(simulation.measure, person, kGap_days, shift(), random);
    stable.push_back({number, {std::move(first), std::move(second)}});
  }
  return stable;
}

reports::StablePool pool_for(const SimulatedMeasure& measure,
                             const std::vector<reports::StableDays>& stable) {
  return reports::pool_of(
      stable, measure.constant ? reports::ErrorScale::linear : reports::ErrorScale::logarithmic);
}

/// Smallest detectable change of this pool for the days of `measure`.
double mdc_of(const SimulatedMeasure& measure, const reports::StablePool& pool) {
  const double trials = measure.trials;
  return reports::mdc95(*pool.error, {2, 2.0 * trials}, {1, trials});
}

// What may be true of a course, in the order of Outcomes.
constexpr std::size_t kOutcomes = 7;
using Flags = std::array<bool, kOutcomes>;

Flags course(const Simulation& simulation, const reports::StablePool& pool, double mdc,
             Random& random) {
  const Person person = person_of(simulation, random);
  std::vector<reports::AssessmentDay> days;
  Flags flags{};
  auto& [possible, confirmed, improved, worsened, improved_at_end, worsened_at_end, useless] =
      flags;
  for (int number = 0; number < simulation.assessments; ++number) {
    days.push_back(measured(simulation.measure, person, kGap_days * number,
                            simulation.change(number, mdc), random));
    const auto judged = reports::judge_change(days, pool, simulation.measure.better);
    const bool better = judged.verdict == reports::Verdict::improved;
    const bool worse = judged.verdict == reports::Verdict::worsened;
    possible = possible || better || worse;
    improved_at_end = better && judged.confirmed;
    worsened_at_end = worse && judged.confirmed;
    improved = improved || improved_at_end;
    worsened = worsened || worsened_at_end;
  }
  confirmed = improved || worsened;
  useless = mdc_of(simulation.measure, pool) > 2.0 * mdc;
  return flags;
}

/// Mean of the shares of pools, and of their squares.
struct Sums {
  double shares = 0.0;
  double squares = 0.0;
  double pools = 0.0;
  void add(double share) {
    shares += share;
    squares += share * share;
    pools += 1.0;
  }
  [[nodiscard]] double mean() const { return shares / pools; }
  [[nodiscard]] double standard_error() const {
    return std::sqrt(std::max(0.0, squares / pools - mean() * mean()) / (pools - 1.0));
  }
};
using Family = std::array<Sums, kOutcomes>;

/// Far from each other, and from each other's random numbers.
std::uint64_t seed_of(int family) {
  constexpr std::uint64_t kFirst = 40'000;
  constexpr std::uint64_t kApart = 5'000;
  return kFirst + kApart * static_cast<std::uint64_t>(family);
}

Family family_of(const Simulation& simulation, int number) {
  const std::uint64_t seed = seed_of(number);
  Family family;
  for (int pool_number = 0; pool_number < simulation.courses / kPerPool; ++pool_number) {
    const auto stream = static_cast<std::uint64_t>(pool_number);
    const Random of_pool(seed, stream);
    const Random of_wild(seed + 1000, stream);
    const auto& measure = simulation.measure;
    const auto clean = pool_for(measure, stable_people(simulation, {}, of_pool, of_wild));
    auto pool =
        simulation.outlying.share > 0.0
            ? pool_for(measure, stable_people(simulation, simulation.outlying, of_pool, of_wild))
            : clean;
    if (simulation.t975) pool.error->t975 = *simulation.t975;
    const double mdc = mdc_of(measure, clean);
    Random random(seed + 2000, stream);
    std::array<double, kOutcomes> shares{};
    for (int person = 0; person < kPerPool; ++person) {
      const Flags flags = course(simulation, pool, mdc, random);
      for (std::size_t i = 0; i < kOutcomes; ++i) shares[i] += flags[i] ? 1.0 / kPerPool : 0.0;
    }
    for (std::size_t i = 0; i < kOutcomes; ++i) family[i].add(shares[i]);
  }
  return family;
}

}  // namespace

Outcomes simulate(const Simulation& simulation) {
  std::vector<Family> families;
  Family all;
  for (int number = 0; number < simulation.families; ++number) {
    families.push_back(family_of(simulation, number));
    for (std::size_t i = 0; i < kOutcomes; ++i) {
      all[i].shares += families.back()[i].shares;
      all[i].squares += families.back()[i].squares;
      all[i].pools += families.back()[i].pools;
    }
  }
  std::array<Share, kOutcomes> shares;
  for (std::size_t i = 0; i < kOutcomes; ++i) {
    shares[i].of_courses = all[i].mean();
    shares[i].standard_error = all[i].standard_error();
    // Of a family as the spread of all pools tells it: its own few may not spread at all.
    const double of_family =
        shares[i].standard_error * std::sqrt(static_cast<double>(simulation.families));
    for (const Family& family : families)
      if (of_family > 0.0)
        shares[i].farthest_family =
            std::max(shares[i].farthest_family,
                     std::abs(family[i].mean() - shares[i].of_courses) / of_family);
  }
  return {shares[0], shares[1], shares[2], shares[3], shares[4], shares[5], shares[6]};
}

double plain_sd_doubled(const Simulation& simulation) {
  const auto mean_square = [&](const std::vector<reports::StableDays>& stable) {
    double sum = 0.0;
    for (const auto& one : stable) {
      const double a = *reports::day_mean(one.days[0]);
      const double b = *reports::day_mean(one.days[1]);
      const double difference = simulation.measure.constant ? a - b : std::log(a / b);
      sum += difference * difference;
    }
    return sum;
  };
  int doubled = 0;
  int pools = 0;
  for (int family = 0; family < simulation.families; ++family)
    for (int number = 0; number < simulation.courses / kPerPool; ++number, ++pools) {
      const Random of_pool(seed_of(family), static_cast<std::uint64_t>(number));
      const Random of_wild(seed_of(family) + 1000, static_cast<std::uint64_t>(number));
      constexpr double kTwice = 4.0;  // of squares
      if (mean_square(stable_people(simulation, simulation.outlying, of_pool, of_wild)) >
          kTwice * mean_square(stable_people(simulation, {}, of_pool, of_wild)))
        ++doubled;
    }
  return static_cast<double>(doubled) / pools;
}

}  // namespace isograsp::test
