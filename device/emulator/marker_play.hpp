// SPDX-License-Identifier: GPL-3.0-or-later
// What emulated cameras show: the rows of a recording, one picture after the other, with faults on
// purpose. No socket and no real clock. The same seed gives the same pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/result.hpp"
#include "core/spatial.hpp"
#include "device/emulator/marker_fault.hpp"

namespace isograsp {

struct MarkerPlay {
  std::vector<std::string> labels;
  std::vector<double> t_s;  ///< from 0, increasing
  std::vector<Vec3> p_W;    ///< row by row [m]; not seen: NaN
  double period_s = 0.01;
  bool repeat = false;

  /// Reads a recording of markers of any format. Errors name the file.
  [[nodiscard]] static Result<MarkerPlay> read(const std::string& path);
};

/// What was done.
struct MarkerSceneCounters {
  std::uint64_t pictures = 0;  ///< made
  std::uint64_t dropped = 0;   ///< lost by a fault
  std::uint64_t silent = 0;    ///< not sent in a silence
  std::uint64_t restarts = 0;  ///< of the numbers
};

/// One picture, with all faults in it.
struct MarkerPicture {
  std::uint32_t frame = 0;    ///< from 1 on
  double stamp_s = 0.0;       ///< on the clock of the cameras
  double play_s = 0.0;        ///< since the play began
  bool sent = true;           ///< false: nobody gets it
  std::span<const Vec3> p_W;  ///< until the next picture
};

class MarkerScene {
 public:
  /// Errors: a fault is of a marker that the play does not have.
  [[nodiscard]] static Result<MarkerScene> make(MarkerPlay play,
                                                std::vector<EmulatedMarkerFault> faults,
                                                std::uint64_t seed);

  /// When the next picture is taken, since the play began; nothing: the play is over.
  [[nodiscard]] std::optional<double> next_s() const noexcept;
  /// @pre next_s()
  MarkerPicture take();
  /// As the cameras would call them now.
  [[nodiscard]] std::vector<std::string> labels(double play_s) const;
  [[nodiscard]] double rate_Hz() const noexcept { return 1.0 / play_.period_s; }
  [[nodiscard]] const std::vector<EmulatedMarkerFault>& faults() const noexcept { return faults_; }
  [[nodiscard]] const MarkerSceneCounters& counters() const noexcept { return counters_; }

 private:
  MarkerScene(MarkerPlay play, std::vector<EmulatedMarkerFault> faults, std::uint64_t seed);
  [[nodiscard]] std::size_t place_of(const std::string& label) const noexcept;
  void apply(const EmulatedMarkerFault& fault);

  MarkerPlay play_;
  std::vector<EmulatedMarkerFault> faults_;
  Random random_;
  std::vector<Vec3> shown_;
  std::vector<Vec3> frozen_;  ///< of each fault: where its marker was last
  std::size_t row_ = 0;
  double round_s_ = 0.0;       ///< when this round of the play began
  double count_from_s_ = 0.0;  ///< when the cameras' numbers and times began
  std::uint32_t last_frame_ = 0;
  std::vector<bool> struck_;  ///< restarts happen once
  MarkerSceneCounters counters_;
};

}  // namespace isograsp
