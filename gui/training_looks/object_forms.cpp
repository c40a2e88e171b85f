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
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include "gui/solids/lathe.hpp"
#include "gui/solids/ring_mesh.hpp"
#include "gui/solids/scene_nodes.hpp"
#include "gui/training_looks/wares.hpp"

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
  auto* surface = make_ring_mesh(points, normals, {0, 2, 4}, kTeaSectors);
  form.tea = static_cast<SoVertexProperty*>(surface->vertexProperty.getValue());
  form.tea_radius_m = radius_m;
  form.tea_top_m = top_m;
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

}  // namespace isograsp::gui::object_forms
