// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp simulate, scenes that two hands press with measured forces (coupling "force"), and those
// without an object ("none").
#include <limits>
#include <optional>
#include <vector>

#include "app/bimanual/hand_forces.hpp"
#include "app/hands_simulation.hpp"
#include "app/simulation/trajectory.hpp"
#include "bimanual/read_hands.hpp"
#include "hand/stale.hpp"

namespace isograsp::app {

namespace {

using bimanual::HandContacts;
using bimanual::HandWrenches;
using bimanual::kSides;
using bimanual::PressedByHands;
using bimanual::PressedWrench;
using bimanual::Side;

/// The contacts of one hand, and the forces that load them.
class PressingHand {
 public:
  static Result<PressingHand> open(const std::string& path, Side side,
                                   const HandContacts& contacts) {
    PressingHand hand(contacts);
    for (const Contact& contact : contacts.contacts) hand.used_[index_of(contact.finger)] = true;
    if (contacts.contacts.empty()) return hand;  // it has no part
    auto forces = HandForcesReader::open(
        path, side, contacts.whole ? HandNeeds{.push = true} : HandNeeds{.fingers = hand.used_});
    if (!forces) return forces.error();
    hand.forces_ = std::move(*forces);
    return hand;
  }

  /// False at the end; of a hand without contacts never.
  Result<bool> next() { return forces_ ? forces_->next(row_) : Result<bool>(true); }
  /// The wrenches of the row read last for a hold of that length.
  StaleRule::Verdict wrenches(double hold_s, FingerWrenches& wrench_C) {
    wrench_C = {};
    if (!forces_) return StaleRule::Verdict::fresh;
    std::array<bool, kFingerCount> present = row_.fingers.present;
    if (!contacts_.whole) {
      wrench_C = row_.fingers.wrench_C;
    } else {
      present = {row_.push_W.has_value()};
      if (row_.push_W) wrench_C = bimanual::of_whole_hand(contacts_, *row_.push_W);
    }
    return stale_.apply(wrench_C, present, used_, hold_s);
  }

 private:
  explicit PressingHand(const HandContacts& contacts) : contacts_(contacts) {}

  HandContacts contacts_;
  std::array<bool, kFingerCount> used_{};
  std::optional<HandForcesReader> forces_;
  HandForcesRow row_;
  StaleRule stale_;
};

/// "left_contact" of a whole hand, "left_thumb_contact" of a finger.
std::vector<std::string> contact_columns(const bimanual::HandsScene& scene) {
  std::vector<std::string> names;
  for (std::size_t side = 0; side < kSides; ++side)
    for (const Contact& contact : scene.contacts[side].contacts)
      names.push_back(
          prefix_of(static_cast<Side>(side)) +
          (scene.contacts[side].whole ? "" : std::string(name_of(contact.finger)) + "_") +
          "contact");
  return names;
}

/// In the order of these columns.
class Touching {
 public:
  explicit Touching(const bimanual::HandsScene& scene) : scene_(scene) {}
  std::span<const bool> of(const PressedWrench& wrench) {
    std::size_t count = 0;
    for (std::size_t side = 0; side < kSides; ++side)
      for (const Contact& contact : scene_.contacts[side].contacts)
        touching_[count++] = wrench.hand[side].contact[index_of(contact.finger)];
    return {touching_.data(), count};
  }

 private:
  const bimanual::HandsScene& scene_;
  std::array<bool, kSides * kFingerCount> touching_{};
};

}  // namespace

Result<void> simulate_pressed(const bimanual::HandsScene& scene, const HandsSimulation& options) {
  const auto grid = read_time_grid([&] { return open_table(options.forces); });
  if (!grid) return grid.error();
  const auto pressed = PressedByHands::compile(scene.object, scene.contacts, grid->hold_s);
  if (!pressed) return pressed.error();
  auto left = PressingHand::open(options.forces, Side::left, scene.contacts[0]);
  if (!left) return left.error();
  auto right = PressingHand::open(options.forces, Side::right, scene.contacts[1]);
  if (!right) return right.error();
  const std::array<PressingHand*, kSides> hands{&*left, &*right};
  const auto opened = open_table(options.forces);  // one row ahead: a hold ends with the next row
  if (!opened) return opened.error();
  TableReader& times = **opened;
  const std::size_t time = *times.find("t_s");
  auto trajectory = TrajectoryWriter::create(options.out, contact_columns(scene));
  if (!trajectory) return trajectory.error();
  Touching touching(scene);
  bimanual::PressedState state = pressed->initial_state();
  PressedWrench wrench;
  HoldCount count;
  double t_s = 0.0, next_t_s = 0.0, hold_s = grid->hold_s;
  if (const auto first = times.next(time, next_t_s); !first) return first.error();
  for (bool more = true; more;) {
    t_s = next_t_s;
    const auto ahead = times.next(time, next_t_s);
    if (!ahead) return ahead.error();
    more = *ahead;
    // The last row holds as long as the row before it.
    if (more && !grid->regular) hold_s = next_t_s - t_s;
    HandWrenches wrench_C;
    bool frozen = false;
    for (std::size_t side = 0; side < kSides; ++side) {
      if (const auto read = hands[side]->next(); !read) return read.error();
      frozen =
          hands[side]->wrenches(hold_s, wrench_C[side]) == StaleRule::Verdict::frozen || frozen;
    }
    if (!frozen) wrench = pressed->grasp(wrench_C, state);
    trajectory->add(t_s, state.object, wrench.both.F_O_W, touching.of(wrench));
    ++count.all;
    if (frozen)
      ++count.frozen;
    else
      pressed->move(wrench, hold_s, state);
    if (state.object.tolerance_exceeded && !frozen) ++count.inexact;
    if (!more) trajectory->add(t_s + hold_s, state.object, wrench.both.F_O_W, touching.of(wrench));
  }
  if (const auto done = trajectory->commit(); !done) return done.error();
  count.print_notes();
  return {};
}

Result<void> simulate_uncoupled(const HandsSimulation& options) {
  const auto grid = read_time_grid([&] { return open_table(options.forces); });
  if (!grid) return grid.error();
  auto left = HandForcesReader::open(options.forces, Side::left, {.push = true});
  if (!left) return left.error();
  auto right = HandForcesReader::open(options.forces, Side::right, {.push = true});
  if (!right) return right.error();
  const std::array<HandForcesReader*, kSides> hands{&*left, &*right};
  std::vector<std::string> columns{"t_s"};
  for (const Side side : {Side::left, Side::right}) columns.push_back(prefix_of(side) + "force_N");
  for (const Side side : {Side::left, Side::right})
    add_three(columns, prefix_of(side) + "push_", "_N");
  auto out = NumberRows::create(options.out, columns);
  if (!out) return out.error();
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  for (;;) {
    std::array<HandForcesRow, kSides> rows;
    for (std::size_t side = 0; side < kSides; ++side) {
      const auto more = hands[side]->next(rows[side]);
      if (!more) return more.error();
      if (!*more) return out->commit();
    }
    out->put(rows.front().t_s);
    for (const HandForcesRow& row : rows)
      out->put(row.push_W ? row.push_W->force.norm() : kUnknown);
    for (const HandForcesRow& row : rows)
      out->put(row.push_W ? row.push_W->force : Vec3(Vec3::Constant(kUnknown)));
    out->end();
  }
}

}  // namespace isograsp::app
