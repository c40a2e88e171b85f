// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/ask_device.hpp"

#include <utility>

#include "core/progress.hpp"
#include "core/time.hpp"

namespace isograsp::session {

namespace {

constexpr double kLooked_s = 1.0;
constexpr double kMostToStart_s = 3.0;  // until its first whole frame

/// For whichever hand it is mounted.
Result<std::unique_ptr<Apparatus>> open_for_either(const Uri& uri, const std::string& library,
                                                   std::span<const ApparatusRow> rows) {
  auto opened = open_apparatus({uri, Hand::right, library, std::nullopt}, rows);
  if (opened || opened.error().field != "hand") return opened;
  return open_apparatus({uri, Hand::left, library, std::nullopt}, rows);
}

/// Counts frames from the first whole one on; where none comes, those with a gap.
void look_at(Apparatus& apparatus, const std::stop_token& stop, DeviceAnswer& answer) {
  double first_s = -1.0;
  int before = 0;
  while (!stop.stop_requested() && apparatus.next()) {
    const double now_s = apparatus.now().session_time_s;
    const Reception reception = apparatus.receive();
    // What cameras do not see at the moment is no fault of theirs.
    const bool whole = !reception.gap && reception.sight != Reception::Sight::lost;
    if (first_s < 0.0 && whole) first_s = now_s;
    if (first_s < 0.0) {
      ++before;
      if (now_s > kMostToStart_s) {
        answer.frames = answer.with_gap = before;
        return;
      }
      continue;
    }
    ++answer.frames;
    answer.with_gap += whole ? 0 : 1;
    if (now_s - first_s >= kLooked_s) return;
  }
}

}  // namespace

Result<DeviceAnswer> ask_device(const std::string& uri, const std::string& library,
                                const std::stop_token& stop, std::span<const ApparatusRow> rows) {
  const auto parsed = parse_address(uri);
  if (!parsed) return parsed.error();
  auto opened = open_for_either(*parsed, library, rows);
  if (!opened) return opened.error();
  Apparatus& apparatus = **opened;
  DeviceAnswer answer;
  SteadyClock clock;
  if (!apparatus.info().watches_person) {
    if (auto started = apparatus.start(clock); !started) return started.error();
    look_at(apparatus, stop, answer);
    apparatus.stop();
  }
  if (stop.stop_requested()) return cancelled();
  answer.description = apparatus.info().description;
  answer.kind = apparatus.info().kind;
  answer.rate_Hz = 1.0 / apparatus.info().period_s;
  storage::SessionRecord session;
  apparatus.describe(session);
  answer.sensors = std::move(session.sensors);
  return answer;
}

}  // namespace isograsp::session
