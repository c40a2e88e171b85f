// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/example_player.hpp"

#include "gui/presenter/patient_facts.hpp"

namespace isograsp::gui {

void ExamplePlayer::show(const tasks::TaskSpec& spec, const session::DemonstrationFor& whom,
                         const std::string& library, std::function<void(Result<void>)> changed) {
  stop();
  showing_ = true;
  hand_ = whom.hand;
  using Shown = Result<session::Demonstration>;
  worker_.run(
      [spec, whom, library]() -> Shown { return session::demonstrate(spec, whom, library); },
      [this, request = request_, changed = std::move(changed)](Shown shown) {
        if (request != request_) return;  // stopped meanwhile
        if (!shown) {
          stop();
          return changed(shown.error());
        }
        if (shown->size() == 0) {
          stop();
        } else {
          if (shown->arm) arm_space_ = std::make_shared<ArmSpace>(*shown->arm, hand_);
          preview_ = std::make_shared<TargetPreview>(preview_target(*shown->task, shown->context));
          example_ = std::make_shared<session::Demonstration>(*std::move(shown));
          frame_ = 0;
          began_ = clock_.now();
        }
        changed({});
      });
}

void ExamplePlayer::stop() {
  ++request_;
  showing_ = false;
  example_.reset();
  preview_.reset();
  arm_space_.reset();
}

void ExamplePlayer::tick() {
  if (example_ == nullptr) return;
  const double shown_s = to_seconds(clock_.now() - began_);
  frame_ = static_cast<std::size_t>(shown_s / example_->period_s);
  if (frame_ >= example_->size()) stop();
}

PatientFacts ExamplePlayer::facts() const {
  PatientFacts facts = arm_space_ != nullptr ? patient_facts(example_->arm_frames[frame_])
                       : !example_->hand_frames.empty()
                           ? patient_facts(example_->hand_frames[frame_])
                           : patient_facts(example_->frames[frame_]);
  facts.arm = arm_space_;
  facts.session_open = true;
  facts.example = true;
  facts.hand = hand_;
  facts.task = example_->task;
  facts.scene = example_->scene;
  facts.preview = preview_;
  facts.maximum_force_N = example_->context.references.maximum({});
  return facts;
}

}  // namespace isograsp::gui
