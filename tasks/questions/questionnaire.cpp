// SPDX-License-Identifier: GPL-3.0-or-later
// Sources: eleven points for naturalness and efficiency (Delrieu et al., grasp assistance); seven
// points for six qualities of working with two hands (Talvas et al., bimanual haptics). The
// wording is ours.
#include "tasks/questions/questionnaire.hpp"

#include <algorithm>
#include <array>

namespace isograsp::tasks {

namespace {

constexpr std::array kVirtualGrasp{
    Question{"naturalness", "Naturalness"_text, "How natural was it to hold and let go?"_text},
    Question{"efficiency", "Efficiency"_text, "How well did it do what you wanted?"_text}};

constexpr std::array kTwoHands{
    Question{"appreciation", "Appreciation"_text, "Did you like working this way?"_text},
    Question{"efficiency", "Efficiency"_text, "Could you do the task well this way?"_text},
    Question{"learning", "Learning"_text, "Was it easy to learn?"_text},
    Question{"usability", "Usability"_text, "Was it easy to use?"_text},
    Question{"fatigue", "Fatigue"_text, "Did it tire you?"_text},
    Question{"realism", "Realism"_text, "Did it feel like a real object?"_text}};

constexpr std::array kQuestionnaires{
    Questionnaire{"virtual_grasp", 0, 10, "not at all"_text, "completely"_text, kVirtualGrasp},
    Questionnaire{"two_hands", 1, 7, "not at all"_text, "very much"_text, kTwoHands}};

}  // namespace

std::span<const Questionnaire> questionnaires() noexcept {
  return kQuestionnaires;
}

const Questionnaire* questionnaire_named(std::string_view name) noexcept {
  const auto found = std::ranges::find(kQuestionnaires, name, &Questionnaire::name);
  return found == kQuestionnaires.end() ? nullptr : &*found;
}

std::string AskedQuestion::full_name() const {
  return std::string(of->name) + "." + std::string(question->name);
}

std::optional<AskedQuestion> question_named(std::string_view full_name) noexcept {
  const auto dot = full_name.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const Questionnaire* const of = questionnaire_named(full_name.substr(0, dot));
  if (of == nullptr) return std::nullopt;
  const auto found = std::ranges::find(of->questions, full_name.substr(dot + 1), &Question::name);
  if (found == of->questions.end()) return std::nullopt;
  return AskedQuestion{of, &*found};
}

}  // namespace isograsp::tasks
