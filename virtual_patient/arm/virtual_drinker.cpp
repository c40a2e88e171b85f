// SPDX-License-Identifier: GPL-3.0-or-later
// Five phases, each a way between two places in one movement of least jerk or in several, one after
// the other. The trunk leans along with the way to the glass. Elbow and wrist follow from hand and
// shoulder: two links whose plane hangs down.
#include "virtual_patient/arm/virtual_drinker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "virtual_patient/force_skill.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

namespace {

// Places of a person of average size at a table, whose front edge is some 0.4 m from the glass
// (docs/virtual_patient.md). [m]
const Vec3 kHandAtRest(0.16, 0.03, 0.30);
const Vec3 kShoulder(0.18, 0.38, 0.36);
const Vec3 kBreastbone(0.0, 0.32, 0.27);
const Vec3 kForehead(0.0, 0.66, 0.30);
const Vec3 kGlassOnTable(0.04, 0.10, -0.10);
const Vec3 kMouthFromForehead(0.0, -0.11, -0.04);
const Vec3 kHandFromGlass(0.05, -0.03, 0.03);

/// What a healthy person of kHealthyTempo_s takes for each phase [s].
constexpr double kHealthyTempo_s = 0.9;
namespace drink {
enum Phase : std::uint8_t { reaching, forward, drinking, back, returning, phases };
enum Marker : std::uint8_t { hand, wrist, elbow, shoulder, trunk, face, glass, markers };
}  // namespace drink
using Marks = std::array<Vec3, drink::markers>;
constexpr std::array<double, drink::phases> kPhase_s{1.0, 1.1, 1.2, 1.2, 1.0};
constexpr double kGrasp_s = 0.15;  ///< at the glass, before it is lifted and after it is put down
/// One piece more for each so much that a first movement falls short of the way.
constexpr double kShortOfPiece = 0.1;
constexpr double kOverlap = 0.9;  ///< a piece begins when so much of the one before is over
/// How far they lean who do not help out with the trunk, and how much more for each share of it.
constexpr double kLeast_m = 0.025;
constexpr double kLeanOfShare_m = 0.30;
constexpr double kStraight = 0.995;   ///< of the length of the arm: nobody stretches it further
constexpr double kTremorArm_m = 0.3;  ///< lever of the tremor
constexpr double kWholeTurn_rad = 6.283185307179586;

constexpr std::array<std::string_view, drink::markers> kDrinkerLabels{
    "HAND", "WRIST", "ELBOW", "SHOULDER", "TRUNK", "FACE", "GLASS"};

/// How far a way of `pieces` movements has come at the share u of its time.
double in_pieces(double u, int pieces) noexcept {
  const double each = 1.0 / (1.0 + kOverlap * (pieces - 1));
  double way = 0.0;
  for (int k = 0; k < pieces; ++k) way += least_jerk((u - k * kOverlap * each) / each);
  return way / pieces;
}

}  // namespace

struct VirtualDrinker::Body {
  Body(const ArmTraits& today, std::uint64_t seed, Hand which)
      : person(today),
        whose(which),
        attention(seed, 221),
        muscles(seed, 222),
        cameras(seed, 223),
        size((today.forearm_m + today.upper_arm_m) /
             (ArmTraits{}.forearm_m + ArmTraits{}.upper_arm_m)) {
    for (const std::string_view label : kDrinkerLabels) labels.emplace_back(label);
    tremor_phase_rad = kWholeTurn_rad * muscles.uniform();
  }

  void begin(double t_s) noexcept;
  [[nodiscard]] Marks at(double t_s) const noexcept;
  void place_arm(Marks& p) const noexcept;
  [[nodiscard]] bool lost(std::size_t marker, double dt_s) noexcept;

  ArmTraits person;
  Hand whose;
  Random attention, muscles, cameras;
  double size;
  std::vector<std::string> labels;

  bool asked = false;  ///< in the last picture
  bool drinks = false;
  std::array<double, drink::phases + 1>
      begins_s{};  ///< of each phase, and when the hand rests again
  std::array<int, drink::phases> pieces{};
  double lean_m = 0.0;
  double tremor_phase_rad = 0.0;
  std::array<double, drink::markers> lost_s{};
  double latest_s = 0.0;
  bool begun = false;
};

/// Plans one drink from the time at which it was asked for.
void VirtualDrinker::Body::begin(double t_s) noexcept {
  drinks = true;
  begins_s[drink::reaching] =
      t_s + person.visual_delay_s +
      person.reaction_s * (1.0 + person.reaction_cv * std::abs(attention.gaussian()));
  const double tempo = person.movement_s / kHealthyTempo_s;
  const int whole = 1 + static_cast<int>(std::lround((1.0 - person.first_gain) / kShortOfPiece));
  for (std::size_t phase = 0; phase < drink::phases; ++phase) {
    const double varied = std::max(0.5, 1.0 + person.movement_cv * muscles.gaussian());
    // A sip takes its time whoever drinks; the arm is slow, not the mouth.
    const double share = phase == drink::drinking ? std::sqrt(tempo) : tempo;
    const double waits_s = phase == drink::reaching || phase == drink::back ? kGrasp_s : 0.0;
    begins_s[phase + 1] = begins_s[phase] + kPhase_s[phase] * share * varied + waits_s;
    pieces[phase] = whole;
  }
  lean_m = (kLeast_m + kLeanOfShare_m * person.trunk_share) *
           std::max(0.5, 1.0 + person.amplitude_cv * muscles.gaussian());
}

