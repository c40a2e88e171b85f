// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/patient_page.hpp"

#include <QApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>
#include <optional>

#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

namespace {

constexpr int kSessions_px = 316;
constexpr int kViews_px = 300;  // below the sessions
constexpr int kButtonEdges_px = 32;

struct LoadedCourse {
  std::shared_ptr<const PatientCourse> course;
  std::vector<MeasureTrend> trends;
};

QString sessions_words(int count) {
  return count == 1 ? QObject::tr("1 session") : QObject::tr("%1 sessions").arg(count);
}

QString date_of(const CourseSession& session) {
  return local_date(session.record.started_utc);
}

}  // namespace

PatientPage::PatientPage(Clinic& clinic, std::string library, QWidget* parent)
    : QWidget(parent), clinic_(clinic), library_(std::move(library)) {
  setObjectName("page");
  sessions_ = new CoursePanel;
  trends_ = new TrendGrid;
  comparison_ = new ComparisonPanel;
  trial_ = new TrialView;
  views_ = new QStackedWidget;
  views_->addWidget(trends_);
  views_->addWidget(comparison_);
  views_->addWidget(trial_);
  auto* body = new QBoxLayout(side_by_side());
  body->setSpacing(12);
  if (body->direction() == QBoxLayout::LeftToRight)
    sessions_->setFixedWidth(scaled(kSessions_px));
  else
    views_->setMinimumHeight(scaled(kViews_px));
  body->addWidget(sessions_);
  body->addWidget(views_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(10);
  column->addWidget(make_head());
  if (body->direction() != QBoxLayout::LeftToRight) column->addWidget(summary_);
  column->addLayout(body, 1);
  connect(sessions_, &CoursePanel::trial_opened, this, &PatientPage::open_trial);
  connect(&clinic_, &Clinic::opened, this, [this] {
    if (!code_.empty()) load();
  });
  switch_to(View::trends);
  tell();
}

QWidget* PatientPage::make_head() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(2, 0, 0, 0);
  row->setSpacing(12);
  title_ = new QLabel;
  title_->setObjectName("patient_title");
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() + 4.0);
  large.setBold(true);
  title_->setFont(large);
  summary_ = new QLabel;
  summary_->setObjectName("patient_summary");
  summary_->setProperty("role", "quiet");
  row->addWidget(title_);
  if (side_by_side() == QBoxLayout::LeftToRight)
    row->addWidget(summary_, 1);
  else
    row->addStretch(1);  // the summary follows in a line of its own
  choice_ = new QButtonGroup(this);
  const auto add = [&](View view, const QString& text, const char* name, int key,
                       const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setCheckable(true);
    QFont bold = font();  // of the chosen one
    bold.setBold(true);
    button->setMinimumWidth(QFontMetrics(bold).horizontalAdvance(text) + kButtonEdges_px);
    describe(*button, text, tip);
    choice_->addButton(button, static_cast<int>(view));
    row->addWidget(button);
    connect(new QShortcut(key, this), &QShortcut::activated, this,
            [this, view] { show_view(view); });
  };
  add(View::trends, tr("Progress"), "view_trends", Qt::Key_F4,
      tr("The main measures over the sessions (F4)"));
  add(View::comparison, tr("Compare"), "view_comparison", Qt::Key_F5,
      tr("Any two sessions side by side (F5)"));
  add(View::trial, tr("Trial"), "view_trial", Qt::Key_F6,
      tr("The opened trial: signals and replay (F6)"));
  connect(choice_, &QButtonGroup::idClicked, this,
          [this](int view) { show_view(static_cast<View>(view)); });
  return head;
}

void PatientPage::switch_to(View view) {
  views_->setCurrentIndex(static_cast<int>(view));
  choice_->button(static_cast<int>(view))->setChecked(true);
}

void PatientPage::show_view(View view) {
  switch_to(view);
  switch (view) {
    case View::trends: trends_->take_focus(); break;
    case View::comparison: comparison_->take_focus(); break;
    case View::trial: trial_->take_focus(); break;
  }
}

