// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that every measure of every task obeys, whatever its definition: signals are taken from
// sessions of a simulated hand with the whole library, changed in a way whose effect is known, and
// scored again.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/kinds/force/directional_maxima.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/recorded.hpp"
#include "tasks/score.hpp"
#include "tests/session/whole_session.hpp"
#include "tests/support/every.hpp"
#include "tests/support/platform_tasks.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::measure_laws_test {
namespace {

namespace fs = std::filesystem;
const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";

struct PlayedTrial {
  tasks::TaskSpec spec;
  Signals signals;
};

/// What others' tasks are measured against comes first.
std::string protocol_of_the_whole_library() {
  const std::vector<std::string> first{"resting_force", "maximum_grip",   "comfortable_grip",
                                       "maximum_thumb", "maximum_index",  "maximum_middle",
                                       "maximum_pinch", "maximum_opening"};
  std::vector<std::string> names = first;
  for (const tasks::TaskSpec& spec : test::platform_tasks(kLibrary)) {
    const std::string name = fs::path(spec.file).stem();
    if (std::find(first.begin(), first.end(), name) == first.end()) names.push_back(name);
  }
  std::sort(names.begin() + static_cast<std::ptrdiff_t>(first.size()), names.end());
  std::string text =
      "format = \"isograsp-protocol-1\"\nname = \"All\"\n[[step]]\nkind = \"instrument_zero\"\n";
  for (const std::string& name : names)
    text += "[[step]]\nkind = \"task\"\ntask = \"" + name + "\"\n";
  return text;
}

/// Every task of the library once, by a weak hand on sensors that lose a sample now and then.
std::vector<PlayedTrial> sessions_of_a_simulated_hand() {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("all.toml");
  std::ofstream(path) << protocol_of_the_whole_library();
  const test::WholeSession whole{folder.path("clinic.db"), "LAW-01",
                                 "sim://moderate?seed=5&drop=0.001&resolution=0.005", path};
  const auto result = run_whole(whole);
  constexpr std::size_t kNeedFormerDays = 1;  // the load of the first days
  EXPECT_LE(result.left_out.size(), kNeedFormerDays) << english(result.left_out.back());
  std::vector<PlayedTrial> played;
  const auto store = storage::open_store(whole.database, storage::OpenMode::existing).value();
  const auto patient = store->find_patient(whole.patient_code).value().value();
  for (const storage::TrialRecord& trial :
       store->trials(store->sessions(patient.id).value().at(0).id).value())
    played.push_back({tasks::parse_task(trial.task_text, trial.task_name).value(),
                      store->signals(trial).value()});
  return played;
}

/// Recordings of others, made up: every kind of them.
std::vector<PlayedTrial> made_up_recordings() {
  Signals signals({"t_s", "sample_flags", "target_force_N", "actual_force_N", "corridor_error_N",
                   "index_fz_N", "ring_fz_N", "beat"});
  Random random(7, 1);
  for (int k = 0; k < 2000; ++k) {
    const double t_s = 0.01 * k;
    const double wave_N = 5.0 + 2.0 * std::sin(6.0 * t_s);
    const double row[] = {t_s,
                          0.0,
                          wave_N,
                          wave_N + 0.3 * random.gaussian(),
                          std::max(0.0, random.gaussian()),
                          wave_N + 0.2 * random.gaussian(),
                          2.0 + 0.2 * random.gaussian(),
                          k % 100 == 0 ? 1.0 : 0.0};
    signals.append_row(row);
  }
  std::vector<PlayedTrial> played;
  using Measures = tasks::RecordedSpec::Measures;
  for (const Measures measures :
       {Measures::corridor, Measures::maximum, Measures::tracking, Measures::finger_forces}) {
    tasks::RecordedSpec recorded;
    recorded.measures = measures;
    recorded.window = {200, 50};
    recorded.fingers = {"index", "ring"};
    tasks::TaskSpec spec;
    spec.kind = recorded;
    spec.name = "recorded " + std::to_string(played.size());
    played.push_back({spec, signals});
  }
  return played;
}

const std::vector<PlayedTrial>& trials() {
  static const std::vector<PlayedTrial> all = [] {
    auto played = sessions_of_a_simulated_hand();
    for (auto& recording : made_up_recordings()) played.push_back(std::move(recording));
    return played;
  }();
  return all;
}

/// The same rows with columns changed; `change` gives the new values of a column.
template <class Change>
Signals changed(const Signals& signals, Change&& change) {
  Signals copy;
  for (const std::string& name : signals.names()) {
    const auto column = signals.column(name);
    std::vector<double> values(column.begin(), column.end());
    change(name, values);
    copy.add_column(name, std::move(values));
  }
  return copy;
}

template <class Number>
Signals with_each(const Signals& signals, Number&& number) {
  return changed(signals, [&](const std::string& name, std::vector<double>& values) {
    for (double& value : values) value = number(name, value);
  });
}

bool is_force(const std::string& name) {
  return name.ends_with("_N") || name.ends_with("_Nm");
}

/// How a law changes a value, and how nearly it must hold.
struct Law {
  std::function<double(const Measure&)> factor = [](const Measure&) { return 1.0; };
  std::function<std::string(std::string)> channel = [](std::string name) { return name; };
  double tolerance = 1e-9;
};

void expect_law(const PlayedTrial& trial, const Signals& transformed, const Law& law,
                const std::string& what) {
  const auto expected = tasks::score(trial.spec, trial.signals);
  const auto found = tasks::score(trial.spec, transformed);
  ASSERT_EQ(found.size(), expected.size()) << trial.spec.name;
  test::AtLeast with_value(1);
  for (const Measure& before : test::every(expected)) {
    const std::string where =
        what + ": " + trial.spec.name + ": " + before.name + " " + before.channel;
    const auto same = std::find_if(found.begin(), found.end(), [&](const Measure& measure) {
      return measure.name == before.name && measure.channel == law.channel(before.channel);
    });
    ASSERT_NE(same, found.end()) << where;
    EXPECT_EQ(same->samples, before.samples) << where;
    EXPECT_EQ(same->excluded, before.excluded) << where;
    EXPECT_EQ(same->value.has_value(), before.value.has_value()) << where << same->reason;
    if (!same->value || !before.value) continue;
    const double wanted = *before.value * law.factor(before);
    EXPECT_WITHIN(*same->value, wanted, law.tolerance * std::max(1.0, std::abs(wanted))) << where;
    ++with_value;
  }
}

TEST(MeasureLaws, TheTrialsAreThoseOfTheWholeLibraryAndHaveValues) {
  ASSERT_GE(trials().size(), 58U);
  std::map<std::string, int> with_value;
  for (const PlayedTrial& trial : trials())
    for (const Measure& measure : tasks::score(trial.spec, trial.signals))
      with_value[measure.name] += measure.value ? 1 : 0;
  int none = 0;
  for (const auto& [name, count] : with_value) none += count == 0 ? 1 : 0;
  constexpr int kRare = 6;  // what no hand shows in every session
  EXPECT_LE(none, kRare);
  EXPECT_GT(with_value.size(), 90U);
}

TEST(MeasureLaws, ATrialThatBeginsLaterHasTheSameMeasures) {
  for (const double shift_s : {0.1, 0.7, 1234.5}) {
    Law law;
    law.tolerance = 1e-6;  // of the clock: a later second has fewer digits after the point
    for (const PlayedTrial& trial : test::every(trials()))
      expect_law(trial,
                 with_each(trial.signals,
                           [&](const std::string& name, double value) {
                             return name == "t_s" ? value + shift_s : value;
                           }),
                 law, std::to_string(shift_s) + " s later");
  }
}

/// 1 for a force or a rate of force, 2 for a variance, 0 for all that has no force in its unit.
double power_of_force(const Measure& measure) {
  if (measure.unit == "N^2") return 2.0;
  return measure.unit == "N" || measure.unit == "Nm" || measure.unit == "N/s" ||
                 measure.unit == "N s"
             ? 1.0
             : 0.0;
}

/// The push counts from 0.5 N of grip on: the one measure with a force of its own.
bool has_a_fixed_force(const Measure& measure) {
  return measure.name == "net_push" || measure.name == "net_push_time";
}

TEST(MeasureLaws, AStrongerHandOnCoarserSensorsHasTheSameMeasuresInItsOwnUnit) {
  for (const double times : {2.0, 0.25}) {
    Law law;
    law.factor = [&](const Measure& measure) { return std::pow(times, power_of_force(measure)); };
    for (const PlayedTrial& trial : test::every(trials())) {
      const auto scaled = with_each(trial.signals, [&](const std::string& name, double value) {
        return is_force(name) ? times * value : value;
      });
      // The rows below 0.5 N are others: without the platform's forces there is no push.
      const auto without_push = [](const Signals& signals) {
        Signals rest;
        for (const std::string& name : signals.names())
          if (!name.starts_with("net_")) {
            const auto column = signals.column(name);
            rest.add_column(name, {column.begin(), column.end()});
          }
        return rest;
      };
      expect_law({trial.spec, without_push(trial.signals)}, without_push(scaled), law,
                 "forces times " + std::to_string(times));
    }
  }
}

TEST(MeasureLaws, ForcesThatNumbersCannotHoldGiveNoNumberThatIsWrong) {
  test::AtLeast numbers(500);
  for (const double times : {1e-300, 1e-200, 1e-100, 1e100, 1e160, 1e250})
    for (const PlayedTrial& trial : test::every(trials())) {
      const auto expected = tasks::score(trial.spec, trial.signals);
      const auto found = tasks::score(
          trial.spec, with_each(trial.signals, [&](const std::string& name, double value) {
            return is_force(name) ? times * value : value;
          }));
      ASSERT_EQ(found.size(), expected.size()) << trial.spec.name;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const std::string where = trial.spec.name + ": " + found[i].name + " " + found[i].channel +
                                  " at " + std::to_string(std::log10(times));
        if (!found[i].value) {
          EXPECT_FALSE(found[i].reason.empty()) << where;
          continue;
        }
        if (has_a_fixed_force(found[i])) continue;
        ASSERT_TRUE(expected[i].value) << where;
        const double power = power_of_force(found[i]);
        const double wanted = *expected[i].value * std::pow(times, power);
        EXPECT_FALSE(std::signbit(*found[i].value) && *found[i].value == 0.0) << where;
        EXPECT_WITHIN(*found[i].value / (wanted == 0.0 ? 1.0 : wanted), wanted == 0.0 ? 0.0 : 1.0,
                      1e-6)
            << where;
        ++numbers;
      }
    }
}

