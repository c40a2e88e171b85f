// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_window.hpp"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QScreen>
#include <algorithm>
#include <cmath>

#include <GL/gl.h>

#include "gui/patient_screen/hand_footer.hpp"
#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_ink.hpp"

namespace isograsp::gui {

namespace {

/// A hand holds its object from above: ring and tick stand below it, by so many diameters.
constexpr double kBelowHand = 1.3;
/// The ring of a hold lies outside the object, by so much of its half diagonal.
constexpr double kRoundObject = 1.12;

QSurfaceFormat compatible_format(int samples) {
  QSurfaceFormat format;
  format.setVersion(2, 1);
  format.setProfile(QSurfaceFormat::CompatibilityProfile);
  format.setDepthBufferSize(24);
  format.setSamples(samples);
  return format;
}

}  // namespace

std::string why_no_opengl() {
  // The test platform of Qt claims to have OpenGL and then draws nothing.
  if (QGuiApplication::platformName() == QLatin1String("offscreen") ||
      QGuiApplication::platformName() == QLatin1String("minimal"))
    return QObject::tr("There is no display for the patient's screen.").toStdString();
  const std::string kRemedy =
      QObject::tr("The patient's screen needs OpenGL 2.1: install the driver of the graphics card.")
          .toStdString();
  QOpenGLContext context;
  context.setFormat(compatible_format(0));
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.create() || !context.makeCurrent(&surface)) return kRemedy;
  const auto* renderer =
      reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const bool software = renderer == nullptr ||
                        std::string(renderer).find("llvmpipe") != std::string::npos ||
                        std::string(renderer).find("softpipe") != std::string::npos;
  const auto version = context.format().version();
  context.doneCurrent();
  if (version < qMakePair(2, 1)) return kRemedy;
  QSurfaceFormat::setDefaultFormat(compatible_format(software ? 0 : 4));
  return {};
}

PatientWindow::PatientWindow(SessionPresenter& presenter, const SettingsFile& settings)
    : presenter_(presenter), settings_(settings) {
  setTitle(tr("IsoGrasp: patient screen"));
  resize(1280, 720);
  setMinimumSize(QSize(640, 360));
  connect(&presenter_.flow(), &SessionFlow::frame, this, [this] {
    if (isExposed()) update();
  });
  connect(this, &QOpenGLWindow::frameSwapped, &presenter_,
          [this] { presenter_.patient_view().picture_shown(shown_); });
}

PatientWindow::~PatientWindow() {
  makeCurrent();
  scene_.reset();
  hand_scene_.reset();
  doneCurrent();
}

void PatientWindow::show_for_patient() {
  const auto screens = QGuiApplication::screens();
  const auto wanted = QString::fromStdString(settings_.now().patient_screen);
  const auto named = std::find_if(screens.begin(), screens.end(),
                                  [&](const QScreen* one) { return one->name() == wanted; });
  if (screens.size() > 1) {
    QScreen* const chosen = named == screens.end() ? screens[1] : *named;
    setScreen(chosen);
    setGeometry(chosen->geometry());
    showFullScreen();
  } else {
    show();
    raise();
  }
}

void PatientWindow::toggle_full_screen() {
  if (windowState() == Qt::WindowFullScreen)
    showNormal();
  else
    showFullScreen();
}

PatientWindow::Rate PatientWindow::rate() const noexcept {
  return {pictures_, pictures_ == 0 ? 0.0 : drawing_s_ / static_cast<double>(pictures_)};
}

QSize PatientWindow::device_size() const {
  return size() * devicePixelRatio();
}

QRect PatientWindow::content() const {
  const QRectF all(QPointF(0, 0), QSizeF(device_size()));
  return content_area(all, presenter_.seating().presentation().half).toRect();
}

double PatientWindow::content_height_m() const {
  const double screen_px = screen()->size().height() * devicePixelRatio();
  const double screen_m =
      settings_.now().screen_height_m.value_or(screen()->physicalSize().height() / 1000.0);
  return screen_m * content().height() / screen_px;
}

