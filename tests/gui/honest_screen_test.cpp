// SPDX-License-Identifier: GPL-3.0-or-later
// For all facts light, sentence and steps agree: every combination of what the flow tells apart.
#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "gui/rules/flow.hpp"

namespace isograsp::gui::honest_screen_test {
namespace {

using Look = std::function<void(const FlowFacts&)>;
/// Hands every value of some facts to the next.
using Axis = std::function<void(FlowFacts&, const std::function<void()>&)>;

Axis flag(bool FlowFacts::*fact) {
  return [fact](FlowFacts& facts, const std::function<void()>& then) {
    for (const bool value : {false, true}) {
      facts.*fact = value;
      then();
    }
  };
}

template <class Words>
Axis text(Words FlowFacts::*fact) {
  return [fact](FlowFacts& facts, const std::function<void()>& then) {
    for (const char* value : {"", "Why."}) {
      if constexpr (std::is_same_v<Words, Text>)
        facts.*fact = Known{value};
      else
        facts.*fact = value;
      then();
    }
  };
}

void every(FlowFacts& facts, const std::vector<Axis>& axes, const Look& look,
           std::size_t from = 0) {
  if (from == axes.size()) return look(facts);
  axes[from](facts, [&] { every(facts, axes, look, from + 1); });
}

void stages(FlowFacts& facts, const std::function<void()>& then) {
  facts.pause_cause = session::PauseCause::none;
  facts.at_rest = false;
  for (const session::Stage stage : {session::Stage::idle, session::Stage::zeroing,
                                     session::Stage::trial, session::Stage::finished}) {
    facts.stage = stage;
    then();
  }
  facts.stage = session::Stage::paused;
  for (const auto cause : {session::PauseCause::therapist, session::PauseCause::missing_samples,
                           session::PauseCause::device_fault, session::PauseCause::occluded,
                           session::PauseCause::object_lost})
    for (const bool at_rest : {false, true}) {
      facts.pause_cause = cause;
      facts.at_rest = at_rest;
      then();
    }
}

/// Faults are told apart by what follows from them.
void healths(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto fault :
       {DeviceFault::none, DeviceFault::silence, DeviceFault::overload, DeviceFault::restarted}) {
    facts.health.fault = fault;
    facts.health.state = fault == DeviceFault::none ? DeviceState::streaming
                         : stops_forces(fault)      ? DeviceState::faulted
                                                    : DeviceState::degraded;
    then();
  }
}

void cameras(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto fault : {MarkerFault::none, MarkerFault::silence, MarkerFault::damaged_samples}) {
    facts.camera_fault = fault;
    facts.health.state = fault == MarkerFault::none ? DeviceState::streaming
                         : stops_markers(fault)     ? DeviceState::faulted
                                                    : DeviceState::degraded;
    then();
  }
}

void arrivals(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto& [arrived, frozen] :
       {std::pair{true, false}, {false, false}, {false, true}, {true, true}}) {
    facts.anything_arrived = arrived;
    facts.frozen = frozen;
    then();
  }
}

void zeros(FlowFacts& facts, const std::function<void()>& then) {
  facts.recorded = false;
  for (const auto& [zeroed, restarted] : {std::pair{false, false}, {true, false}, {true, true}}) {
    facts.zeroed = zeroed;
    facts.restarted = restarted ? std::optional(Finger::index) : std::nullopt;
    for (const char* refusal : {"", "The thumb was not quiet."}) {
      facts.zero_refusal = Known{refusal};
      then();
    }
  }
  facts.zero_refusal = {};
  facts.restarted.reset();
  facts.zeroed = false;
  facts.recorded = true;
  then();
}

void straps(FlowFacts& facts, const std::function<void()>& then) {
  for (const bool rest_done : {false, true})
    for (int state = 0; state < 5; ++state) {
      facts.rest_done = rest_done;
      facts.strapped = state >= 1 && state <= 3;
      facts.settling_s = state == 1 ? 42 : 0;
      facts.straps_due = state == 3;
      facts.hand_out = state == 4 && rest_done && !facts.recorded;
      if (state == 4 && !facts.hand_out) continue;
      then();
    }
}

