// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/recorded_target.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/butterworth.hpp"
#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "tasks/record.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kCourseCutoff_Hz = 2.0;  // above what a hand follows, below tremor
constexpr double kPointsPerSecond = 10;   // five times that
constexpr double kLeast_m = 0.005;        // smaller ones are unintended: half a shipped tolerance
constexpr double kLeast_rad = 5.0 * std::numbers::pi / 180.0;
constexpr double kLeast_N = 0.5;     // several steps of a coarse sensor
constexpr double kStillness = 0.02;  // of the range
constexpr double kKeptStill_s = 0.5;
constexpr double kShortest_s = 1.0;

/// One thing that moved: a degree of freedom or the force.
struct Course {
  std::string dof;   ///< empty: the force
  std::string unit;  ///< of the keys
  double least = 0.0;
  double most = 0.0;
  std::vector<double> values;  ///< on the grid, in `unit`
};

/// Angles without jumps of a whole turn.
void unwrap_course(std::vector<double>& angle_rad) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (std::size_t k = 1; k < angle_rad.size(); ++k)
    angle_rad[k] -= kTurn * std::round((angle_rad[k] - angle_rad[k - 1]) / kTurn);
}

/// Turn about axis 0, 1 or 2 of the world, as far as the object turned about that one.
std::vector<double> turns(const Section& rows, std::size_t axis) {
  const auto w = rows.values(columns::actual_attitude[0]);
  auto turn = rows.values(columns::actual_attitude[1 + axis]);
  for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = 2.0 * std::atan2(turn[k], w[k]);
  unwrap_course(turn);
  return turn;
}

class Recording {
 public:
  Recording(const TaskSpec& spec, const Signals& signals, const RecordedTarget& wanted)
      : spec_(spec), signals_(signals), wanted_(wanted), record_(signals) {}

  Result<std::string> text() {
    if (!(wanted_.slower > 0.0))
      return refused("the time cannot be stretched by %1"_text(shortest(wanted_.slower)),
                     "give a number above 0"_text)
          .about(spec_.name);
    if (auto found = wanted_.force || spec_.scene().empty() ? find_force() : find_path(); !found)
      return found.error();
    cut_stillness();
    if (duration_s() < kShortest_s)
      return refused("the movement lasted less than a second"_text, "record it again, slower"_text)
          .about(spec_.name);
    std::string text = spec_.scene().empty() || wanted_.force ? force_task() : pose_task();
    if (auto good = parse_task(text, wanted_.name); !good) return good.error();
    return text;
  }

 private:
  /// Freed of tremor, on the grid.
  [[nodiscard]] std::vector<double> smooth(const Section& rows, const std::vector<double>& values) {
    const statistics::UniformSamples grid = statistics::on_uniform_grid(rows.t_s, values);
    step_s_ = grid.step_s;
    return filtered_zero_phase(butterworth2(1.0 / grid.step_s, kCourseCutoff_Hz), grid.values);
  }
  void add(std::string dof, std::string unit, double per_unit, std::vector<double> values) {
    for (double& value : values) value /= per_unit;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    courses_.push_back({std::move(dof), std::move(unit), *least, *most, std::move(values)});
  }
  static double range_of(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *most - *least;
  }
  [[nodiscard]] bool enough(const Section& rows) const {
    return rows.rows.size() >= 2 && rows.t_s.back() - rows.t_s.front() > kShortest_s;
  }

  Result<void> find_force() {
    const Section rows =
        record_.select({Phase::active, Phase::transport, Phase::hold}, {columns::actual_force_N});
    if (!enough(rows))
      return refused("it holds no force"_text, "record one"_text).about(spec_.name);
    auto force_N = smooth(rows, rows.values(columns::actual_force_N));
    if (range_of(force_N) < kLeast_N)
      return refused("the force changed by less than 0.5 N"_text, "press while it is recorded"_text)
          .about(spec_.name);
    add("", "N", 1.0, std::move(force_N));
    return {};
  }

