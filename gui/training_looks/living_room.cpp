// SPDX-License-Identifier: GPL-3.0-or-later
// Table, wall, window and plant: where objects are carried in training.
#include <cmath>
#include <numbers>
#include <vector>

#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include "gui/solids/lathe.hpp"
#include "gui/solids/scene_nodes.hpp"
#include "gui/training_looks/object_forms.hpp"
#include "gui/training_looks/wares.hpp"

namespace isograsp::gui::object_forms {

namespace {

using namespace scene_nodes;

struct RoomColours {
  SbColor wall_top, wall_low, table, grain, sky_top, sky_low;
};
const RoomColours& room_colours(tasks::Daylight light) {
  static const RoomColours kMorning{{0.95F, 0.92F, 0.85F}, {0.89F, 0.85F, 0.78F},
                                    {0.80F, 0.69F, 0.55F}, {0.71F, 0.59F, 0.45F},
                                    {0.72F, 0.82F, 0.90F}, {0.98F, 0.88F, 0.76F}};
  static const RoomColours kDay{{0.93F, 0.95F, 0.94F}, {0.85F, 0.89F, 0.88F},
                                {0.78F, 0.66F, 0.51F}, {0.68F, 0.56F, 0.42F},
                                {0.56F, 0.76F, 0.92F}, {0.87F, 0.94F, 0.97F}};
  static const RoomColours kEvening{{0.77F, 0.73F, 0.80F}, {0.86F, 0.75F, 0.70F},
                                    {0.62F, 0.48F, 0.38F}, {0.53F, 0.40F, 0.31F},
                                    {0.38F, 0.40F, 0.62F}, {0.93F, 0.64F, 0.50F}};
  return light == tasks::Daylight::morning ? kMorning
         : light == tasks::Daylight::day   ? kDay
                                           : kEvening;
}

/// Beside where objects are carried, and flat at the wall.
void add_window(SoSeparator& room, const RoomColours& colours) {
  const float z = kTableRoom.wall + 0.002F;
  constexpr float kLeft = -0.375F, kRight = -0.255F, kLow = -0.005F, kTop = 0.125F;
  room.addChild(
      make_shaded_plane({{kLeft, kLow, z}, {kRight, kLow, z}, {kRight, kTop, z}, {kLeft, kTop, z}},
                        {colours.sky_low, colours.sky_low, colours.sky_top, colours.sky_top}));
  const SbColor frame(0.96F, 0.95F, 0.92F);
  constexpr float kBar = 0.007F;
  const float x = 0.5F * (kLeft + kRight), y = 0.5F * (kLow + kTop);
  for (const float at : {kLeft, x, kRight})
    room.addChild(make_board({at, y, z}, {kBar, kTop - kLow + kBar, 0.008F}, frame));
  for (const float at : {kLow, y, kTop})
    room.addChild(make_board({x, at, z}, {kRight - kLeft + kBar, kBar, 0.008F}, frame));
  room.addChild(
      make_board({x, kLow - 0.008F, z + 0.008F}, {kRight - kLeft + 0.03F, 0.008F, 0.024F}, frame));
}

/// On the table, at the right.
void add_plant(SoSeparator& room) {
  auto* plant = new SoSeparator;
  auto* place = new SoTranslation;
  place->translation.setValue(0.315F, kTableRoom.floor, -0.070F);
  plant->addChild(place);
  auto* smaller = new SoTransform;
  smaller->scaleFactor.setValue(0.82F, 0.82F, 0.82F);
  plant->addChild(smaller);
  plant->addChild(make_open());
  plant->addChild(make_shiny(SbColor(0.72F, 0.42F, 0.30F), 0.1F));
  plant->addChild(make_lathe({{0.0F, 0.001F},
                              {0.022F, 0.001F},
                              {0.022F, 0.001F},
                              {0.030F, 0.040F},
                              {0.034F, 0.040F},
                              {0.034F, 0.050F},
                              {0.034F, 0.050F},
                              {0.0F, 0.046F}},
                             24));
  constexpr int kLeaves = 9;
  for (int k = 0; k < kLeaves; ++k) {
    const float a = 2.4F * static_cast<float>(k);  // as leaves stand round a stem
    const float out = 0.016F + 0.004F * static_cast<float>(k % 4);
    const float up = 0.060F + 0.011F * static_cast<float>(k % 5);
    std::vector<SbVec3f> stem{
        {0, 0.045F, 0},
        {0.4F * out * std::cos(a), 0.6F * up + 0.02F, 0.4F * out * std::sin(a)},
        {out * std::cos(a), up + 0.02F, out * std::sin(a)}};
    plant->addChild(
        make_shiny(SbColor(0.27F + 0.02F * static_cast<float>(k % 3), 0.47F, 0.30F), 0.1F));
    plant->addChild(make_tube(stem, 0.0012F, 6));
    auto* leaf = new SoSeparator;
    auto* at = new SoTransform;
    at->translation.setValue(stem.back() + SbVec3f(0, 0.010F, 0));
    at->rotation.setValue(SbVec3f(std::sin(a), 0, -std::cos(a)), 0.55F);
    at->scaleFactor.setValue(0.011F, 0.022F, 0.006F);
    leaf->addChild(at);
    leaf->addChild(new SoSphere);
    plant->addChild(leaf);
  }
  room.addChild(plant);
}

}  // namespace

SoSeparator* make_living_room(tasks::Daylight light) {
  const RoomColours& colours = room_colours(light);
  const RoomSize& size = kTableRoom;
  auto* room = new SoSeparator;
  const float w = size.half_width;
  room->addChild(
      make_shaded_plane({{-w, size.floor, size.wall},
                         {w, size.floor, size.wall},
                         {w, size.top, size.wall},
                         {-w, size.top, size.wall}},
                        {colours.wall_low, colours.wall_low, colours.wall_top, colours.wall_top}));
  room->addChild(make_shaded_plane({{-w, size.floor, size.front},
                                    {w, size.floor, size.front},
                                    {w, size.floor, size.wall},
                                    {-w, size.floor, size.wall}},
                                   {colours.table, colours.table, colours.grain, colours.grain}));
  std::vector<SbVec3f> grain;
  constexpr float kLift_m = 0.0006F;
  for (float z = size.wall + 0.03F; z < size.front; z += 0.045F)
    grain.insert(grain.end(), {{-w, size.floor + kLift_m, z}, {w, size.floor + kLift_m, z}});
  room->addChild(make_lines(grain, colours.grain, 2.0F));
  add_window(*room, colours);
  add_plant(*room);
  return room;
}

}  // namespace isograsp::gui::object_forms
