// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/demonstration.hpp"

#include "device/config/uri.hpp"
#include "session/acquisition/acquisition.hpp"
#include "session/platform/force_platform.hpp"
#include "session/platform/prepare_trial.hpp"
#include "session/simulated_person.hpp"

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

}  // namespace

Result<Demonstration> demonstrate(const tasks::TaskSpec& spec,
                                  const tasks::ForceReferences& references, Hand hand,
                                  const std::string& library) {
  ApparatusInfo shown_with;
  shown_with.kind = ForcePlatform::kKind;
  if (auto fits = check_apparatus(spec.apparatus(), shown_with); !fits) return fits.error();
  const std::string text = "sim://healthy?seed=1&hand=" + std::string(name_of(hand));
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

  Demonstration shown;
  shown.task = std::make_shared<tasks::TaskSpec>(spec);
  shown.period_s = platform.info().period_s;
  shown.context.period_s = shown.period_s;
  shown.context.references = completed(references);
  const auto scene = read_trial_scene(spec, hand, {}, library);
  if (!scene) return scene.error();
  if (scene->scene) shown.scene = std::make_shared<Scene>(*scene->scene);
  const auto setup = prepare_trial(spec, shown.context, *scene);
  if (!setup) return setup.error();
  (void)acquisition.commands().push({.kind = Command::Kind::begin, .setup = setup->get()});
  const auto most = static_cast<std::size_t>(kLongestDemonstration_s / shown.period_s);
  bool begun = false;
  while (shown.frames.size() < most && acquisition.tick()) {
    for (RecordItem unwanted; acquisition.records().pop(unwanted);) {
    }
    const Snapshot& now = platform.snapshots().read();
    begun = begun || now.stage == Stage::trial;
    if (begun && now.stage != Stage::trial) break;
    if (begun) shown.frames.push_back(now);
  }
  platform.stop();
  return shown;
}

}  // namespace isograsp::session
