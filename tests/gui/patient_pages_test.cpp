// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of force task on the patient's screen, played by the task itself: what must be seen is
// seen, what must not be is not. With ISOGRASP_TEST_PICTURES set the pages are kept there.
#include <QDir>
#include <QPainter>
#include <functional>

#include <gtest/gtest.h>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_directions.hpp"
#include "qt_test.hpp"
#include "session/platform/snapshot.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::test::patient_pages_test {
namespace {

tasks::TaskSpec parse(const std::string& body) {
  auto spec = tasks::parse_task(
      "format = \"isograsp-task-1\"\nname = \"task\"\ninstruction = \"do\"\n"
      "version = 1\n" +
          body,
      "task.toml");
  if (!spec) ADD_FAILURE() << spec.error().message();
  return *spec;
}

tasks::TaskContext context(std::uint64_t seed = 1) {
  tasks::TaskContext context;
  context.seed = seed;
  for (const Digits digits : {Digits::grip, Digits::thumb, Digits::index, Digits::middle})
    for (const Direction direction : {Direction::plus_z, Direction::minus_z})
      context.references.maximum_N[{digits, direction}] = digits == Digits::grip ? 40.0 : 20.0;
  return context;
}

/// Three fingers of which each presses `share` of what is asked in the channel.
FingerWrenches answer(const tasks::TaskView& view, double share) {
  FingerWrenches wrench_C;
  const double sign = view.force().channel.direction == Direction::minus_z ? -1.0 : 1.0;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const double part = f == 0 ? 1.0 : 0.5;
    wrench_C[f].force = Vec3(0, 0, sign * share * part * view.force().target_force_N);
    if (single_digit(view.force().channel) == kFingers[f]) wrench_C[f].force.z() *= 1.0 / part;
    if (view.force().digit_targets.shown[f])
      wrench_C[f].force = share * view.force().digit_targets.force_C[f];
  }
  return wrench_C;
}

/// The facts of each frame of a trial in which the patient gives `share` of what is asked.
class Play {
 public:
  explicit Play(const tasks::TaskSpec& spec, std::uint64_t seed = 1, double share = 0.8,
                Hand hand = Hand::right)
      : share_(share), task_(*tasks::make_task(spec, context(seed))) {
    facts_.session_open = facts_.arrived = true;
    facts_.stage = session::Stage::trial;
    facts_.hand = hand;
    facts_.task = std::make_shared<tasks::TaskSpec>(spec);
    facts_.preview = std::make_shared<TargetPreview>(preview_target(spec, context(seed)));
    now_.stage = session::Stage::trial;
  }

  /// False after the end.
  bool next() {
    tasks::ForceInput input;
    input.wrench_C = answer(view_, share_);
    now_.forces.wrench_C = input.wrench_C;
    now_.grip_N = kOtherForce_N;
    view_ = task_->step(input);
    now_.task = view_;
    now_.special = view_;
    facts_.stimulus = session::screen_of(now_);
    return view_.phase != tasks::Phase::done;
  }
  bool run_to(const std::function<bool(const tasks::TaskView&)>& reached) {
    while (next())
      if (reached(view())) return true;
    return false;
  }
  [[nodiscard]] const tasks::TaskView& view() const { return view_; }
  [[nodiscard]] PatientPicture picture() const { return picture_for(facts_); }
  [[nodiscard]] PatientFacts& facts() { return facts_; }

  static constexpr double kOtherForce_N = 123.0;  ///< of the grip, where another force is shown

 private:
  double share_;
  PatientFacts facts_;
  session::Snapshot now_;
  tasks::TaskView view_;
  std::unique_ptr<tasks::Task> task_;
};

QImage paint(const PatientPicture& picture, int height = 360) {
  application();
  QImage image(height * 16 / 9, height, QImage::Format_RGB32);
  QPainter painter(&image);
  paint_page(painter, QRectF(image.rect()), picture);
  return image;
}

void keep(const PatientPicture& picture, const char* name) {
  const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  paint(picture, 720).save(folder + "/page_" + name + ".png");
}

const char* const kOpening =
    "kind = \"force_tracking\"\nchannel = \"opening\"\nleast_fraction = 0\nmost_fraction = 0.3\n"
    "duration_s = 10\n";
