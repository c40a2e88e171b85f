// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/presentation.hpp"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace isograsp::gui {

namespace {

using ScreenHalf = Presentation::Half;

struct PresentationTexts {
  Q_DECLARE_TR_FUNCTIONS(Presentation)
};

constexpr const char* kPresentationTopic = "screen";
constexpr const char* kHalf = "half";
constexpr std::array<ScreenHalf, 3> kHalves{ScreenHalf::whole, ScreenHalf::left, ScreenHalf::right};
constexpr std::array<std::pair<const char*, bool Presentation::*>, 4> kPresentationSwitches{
    {{"calm", &Presentation::calm},
     {"sound", &Presentation::sound},
     {"hear", &Presentation::hear},
     {"voice", &Presentation::voice}}};

/// Metres on the screen per newton.
double scale_m_per_N(const ForceAxis& axis, const Viewing& viewing) {
  return axis.share_per_N() * kFieldShare * viewing.picture_height_m;
}

}  // namespace

const char* name_of(ScreenHalf half) noexcept {
  switch (half) {
    case ScreenHalf::whole: return "whole";
    case ScreenHalf::left: return "left";
    case ScreenHalf::right: return "right";
  }
  return "";
}

std::vector<storage::SessionAnswer> stored(const Presentation& presentation) {
  std::vector<storage::SessionAnswer> answers{
      {kPresentationTopic, kHalf, name_of(presentation.half)}};
  for (const auto& [item, member] : kPresentationSwitches)
    answers.push_back({kPresentationTopic, item, presentation.*member ? "yes" : "no"});
  return answers;
}

Presentation presentation_in(const std::vector<storage::SessionAnswer>& answers) {
  Presentation presentation;
  for (const auto& answer : answers) {
    if (answer.topic != kPresentationTopic) continue;
    for (const auto half : kHalves)
      if (answer.item == kHalf && answer.value == name_of(half)) presentation.half = half;
    for (const auto& [item, member] : kPresentationSwitches)
      if (answer.item == item) presentation.*member = answer.value == "yes";
  }
  return presentation;
}

QString summary(const Presentation& presentation) {
  QStringList words;
  if (presentation.half == ScreenHalf::left) words += PresentationTexts::tr("left half");
  if (presentation.half == ScreenHalf::right) words += PresentationTexts::tr("right half");
  if (presentation.calm) words += PresentationTexts::tr("calm");
  if (presentation.sound) words += PresentationTexts::tr("sounds");
  if (presentation.hear) words += PresentationTexts::tr("force heard");
  if (presentation.voice) words += PresentationTexts::tr("spoken");
  return words.join(QStringLiteral(", "));
}

QRectF content_area(const QRectF& screen, ScreenHalf half) {
  if (half == ScreenHalf::whole) return screen;
  constexpr double kWidestHalf = 4.0 / 3.0;
  const double width = screen.width() / 2;
  const double height = std::min(screen.height(), width / kWidestHalf);
  const double left = half == ScreenHalf::left ? screen.left() : screen.left() + width;
  return {left, screen.center().y() - height / 2, width, height};
}

double Viewing::angle_deg(double length_m) const noexcept {
  return length_m / distance_m * 180.0 / std::numbers::pi;
}

double gain_of(const ForceAxis& axis, const Viewing& viewing) noexcept {
  return viewing.angle_deg(scale_m_per_N(axis, viewing));
}

ForceAxis with_gain(const ForceAxis& axis, double gain_deg_per_N, const Viewing& viewing) noexcept {
  const double fit = gain_of(axis, viewing);
  if (gain_deg_per_N >= fit) return axis;
  // A lower gain shows more newtons: above zero, or on both sides where targets pull as well.
  const double more = fit / gain_deg_per_N;
  return {axis.least_N * more, axis.most_N * more};
}

}  // namespace isograsp::gui
