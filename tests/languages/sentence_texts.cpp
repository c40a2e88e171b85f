// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/languages/sentence_texts.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <stdexcept>

#include "core/files.hpp"
#include "session/library/library.hpp"
#include "session/platform/zeroing.hpp"
#include "session/recorder.hpp"
#include "session/resting.hpp"
#include "session/resume.hpp"
#include "session/work_limits.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tasks/references.hpp"

namespace isograsp::languages {

namespace {

namespace fs = std::filesystem;
using Texts = std::set<std::string>;

/// With %1, %2 … for numbers that stand alone or before a unit, not for digits of a name.
std::string pattern_of(const std::string& text) {
  static const std::regex kNumber(
      "(^|[^A-Za-z0-9_.%])(-?[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?)(?![A-Za-z0-9_])");
  std::string pattern;
  std::string rest = text;
  std::smatch found;
  for (int place = 1; std::regex_search(rest, found, kNumber); ++place) {
    pattern += found.prefix().str() + found[1].str() + "%" + std::to_string(place);
    rest = found.suffix().str();
  }
  return pattern + rest;
}

/// With the numbers of this moment in it, and made of sentences that vary on their own.
void add_sentences(Texts& texts, const std::string& text) {
  static const std::regex kEnd("([.!?]) +");
  const std::string lines = std::regex_replace(text, kEnd, "$1\n");
  for (std::size_t from = 0; from < lines.size();) {
    const std::size_t to = std::min(lines.find('\n', from), lines.size());
    if (to > from) texts.insert(pattern_of(lines.substr(from, to - from)));
    from = to + 1;
  }
}

void add_session(Texts& texts) {
  using Why = session::ZeroRefusal::Why;
  for (const Why why :
       {Why::gaps, Why::noisy_force, Why::noisy_torque, Why::drift, Why::loaded, Why::changed})
    for (const Finger finger : kFingers)
      add_sentences(texts, session::words_of(session::ZeroRefusal{why, finger, 0.5, 0.25}));
  session::ZeroRecord zero;
  zero.change_confirmed = zero.drifted = true;
  zero.change_N = zero.drift_N = 0.5;
  add_sentences(texts, session::remark_on(zero));
  // Every combination of fingers that press, pull or rest.
  constexpr double kForce_N = 50.0;
  for (int combination = 0; combination < 27; ++combination) {
    session::RestingForce rest;
    int digits = combination;
    for (auto& mean : rest.mean) {
      mean.setZero();
      mean[2] = kForce_N * (digits % 3 - 1);
      digits /= 3;
    }
    for (auto& sd : rest.sd) sd.setConstant(kForce_N);
    add_sentences(texts, session::words_of(rest));
  }
  std::vector<storage::RatingRecord> ratings(2);
  for (const auto& [first, last] : {std::pair{0, 9}, std::pair{0, 3}}) {
    ratings[0].pain = first;
    ratings[1].pain = last;
    if (const auto reason = session::reason_to_stop(ratings)) add_sentences(texts, *reason);
  }
  session::WorkLimits tired;
  Measure maximum;
  maximum.name = "maximum_force";
  for (const double force_N : {kForce_N, 0.5 * kForce_N}) {
    maximum.value = force_N;
    tired.tried({&maximum, 1});
  }
  add_sentences(texts, *tired.reason_to_stop());
  session::WorkLimits long_day;
  long_day.worked(session::kMostWork_s);
  add_sentences(texts, *long_day.reason_to_stop());
  // Why a trial ended or nothing could begin, as the session says it.
  for (const char* text :
       {"Stopped by the therapist.", "The recording ended.", "The session was closed.",
        "Stopped after a device fault.", "Instrument zero", "Pause", "reading", "page %1 of %2",
        "part %1 of %2", "session %1 of %2", "task %1 of %2", "checking trial %1",
        "a trial or a zero is still running", "wait for its end",
        "the hand was strapped less than a minute ago and still settles", "wait another %1 s",
        "nobody has confirmed that the device is empty",
        "take the hand out, let nothing touch the supports, and confirm that"})
    texts.insert(text);
}

/// A measure's title without its channel, and what its channel adds.
void add_measures(Texts& texts) {
  const auto capital = [](std::string text) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
  };
  for (const auto name : tasks::worded_measures())
    for (const char* channel : {"", "grip"})
      texts.insert(capital(tasks::words_of(name, channel).title));
  // Of a change, with how sure it is, or why there is no verdict.
  for (const char* verdict :
       {"improved (possible)", "improved (confirmed)", "worsened (possible)",
        "worsened (confirmed)", "not larger than measurement error", "cannot be judged yet",
        "of %1", "more of it is neither better nor worse", "the baseline needs two assessment days",
        "a day of the baseline has no value", "no assessment after the baseline",
        "the last assessment has no value", "stable pairs of %1 people instead of %2",
        "stable people show no variation", "a value is not positive, its error is a share",
        "the level of its trials follows success", "the affected side is not known"})
    texts.insert(verdict);
  for (const tasks::Better better :
       {tasks::Better::lower, tasks::Better::higher, tasks::Better::near_zero})
    texts.insert(std::string(tasks::words_of(better)));
  const std::string plain = tasks::words_of("gain", "").title;
  const auto add = [&](const std::string& channel) {
    const auto behind = tasks::words_of("gain", channel).title.substr(plain.size());
    if (!behind.empty()) texts.insert(pattern_of(behind));
  };
  for (std::size_t d = 0; d < kDigitsCount; ++d)
    for (std::size_t way = 0; way < kDirectionCount; ++way)
      add(name_of(ForceChannel{static_cast<Digits>(d), static_cast<Direction>(way)}));
  for (const char* part :
       {"rx", "ry", "rz", "x", "y", "z", "force_rise", "force_hold", "force_fall", "force_rate",
        "force_25_percent", "force_5_N", "force_0.2_Hz", "target_3"})
    add(part);
  for (const auto& digit : kFingerNames)
    for (const char* axis : {"fx", "fy", "fz", "tx", "ty", "tz"})  // of the resting force
      texts.insert(std::string(digit) + " " + axis);
  for (const auto& digit : kFingerNames)
    for (const auto& other : kFingerNames)
      if (digit != other) add(std::string(digit) + "_to_" + std::string(other));
}

/// Why a measure has no value: sentences without a capital, wherever measures are computed.
void add_reasons(Texts& texts, const std::string& source_folder) {
  static const std::regex kReason("\"([a-z]+,? [a-z0-9][A-Za-z0-9 ,.;%'-]*)\"");
  std::vector<fs::path> files{
      source_folder + "/tasks/record.cpp", source_folder + "/tasks/score.cpp",
      source_folder + "/statistics/percentile.cpp", source_folder + "/statistics/quantile.cpp",
      source_folder + "/statistics/survival.cpp"};
  for (const auto& entry : fs::directory_iterator(source_folder + "/tasks/measures"))
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(source_folder + "/tasks/kinds"))
    if (entry.path().filename().string().find("score") != std::string::npos)
      files.push_back(entry.path());
  for (const auto& file : files) {
    const auto code = read_text(file);
    if (!code) throw std::runtime_error(file.string() + " cannot be read");
    for (std::sregex_iterator at(code->begin(), code->end(), kReason), end; at != end; ++at)
      if (const auto reason = (*at)[1].str();
          !reason.ends_with(' '))  // or it is the beginning of one
        texts.insert(pattern_of(reason));
  }
}

}  // namespace

std::set<std::string> sentence_texts(const std::string& source_folder) {
  Texts texts;
  add_session(texts);
  add_measures(texts);
  add_reasons(texts, source_folder);
  texts.erase("");
  return texts;
}

}  // namespace isograsp::languages
