// SPDX-License-Identifier: GPL-3.0-or-later
// gui_screenshots FOLDER [LANGUAGE]: runs a session with the simulated patient and makes pictures
// of both windows in their states. Needs a display with OpenGL (scripts/screenshots gives it Xvfb).
#include <QDir>
#include <QPainter>
#include <QTabWidget>
#include <cstdio>

#include "gui/library_pages/posture_view.hpp"
#include "gui/look/page_view.hpp"
#include "gui/words/texts.hpp"
#include "operator.hpp"
#include "session/protocol/protocol_run.hpp"
#include "short_library.hpp"
#include "storage/access/open_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test {
namespace {

constexpr const char* kHealthy = "sim://healthy?seed=7";

/// Earlier sessions of the patient, in virtual time, so that the history shows something.
void make_history(const std::string& database, const std::string& code,
                  const std::string& library) {
  const auto protocol = session::read_protocol(library + "/protocols/demonstration.toml", library);
  ASSERT_TRUE(protocol.ok());
  for (const char* seed : {"3", "4", "5"}) {
    session::SessionConfig config;
    config.database = database;
    config.patient_code = code;
    config.device_uri = std::string("sim://healthy?seed=") + seed;
    config.library = library;
    config.virtual_time = true;
    config.started_utc = std::string("2026-03-0") + seed + "T09:30:00Z";
    auto session = session::Session::open(config);
    ASSERT_TRUE(session.ok()) << session.error().message();
    ASSERT_TRUE(session::run_protocol(**session, *protocol, [](const auto&) {}).ok());
  }
  auto store = storage::open_store(database, storage::OpenMode::existing);
  ASSERT_TRUE(store.ok());
  storage::PrimaryMeasure primary;
  primary.task_name = "Maximum grip force";
  primary.measure = "maximum_force";
  primary.channel = "grip";
  primary.chosen_by = "Ada";
  ASSERT_TRUE(
      (*store)->add_primary_measure((*store)->find_patient(code)->value().id, primary).ok());
}

class Photographer {
 public:
  Photographer(Windows& windows, QString folder) : windows_(windows), folder_(std::move(folder)) {}

  void take_therapist(const char* name) const {
    QTest::qWait(100);  // the page finds its sizes
    auto& window = windows_.therapist();
    QImage image = window.grab().toImage();
    auto& view = widget_called<PostureView>("posture_view", window);
    if (view.isVisible() && view.solid() != nullptr) {
      const auto& place = widget_called<QWidget>("posture_solid", window);
      QPainter(&image).drawImage(QRect(place.mapTo(&window, QPoint()), place.size()),
                                 view.solid()->grabFramebuffer());
    }
    save(image, name);
  }
  void take_patient(const char* name) const {
    QTest::qWait(60);
    save(windows_.patient()->grabFramebuffer(), name);
  }
  void take_both(const char* name) const {
    take_therapist((std::string("therapist_") + name).c_str());
    take_patient((std::string("patient_") + name).c_str());
  }

 private:
  void save(const QImage& image, const char* name) const {
    const auto path = QStringLiteral("%1/%2.png").arg(folder_, name);
    constexpr int kSmallest = 0;  // of the file, by more work
    image.convertToFormat(QImage::Format_RGB32).save(path, "PNG", kSmallest);
    std::printf("%s\n", qPrintable(path));
  }