void PatientPage::show_patient(const std::string& code) {
  if (code != code_) {
    course_.reset();
    sessions_->show_course(nullptr);
    comparison_->show_course(nullptr);
    trends_->show_trends({});
    ++*wanted_trial_;
    loading_trial_ = false;
    trial_->show_problem(tr("Choose a trial at the left and open it with Enter."));
    switch_to(View::trends);
  }
  code_ = code;
  problem_.clear();
  load();
}

void PatientPage::load() {
  const int mine = ++*wanted_course_;
  loading_course_ = false;
  using Loaded = std::optional<Result<LoadedCourse>>;  // nothing: no longer wanted
  if (!code_.empty())
    loading_course_ = clinic_.read(
        this,
        [code = code_, mine, wanted = wanted_course_](storage::SessionStore& store) -> Loaded {
          if (*wanted != mine) return std::nullopt;
          auto course = read_course(store, code);
          if (!course) return course.error();
          LoadedCourse loaded;
          loaded.trends = choose_trends(*course);
          const auto verdicts = reports::gather_verdicts(store, code);
          if (!verdicts) return verdicts.error();
          add_verdicts(loaded.trends, *verdicts);
          loaded.course = std::make_shared<const PatientCourse>(*std::move(course));
          return loaded;
        },
        [this, mine](Loaded outcome) {
          if (*wanted_course_ != mine || !outcome) return;
          loading_course_ = false;
          if (*outcome) {
            course_ = (*outcome)->course;
            sessions_->show_course(course_);
            comparison_->show_course(course_);
            trends_->show_trends(std::move((*outcome)->trends));
          } else {
            problem_ = translated(outcome->error());
          }
          tell();
          Q_EMIT loaded();
        });
  tell();
}

void PatientPage::open_trial(int session_index, int trial_index) {
  if (course_ == nullptr) return;
  const auto& chosen = course_->sessions.at(static_cast<std::size_t>(session_index));
  const auto& record = chosen.trials.at(static_cast<std::size_t>(trial_index)).record;
  sessions_->choose(session_index, trial_index);
  show_view(View::trial);
  trial_->show_loading(tr("trial %1, %2").arg(record.number).arg(translated(record.task_name)));
  const int mine = ++*wanted_trial_;
  using Loaded = std::optional<Result<LoadedTrial>>;
  loading_trial_ = clinic_.read(
      this,
      [mine, wanted = wanted_trial_, course = course_, &chosen, &record,
       library = library_](storage::SessionStore& store) -> Loaded {
        if (*wanted != mine) return std::nullopt;
        return load_trial(store, chosen.record, record, library);
      },
      [this, mine](Loaded outcome) {
        if (*wanted_trial_ != mine || !outcome) return;
        loading_trial_ = false;
        if (*outcome) {
          trial_->show_trial(std::make_shared<const LoadedTrial>(**std::move(outcome)));
          // If another page was opened meanwhile, it stays open.
          if (views_->currentWidget() == trial_ && isAncestorOf(QApplication::focusWidget()))
            trial_->take_focus();
        } else {
          trial_->show_problem(
              tr("This trial cannot be read: %1").arg(translated(outcome->error())));
        }
        Q_EMIT trial_loaded();
      });
}

void PatientPage::tell() {
  title_->setText(code_.empty() ? tr("No patient") : QString::fromStdString(code_));
  if (!problem_.isEmpty()) {
    summary_->setText(tr("⚠ %1").arg(problem_));
  } else if (loading_course_) {
    summary_->setText(tr("Loading …"));
  } else if (code_.empty()) {
    summary_->setText(tr("Choose a patient to see what is stored."));
  } else if (course_ == nullptr) {
    summary_->setText(tr("The database is not open yet."));
  } else if (course_->sessions.empty()) {
    summary_->setText(tr("Nothing stored for this patient yet."));
  } else {
    int trials = 0;
    for (const auto& session : course_->sessions) trials += static_cast<int>(session.trials.size());
    summary_->setText(tr("%1, %2, from %3 to %4")
                          .arg(sessions_words(static_cast<int>(course_->sessions.size())),
                               trials_words(trials), date_of(course_->sessions.front()),
                               date_of(course_->sessions.back())));
  }
}

}  // namespace isograsp::gui