void PatientWindow::initializeGL() {
  scene_ = std::make_unique<ObjectScene>();
  hand_scene_ = std::make_unique<HandScene>();
}

void PatientWindow::paintGL() {
  QElapsedTimer stopwatch;
  stopwatch.start();
  shown_ = presenter_.patient_view().picture(content_height_m());
  const PatientPicture& picture = shown_;
  const bool solid =
      picture.page == PatientPicture::Page::object || picture.page == PatientPicture::Page::hand;
  const QSize size = device_size();
  const QRect part = content();
  if (solid) {
    draw_scene(picture, part);
  } else {
    if (page_.size() != size) page_ = QImage(size, QImage::Format_RGB32);
    QPainter painter(&page_);
    if (part.size() != size) painter.fillRect(page_.rect(), ink::kPaper);
    paint_page(painter, part, picture);
  }
  // QPainter changes OpenGL's state, and the next 3D picture would be lit wrongly.
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  {
    QPainter painter(this);
    painter.scale(1.0 / devicePixelRatio(), 1.0 / devicePixelRatio());
    if (solid)
      draw_object(picture, part, painter);
    else
      painter.drawImage(0, 0, page_);
  }
  glPopClientAttrib();
  glPopAttrib();
  sound();
  ++pictures_;
  drawing_s_ += static_cast<double>(stopwatch.nsecsElapsed()) * 1e-9;
}

