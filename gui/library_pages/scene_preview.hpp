// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene will be: its object with the fingers or hands that press it, what their pads cover
// of it, its plan in words. Knows no widget.
#pragma once

#include <string>

#include "grasp_model/scene.hpp"
#include "gui/library_pages/library_preview.hpp"

namespace isograsp::gui {

/// The object in the plane of x and y, with the contacts of one hand.
[[nodiscard]] LibraryPreview::Sketch sketch_of(const Scene& scene);

/// Of a text that is a scene, of one hand or of two; empty for any other. Measures what a scene of
/// one hand costs, so it takes some milliseconds; any thread.
[[nodiscard]] LibraryPreview preview_of_scene(const std::string& text, const std::string& path);

/// What the pad of a contact covers. @pre contact.pad, of a scene that was read
[[nodiscard]] LibraryPreview::Patch patch_of(const Contact& contact, const Scene& object,
                                             const QString& title);

}  // namespace isograsp::gui
