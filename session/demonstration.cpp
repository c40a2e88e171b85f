// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/demonstration.hpp"

#include <utility>

#include "core/latest.hpp"
#include "device/config/uri.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/arm/marker_arm.hpp"
#include "session/arm/start_posture.hpp"
#include "session/open_arm.hpp"
#include "session/open_hand.hpp"
#include "session/platform/force_platform.hpp"
#include "session/platform/prepare_trial.hpp"
#include "session/simulated_person.hpp"
#include "session/tracked_hand/tracked_hand.hpp"

namespace isograsp::session {

namespace {

/// Forces that the patient has not been measured in: well below a healthy hand's, for they are
/// shown and not asked. Opening and sideways a hand is weaker.
constexpr double kAssumedClosing_N = 20.0;
constexpr double kAssumedOther_N = 6.0;
constexpr double kComfortable = 0.4;  ///< of the maximum

tasks::ForceReferences completed(const tasks::ForceReferences& known) {
  tasks::ForceReferences all;
  all.maximum_N = known.maximum_N;
  all.comfortable_N = known.comfortable_N;
  all.resting_C = known.resting_C.value_or(FingerWrenches{});
  for (std::size_t digits = 0; digits < kDigitsCount; ++digits)
    for (std::size_t direction = 0; direction < kDirectionCount; ++direction) {
      const ForceChannel channel{static_cast<Digits>(digits), static_cast<Direction>(direction)};
      const bool closing = channel.direction == Direction::plus_z;
      const double maximum_N =
          all.maximum_N.try_emplace(channel, closing ? kAssumedClosing_N : kAssumedOther_N)
              .first->second;
      all.comfortable_N.try_emplace(channel, kComfortable * maximum_N);
      all.baseline_N[channel] = maximum_N;
    }
  return all;
}

/// The next frame of the acquisition, of which nothing is recorded; false: there is none.
bool go_on(Acquisition& acquisition) {
  if (!acquisition.tick()) return false;
  for (RecordItem unwanted; acquisition.records().pop(unwanted);) {
  }
  return true;
}

/// Frames of the trial that was begun, as far as they are shown: a pause is left out, since a
/// demonstration has no reason for one that a patient could see.
template <class Frame>
void keep_trial(Acquisition& acquisition, Latest<Frame>& snapshots, double period_s,
                double longest_s, std::vector<Frame>& frames) {
  const auto most = static_cast<std::size_t>(longest_s / period_s);
  bool begun = false;
  for (std::size_t k = 0; k < most && go_on(acquisition); ++k) {
    const Frame& now = snapshots.read();
    begun = begun || now.stage == Stage::trial;
    if (begun && now.stage != Stage::trial && now.stage != Stage::paused) break;
    if (now.stage == Stage::trial) frames.push_back(now);
  }
}

/// Does what stands before a trial; false: it was not done in that time.
template <class Frame>
bool prepared(Acquisition& acquisition, Preparation& preparation, Latest<Frame>& snapshots,
              double longest_s) {
  (void)acquisition.commands().push({.kind = Command::Kind::prepare, .preparation = &preparation});
  while (!snapshots.read().zeroed)
    if (snapshots.read().session_time_s > longest_s || !go_on(acquisition)) return false;
  return true;
}

Demonstration begun_with(const tasks::TaskSpec& spec, double period_s) {
  Demonstration shown;
  shown.task = std::make_shared<tasks::TaskSpec>(spec);
  shown.period_s = shown.context.period_s = period_s;
  return shown;
}

Result<Demonstration> by_hand(const tasks::TaskSpec& spec, const DemonstrationFor& whom,
                              const std::string& library) {
  ApparatusInfo shown_with;
  shown_with.kind = ForcePlatform::kKind;
  if (auto fits = check_apparatus(spec.apparatus(), shown_with); !fits) return fits.error();
  const std::string text = "sim://healthy?seed=1&hand=" + std::string(name_of(whom.hand));
  const auto uri = Uri::parse(text);
  if (!uri) return uri.error();
  auto person = simulated_person(*uri, library);
  if (!person) return person.error();
  DeviceOptions options;
  options.source = person->get();
  auto device = open_device(text, options);
  if (!device) return device.error();
  ManualClock clock;
  ForcePlatform platform(*std::move(device), *std::move(person));
  if (auto started = platform.start(clock); !started) return started.error();
  Acquisition acquisition(platform, clock);

  Demonstration shown = begun_with(spec, platform.info().period_s);
  shown.context.references = completed(whom.references);
  const auto scene = read_trial_scene(spec, whom.hand, {}, library);
  if (!scene) return scene.error();
  if (scene->scene) shown.scene = std::make_shared<Scene>(*scene->scene);
  const auto setup = prepare_trial(spec, shown.context, *scene);
  if (!setup) return setup.error();
  (void)acquisition.commands().push({.kind = Command::Kind::begin, .setup = setup->get()});
  keep_trial(acquisition, platform.snapshots(), shown.period_s, kLongestDemonstration_s,
             shown.frames);
  platform.stop();
  return shown;
}

Result<Demonstration> by_arm(const tasks::TaskSpec& spec, const DemonstrationFor& whom,
                             const std::string& library) {
  const auto uri = Uri::parse("sim://arm?patient=healthy&seed=1");
  if (!uri) return uri.error();
  const auto opened = open_arm({*uri, whom.hand, library, std::nullopt});
  if (!opened) return opened.error();
  Apparatus& apparatus = **opened;
  auto& arm = dynamic_cast<MarkerArm&>(apparatus);  // what open_arm() opens
  ManualClock clock;
  if (auto started = arm.start(clock); !started) return started.error();
  Acquisition acquisition(arm, clock);

  Demonstration shown = begun_with(spec, arm.info().period_s);
  shown.arm = arm.setup();
  shown.context.ranges = whom.ranges;
  const auto posture = apparatus.make_preparation({});
  if (!posture) return posture.error();
  if (!prepared(acquisition, **posture, arm.snapshots(), 2.0 * StartPostureLimits().longest_s))
    return failed("the simulated arm was not seen in its start posture"_text,
                  "use the rigs of the library as they are shipped"_text);
  const auto setup = apparatus.make_trial(spec, shown.context);
  if (!setup) return setup.error();
  (void)acquisition.commands().push({.kind = Command::Kind::begin, .setup = setup->get()});
  keep_trial(acquisition, arm.snapshots(), shown.period_s, kLongestDemonstration_s,
             shown.arm_frames);
  arm.stop();
  return shown;
}

Result<Demonstration> by_tracked_hand(const tasks::TaskSpec& spec, const DemonstrationFor& whom,
                                      const std::string& library) {
  const auto uri = Uri::parse("sim://hand?user=healthy&seed=1");
  if (!uri) return uri.error();
  const auto opened = open_hand({*uri, whom.hand, library, std::nullopt});
  if (!opened) return opened.error();
  Apparatus& apparatus = **opened;
  auto& hand = dynamic_cast<TrackedHand&>(apparatus);  // what open_hand() opens
  ManualClock clock;
  if (auto started = hand.start(clock); !started) return started.error();
  Acquisition acquisition(hand, clock);

  Demonstration shown = begun_with(spec, hand.info().period_s);
  const auto entry = apparatus.make_preparation({});
  if (!entry) return entry.error();
  constexpr double kLongestEntry_s = 60.0;
  if (!prepared(acquisition, **entry, hand.snapshots(), kLongestEntry_s))
    return failed("the simulated hand did not pass the entry test"_text,
                  "use the hands of the library as they are shipped"_text);
  const auto setup = apparatus.make_trial(spec, shown.context);
  if (!setup) return setup.error();
  (void)acquisition.commands().push({.kind = Command::Kind::begin, .setup = setup->get()});
  keep_trial(acquisition, hand.snapshots(), shown.period_s, kLongestOfHand_s, shown.hand_frames);
  hand.stop();
  return shown;
}

}  // namespace

Text why_not_shown(const tasks::TaskSpec& spec) {
  // Markers alone are looked at: of what is done with them nothing is on the screen.
  if (spec.kind->markers != nullptr)
    return "It is done with a real thing, of which the screen shows nothing: show it yourself."_text;
  if (spec.kind->group == tasks::TaskGroup::two_hands)
    return "No person in software shows both hands: show it with your own."_text;
  return {};
}

Result<Demonstration> demonstrate(const tasks::TaskSpec& spec, const DemonstrationFor& whom,
                                  const std::string& library) {
  if (const Text why = why_not_shown(spec); !why.empty())
    return refused("cannot be shown on a screen"_text, why).at(spec.file);
  if (spec.apparatus() == MarkerArm::kKind) return by_arm(spec, whom, library);
  if (spec.apparatus() == TrackedHand::kKind) return by_tracked_hand(spec, whom, library);
  return by_hand(spec, whom, library);
}

}  // namespace isograsp::session