void protocols(FlowFacts& facts, const std::function<void()>& then) {
  facts.protocol = {};
  then();
  if (facts.recorded) return;  // a recording follows none
  facts.protocol.active = true;
  facts.protocol.act_words = "Grip";
  using Act = ProtocolFacts::Act;
  for (const Act act : {Act::none, Act::zero, Act::pause, Act::trial})
    for (const int wait_s : {0, 20})
      for (const int read_s : {0, 6})
        for (int going = 0; going < 3; ++going) {
          facts.protocol.act = act;
          facts.protocol.wait_s = wait_s;
          facts.protocol.start_in_s = std::max(wait_s, read_s);
          facts.protocol.by_itself = going >= 1;
          facts.protocol.goes_on = going == 2 && act != Act::none;
          then();
        }
  facts.protocol = {};
}

void tasks(FlowFacts& facts, const std::function<void()>& then) {
  facts.task_lacks.clear();
  facts.task_chosen = false;
  facts.task_rests = true;
  then();
  facts.task_chosen = true;
  for (const bool rests : {true, false}) {
    facts.task_rests = rests;
    then();
  }
  facts.task_lacks = "The maximum was not measured.";
  then();
}

void forces(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto& [attempts, maximum_N, done] :
       {std::tuple{0, 0.0, false}, {1, 40.0, false}, {2, 40.0, false}, {2, 40.0, true}}) {
    facts.maximum_attempts = attempts;
    facts.maximum_force_N = maximum_N;
    facts.task_done = done;
    then();
  }
}

void last_trials(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto& last : {std::optional<bool>{}, std::optional(true), std::optional(false)}) {
    facts.last_rested = last;
    then();
  }
}

void pictures(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto& [unsure, watched] :
       {std::pair{false, false}, std::pair{true, false}, std::pair{true, true}}) {
    facts.picture_unsure = unsure;
    facts.picture_watched = watched;
    facts.task_in_picture = facts.last_in_picture = unsure;
    facts.last_rested = unsure ? std::optional(false) : std::nullopt;
    then();
  }
  facts.picture_unsure = facts.picture_watched = facts.task_in_picture = false;
  facts.last_in_picture = false;
  facts.last_rested.reset();
}

FlowFacts with_database() {
  FlowFacts facts;
  facts.database_open = true;
  facts.task_name = "Grip";
  return facts;
}