  Windows& windows_;
  QString folder_;
};

/// The three-dimensional picture is a window of its own: it is put where it stands.
void photograph_postures(const Operator& therapist, const Photographer& photographer) {
  therapist.press("library_postures");
  auto& list = therapist.find<QListWidget>("posture_list");
  ASSERT_TRUE(wait_until([&] { return list.isVisible() && list.count() > 3; }));
  therapist.press("library_duplicate");
  ASSERT_TRUE(wait_until([&] { return therapist.find<QWidget>("posture_turn_x_on").isEnabled(); }));
  list.setCurrentRow(7);
  list.setFocus();
  photographer.take_therapist("therapist_postures");
}

void photograph(const QString& output, const std::string& language) {
  TemporaryFolder folder;
  const auto library = make_short_library(folder, "30");
  shorten_rests(library, "demonstration.toml");
  const auto database = folder.path("clinic.db");
  {
    auto store = storage::open_store(database, storage::OpenMode::create);
    ASSERT_TRUE(store.ok());
    for (const char* code : {"P-4T8R2", "P-6K3W9", "P-7M2H5"})
      ASSERT_TRUE((*store)->add_patient(code).ok());
  }
  make_history(database, "P-7M2H5", library);

  GuiConfig config{database, kHealthy, library, "isograsp"};
  config.settings = folder.write("isograsp.ini", "[General]\nlanguage=" + language);
  Windows windows(settling_soon(config));
  const Operator therapist(windows);
  const Photographer photographer(windows, output);
  windows.show();
  windows.show_patient_screen();
  ASSERT_NE(windows.patient(), nullptr);
  ASSERT_TRUE(wait_until([&] { return windows.clinic().is_open(); }));
  QTest::qWait(300);
  photographer.take_both("start");

  auto& presenter = windows.presenter();
  therapist.find<QListWidget>("patient_list").setCurrentRow(0);
  ASSERT_TRUE(wait_until([&] { return !windows.clinic().history_loading(); }));
  therapist.press("begin_P-7M2H5");
  photographer.take_therapist("therapist_hand");
  therapist.press("hand_right");
  photographer.take_therapist("therapist_screening");
  therapist.press("screening_clear");
  for (std::size_t i = 0; i < presenter.state().library.protocols.size(); ++i)
    if (presenter.state().library.protocols[i].spec.file.find("demonstration") != std::string::npos)
      presenter.choices().choose_protocol(static_cast<int>(i));
  QTest::qWait(300);
  photographer.take_therapist("therapist_device");
  therapist.press("connect");
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_zero; }));
  QTest::qWait(1200);
  photographer.take_both("connected");
  therapist.press("zero");
  photographer.take_therapist("therapist_confirm");
  ASSERT_TRUE(wait_until([&] { return presenter.state().snapshot().zeroed; }));
  QTest::qWait(200);
  photographer.take_both("zeroed");
  therapist.press("posture_edit");
  QTest::qWait(100);
  photographer.take_therapist("therapist_posture");
  therapist.press("posture_edit");
  therapist.press("strapped");  // the resting force follows by itself
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stop; }));
  QTest::qWait(800);
  photographer.take_both("rest");

  const auto wait_for = [&](const char* name, double task_time_s) {
    return wait_until(
        [&] {
          const auto& now = presenter.state().snapshot();
          return now.stage == session::Stage::trial && now.task.task_time_s > task_time_s &&
                 presenter.flow().view().sentence.find(translated(name).toStdString()) !=
                     std::string::npos;
        },
        180);
  };
  ASSERT_TRUE(wait_until([&] { return presenter.flow().view().may_stand_by; }, 60));
  QTest::qWait(1500);
  photographer.take_both("next");
  ASSERT_TRUE(wait_for("Maximum grip force", 2.6));
  photographer.take_both("maximum");
  ASSERT_TRUE(wait_for("Grip force, sine", 11.2));
  photographer.take_therapist("therapist");
  photographer.take_patient("patient_force");
  Presentation presentation;
  presentation.half = Presentation::Half::left;
  presenter.seating().say_presentation(presentation);
  photographer.take_patient("patient_half");
  presentation = {};
  presentation.calm = true;
  presenter.seating().say_presentation(presentation);
  photographer.take_patient("patient_calm");
  presenter.seating().say_presentation({});
  therapist.press("pause");
  QTest::qWait(300);
  photographer.take_both("paused");
  therapist.press("pause");  // now Resume
  ASSERT_TRUE(wait_for("Two targets", 1.2));
  photographer.take_patient("patient_transport");
  ASSERT_TRUE(wait_until([&] {
    const auto& task = presenter.state().snapshot().task;
    return task.target_index == 1 && task.hold_fraction > 0.4;
  }));
  photographer.take_patient("patient_object");
  presentation.half = Presentation::Half::right;
  presenter.seating().say_presentation(presentation);
  photographer.take_patient("patient_object_half");
  presenter.seating().say_presentation({});
  photographer.take_therapist("therapist_object");
  windows.therapist().resize(1920, 1080);
  QTest::qWait(300);
  photographer.take_therapist("therapist_large");
  windows.therapist().resize(1280, 720);
  QTest::qWait(100);
  const auto rate = windows.patient()->rate();
  std::printf("patient screen: %lld pictures, %.1f ms each\n", rate.pictures, rate.mean_s * 1e3);
  ASSERT_TRUE(wait_until([&] { return presenter.state().zero_is_next(); }, 120));
  QTest::qWait(200);
  photographer.take_both("hand_out");
  therapist.set_zero();
  ASSERT_TRUE(wait_until([&] { return presenter.state().guide().over(); }));
  QTest::qWait(200);
  photographer.take_both("over");
  therapist.press("by_hand");
  QTest::qWait(200);
  photographer.take_therapist("therapist_by_hand");

  windows.therapist().show_page(TherapistWindow::Page::patient);
  QTest::qWait(1500);
  photographer.take_therapist("therapist_patient");
  therapist.find<QTabWidget>("patient_tabs").setCurrentIndex(1);
  QTest::qWait(500);
  photographer.take_therapist("therapist_person");
  windows.therapist().show_page(TherapistWindow::Page::device);
  therapist.press("check_begin");
  QTest::qWait(1600);
  photographer.take_therapist("therapist_check");
  therapist.press("check_begin");  // now Stop
  windows.therapist().show_page(TherapistWindow::Page::reports);
  auto& pages = therapist.find<PageView>("report_pages");
  ASSERT_TRUE(wait_until([&] { return pages.isVisible() && pages.complete(); }));
  photographer.take_therapist("therapist_reports");
  therapist.find<QTabWidget>("report_tabs").setCurrentIndex(1);
  ASSERT_TRUE(wait_until([&] { return therapist.find<QListWidget>("export_files").count() > 0; }));
  photographer.take_therapist("therapist_export");
  windows.therapist().show_page(TherapistWindow::Page::library);
  auto& files = therapist.find<QListWidget>("library_list");
  ASSERT_TRUE(wait_until([&] { return files.count() > 30; }));
  for (int row = 0; row < files.count(); ++row)
    if (files.item(row)->text().trimmed() == "Grip force, trapezoid") files.setCurrentRow(row);
  QTest::qWait(800);
  photographer.take_therapist("therapist_library");
  photograph_postures(therapist, photographer);
  windows.therapist().show_page(TherapistWindow::Page::settings);
  QTest::qWait(200);
  photographer.take_therapist("therapist_settings");
  windows.therapist().show_page(TherapistWindow::Page::session);
  therapist.disconnect();

  // A silent sensor: the trial waits and both screens say why.
  therapist.press("hand_right");
  therapist.press("screening_clear");
  presenter.choices().choose_device("replay://" + write_recording_with_gap(folder));
  therapist.press("connect");
  therapist.start_task();
  ASSERT_TRUE(
      wait_until([&] { return presenter.state().snapshot().stage == session::Stage::paused; }));
  QTest::qWait(300);
  photographer.take_both("fault");
  presenter.connecting().end_session();
  ASSERT_TRUE(wait_until([&] { return !presenter.state().busy(); }));

  // An arm, whose task the patient watches.
  therapist.press("hand_right");
  therapist.choose_device("sim://arm?patient=healthy&seed=7");
  presenter.choices().choose_protocol(std::nullopt);
  therapist.choose_task("pose_matching");
  therapist.press("show_how");
  ASSERT_TRUE(wait_until([&] {
    const auto picture = presenter.patient_view().picture(0.3);
    return picture.example && picture.target_shown;
  }));
  photographer.take_both("demonstration");
  therapist.press("show_how");
  therapist.choose_device(kHealthy);

  // Every page with letters of twice the size.
  Settings settings;
  settings.font_percent = limits::kLargestFont_percent;
  windows.settings().change(settings);
  QTest::qWait(300);
  for (int page = 0; page <= static_cast<int>(TherapistWindow::Page::settings); ++page) {
    windows.therapist().show_page(static_cast<TherapistWindow::Page>(page));
    QTest::qWait(500);
    photographer.take_therapist(qPrintable(QStringLiteral("letters_200_%1").arg(page + 1)));
  }
}

}  // namespace
}  // namespace isograsp::gui::test

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: gui_screenshots FOLDER [LANGUAGE]\n");
    return 2;
  }
  ::testing::InitGoogleTest();
  isograsp::gui::test::application();
  QDir().mkpath(argv[1]);
  isograsp::gui::test::photograph(argv[1], argc == 3 ? argv[2] : "en");
  return ::testing::Test::HasFailure() ? 1 : 0;
}
