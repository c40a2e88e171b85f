// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/posture_view.hpp"

#include "gui/look/look.hpp"
#include "gui/patient_screen/patient_window.hpp"

namespace isograsp::gui {

PostureView::PostureView(QWidget* parent) : Card({}, parent) {
  setObjectName("posture_view");
  title_->setText(tr("The posture"));
  title_->setObjectName("posture_view_title");
  title_->setWordWrap(true);
  arm_ = new ArmViews;
  arm_->setObjectName("posture_sides");
  arm_->setFocusPolicy(Qt::StrongFocus);
  describe(*arm_, tr("The arm in this posture from the front, from the side and from above"),
           tr("X, Y and Z turn the link, with Shift the other way; Ctrl with arrow and page keys "
              "moves it; one square is 10 cm"));
  take_rest(*arm_, 110);
  auto* sides_words = new QLabel(tr("The arm, and dashed the object in the initial posture"));
  sides_words->setProperty("role", "quiet");
  sides_words->setWordWrap(true);
  solid_words_ = new QLabel;
  solid_words_->setProperty("role", "quiet");
  solid_words_->setWordWrap(true);
  column_->addWidget(solid_words_);
  column_->addWidget(arm_, 2);
  column_->addWidget(sides_words);
}

void PostureView::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  show_solid();
}

void PostureView::show_solid() {
  static const bool kOpenGl = why_no_opengl().empty();
  solid_words_->setText(kOpenGl ? tr("The patient sees the object at the start, and this target.")
                                : tr("Drawn flat: this display has no OpenGL for the 3D picture."));
  if (!kOpenGl) return;
  if (window_ == nullptr) {
    window_ = new ObjectWindow;
    connect(window_, &ObjectWindow::key_pressed, this, &PostureView::key_pressed);
    auto* container = QWidget::createWindowContainer(window_);
    container->setObjectName("posture_solid");
    describe(*container, tr("The object in three dimensions"),
             tr("As the patient sees it; the keys are those of the three sides"));
    take_rest(*container, 120);
    column_->insertWidget(1, container, 3);
  }
  window_->show_picture(picture_);
}

void PostureView::show_posture(const PostureScene& scene, const Postures& postures,
                               std::size_t index, std::size_t axes) {
  title_->setText(QString::fromStdString(postures.postures[index].name));
  arm_->show_arm(scene.arm_in(postures, index), scene.space(),
                 scene.segments_W(postures.postures[index])[axes]);
  picture_ = scene.picture_of(postures, index);
  if (isVisible()) show_solid();
}

}  // namespace isograsp::gui