/// What holds for every fact. @return why not; null: it holds
const char* disagreement(const FlowFacts& facts, const FlowView& view) {
  const auto next = view.next();
  const bool open = facts.connection == Connection::open;
  const bool fresh_zero = facts.start_posture
                              ? facts.zeroed  // of a recorded arm, too
                              : facts.recorded || (facts.zeroed && !facts.restarted);
  const bool begins = view.may_begin || view.may_start || view.may_repeat;
  if (std::count(view.steps.begin(), view.steps.end(), StepState::next) > 1)
    return "two next steps";
  // The two lights.
  if (view.device_mood == Mood::fault && open && view.mood != Mood::fault)
    return "the small light tells a fault, the large one does not";
  if (view.device_mood == Mood::attention && (view.mood == Mood::ready || view.mood == Mood::busy ||
                                              view.mood == Mood::turn || view.mood == Mood::off))
    return "the small light asks for something, the large one is content";
  if (view.mood == Mood::ready && view.device_mood != Mood::ready) return "a check without reason";
  // Start.
  if (begins && !fresh_zero) return "Start with no zero, or one older than a restart";
  if (begins && view.device_mood == Mood::fault) return "Start with a fault";
  if (begins && !facts.anything_arrived) return "Start without samples";
  if (begins && view.may_stop) return "Start in a trial";
  if (view.may_start && facts.task_chosen && facts.task_in_picture && facts.picture_unsure &&
      (!facts.protocol.active || facts.protocol.act == ProtocolFacts::Act::trial))
    return "a target in a picture that may move another way than the arm";
  if (view.may_repeat && facts.last_in_picture && facts.picture_unsure)
    return "once more a target in such a picture";
  if (view.may_resume && session::goes_on_by_itself(facts.pause_cause))
    return "Resume of what goes on by itself";
  if (view.may_resume && !fresh_zero && !facts.at_rest)
    return "Resume with a zero older than a restart, and not from rest";
  const bool rest = facts.task_chosen && facts.task_rests && !facts.recorded;
  if (view.may_begin && rest && (!facts.strapped || facts.settling_s > 0))
    return "a resting force without its minute";
  // The steps.
  const auto state = [&](Step step) { return view.steps[static_cast<std::size_t>(step)]; };
  if (state(Step::zero) == StepState::done && !fresh_zero) return "a zero that is none is done";
  if (state(Step::device) == StepState::done && view.device_mood == Mood::fault)
    return "a device with a fault is done";
  if (open && !facts.recorded && view.mood == Mood::ready && next == Step::zero)
    return "a check while the zero is to be set";
  // The one filled button can be pressed, and it is that of the next step.
  const auto is = [&](NextPress press, bool possible, std::optional<Step> step) {
    return view.press != press || (possible && next == step);
  };
  if (!is(NextPress::patient, view.may_change_patient, Step::patient)) return "patient";
  if (!is(NextPress::hand, view.may_change_hand, Step::hand)) return "hand";
  if (!is(NextPress::confirm_hand, view.may_change_hand, Step::hand)) return "confirm";
  if (!is(NextPress::screening, view.may_change_hand, Step::screening)) return "screening";
  if (!is(NextPress::earlier, view.may_change_hand, Step::work)) return "earlier";
  if (!is(NextPress::device, view.may_change_device, Step::device)) return "device";
  if (!is(NextPress::connect, view.may_connect, Step::device)) return "connect";
  if (!is(NextPress::zero, view.may_zero, Step::zero)) return "zero";
  if (!is(NextPress::platforms, view.may_check_platforms, Step::zero)) return "platforms";
  if (!is(NextPress::reach, view.may_promise_reach, Step::rest)) return "reach";
  if (!is(NextPress::strap, view.may_strap, Step::rest)) return "strap";
  // Both hands.
  const bool free_at_once = facts.platforms_checked && facts.stop_tested && facts.within_reach;
  if (facts.both_hands && begins && !(facts.strapped && free_at_once))
    return "Start of both hands that nobody can free at once, or that are not in";
  if (facts.both_hands && view.may_strap && !free_at_once)
    return "hands go in before the stop was tested and somebody stays";
  if (view.situation == Situation::test_stop && !view.may_test_stop)
    return "a test is asked for that counts for nothing";
  if (!is(NextPress::picture, view.may_watch_picture, Step::work)) return "picture";
  if (!is(NextPress::end, view.offers_end, std::nullopt)) return "end";
  if (view.press == NextPress::start &&
      !(view.may_start && (next == Step::work || next == Step::rest) &&
        (view.mood == Mood::ready || view.device_speaks || view.situation == Situation::settle)))
    return "Start is filled but not what comes next";
  if (view.press == NextPress::resume && !view.may_resume) return "resume";
  // What is asked for can be done.
  if (next == Step::zero && facts.stage == session::Stage::idle && !facts.zero_asked &&
      !view.may_zero)
    return "a zero is asked for that cannot be set";
  if ((view.situation == Situation::straps_due || view.situation == Situation::strap_in ||
       view.situation == Situation::strap_again) &&
      !view.may_strap)
    return "the hand is to go in and nobody can say so";
  if (view.situation == Situation::next_act && !view.may_start && facts.task_lacks.empty())
    return "Press Start, and it cannot be pressed";
  if (view.offers_end && !view.may_disconnect) return "an end that cannot be made";
  if (view.may_stand_by && view.must_stand_by && view.may_begin && !facts.straps_due &&
      facts.zero_refusal.empty())
    return "begins by itself after a fault";
  return nullptr;
}

