// SPDX-License-Identifier: GPL-3.0-or-later
// Work that may take long leaves the GUI thread: one worker, jobs in order, results come back as
// events. Jobs must not touch widgets.
#pragma once

#include <QMetaObject>
#include <QObject>
#include <QThreadPool>
#include <memory>
#include <type_traits>
#include <utility>

namespace isograsp::gui {

class Background : public QObject {
 public:
  explicit Background(QObject* parent = nullptr) : QObject(parent) {
    pool_.setMaxThreadCount(1);
    pool_.setExpiryTimeout(-1);
  }
  /// Waits for the jobs; results that have not been received yet are dropped.
  ~Background() override { pool_.waitForDone(); }

  /// Runs `work()` on the worker, then `done(result)` on the thread of this object. What `work`
  /// captured is destroyed on the worker.
  template <class Work, class Done>
  void run(Work work, Done done) {
    auto job = std::make_shared<Work>(std::move(work));
    pool_.start([this, job = std::move(job), done = std::move(done)]() mutable {
      using Outcome = std::invoke_result_t<Work>;
      auto outcome = std::make_shared<Outcome>((*job)());
      job.reset();
      QMetaObject::invokeMethod(
          this, [outcome, done = std::move(done)]() mutable { done(std::move(*outcome)); },
          Qt::QueuedConnection);
    });
  }

 private:
  QThreadPool pool_;
};

}  // namespace isograsp::gui
