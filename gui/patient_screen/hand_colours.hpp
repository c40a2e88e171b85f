// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/patient_screen/ only: colours of a tracked hand's picture.
#pragma once

#include <Inventor/SbColor.h>

namespace isograsp::gui::scene_nodes {

inline const SbColor kSkinColour(0.83F, 0.62F, 0.49F);
inline const SbColor kNailColour(0.95F, 0.80F, 0.72F);
inline const SbColor kSleeveColour(0.30F, 0.37F, 0.45F);
/// Of fingertips, which is told by a mark and a band, too.
inline const SbColor kTouchesColour(0.98F, 0.78F, 0.16F);
inline const SbColor kTiedColour(0.10F, 0.66F, 0.42F);
inline const SbColor kBandColour(0.02F, 0.30F, 0.19F);
inline const SbColor kTrackedColour(0.33F, 0.42F, 0.52F);
inline const SbColor kThingColour(0.87F, 0.33F, 0.14F);
inline const SbColor kThingEdge(0.38F, 0.11F, 0.02F);
inline const SbColor kTargetColour(0.13F, 0.45F, 0.92F);
inline const SbColor kTargetEdge(0.04F, 0.18F, 0.50F);
inline const SbColor kPlacedColour(0.52F, 0.20F, 0.68F);
inline const SbColor kTableColour(0.86F, 0.84F, 0.80F);
inline const SbColor kTableGrid(0.77F, 0.75F, 0.71F);
inline const SbColor kBlockSide(0.70F, 0.69F, 0.67F);
inline const SbColor kBlockTop(0.80F, 0.79F, 0.77F);

}  // namespace isograsp::gui::scene_nodes
