// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/posture_desk.hpp"

#include <QLocale>
#include <utility>

#include "gui/words/texts.hpp"
#include "session/arm/arm_rig.hpp"

namespace isograsp::gui {

namespace {

QString sd_words(double sd_m) {
  constexpr double kMmPerM = 1000.0;
  return QLocale().toString(kMmPerM * sd_m, 'f', 1);
}

}  // namespace

PostureDesk::PostureDesk(SessionPresenter& presenter, QObject* parent)
    : QObject(parent), presenter_(presenter), editor_(new PostureEditor), view_(new PostureView) {
  editor_->add_keys(view_->sides());
  connect(view_, &PostureView::key_pressed, editor_, &PostureEditor::act_on);
  connect(editor_, &PostureEditor::shown_changed, this, &PostureDesk::show_pictures);
  connect(editor_, &PostureEditor::refused, this, &PostureDesk::said);
  connect(editor_, &PostureEditor::edited, this, [this](const PostureFile& file) {
    Q_EMIT edited(QString::fromStdString(posture_file_text(file)));
  });
  connect(editor_, &PostureEditor::record_pressed, this, &PostureDesk::press_record);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &PostureDesk::refresh_recording);
  connect(&presenter_.flow(), &SessionFlow::frame, this, &PostureDesk::look);
}

bool PostureDesk::show_text(const std::string& text, const std::string& path, bool editable,
                            bool changed) {
  // What is being typed into a field stays.
  if (path == path_ && text == text_ && editable == editable_ && changed == changed_) return true;
  const auto file = read_posture_file(text, path);
  if (!file) return false;
  const auto& chain = file->postures.chain;
  if (scene_ == nullptr || scene_->chain() != chain)
    scene_ = std::make_unique<PostureScene>(presenter_.state().config.library, chain);
  const bool other = path != path_;
  if (other) take_.stop();
  path_ = path;
  text_ = text;
  editable_ = editable;
  changed_ = changed;
  editor_->show_file(*file, editable, changed);
  if (other) editor_->choose(0);
  refresh_recording();
  return true;
}

void PostureDesk::leave() {
  path_.clear();
  take_.stop();
}

void PostureDesk::made(const std::string& path) {
  const auto& open = presenter_.state().open;
  recorded_.reset();
  if (open) recorded_ = Recorded{path, open->session->known().record.uuid};
}

void PostureDesk::show_pictures() {
  const Postures& postures = editor_->file().postures;
  if (scene_ != nullptr && scene_->chain() == postures.chain)
    view_->show_posture(*scene_, postures, editor_->chosen(), editor_->segment_of_axes());
}

bool PostureDesk::sees_an_arm() const {
  const auto& open = presenter_.state().open;
  if (!open) return false;
  const auto& arm = open->session->known().arm;
  return arm && arm->has_segment[index_of(ArmSegment::elbow)];
}

bool PostureDesk::may_record() const {
  return sees_an_arm() && presenter_.state().open->arm && presenter_.flow().view().may_choose_task;
}

bool PostureDesk::goes_on_in_this_file() const {
  const auto& open = presenter_.state().open;
  return open && recorded_ && editable_ && recorded_->path == path_ &&
         recorded_->session == open->session->known().record.uuid;
}

void PostureDesk::refresh_recording() {
  PostureEditor::Recording recording;
  recording.offered = sees_an_arm();
  recording.possible = may_record();
  recording.running = take_.running();
  recording.progress = take_.progress();
  recording.into_this_file = goes_on_in_this_file();
  editor_->show_recording(recording);
}

void PostureDesk::press_record() {
  if (take_.running())
    take_.stop();
  else if (may_record())
    take_.begin();
  refresh_recording();
}

void PostureDesk::look() {
  if (!take_.running()) return;
  if (!may_record()) take_.stop();  // a trial begins, or the session ends
  if (take_.running() && take_.add(*presenter_.state().open->arm)) take();
  refresh_recording();
}

void PostureDesk::take() {
  switch (take_.state()) {
    case PostureTake::State::moved:
      return said(tr("Not recorded: the arm moved by %1 mm (SD). Hold it still.")
                      .arg(sd_words(take_.sd_m())));
    case PostureTake::State::not_seen:
      return said(
          tr("Not recorded: elbow, forearm, hand and object were not seen together for a second."));
    case PostureTake::State::taken: break;
    case PostureTake::State::idle:
    case PostureTake::State::running: return;
  }
  const storage::SessionRecord& session = presenter_.state().open->session->known().record;
  const Hand hand = session.hand.value_or(Hand::right);
  const auto remark =
      tr("Recorded for a second; it moved by %1 mm (SD).").arg(sd_words(take_.sd_m()));
  if (goes_on_in_this_file()) {
    PostureFile file = editor_->file();
    file.postures =
        with_added(file.postures, file.postures.postures.size() - 1, {"posture", take_.links()});
    const std::size_t added = file.postures.postures.size() - 1;
    Q_EMIT edited(QString::fromStdString(posture_file_text(file)));
    editor_->choose(added);
    return said(remark);
  }
  const auto rig = session::ArmRig::parse(session.calibration, "rig", hand);
  if (!rig) return said(translated(rig.error()));
  Postures postures;
  postures.name = tr("Recorded postures").toStdString();
  postures.hand = hand;
  postures.chain = rig->chain;
  postures.postures.push_back({"initial", take_.links()});
  Q_EMIT new_file(QString::fromStdString(postures_text(postures)), remark);
}

}  // namespace isograsp::gui