TEST(MeasureLaws, TheMirroredHandHasTheSameMeasures) {
  const auto mirrored_channel = [](std::string channel) {
    if (channel.ends_with("_+x")) return channel.replace(channel.size() - 2, 1, "-");
    if (channel.ends_with("_-x")) return channel.replace(channel.size() - 2, 1, "+");
    return channel;
  };
  Law law;
  law.channel = mirrored_channel;
  law.factor = [](const Measure& measure) {
    const auto is = [&](const std::string& end) { return measure.channel.ends_with(end); };
    if (measure.name == "resting_force" && (is("_fx") || is("_ty") || is("_tz"))) return -1.0;
    if (measure.name == "constant_error" && (is("x") || is("ry") || is("rz")))
      return measure.channel == "rx" ? 1.0 : -1.0;
    return 1.0;
  };
  for (const PlayedTrial& trial : test::every(trials()))
    expect_law(
        trial,
        with_each(trial.signals,
                  [](const std::string& name, double value) {
                    for (const char* end : {"fx_N", "ty_Nm", "tz_Nm", "_x_m", "vx_mps", "wy_radps",
                                            "wz_radps", "_qy", "_qz", "_angle_rad"})
                      if (name.ends_with(end)) return -value;
                    if (name == "channel_direction" && value < 2.0) return 1.0 - value;
                    return value;
                  }),
        law, "mirrored");
}

