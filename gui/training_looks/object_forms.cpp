// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training_looks/object_forms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoIndexedTriangleStripSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include "gui/solids/lathe.hpp"
#include "gui/solids/scene_nodes.hpp"

namespace isograsp::gui::object_forms {

namespace {

using namespace scene_nodes;

constexpr int kTeaSectors = 28;

/// Half its width and half its height; round, so that digits touch it where they touch the box.
struct Extent {
  float r;
  float h;
};
Extent extent_of_form(const Scene& scene) {
  const SbVec3f size = to_sb(scene.size_m);
  return {0.5F * size[0], 0.5F * size[1]};
}

SoMaterial* make_shiny(const SbColor& colour, float shine, float transparency = 0.0F) {
  SoMaterial* material = make_material(colour, transparency);
  material->ambientColor.setValue(colour * 0.9F);
  material->specularColor.setValue(shine, shine, shine);
  material->shininess.setValue(0.45F);
  return material;
}

/// Seen from within as well.
SoShapeHints* make_open() {
  auto* hints = new SoShapeHints;
  hints->vertexOrdering.setValue(SoShapeHints::COUNTERCLOCKWISE);
  hints->shapeType.setValue(SoShapeHints::UNKNOWN_SHAPE_TYPE);
  return hints;
}

/// Rings about the axis: middle of the bottom, its edge, the edge of the top, its middle.
SoNode* make_tea(Form& form, float radius_m, float bottom_m, float top_m) {
  std::vector<SbVec3f> points, normals;
  for (const auto& [radius, y, normal] : {std::tuple{0.0F, bottom_m, SbVec3f(0, -1, 0)},
                                          {0.92F * radius_m, bottom_m, SbVec3f(0, -1, 0)},
                                          {0.92F * radius_m, bottom_m, SbVec3f(1, 0, 0)},
                                          {radius_m, top_m, SbVec3f(1, 0, 0)},
                                          {radius_m, top_m, SbVec3f(0, 1, 0)},
                                          {0.0F, top_m, SbVec3f(0, 1, 0)}})
    for (int j = 0; j < kTeaSectors; ++j) {
      const float a = 2.0F * std::numbers::pi_v<float> * static_cast<float>(j) / kTeaSectors;
      points.emplace_back(radius * std::cos(a), y, radius * std::sin(a));
      normals.push_back(normal[0] > 0.5F ? SbVec3f(std::cos(a), 0, std::sin(a)) : normal);
    }
  std::vector<int32_t> strips;
  for (const int ring : {0, 2, 4}) {
    for (int j = 0; j <= kTeaSectors; ++j) {
      strips.push_back(ring * kTeaSectors + j % kTeaSectors);
      strips.push_back((ring + 1) * kTeaSectors + j % kTeaSectors);
    }
    strips.push_back(SO_END_STRIP_INDEX);
  }
  form.tea = new SoVertexProperty;
  form.tea->vertex.setValues(0, static_cast<int>(points.size()), points.data());
  form.tea->normal.setValues(0, static_cast<int>(normals.size()), normals.data());
  form.tea->normalBinding.setValue(SoVertexProperty::PER_VERTEX_INDEXED);
  form.tea_radius_m = radius_m;
  form.tea_top_m = top_m;
  auto* surface = new SoIndexedTriangleStripSet;
  surface->vertexProperty.setValue(form.tea);
  surface->coordIndex.setValues(0, static_cast<int>(strips.size()), strips.data());
  return surface;
}

/// The shape, and its edge as it is seen from the front.
void set_outline(Form& form, const std::vector<Turned>& outline) {
  form.outline = make_lathe(outline);
  for (const float side : {-1.0F, 1.0F})
    for (std::size_t i = 0; i + 1 < outline.size(); ++i)
      form.edge.insert(form.edge.end(),
                       {{side * outline[i].radius_m, outline[i].y_m, 0.0F},
                        {side * outline[i + 1].radius_m, outline[i + 1].y_m, 0.0F}});
}

/// A glass of tea in a sleeve that keeps the fingers cool.
Form make_cup(const Extent& e) {
  const auto& [r, h] = e;
  Form form;
  form.solid = new SoSeparator;
  form.usual = SbColor(0.16F, 0.38F, 0.60F);
  form.solid->addChild(make_open());
  form.solid->addChild(make_shiny(SbColor(0.62F, 0.27F, 0.06F), 0.15F));
  form.solid->addChild(make_tea(form, 0.84F * r, -0.90F * h, 0.60F * h));
  const float s = 0.985F * r;
  form.solid->addChild(form.colour = make_shiny(form.usual, 0.55F));
  form.solid->addChild(make_lathe({{0.0F, -h},
                                   {0.86F * r, -h},
                                   {0.86F * r, -h},
                                   {0.96F * r, -0.93F * h},
                                   {s, -0.80F * h},
                                   {s, -0.10F * h},
                                   {s, 0.22F * h},
                                   {s, 0.22F * h},
                                   {0.93F * r, 0.26F * h},
                                   {0.90F * r, 0.26F * h}}));
  form.solid->addChild(make_shiny(SbColor(0.93F, 0.80F, 0.52F), 0.6F));
  for (const float y : {-0.78F, 0.16F})
    form.solid->addChild(make_lathe({{s, (y - 0.05F) * h},
                                     {1.01F * r, (y - 0.03F) * h},
                                     {1.01F * r, (y + 0.03F) * h},
                                     {s, (y + 0.05F) * h}}));
  form.solid->addChild(make_shiny(SbColor(0.86F, 0.94F, 0.97F), 0.9F, 0.72F));
  form.solid->addChild(make_lathe({{0.90F * r, 0.20F * h}, {0.92F * r, 0.6F * h}, {0.95F * r, h}}));
  form.solid->addChild(make_shiny(SbColor(0.97F, 0.99F, 1.0F), 0.9F));
  form.solid->addChild(
      make_lathe({{0.93F * r, 0.97F * h}, {0.95F * r, h}, {0.97F * r, 0.97F * h}}));
  set_outline(form, {{0.0F, -h},
                     {0.86F * r, -h},
                     {0.86F * r, -h},
                     {r, -0.82F * h},
                     {r, 0.22F * h},
                     {0.92F * r, 0.3F * h},
                     {0.95F * r, h},
                     {0.95F * r, h},
                     {0.0F, h}});
  return form;
}

/// A lantern with a candle, carried by its waist.
Form make_lantern(const Extent& e) {
  const auto& [r, h] = e;
  Form form;
  form.solid = new SoSeparator;
  form.usual = SbColor(0.17F, 0.25F, 0.33F);
  form.solid->addChild(make_open());
  // Candle and flame shine by themselves.
  auto* flame = new SoSeparator;
  flame->addChild(make_flat());
  flame->addChild(make_material(SbColor(1.0F, 0.96F, 0.86F)));
  flame->addChild(make_lathe({{0.0F, -0.62F * h},
                              {0.30F * r, -0.62F * h},
                              {0.30F * r, -0.62F * h},
                              {0.30F * r, -0.16F * h},
                              {0.30F * r, -0.16F * h},
                              {0.0F, -0.16F * h}},
                             16));
  flame->addChild(make_material(SbColor(1.0F, 0.80F, 0.25F)));
  flame->addChild(make_lathe(
      {{0.0F, -0.12F * h}, {0.13F * r, 0.02F * h}, {0.08F * r, 0.16F * h}, {0.0F, 0.30F * h}}, 14));
  form.solid->addChild(flame);
  form.solid->addChild(form.colour = make_shiny(form.usual, 0.45F));
  form.solid->addChild(make_lathe({{0.0F, -h},
                                   {0.92F * r, -h},
                                   {0.92F * r, -h},
                                   {r, -0.92F * h},
                                   {r, -0.72F * h},
                                   {0.86F * r, -0.62F * h},
                                   {0.86F * r, -0.62F * h},
                                   {0.0F, -0.62F * h}}));
  form.solid->addChild(make_lathe({{0.86F * r, 0.50F * h},
                                   {r, 0.46F * h},
                                   {r, 0.46F * h},
                                   {r, 0.54F * h},
                                   {0.62F * r, 0.72F * h},
                                   {0.34F * r, 0.82F * h},
                                   {0.34F * r, 0.94F * h},
                                   {0.34F * r, 0.94F * h},
                                   {0.0F, 0.96F * h}}));
  for (int k = 0; k < 4; ++k) {
    const float a = std::numbers::pi_v<float> * (0.25F + 0.5F * static_cast<float>(k));
    const SbVec3f foot(0.90F * r * std::cos(a), -0.64F * h, 0.90F * r * std::sin(a));
    form.solid->addChild(make_tube({foot, foot + SbVec3f(0, 1.14F * h, 0)}, 0.045F * r, 8));
  }
  std::vector<SbVec3f> ring;
  for (int k = 0; k <= 20; ++k) {
    const float a = std::numbers::pi_v<float> * static_cast<float>(k) / 10.0F;
    ring.emplace_back(0.24F * r * std::sin(a), 1.14F * h - 0.24F * r * std::cos(a), 0.0F);
  }
  form.solid->addChild(make_tube(ring, 0.05F * r, 8));
  form.solid->addChild(make_shiny(SbColor(1.0F, 0.83F, 0.48F), 0.8F, 0.62F));
  form.solid->addChild(make_lathe({{0.84F * r, -0.62F * h},
                                   {0.88F * r, -0.3F * h},
                                   {0.88F * r, 0.3F * h},
                                   {0.82F * r, 0.52F * h}}));
  set_outline(form, {{0.0F, -h},
                     {r, -h},
                     {r, -h},
                     {r, -0.72F * h},
                     {0.88F * r, -0.5F * h},
                     {0.88F * r, 0.44F * h},
                     {r, 0.46F * h},
                     {r, 0.54F * h},
                     {0.34F * r, 0.82F * h},
                     {0.34F * r, 0.95F * h},
                     {0.34F * r, 0.95F * h},
                     {0.0F, 0.95F * h}});
  return form;
}

SoSeparator* make_board(const SbVec3f& middle, const SbVec3f& size, const SbColor& colour) {
  auto* board = new SoSeparator;
  auto* place = new SoTranslation;
  place->translation.setValue(middle);
  auto* box = new SoCube;
  box->width.setValue(size[0]);
  box->height.setValue(size[1]);
  box->depth.setValue(size[2]);
  board->addChild(place);
  board->addChild(make_shiny(colour, 0.12F));
  board->addChild(box);
  return board;
}

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

SoNode* along_z(SoNode* turned) {
  auto* group = new SoSeparator;
  auto* turn = new SoTransform;
  turn->rotation.setValue(SbVec3f(1, 0, 0), 0.5F * std::numbers::pi_v<float>);
  group->addChild(turn);
  group->addChild(turned);
  return group;
}

}  // namespace

void add_kitchen_details(SoSeparator& form, const Scene& scene) {
  const SbVec3f size = to_sb(scene.size_m);
  const SbColor label(0.97F, 0.94F, 0.86F), lid(0.58F, 0.40F, 0.24F);
  form.addChild(make_open());
  if (scene.shape == Shape::cylinder) {
    const float r = 0.5F * size[0], h = 0.5F * size[1];
    form.addChild(make_shiny(label, 0.1F));
    form.addChild(along_z(make_lathe({{1.01F * r, -0.50F * h}, {1.01F * r, 0.25F * h}})));
    form.addChild(make_shiny(lid, 0.3F));
    form.addChild(along_z(make_lathe({{1.01F * r, 0.66F * h},
                                      {1.06F * r, 0.70F * h},
                                      {1.06F * r, 0.98F * h},
                                      {1.02F * r, 1.01F * h},
                                      {1.02F * r, 1.01F * h},
                                      {0.0F, 1.01F * h}})));
    return;
  }
  form.addChild(make_board({0, 0.40F * size[1], 0},
                           {1.04F * size[0], 0.21F * size[1], 1.04F * size[2]}, lid));
  form.addChild(make_board({0, -0.12F * size[1], 0},
                           {0.62F * size[0], 0.40F * size[1], 1.02F * size[2]}, label));
}

bool has_form(tasks::Look look, const Scene& scene) noexcept {
  constexpr std::size_t kTurnX = 3, kTurnY = 4;
  return scene.shape == Shape::box && !scene.free[kTurnX] && !scene.free[kTurnY] &&
         (look == tasks::Look::cup || look == tasks::Look::lantern);
}

Form make_form(tasks::Look look, const Scene& scene) {
  const Extent extent = extent_of_form(scene);
  return look == tasks::Look::lantern ? make_lantern(extent) : make_cup(extent);
}

void keep_level(const Form& form, const Quat& q_WO) {
  if (form.tea == nullptr) return;
  constexpr double kSteepest = 0.6;  // it never runs over
  const Vec3 up_O = q_WO.conjugate() * Vec3::UnitY();
  const double least = std::max(0.3, up_O.y());
  const auto slope = [&](double part) {
    return static_cast<float>(std::clamp(-part / least, -kSteepest, kSteepest));
  };
  const float by_x = slope(up_O.x()), by_z = slope(up_O.z());
  SbVec3f* const points = form.tea->vertex.startEditing();
  for (const int ring : {3, 4})
    for (int j = 0; j < kTeaSectors; ++j) {
      SbVec3f& p = points[ring * kTeaSectors + j];
      p[1] = form.tea_top_m + by_x * p[0] + by_z * p[2];
    }
  form.tea->vertex.finishEditing();
}

SoSeparator* make_shelf(const Scene& scene) {
  const SbVec3f size = to_sb(scene.size_m);
  const SbColor wood(0.66F, 0.48F, 0.31F);
  constexpr float kThick_m = 0.010F;
  const float under = -0.5F * size[1] - 0.5F * kThick_m - 0.001F;
  auto* shelf = new SoSeparator;
  shelf->addChild(make_board({0, under, 0}, {2.0F * size[0], kThick_m, 1.1F * size[2]}, wood));
  for (const float side : {-0.72F, 0.72F})
    shelf->addChild(make_board({side * size[0], under - 0.012F, -0.1F * size[2]},
                               {0.008F, 0.016F, 0.7F * size[2]}, SbColor(0.45F, 0.31F, 0.19F)));
  return shelf;
}

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
