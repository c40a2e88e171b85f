// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/cameras/ only. What a client and Qualisys Track Manager say to each other until
// frames come, and when they do not. Pure: no socket and no clock of its own; real-time safe.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/time.hpp"
#include "device/markers/qtm_rt_codec.hpp"

namespace isograsp {

class QtmConversation {
 public:
  enum class Failure : std::uint8_t {
    none,
    no_answer,  ///< nothing came in time
    not_qtm,    ///< what came is not the protocol
    version,    ///< it speaks no version of the protocol that we do
    no_labels,  ///< it has no labelled markers
    no_frames   ///< it sends no frames
  };

  QtmConversation();
  /// The connection stands.
  void begin(Timestamp now) noexcept;
  /// Frames have stayed away: labels and frames are asked for again.
  void ask_again(Timestamp now) noexcept;
  void hear(QtmRtStream::Step step, std::string_view message, Timestamp now) noexcept;
  /// Time has passed.
  void look(Timestamp now) noexcept;
  /// The command to send now; empty: none. Each is given once.
  [[nodiscard]] std::string_view say() noexcept;

  [[nodiscard]] bool streaming() const noexcept { return stage_ == Stage::streaming; }
  [[nodiscard]] Failure failure() const noexcept { return failure_; }
  /// What QTM said last when it refused something; at most 200 bytes.
  [[nodiscard]] const std::string& refusal() const noexcept { return refusal_; }
  /// When look() will have something to say.
  [[nodiscard]] Timestamp due() const noexcept { return due_; }

 private:
  enum class Stage : std::uint8_t { greeting, version, parameters, frames, streaming };
  void enter(Stage stage, std::size_t form, Timestamp now) noexcept;
  void refused_here(Timestamp now) noexcept;
  void fail(Failure failure) noexcept;

  Stage stage_ = Stage::greeting;
  std::size_t form_ = 0;  ///< which of the ways to say it
  bool unsaid_ = false;
  Failure failure_ = Failure::none;
  Timestamp due_ = Timestamp::max();
  std::string refusal_;
};

}  // namespace isograsp