TEST(MeasureLaws, TheOrderOfColumnsChangesNoBit) {
  Law law;
  law.tolerance = 0.0;
  for (const PlayedTrial& trial : test::every(trials())) {
    Signals reversed;
    const auto& names = trial.signals.names();
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
      const auto column = trial.signals.column(*name);
      reversed.add_column(*name, {column.begin(), column.end()});
    }
    expect_law(trial, reversed, law, "columns reversed");
  }
}

/// Halves of cycles tell all rows that were excluded, to whichever half they belong.
bool is_half_of_a_cycle(const tasks::TaskSpec& spec, const Measure& measure) {
  const auto* tracking = spec.kind.get_if<tasks::ForceTrackingSpec>();
  if (tracking == nullptr) return false;
  const bool cycles = tracking->waveform.shape == tasks::Waveform::Shape::sine ||
                      tracking->waveform.shape == tasks::Waveform::Shape::triangle;
  return cycles && (measure.channel == "force_rise" || measure.channel == "force_fall");
}

TEST(MeasureLaws, WhatStandsInHeldRowsCountsNowhereAndTheyAreCounted) {
  for (const PlayedTrial& trial : test::every(trials())) {
    Random random(3, 9);
    std::vector<bool> held(trial.signals.rows());
    for (std::size_t row = 0; row < held.size(); ++row) held[row] = random.uniform() < 0.02;
    const auto with_garbage = [&](double garbage_N) {
      return changed(trial.signals, [&](const std::string& name, std::vector<double>& values) {
        const bool of_hand = is_force(name) && name != "resting_force_N" &&
                             name != "maximum_force_N" && name != "noise_sd_N" &&
                             name != "resolution_N" && !name.starts_with("target_");
        for (std::size_t row = 0; row < values.size(); ++row) {
          if (!held[row]) continue;
          if (name == "sample_flags") values[row] = bit(SampleFlag::held);
          if (of_hand) values[row] = garbage_N;
        }
      });
    };
    const auto clean = tasks::score(trial.spec, trial.signals);
    const auto quiet = tasks::score(trial.spec, with_garbage(0.0));
    Law law;
    law.tolerance = 0.0;
    expect_law({trial.spec, with_garbage(0.0)}, with_garbage(1e6), law, "other garbage");
    ASSERT_EQ(clean.size(), quiet.size());
    for (std::size_t i = 0; i < clean.size(); ++i) {
      if (is_half_of_a_cycle(trial.spec, clean[i])) continue;
      EXPECT_EQ(clean[i].samples + clean[i].excluded, quiet[i].samples + quiet[i].excluded)
          << trial.spec.name << ": " << clean[i].name << " " << clean[i].channel;
    }
  }
}