Marks VirtualDrinker::Body::at(double t_s) const noexcept {
  std::array<double, drink::phases> way{};
  for (std::size_t phase = 0; phase < drink::phases && drinks; ++phase) {
    const double waits_s = phase == drink::reaching || phase == drink::back ? kGrasp_s : 0.0;
    const double lasts_s = begins_s[phase + 1] - begins_s[phase] - waits_s;
    way[phase] = in_pieces(std::clamp((t_s - begins_s[phase]) / lasts_s, 0.0, 1.0), pieces[phase]);
  }
  const double lean =
      size * lean_m *
      (way[drink::reaching] - way[drink::forward] + way[drink::back] - way[drink::returning]);
  const Vec3 leant = Vec3(0.0, -0.15 * lean, -lean);
  Marks p;
  p[drink::shoulder] = size * kShoulder + leant;
  p[drink::trunk] = size * kBreastbone + leant;
  p[drink::face] = size * kForehead + leant;
  const Vec3 rest = size * kHandAtRest;
  const Vec3 at_glass = kGlassOnTable + kHandFromGlass;
  const Vec3 at_mouth = size * (kForehead + kMouthFromForehead) + kHandFromGlass;
  p[drink::hand] = rest + (way[drink::reaching] - way[drink::returning]) * (at_glass - rest) +
                   (way[drink::forward] - way[drink::back]) * (at_mouth - at_glass);
  const bool carried =
      drinks && t_s >= begins_s[drink::forward] && t_s < begins_s[drink::returning];
  p[drink::glass] = carried ? Vec3(p[drink::hand] - kHandFromGlass) : kGlassOnTable;
  place_arm(p);
  return p;
}

/// Elbow and wrist between shoulder and hand. Where the hand is too far the shoulder comes along.
void VirtualDrinker::Body::place_arm(Marks& p) const noexcept {
  const double upper_m = person.upper_arm_m;
  const double lower_m = person.forearm_m + person.palm_m;
  Vec3 along = p[drink::hand] - p[drink::shoulder];
  const double too_far_m = along.norm() - kStraight * (upper_m + lower_m);
  if (too_far_m > 0.0) p[drink::shoulder] += too_far_m * along.normalized();
  along = p[drink::hand] - p[drink::shoulder];
  const double reach_m = along.norm();
  along /= reach_m;
  const double to_foot_m =
      (upper_m * upper_m - lower_m * lower_m + reach_m * reach_m) / (2.0 * reach_m);
  const Vec3 hangs(0.35, -1.0, 0.0);
  const Vec3 aside = (hangs - hangs.dot(along) * along).normalized();
  p[drink::elbow] = p[drink::shoulder] + to_foot_m * along +
                    std::sqrt(std::max(0.0, upper_m * upper_m - to_foot_m * to_foot_m)) * aside;
  p[drink::wrist] =
      p[drink::elbow] + person.forearm_m / lower_m * (p[drink::hand] - p[drink::elbow]);
}

bool VirtualDrinker::Body::lost(std::size_t marker, double dt_s) noexcept {
  const double draw = cameras.uniform();
  if (lost_s[marker] > 0.0)
    lost_s[marker] -= dt_s;
  else if (draw < person.loss_per_s * dt_s)
    lost_s[marker] = person.loss_s;
  return lost_s[marker] > 0.0;
}

VirtualDrinker::VirtualDrinker(const ArmTraits& traits, std::uint64_t seed, Hand hand,
                               std::optional<std::uint64_t> day)
    : body_(day ? std::make_unique<Body>(arm_on_day(drawn(traits, seed), day_seed(seed, *day)),
                                         day_seed(seed, *day), hand)
                : std::make_unique<Body>(drawn(traits, seed), seed, hand)) {}

VirtualDrinker::~VirtualDrinker() = default;

std::span<const std::string> VirtualDrinker::labels() const noexcept {
  return body_->labels;
}

std::span<const std::string_view> VirtualDrinker::names() noexcept {
  return kDrinkerLabels;
}

void VirtualDrinker::see(const Stimulus& stimulus) noexcept {
  const bool asks = stimulus.cue == Cue::move && !stimulus.progress.getting_ready;
  if (asks && !body_->asked && (!body_->drinks || body_->latest_s >= body_->begins_s.back()))
    body_->begin(body_->latest_s);
  body_->asked = asks;
}

void VirtualDrinker::markers(double t_s, std::span<Vec3> p_W) noexcept {
  Body& body = *body_;
  const double dt_s = body.begun ? std::max(0.0, t_s - body.latest_s) : 0.0;
  if (body.begun && t_s < body.latest_s) body.drinks = body.asked = false;  // another record
  body.begun = true;
  body.latest_s = t_s;
  body.tremor_phase_rad = std::fmod(
      body.tremor_phase_rad + kWholeTurn_rad * body.person.tremor_Hz * dt_s, kWholeTurn_rad);
  const auto p = body.at(t_s);
  const double tremor_m = kTremorArm_m * body.person.tremor_rad * std::sin(body.tremor_phase_rad);
  for (std::size_t m = 0; m < drink::markers; ++m) {
    const double x = body.cameras.gaussian(), y = body.cameras.gaussian(),
                 z = body.cameras.gaussian();
    Vec3 seen = p[m] + body.person.camera_m * Vec3(x, y, z);
    // Whoever moves trembles; a hand that lies on the table does not.
    const bool moves = body.drinks && t_s >= body.begins_s.front() && t_s < body.begins_s.back();
    if (moves && (m == drink::hand || m == drink::wrist)) seen.y() += tremor_m;
    if (body.whose == Hand::left) seen.x() = -seen.x();
    p_W[m] = body.lost(m, dt_s) ? Vec3::Constant(std::nan("")) : seen;
  }
}

}  // namespace isograsp::virtual_patient
