// SPDX-License-Identifier: GPL-3.0-or-later
// What is special about a kind of task: one KindFacts each, made beside its spec in
// tasks/kinds/*/<kind>.cpp and listed in tasks/kinds/kinds.cpp. Everything that is not said here is
// the same for all kinds. Functions are asked while a task is read, prepared, scored or shown,
// never between the arrival of a frame and the published state; the plain words may be read there,
// too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "tasks/aim.hpp"
#include "tasks/carry_forces.hpp"
#include "tasks/difficulty.hpp"
#include "tasks/looks/look.hpp"
#include "tasks/object_targets.hpp"
#include "tasks/pace.hpp"

namespace isograsp {
class TomlReader;
}

namespace isograsp::tasks {

class KindSpec;
class Record;
class Task;
struct Segment;
struct TaskContext;
struct Waveform;

/// Headings under which people find tasks, in order.
enum class TaskGroup : std::uint8_t {
  rest_and_maximum,
  follow,
  hold_and_let_go,
  fingers_and_directions,
  object,
  two_hands,
  arm
};

/// Which measures of a task the report draws, in order, and which of them stand at a glance.
enum class Prominence : std::uint8_t { none, trend, key };
struct PlacedMeasure {
  std::string_view name;
  std::string_view channel;  ///< empty: any
  Prominence prominence;
};

/// What may limit a hand.
enum class Component : std::uint8_t {
  strength,
  opening,
  release,
  control,
  individuation,
  direction
};
/// A measure that shows a component: the mean over these channels.
struct ComponentMeasure {
  Component component;
  std::string_view measure;
  std::string_view channel;  ///< its end ("_opening" fits every digit); empty: all
  int rank = 0;              ///< the lowest that was measured counts
};

/// @pre of every function: the spec is one of this kind
struct KindFacts {
  std::string_view name;  ///< in task files: "force_tracking"
  TaskGroup group = TaskGroup::follow;
  /// Reads the keys that other kinds have not. Problems are reported to the reader.
  KindSpec (*read)(TomlReader& reader) = nullptr;

  /// Of what a task is made for: an apparatus of this kind (session/acquisition/apparatus.hpp);
  /// empty: a task without scene can be done with any.
  std::string_view apparatus = "platform";

  // What a task asks; nullptr, if nothing else is said: it has none.
  /// nullptr: as long as its segments.
  Duration (*duration)(const KindSpec&) = nullptr;
  /// Name of the scene; nullptr: a force task has no object.
  std::string (*scene)(const KindSpec&) = nullptr;
  /// Name of a file of postures (kinematics/postures.hpp): those that the arm is brought to, and
  /// the initial one.
  std::string (*postures)(const KindSpec&) = nullptr;
  /// Names of the markers that it cannot do without, as the rig calls them.
  std::vector<std::string> (*markers)(const KindSpec&) = nullptr;
  /// How force and target are shown and scaled.
  const Aim* (*aim)(const KindSpec&) = nullptr;
  /// The force that is to be as large as possible, or as is comfortable, where there is one.
  const ForceChannel* (*effort)(const KindSpec&) = nullptr;
  /// In units of the scale; nullptr: 0.
  double (*largest_level)(const KindSpec&) = nullptr;
  /// Those that the scale is about; nullptr: the one of the aim.
  std::vector<ForceChannel> (*channels)(const KindSpec&) = nullptr;
  /// Those whose maximum, or comfortable force, a trial measures; above rest, which has to be
  /// known.
  std::vector<ForceChannel> (*measured)(const KindSpec&, Scale scale) = nullptr;
  /// The shape of the target; its points may stand in a file beside that of the task.
  const Waveform* (*waveform)(const KindSpec&) = nullptr;
  /// Where the object is to be brought.
  std::vector<TargetPlace> (*targets)(const KindSpec&) = nullptr;
  PoseTolerance (*tolerance)(const KindSpec&) = nullptr;
  /// How heavy the object of its scene is made for two hands.
  HandsLoad (*hands_load)(const KindSpec&) = nullptr;
  /// How two hands that are points carry the object of its scene.
  HandsCarry (*hands_carry)(const KindSpec&) = nullptr;
  /// How the target of an object moves, seen in one degree of freedom.
  std::optional<AxisCourse> (*course)(const KindSpec&, double period_s) = nullptr;
  /// Makes a task easier or harder. False: it has nothing of that sort to multiply.
  bool (*multiply)(KindSpec&, Difficulty::Factor factor, double by) = nullptr;
  /// What training looks can clothe of it.
  Wardrobe wardrobe = Wardrobe::nothing;
  /// The column that it is about, where that is no force and no object; nullptr: none.
  std::string (*curve)(const KindSpec&) = nullptr;
  /// Efforts that it asks for; nullptr: 1, it goes on without a break.
  int (*repetitions)(const KindSpec&) = nullptr;

  // How it runs: one of the two. Both nullptr: it was recorded elsewhere, nobody can do it live.
  /// Levels times `unit` are newtons.
  std::vector<Segment> (*segments)(const KindSpec&, const Unit& unit, Pace& pace) = nullptr;
  /// Refused where the context lacks what the task needs.
  Result<std::unique_ptr<Task>> (*make)(const KindSpec&, const TaskContext& context) = nullptr;

  // What is measured. Pure: same signals, same numbers, bit for bit.
  std::vector<Measure> (*measures)(const KindSpec&, const Record& record) = nullptr;
  std::span<const PlacedMeasure> places = {};  ///< no research measure has one
  std::span<const ComponentMeasure> components = {};

  // What a trial stands for.
  bool rests = false;  ///< the hand relaxes: that is no effort, and the resting force is measured
  bool free = false;   ///< free handling: whole wherever a recording ends
  bool tires = false;  ///< on purpose, whatever its level: no comfortable effort
  bool all_directions = false;    ///< one maximum beside the other: the report draws a compass
  bool follows_curve = false;     ///< one force is on one moving target from beginning to end
  bool unforeseen_waits = false;  ///< before what is asked: the screen must not tell them
  bool path_drawn = false;        ///< the report draws the object's path past its targets
  bool unseen_goes_on = false;    ///< what cameras do not see for a while stops nothing
  bool research = false;          ///< all it measures is of research: no report of a patient has it
  bool carries = false;           ///< the object is taken, brought to a place and let go there
};

/// Of a task that was not read: it asks nothing and measures nothing.
inline constexpr KindFacts kNoKind{};

/// The table: every kind that this program knows, in the order of an assessment.
[[nodiscard]] std::span<const KindFacts* const> all_kinds() noexcept;
/// Place in the table. @pre it stands there
[[nodiscard]] std::size_t order_of(const KindFacts& kind) noexcept;

}  // namespace isograsp::tasks