/// What says which rows belong together; no measure computes with it.
bool is_bookkeeping(const std::string& name) {
  return name == "t_s" || name == "phase" || name == "sample_flags" || name == "segment" ||
         name == "cue" || name.starts_with("channel_") || name == "target_index" ||
         name == "targets_reached" || name == "beat";
}

/// The first trial of those that give the same measures.
std::vector<PlayedTrial> one_of_each_kind() {
  std::map<std::vector<std::string>, bool> known;
  std::vector<PlayedTrial> each;
  for (const PlayedTrial& trial : test::every(trials())) {
    std::vector<std::string> names{std::string(trial.spec.kind->name)};
    for (const Measure& measure : tasks::score(trial.spec, trial.signals))
      names.push_back(measure.name);
    if (known.emplace(std::move(names), true).second) each.push_back(trial);
  }
  return each;
}

/// It has the rows of two: its own, and those of the maximum that tells which forces count.
bool has_two_selections(const tasks::TaskSpec& spec, const Measure& measure) {
  return spec.kind.is<tasks::DirectionalMaximaSpec>() && measure.name == "direction_error";
}

bool is_same(const Measure& a, const Measure& b) {
  return a.value == b.value && a.samples == b.samples && a.excluded == b.excluded;
}

std::string words_of(const Measure& measure) {
  return (measure.value ? std::to_string(*measure.value) : measure.reason) + " of " +
         std::to_string(measure.samples) + ", " + std::to_string(measure.excluded) + " excluded";
}