/// Looks at each combination; words are made for each situation that differs.
class Judge {
 public:
  void look(const FlowFacts& facts) {
    ++seen_;
    const FlowView view = judge(facts);
    if (const char* why = disagreement(facts, view); why != nullptr && wrong_.insert(why).second)
      ADD_FAILURE() << why << ": " << decide(facts).sentence << " | " << decide(facts).device_words
                    << " | situation " << static_cast<int>(view.situation);
    situations_.insert(view.situation);
    if (!told_.insert({view.situation, view.device, view.may_start, facts.protocol.goes_on}).second)
      return;
    const FlowView words = decide(facts);
    EXPECT_FALSE(words.sentence.empty()) << static_cast<int>(view.situation);
    EXPECT_FALSE(words.device_words.empty()) << static_cast<int>(view.situation);
    const bool says_start = words.sentence.find("Press Start") != std::string::npos;
    if (facts.task_lacks.empty()) {
      EXPECT_TRUE(!says_start || view.may_start) << words.sentence;
    }
    const bool fault = view.device_mood == Mood::fault && facts.connection == Connection::open;
    const bool trouble = view.device == DeviceCondition::degraded && view.mood != Mood::fault;
    if (fault || trouble) {
      EXPECT_NE(words.sentence.find(words.device_words), std::string::npos) << words.sentence;
    }
  }
  [[nodiscard]] long seen() const { return seen_; }
  [[nodiscard]] const std::set<Situation>& situations() const { return situations_; }

 private:
  long seen_ = 0;
  std::set<std::string> wrong_;
  std::set<Situation> situations_;
  std::set<std::tuple<Situation, DeviceCondition, bool, bool>> told_;
};

void before_a_session(Judge& judge) {
  FlowFacts facts;
  const auto connections = [](FlowFacts& f, const std::function<void()>& then) {
    for (const auto connection : {Connection::none, Connection::opening, Connection::closing}) {
      f.connection = connection;
      then();
    }
  };
  every(
      facts,
      {flag(&FlowFacts::database_open), text(&FlowFacts::database_error),
       flag(&FlowFacts::look_only), flag(&FlowFacts::patient_chosen), flag(&FlowFacts::hand_chosen),
       flag(&FlowFacts::hand_to_confirm), flag(&FlowFacts::screened),
       flag(&FlowFacts::earlier_sought), flag(&FlowFacts::earlier_undecided),
       flag(&FlowFacts::device_chosen), text(&FlowFacts::connection_error), connections, tasks},
      [&](const FlowFacts& now) {
        if (!now.database_error.empty() && now.database_open) return;
        judge.look(now);
      });
}

void in_a_session(Judge& judge) {
  FlowFacts facts = with_database();
  facts.connection = Connection::open;
  facts.patient_chosen = facts.hand_chosen = facts.screened = facts.device_chosen = true;
  every(facts,
        {zeros, stages, healths, arrivals, flag(&FlowFacts::zero_asked), flag(&FlowFacts::starting),
         straps, tasks, text(&FlowFacts::stop_reason), protocols},
        [&](const FlowFacts& now) {
          FlowFacts changed = now;
          // What matters only where tasks are chosen by hand, or a trial can be repeated.
          if (now.protocol.active || now.stage != session::Stage::idle) return judge.look(now);
          every(changed, {forces, last_trials}, [&](const FlowFacts& all) { judge.look(all); });
        });
}