const char* const kNegative =
    "kind = \"force_tracking\"\nscale = \"newton\"\nleast_N = -6\nmost_N = 6\nduration_s = 10\n"
    "preview_s = 2\n";
const char* const kBlind =
    "kind = \"force_tracking\"\nforce_shown = false\nduration_s = 10\npreview_s = 3\n";
const char* const kSteadiness = "kind = \"steadiness\"\nlevels_fractions = [0.1, 0.25]\n";
const char* const kStep = "kind = \"step_response\"\npreview_s = 5\n";
const char* const kRelease = "kind = \"grip_release\"\npreview_s = 5\n";
const char* const kReleaseOpen = "kind = \"grip_release\"\nopen = true\n";
const char* const kSense = "kind = \"force_sense\"\n";
const char* const kFatigue = "kind = \"fatigue\"\n";
const char* const kIndividuation = "kind = \"individuation\"\n";
const char* const kComfortable = "kind = \"maximum\"\neffort = \"comfortable\"\n";
const char* const kOpeningMaximum = "kind = \"maximum\"\nchannel = \"opening\"\n";
const char* const kMaxima =
    "kind = \"directional_maxima\"\ndigits = [\"thumb\", \"index\"]\n"
    "directions = [\"+x\", \"-x\", \"+y\", \"-y\", \"+z\", \"-z\"]\n";
const char* const kDirections =
    "kind = \"force_direction\"\n[[target]]\nthumb_direction = [1, 0, 1]\n"
    "[[target]]\nthumb_direction = [0, 1, 2]\nindex_direction = [-1, 0, 1]\n"
    "middle_direction = [0, 0, 1]\n[[target]]\nmiddle_direction = [0.3, 0.3, -1]\n";

const std::array kEveryKind{kOpening,     kNegative,       kBlind,  kSteadiness, kStep,
                            kRelease,     kReleaseOpen,    kSense,  kFatigue,    kIndividuation,
                            kComfortable, kOpeningMaximum, kMaxima, kDirections};

TEST(PatientPages, ShowTheForceOfTheChannelAndNothingOfItWhileItIsOff) {
  for (const char* text : kEveryKind) {
    Play play(parse(text));
    AtLeast frames(100);
    while (play.next()) {
      ++frames;
      const auto picture = play.picture();
      ASSERT_EQ(picture.force_shown, play.view().force().force_shown) << text;
      ASSERT_EQ(picture.force_N,
                play.view().force().force_shown ? play.view().force().actual_force_N : 0.0)
          << text;
      ASSERT_EQ(picture.line_shown, play.view().force().force_target_shown) << text;
      ASSERT_EQ(picture.target_N,
                play.view().force().force_target_shown ? play.view().force().target_force_N : 0.0)
          << text;
      ASSERT_FALSE(picture.headline.empty()) << text;
    }
  }
}

TEST(PatientPages, LookTheSameWhateverTheForceWhileItIsOff) {
  const std::array blind{std::string(kSense), std::string(kBlind),
                         "force_shown = false\n" + std::string(kRelease),
                         "force_shown = false\n" + std::string(kDirections),
                         "force_shown = false\n" + std::string(kComfortable)};
  for (const auto& text : blind) {
    Play weak(parse(text), 1, 0.2);
    Play strong(parse(text), 1, 1.7);
    int compared = 0;
    for (int frame = 0; weak.next() && strong.next(); ++frame) {
      if (weak.view().force().force_shown || frame % 50 != 0) continue;
      ++compared;
      ASSERT_TRUE(paint(weak.picture(), 180) == paint(strong.picture(), 180))
          << text << " at " << weak.view().task_time_s << " s";
    }
    EXPECT_GT(compared, 2) << text;
  }
}