  Result<void> find_path() {
    auto pose = names_of(columns::actual_position);
    for (const Column& component : columns::actual_attitude) pose.emplace_back(component);
    const Section rows = record_.select({Phase::active, Phase::transport, Phase::hold}, pose);
    if (!enough(rows))
      return refused("it holds no path of an object"_text, "record one"_text).about(spec_.name);
    int axes_turned = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name(columns::kXyz[axis]);
      auto path_m = smooth(rows, rows.values(columns::actual_position[axis]));
      if (range_of(path_m) > kLeast_m) add(name, "m", 1.0, std::move(path_m));
      auto turn_rad = smooth(rows, turns(rows, axis));
      if (range_of(turn_rad) < kLeast_rad) continue;
      ++axes_turned;
      add("r" + name, "deg", std::numbers::pi / 180.0, std::move(turn_rad));
    }
    if (courses_.empty())
      return refused("the object moved by less than 5 mm and 5 degrees"_text,
                     "move it while it is recorded"_text)
          .about(spec_.name);
    if (axes_turned > 1)
      return refused("the object turned about more than one axis"_text,
                     "choose a scene in which it can turn about one alone"_text)
          .about(spec_.name);
    return {};
  }

  /// Rows from first_ to last_ stay: half a second before anything moves until half a second after.
  void cut_stillness() {
    const std::size_t rows = courses_.front().values.size();
    const auto moves = [&](std::size_t k, std::size_t from) {
      return std::any_of(courses_.begin(), courses_.end(), [&](const Course& course) {
        return std::abs(course.values[k] - course.values[from]) >
               kStillness * (course.most - course.least);
      });
    };
    first_ = 0;
    last_ = rows - 1;
    while (first_ < last_ && !moves(first_, 0)) ++first_;
    while (last_ > first_ && !moves(last_, rows - 1)) --last_;
    const auto kept = static_cast<std::size_t>(std::lround(kKeptStill_s / step_s_));
    first_ -= std::min(first_, kept);
    last_ = std::min(rows - 1, last_ + kept);
  }
  [[nodiscard]] double duration_s() const {
    return wanted_.slower * step_s_ * static_cast<double>(last_ - first_);
  }
  /// For people: five significant digits.
  static std::string in_short(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
  }

  /// Points between least and most as numbers from 0 to 1.
  [[nodiscard]] std::string points(const Course& course, const std::string& table) const {
    const double stride_s = 1.0 / kPointsPerSecond;
    std::string times;
    std::string values;
    for (double t_s = 0.0; t_s <= duration_s(); t_s += stride_s) {
      const double row = static_cast<double>(first_) + t_s / (wanted_.slower * step_s_);
      const auto before = std::min(static_cast<std::size_t>(row), last_);
      const auto after = std::min(before + 1, last_);
      const double value =
          std::lerp(course.values[before], course.values[after], row - static_cast<double>(before));
      const double share = (value - course.least) / (course.most - course.least);
      char text[32];
      std::snprintf(text, sizeof text, "%.1f", t_s);
      times += (times.empty() ? "" : ", ") + std::string(text);
      std::snprintf(text, sizeof text, "%.4f", std::clamp(share, 0.0, 1.0));
      values += (values.empty() ? "" : ", ") + std::string(text);
    }
    return "waveform = \"csv\"\ncsv = \"recorded by doing\"\n[" + table + "]\nt_s = [" + times +
           "]\ntarget = [" + values + "]\n";
  }

  [[nodiscard]] std::string head(const char* kind, const char* instruction) const {
    std::string quoted;
    for (const char c : wanted_.name)
      if (static_cast<unsigned char>(c) >= ' ' && c != '"' && c != '\\') quoted += c;
    return "# Recorded by doing: '" + spec_.name + "'.\nformat = \"isograsp-task-1\"\nname = \"" +
           quoted + "\"\ninstruction = \"" + instruction + "\"\nversion = 1\nkind = \"" + kind +
           "\"\nlead_in_s = 3\nduration_s = " + in_short(duration_s()) + "\n";
  }

  [[nodiscard]] std::string force_task() const {
    const Course& force = courses_.front();
    Aim aim;
    if (const Aim* own = spec_.aim())
      aim = *own;
    else if (const ForceChannel* effort = spec_.effort())
      aim.channel = *effort;
    return head("force_tracking", "Press so that your mark stays on the moving target.") +
           "channel = \"" + name_of(aim.channel) +
           "\"\nscale = \"newton\"\nleast_N = " + in_short(force.least) +
           "\nmost_N = " + in_short(force.most) +
           "\nband_fraction = " + format_number(aim.band_fraction) + "\npreview_s = 3\n" +
           points(force, "csv_data");
  }

  [[nodiscard]] std::string pose_task() const {
    std::string text = head("pose_tracking", "Keep the object on its outline.") + "scene = \"" +
                       spec_.scene() + "\"\n";
    for (const Course& course : courses_)
      text += "\n[[axis]]\ndof = \"" + course.dof + "\"\nleast_" + course.unit + " = " +
              in_short(course.least) + "\nmost_" + course.unit + " = " + in_short(course.most) +
              "\n" + points(course, "axis.csv_data");
    return text;
  }

  const TaskSpec& spec_;
  const Signals& signals_;
  const RecordedTarget& wanted_;
  Record record_;
  std::vector<Course> courses_;
  double step_s_ = 0.0;
  std::size_t first_ = 0;
  std::size_t last_ = 0;
};

}  // namespace

Result<std::string> target_by_doing(const TaskSpec& spec, const Signals& signals,
                                    const RecordedTarget& wanted) {
  return Recording(spec, signals, wanted).text();
}

}  // namespace isograsp::tasks