TEST(MeasureLaws, AnEmptyFieldInAColumnThatIsReadIsAMissingSample) {
  for (const PlayedTrial& trial : test::every(one_of_each_kind())) {
    Random random(11, 4);
    std::vector<bool> chosen(trial.signals.rows());
    for (std::size_t row = 0; row < chosen.size(); ++row) chosen[row] = random.uniform() < 0.01;
    const auto with = [&](const std::string& column, double value) {
      return changed(trial.signals, [&](const std::string& name, std::vector<double>& values) {
        if (name != column) return;
        for (std::size_t row = 0; row < values.size(); ++row)
          if (chosen[row]) values[row] = value;
      });
    };
    const auto whole = tasks::score(trial.spec, trial.signals);
    const auto missing = tasks::score(trial.spec, with("sample_flags", bit(SampleFlag::missing)));
    ASSERT_EQ(missing.size(), whole.size()) << trial.spec.name;
    for (const std::string& column : test::every(trial.signals.names())) {
      if (is_bookkeeping(column)) continue;
      const auto empty = tasks::score(trial.spec, with(column, std::nan("")));
      EXPECT_EQ(empty.size(), whole.size()) << trial.spec.name << " without " << column;
      for (std::size_t i = 0; i < std::min(whole.size(), empty.size()); ++i)
        EXPECT_TRUE(has_two_selections(trial.spec, whole[i]) || is_same(empty[i], whole[i]) ||
                    is_same(empty[i], missing[i]))
            << trial.spec.name << ": " << whole[i].name << " " << whole[i].channel << " without "
            << column << ": " << words_of(empty[i]) << "; whole " << words_of(whole[i])
            << "; missing " << words_of(missing[i]);
    }
  }
}

/// So a recorded trial has the same rows whichever of these columns a measure asks for.
TEST(MeasureLaws, ARecordedRowWithoutAFlagHasAValueInEveryColumnOfHandAndObject) {
  for (const PlayedTrial& trial : test::every(trials())) {
    if (trial.spec.kind.is<tasks::RecordedSpec>()) continue;
    const auto flags = trial.signals.column("sample_flags");
    const auto phase = trial.signals.column("phase");
    test::AtLeast fields(100);
    for (const std::string& name : test::every(trial.signals.names())) {
      const bool of_target = name.starts_with("target_q");  // shown while it is scored
      const bool of_hand = name.starts_with("thumb_") || name.starts_with("index_") ||
                           name.starts_with("middle_") || name.starts_with("contact_") ||
                           name.starts_with("slip_") || name.starts_with("utilisation_") ||
                           name.starts_with("actual_");
      if (!of_hand && !of_target) continue;
      const auto values = trial.signals.column(name);
      const bool shown = std::any_of(values.begin(), values.end(),
                                     [](double value) { return !std::isnan(value); });
      if (of_target && !shown) continue;  // free handling has no target
      for (std::size_t row = 0; row < values.size(); ++row) {
        const bool scored = phase[row] == static_cast<double>(tasks::Phase::active) ||
                            phase[row] == static_cast<double>(tasks::Phase::transport) ||
                            phase[row] == static_cast<double>(tasks::Phase::hold);
        if (flags[row] != 0.0 || !scored) continue;
        ASSERT_FALSE(std::isnan(values[row])) << trial.spec.name << " " << name << " " << row;
        ++fields;
      }
    }
  }
}

}  // namespace
}  // namespace isograsp::session::measure_laws_test