TEST(PatientPages, TheAxisHoldsZeroAndAllTargetsAndStaysForTheTrial) {
  for (const char* text :
       {kOpening, kNegative, kSteadiness, kStep, kRelease, kSense, kFatigue, kIndividuation}) {
    Play play(parse(text), 1, 2.5);
    const ForceAxis first = (play.next(), play.picture().axis);
    EXPECT_LE(first.least_N, 0.0) << text;
    EXPECT_GE(first.most_N, 0.0) << text;
    AtLeast frames(100);
    while (play.next()) {
      ++frames;
      const auto picture = play.picture();
      ASSERT_EQ(picture.axis.least_N, first.least_N) << text;
      ASSERT_EQ(picture.axis.most_N, first.most_N) << text;
      ASSERT_GE(picture.target_N, first.least_N) << text;
      ASSERT_LE(picture.target_N, first.most_N) << text;
    }
  }
}

TEST(PatientPages, WaitsThatCannotBeForeseenAreNotSeenWhateverTheFileSays) {
  for (const char* text : {kStep, kRelease}) {
    const tasks::TaskSpec spec = parse(text);
    ASSERT_GT(spec.aim()->preview_s, 0.0);
    EXPECT_EQ(preview_target(spec, context()).ahead_s, 0.0);
    EXPECT_TRUE(preview_target(spec, context()).target_N.empty());
    // Two waits, one screen: until the shorter one ends nothing tells them apart.
    Play one(spec, 1);
    Play other(spec, 2);
    int compared = 0;
    for (int frame = 0; one.next() && other.next(); ++frame) {
      if (one.view().segment != other.view().segment) break;
      auto a = one.picture();
      auto b = other.picture();
      a.progress = b.progress = 0.0;  // of the whole trial, with all its waits
      if (frame % 40 != 0) continue;
      ++compared;
      ASSERT_TRUE(paint(a, 180) == paint(b, 180)) << text << one.view().task_time_s;
    }
    EXPECT_GT(compared, 2) << text;
  }
}

TEST(PatientPages, WithoutPreviewThePresentTargetIsAllThereIs) {
  Play play(parse(kOpening));
  ASSERT_TRUE(play.run_to([](const tasks::TaskView& view) { return view.task_time_s > 5.0; }));
  const auto now = play.picture();
  EXPECT_EQ(now.preview, nullptr);
  // The same force and target at another time look the same.
  auto later = now;
  later.task_time_s += 1.3;
  EXPECT_TRUE(paint(now) == paint(later));
}

TEST(PatientPages, EveryAskedDigitHasAPadAndItsDiscFillsTheRingOnTarget) {
  Play play(parse(kDirections), 1, 1.0);
  ASSERT_TRUE(play.run_to([](const tasks::TaskView& view) { return view.segment == 4; }));
  play.next();
  const auto picture = play.picture();
  EXPECT_EQ(picture.page, PatientPicture::Page::directions);
  for (const auto& digit : every(picture.digits)) {
    EXPECT_TRUE(digit.asked);
    EXPECT_TRUE(digit.on_target);
    const auto ring = mark_on_pad(digit.target_C, picture.digits_N);
    const auto disc = mark_on_pad(digit.force_C, picture.digits_N);
    EXPECT_DOUBLE_EQ(ring.x, disc.x);
    EXPECT_DOUBLE_EQ(ring.radius, disc.radius);
  }
}

TEST(PatientPages, AMarkStaysOnItsPadAndSaysPressingBySizeAndPullingByShape) {
  const auto rest = mark_on_pad(Vec3::Zero(), 5.0);
  EXPECT_WITHIN(rest.x, 0.0, 1e-12);
  EXPECT_WITHIN(rest.y, 0.0, 1e-12);
  EXPECT_GT(mark_on_pad({0, 0, 1}, 5.0).radius, rest.radius);
  EXPECT_FALSE(mark_on_pad({0, 0, -0.1}, 5.0).pulls) << "noise of a sensor";
  EXPECT_TRUE(mark_on_pad({0, 0, -1}, 5.0).pulls);
  EXPECT_GT(mark_on_pad({1, 0, 0}, 5.0).y, 0.0) << "x of the contact is up";
  EXPECT_GT(mark_on_pad({0, 1, 0}, 5.0).x, 0.0) << "y of the contact is right";
  for (const double force_N : {-100.0, 100.0}) {
    const auto far = mark_on_pad({force_N, force_N, force_N}, 5.0);
    EXPECT_LT(std::abs(far.x), 1.0);
    EXPECT_LT(std::abs(far.y), 1.0);
    EXPECT_LT(far.radius, 0.6);
  }
}

