// SPDX-License-Identifier: GPL-3.0-or-later
// A file of postures while it is edited: its text becomes postures, changed postures become its
// text again. The comments above its first key stay; others go with the text that they stood in.
#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "kinematics/postures.hpp"

namespace isograsp::gui {

struct PostureFile {
  std::string head;  ///< comments, with their line breaks
  Postures postures;
};

/// Errors: those of parse_postures().
[[nodiscard]] Result<PostureFile> read_posture_file(std::string_view text, const std::string& path);
/// read_posture_file() of it gives the same, bit for bit.
[[nodiscard]] std::string posture_file_text(const PostureFile& file);

/// "screw", "screw 2", "screw 3" …: the first that no posture of the file has.
[[nodiscard]] std::string free_posture_name(const Postures& postures, const std::string& wanted);

/// `posture` behind the one at `index`, under the first free name.
[[nodiscard]] Postures with_added(Postures postures, std::size_t index, Posture posture);
/// Errors: the name is empty, or another posture's.
[[nodiscard]] Result<Postures> with_renamed(Postures postures, std::size_t index,
                                            const std::string& name);
/// Errors: it is the initial one, from which all others are seen.
[[nodiscard]] Result<Postures> without(Postures postures, std::size_t index);

}  // namespace isograsp::gui