void PatientWindow::draw_scene(const PatientPicture& picture, const QRect& content) {
  const auto share = [](double value) { return static_cast<float>(value); };
  glClearColor(share(ink::kPaper.redF()), share(ink::kPaper.greenF()), share(ink::kPaper.blueF()),
               1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  // OpenGL counts pixels from the lower left.
  const auto from_below = [this](const QRect& part) {
    return QRect(part.x(), device_size().height() - part.y() - part.height(), part.width(),
                 part.height());
  };
  if (picture.page == PatientPicture::Page::hand) {
    hand_scene_->show(*picture.tracked_hand);
    hand_scene_->draw(from_below(hand_area(content).toRect()));
  } else {
    scene_->show(picture);
    scene_->draw(from_below(content));
  }
}

void PatientWindow::draw_footer(const PatientPicture& picture, const QRectF& area,
                                QPainter& painter) {
  const int height = static_cast<int>(std::ceil(kFooterShare * area.height()));
  const QString key =
      QStringLiteral("%1|%2x%3").arg(footer_key(picture)).arg(area.width()).arg(height);
  if (key != footer_key_) {
    footer_key_ = key;
    footer_ = QImage(static_cast<int>(area.width()), height, QImage::Format_RGB32);
    QPainter strip(&footer_);
    strip.translate(0, height - area.height());
    paint_footer(strip, area, picture);
  }
  painter.drawImage(QPointF(0, area.height() - height), footer_);
}

/// What belongs to the picture that was drawn just now.
void PatientWindow::sound() {
  const auto sounds = soundtrack_.next(shown_, presenter_.seating().presentation());
  speaker_.set_volume(settings_.now().volume_percent);
  if (sounds.tone) say_once(speaker_.play(*sounds.tone));
  if (sounds.words) say_once(speaker_.speak(QString::fromStdString(*sounds.words)));
  say_once(speaker_.hear(sounds.force));
}

/// There was no sound where there should have been one: the therapist is told once.
void PatientWindow::say_once(const QString& why) {
  if (why.isEmpty() || told_.contains(why)) return;
  told_ += why;
  Q_EMIT presenter_.flow().failed(why);
}

void PatientWindow::hideEvent(QHideEvent* event) {
  speaker_.be_silent();
  QOpenGLWindow::hideEvent(event);
}

void PatientWindow::draw_object(const PatientPicture& picture, const QRect& content,
                                QPainter& painter) {
  painter.translate(content.topLeft());
  const QSize size = content.size();
  const QRectF area(QPointF(0, 0), QSizeF(size));
  const bool hand = picture.page == PatientPicture::Page::hand;
  const auto project = [&](const Vec3& p_W) {
    if (!hand) return scene_->project(p_W, size);
    const QRect drawn = hand_area(area).toRect();
    return hand_scene_->project(p_W, drawn.size()) + drawn.topLeft();
  };
  const QString key =
      QStringLiteral("%1|%2|%3|%4|%5x%6")
          .arg(QString::fromStdString(picture.headline), QString::fromStdString(picture.detail))
          .arg(picture.targets_reached)
          .arg(2 * picture.example + picture.simulated)
          .arg(size.width())
          .arg(size.height());
  if (key != banner_key_) {
    banner_key_ = key;
    banner_ =
        QImage(size.width(), static_cast<int>(size.height() * kBannerShare), QImage::Format_RGB32);
    QPainter strip(&banner_);
    paint_banner(strip, area, picture);
    const int disc = size.height() / 20;
    check_ = QImage(disc, disc, QImage::Format_ARGB32_Premultiplied);
    check_.fill(Qt::transparent);
    QPainter mark(&check_);
    paint_check(mark, QPointF(disc / 2.0, disc / 2.0), 0.44 * disc);
  }
  for (const auto& finger : picture.fingers) {
    if (!finger.shown || !finger.touching) continue;
    constexpr double kBehindTip_m = 0.054;  // just behind the collar
    const auto place = project(finger.tip_W - kBehindTip_m * finger.axis_W);
    painter.drawImage(place - QPointF(check_.width() / 2.0, check_.height() / 2.0), check_);
  }
  if (picture.matched) {
    const int diameter = size.height() / 9;
    if (tick_.width() != diameter) {
      tick_ = QImage(diameter, diameter, QImage::Format_ARGB32_Premultiplied);
      tick_.fill(Qt::transparent);
      QPainter mark(&tick_);
      paint_check(mark, QPointF(diameter / 2.0, diameter / 2.0), 0.44 * diameter);
    }
    // Above the object, which is to be seen.
    const double above = hand ? 0.5 - kBelowHand : 1.9;
    const auto place = project(picture.X_WO.p);
    painter.drawImage(place - QPointF(diameter / 2.0, above * diameter), tick_);
  }
  if (picture.hold_fraction > 0.0) {
    const auto place = project(picture.ring_W);
    // Round the object, which is to be seen; a hand holds it from above, and its ring is below.
    double radius = 0.36 * size.height() / 8;
    double thick = 0.36;
    if (!hand && picture.scene != nullptr) {
      const Vec3 beside = picture.ring_W + 0.5 * picture.scene->size_m.norm() * Vec3::UnitX();
      radius = kRoundObject * (project(beside).x() - place.x());
      thick = 0.11;
    }
    const int diameter = 2 * static_cast<int>(std::ceil((1.0 + thick) * radius));
    if (ring_.width() != diameter)
      ring_ = QImage(diameter, diameter, QImage::Format_ARGB32_Premultiplied);
    ring_.fill(Qt::transparent);
    {
      QPainter round(&ring_);
      paint_hold_ring(round, QPointF(diameter / 2.0, diameter / 2.0), radius, picture.hold_fraction,
                      thick);
    }
    const double below = hand ? kBelowHand * size.height() / 8 : 0.0;
    painter.drawImage(place - QPointF(diameter / 2.0, diameter / 2.0 - below), ring_);
  }
  painter.drawImage(0, 0, banner_);
  if (hand) draw_footer(picture, area, painter);
  if (picture.notice != PatientPicture::Notice::none) {
    QImage notice(size, QImage::Format_ARGB32_Premultiplied);
    notice.fill(Qt::transparent);
    {
      QPainter over(&notice);
      paint_notice(over, area, picture);
    }
    painter.drawImage(0, 0, notice);
  }
}

void PatientWindow::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;  // a key, or a pedal, that is held presses once
  switch (event->key()) {
    case Qt::Key_F11: return toggle_full_screen();
    case Qt::Key_Escape: return showNormal();
    case Qt::Key_F8:
    case Qt::Key_F9:
    case Qt::Key_Space: return presenter_.trials().start_pause_resume();
    case Qt::Key_F10: return presenter_.trials().stop();
    default: QOpenGLWindow::keyPressEvent(event);
  }
}

}  // namespace isograsp::gui