TEST(PatientPages, RestSaysWhatComesNext) {
  Play play(parse(kIndividuation));
  play.next();
  EXPECT_EQ(play.picture().headline, "Let your hand rest");
  EXPECT_EQ(play.picture().detail, "Next: press with the thumb only");
  Play maxima(parse(kMaxima));
  maxima.next();
  EXPECT_EQ(maxima.picture().headline, "Get ready");
  EXPECT_EQ(maxima.picture().detail, "Next: thumb, push up");
  Play sense(parse(kSense));
  ASSERT_TRUE(sense.run_to([](const tasks::TaskView& view) { return view.segment == 1; }));
  EXPECT_EQ(sense.picture().detail, "Next: the same force again");
}

TEST(PatientPages, LetGoAndMaximumStandOut) {
  Play release(parse(kRelease));
  ASSERT_TRUE(
      release.run_to([](const tasks::TaskView& view) { return view.phase == tasks::Phase::hold; }));
  EXPECT_FALSE(release.picture().urgent);
  ASSERT_TRUE(release.run_to([](const tasks::TaskView& view) { return view.cue == Cue::let_go; }));
  EXPECT_TRUE(release.picture().urgent);
  Play comfortable(parse(kComfortable));
  ASSERT_TRUE(
      comfortable.run_to([](const tasks::TaskView& view) { return view.cue == Cue::press; }));
  EXPECT_FALSE(comfortable.picture().urgent);
}

TEST(PatientPages, OfEveryKindAreKept) {
  const auto at = [](const char* text, const char* name, double task_time_s, double share = 0.8,
                     Hand hand = Hand::right) {
    Play play(parse(text), 1, share, hand);
    ASSERT_TRUE(play.run_to([&](const tasks::TaskView& v) { return v.task_time_s >= task_time_s; }))
        << name;
    auto picture = play.picture();
    if (picture.page == PatientPicture::Page::effort && picture.force_shown) picture.force_N = 9.0;
    EXPECT_FALSE(picture.detail.empty()) << name;
    keep(picture, name);
  };
  at(kOpening, "opening", 4.0, 0.95);
  at(kNegative, "negative", 5.0, 1.3);
  at(kBlind, "blind", 5.0);
  at(kSteadiness, "steadiness_rise", 1.5);
  at(kSteadiness, "steadiness_hold", 8.0, 1.0);
  at(kSteadiness, "steadiness_rest", 18.0);
  at(kStep, "step_wait", 0.8);
  at(kStep, "step_up", 3.4, 0.5);
  at(kRelease, "release_hold", 2.7, 1.0);
  at(kRelease, "release_let_go", 5.2);
  at(kReleaseOpen, "release_open", 5.2);
  at(("force_shown = false\n" + std::string(kRelease)).c_str(), "release_blind", 5.2);
  at(kSense, "sense_learn", 2.0, 1.0);
  at(kSense, "sense_pause", 6.0);
  at(kSense, "sense_again", 9.0);
  at(kFatigue, "fatigue", 10.0, 1.4);
  at(kIndividuation, "individuation_rest", 0.5);
  at(kIndividuation, "individuation_thumb", 3.5);
  at(kIndividuation, "individuation_index", 8.5, 1.0);
  at(kIndividuation, "individuation_middle_left", 13.5, 0.3, Hand::left);
  at(kComfortable, "comfortable", 2.0);
  at(kOpeningMaximum, "opening_maximum", 2.0);
  at(kMaxima, "maxima_ready", 0.5);
  at(kMaxima, "maxima_up", 2.0);
  at(kMaxima, "maxima_down", 9.0);
  at(kMaxima, "maxima_toward", 16.0);
  at(kMaxima, "maxima_away", 23.0);
  at(kMaxima, "maxima_press", 30.0);
  at(kMaxima, "maxima_pull", 37.0);
  at(kDirections, "direction_one", 3.0, 0.6);
  at(kDirections, "direction_all", 10.0, 0.9);
  at(kDirections, "direction_all_left", 10.0, 0.5, Hand::left);
  at(kDirections, "direction_pull", 17.0, 0.5);
}

}  // namespace
}  // namespace isograsp::gui::test::patient_pages_test