/// Cameras see an arm: a start posture in the place of the zero, nobody rests in a device.
void before_cameras(Judge& judge) {
  FlowFacts facts = with_database();
  facts.connection = Connection::open;
  facts.patient_chosen = facts.hand_chosen = facts.screened = facts.device_chosen = true;
  facts.start_posture = facts.rest_done = true;
  facts.asks_rest = facts.task_rests = false;
  std::set<std::tuple<Situation, DeviceCondition, ProtocolFacts::Act>> told;
  every(facts,
        {zeros, stages, cameras, arrivals, flag(&FlowFacts::zero_asked), flag(&FlowFacts::starting),
         flag(&FlowFacts::task_chosen), flag(&FlowFacts::task_done), text(&FlowFacts::stop_reason),
         pictures, protocols},
        [&](const FlowFacts& now) {
          judge.look(now);
          const FlowView seen = isograsp::gui::judge(now);
          ASSERT_FALSE(seen.may_check || seen.may_strap);
          if (!told.insert({seen.situation, seen.device, now.protocol.act}).second) return;
          const FlowView view = decide(now);
          for (const std::string& said : {view.sentence, view.device_words, view.start_hint})
            for (const char* of_forces : {"empty", "forces", "strap", "hand out", "zero", "device"})
              EXPECT_EQ(said.find(of_forces), std::string::npos) << said;
        });
}

/// How far it is made sure of that both hands are free at once; none goes in before.
void safeties(FlowFacts& facts, const std::function<void()>& then) {
  for (const auto& [tested, stays] : {std::pair{false, false}, {true, false}, {true, true}}) {
    facts.stop_tested = tested;
    facts.within_reach = stays;
    for (const auto& [checked, pressed] : {std::pair{false, false}, {false, true}, {true, false}}) {
      facts.platforms_checked = checked;
      facts.platforms_pressed = pressed;
      if ((facts.strapped && !(tested && stays)) || (tested && !checked)) continue;
      then();
    }
  }
}

/// Whose fault or restart it is; after health and zero.
void sides(FlowFacts& facts, const std::function<void()>& then) {
  if (facts.health.fault == DeviceFault::none && !facts.restarted) {
    facts.health_side = facts.restarted_side = std::nullopt;
    return then();
  }
  for (const Hand hand : {Hand::left, Hand::right}) {
    facts.health_side = facts.restarted_side = hand;
    then();
  }
}

/// Both hands, each on a platform.
void on_two_platforms(Judge& judge) {
  FlowFacts facts = with_database();
  facts.connection = Connection::open;
  facts.patient_chosen = facts.hand_chosen = facts.screened = facts.device_chosen = true;
  facts.both_hands = true;
  std::set<std::tuple<Situation, DeviceCondition, Hand>> told;
  every(facts,
        {zeros, stages, healths, sides, arrivals, flag(&FlowFacts::starting), straps, safeties,
         tasks, text(&FlowFacts::stop_reason), protocols},
        [&](const FlowFacts& now) {
          if (now.recorded) return;  // there is no recording of both
          judge.look(now);
          const FlowView seen = isograsp::gui::judge(now);
          const Hand side = now.health_side.value_or(Hand::left);
          if (!told.insert({seen.situation, seen.device, side}).second) return;
          const FlowView view = decide(now);
          if (seen.device == DeviceCondition::faulted || seen.device == DeviceCondition::outdated) {
            EXPECT_EQ(
                view.device_words.find(side == Hand::left ? "Left platform: " : "Right platform: "),
                0u)
                << view.device_words;
          }
        });
}

TEST(HonestScreen, LightSentenceAndStepsAgreeForAllFacts) {
  Judge judge;
  before_a_session(judge);
  in_a_session(judge);
  before_cameras(judge);
  on_two_platforms(judge);
  EXPECT_EQ(judge.situations().size(), kSituationCount) << "every situation was met";
  std::printf("combinations of facts: %ld\n", judge.seen());
}

}  // namespace
}  // namespace isograsp::gui::honest_screen_test
