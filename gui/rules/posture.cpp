// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/posture.hpp"

#include <QCoreApplication>
#include <QStringList>

namespace isograsp::gui {

namespace {

struct PostureTexts {
  Q_DECLARE_TR_FUNCTIONS(Posture)
};

constexpr const char* kPostureTopic = "posture";

/// Words of a choice; empty: it is its own word.
QString words_of_choice(const std::string& value) {
  if (value == "chair") return PostureTexts::tr("chair with back");
  if (value == "wheelchair") return PostureTexts::tr("wheelchair");
  if (value == "bedside") return PostureTexts::tr("edge of the bed");
  if (value == "bed") return PostureTexts::tr("in bed");
  if (value == "table") return PostureTexts::tr("on the table");
  if (value == "trough") return PostureTexts::tr("in a trough");
  if (value == "free") return PostureTexts::tr("free");
  if (value == "neutral") return PostureTexts::tr("neutral");
  if (value == "extended") return PostureTexts::tr("extended");
  if (value == "flexed") return PostureTexts::tr("flexed");
  if (value == "none") return PostureTexts::tr("none");
  if (value == "wrist_splint") return PostureTexts::tr("wrist splint");
  if (value == "hand_splint") return PostureTexts::tr("hand splint");
  if (value == "other") return PostureTexts::tr("another one");
  return {};
}

/// As stored of one of both hands.
std::string name_of_hand(PostureItem item, Hand hand) {
  if (item == PostureItem::seat) return name_of(item);
  return std::string(isograsp::name_of(hand)) + "_" + name_of(item);
}

}  // namespace

const char* name_of(PostureItem item) noexcept {
  switch (item) {
    case PostureItem::seat: return "seat";
    case PostureItem::elbow: return "elbow_deg";
    case PostureItem::forearm: return "forearm";
    case PostureItem::wrist: return "wrist";
    case PostureItem::orthosis: return "orthosis";
    case PostureItem::supports: return "supports";
    case PostureItem::straps: return "straps";
  }
  return "";
}

QString words_of(PostureItem item) {
  switch (item) {
    case PostureItem::seat: return PostureTexts::tr("Seat");
    case PostureItem::elbow: return PostureTexts::tr("Elbow");
    case PostureItem::forearm: return PostureTexts::tr("Forearm");
    case PostureItem::wrist: return PostureTexts::tr("Wrist");
    case PostureItem::orthosis: return PostureTexts::tr("Orthosis");
    case PostureItem::supports: return PostureTexts::tr("Supports at");
    case PostureItem::straps: return PostureTexts::tr("Straps at");
  }
  return {};
}

const std::vector<const char*>& choices_of(PostureItem item) {
  static const std::vector<const char*> kSeats{"chair", "wheelchair", "bedside", "bed"};
  static const std::vector<const char*> kElbows{"60", "70", "80", "90", "100", "110", "120", "140"};
  static const std::vector<const char*> kForearms{"table", "trough", "free"};
  static const std::vector<const char*> kWrists{"neutral", "extended", "flexed"};
  static const std::vector<const char*> kOrthoses{"none", "wrist_splint", "hand_splint", "other"};
  static const std::vector<const char*> kWritten;
  switch (item) {
    case PostureItem::seat: return kSeats;
    case PostureItem::elbow: return kElbows;
    case PostureItem::forearm: return kForearms;
    case PostureItem::wrist: return kWrists;
    case PostureItem::orthosis: return kOrthoses;
    default: return kWritten;
  }
}

QString words_of(PostureItem item, const std::string& value) {
  if (value.empty()) return PostureTexts::tr("not said");
  const auto as_stored = QString::fromStdString(value);
  if (item == PostureItem::elbow) return PostureTexts::tr("%1°").arg(as_stored);
  const auto words = words_of_choice(value);
  return words.isEmpty() ? as_stored : words;
}

std::vector<storage::SessionAnswer> stored(const SittingPosture& posture) {
  std::vector<storage::SessionAnswer> answers;
  for (const auto item : kPostureOrder)
    if (!posture.of(item).empty())
      answers.push_back({kPostureTopic, name_of(item), posture.of(item)});
  return answers;
}

SittingPosture posture_in(const std::vector<storage::SessionAnswer>& answers) {
  SittingPosture posture;
  for (const auto& answer : answers)
    for (const auto item : kPostureOrder)
      if (answer.topic == kPostureTopic && answer.item == name_of(item))
        posture.of(item) = answer.value;
  return posture;
}

std::vector<storage::SessionAnswer> stored(const OfHands<SittingPosture>& postures) {
  std::vector<storage::SessionAnswer> answers;
  for (const Hand hand : kBothHands)
    for (const auto item : kPostureOrder) {
      const bool said_before = item == PostureItem::seat && hand == Hand::right;
      if (const auto& value = postures[hand].of(item); !value.empty() && !said_before)
        answers.push_back({kPostureTopic, name_of_hand(item, hand), value});
    }
  return answers;
}

OfHands<SittingPosture> postures_in(const std::vector<storage::SessionAnswer>& answers) {
  OfHands<SittingPosture> postures;
  for (const auto& answer : answers)
    for (const Hand hand : kBothHands)
      for (const auto item : kPostureOrder)
        if (answer.topic == kPostureTopic && answer.item == name_of_hand(item, hand))
          postures[hand].of(item) = answer.value;
  return postures;
}

QString deviations(const SittingPosture& now, const SittingPosture& last) {
  QStringList found;
  for (const auto item : kPostureOrder)
    if (!last.of(item).empty() && now.of(item) != last.of(item))
      found +=
          PostureTexts::tr("%1: %2 instead of %3")
              .arg(words_of(item), words_of(item, now.of(item)), words_of(item, last.of(item)));
  return found.join(QStringLiteral("; "));
}

}  // namespace isograsp::gui
