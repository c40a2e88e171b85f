// SPDX-License-Identifier: GPL-3.0-or-later
// What the library page does with files; all of it on its worker, in order.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "gui/library/library_use.hpp"
#include "gui/library_pages/library_page.hpp"
#include "gui/library_pages/library_preview.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

struct Opened {
  Result<std::string> text;
  std::optional<std::string> draft;
};

struct Checked {
  std::optional<Error> error;
  std::optional<LibraryPreview> preview;
};

QString file_name(const std::string& path) {
  return QString::fromStdString(fs::path(path).filename().string());
}

QString with_capital(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

void LibraryPage::show_kind(LibraryKind kind) {
  keep_draft_now();
  kind_ = kind;
  search_->clear();
  list_files("");
}

void LibraryPage::list_files(const std::string& path, bool select_name) {
  worker_.run([files = files_, kind = kind_] { return files.list(kind); },
              [this, path, select_name, kind = kind_,
               number = ++lists_](std::vector<LibraryEntry> entries) {
                if (number != lists_ || kind != kind_) return;
                entries_ = std::move(entries);
                const auto wanted =
                    std::find_if(entries_.begin(), entries_.end(),
                                 [&](const auto& entry) { return entry.path == path; });
                const bool stays = entry_ && wanted != entries_.end() && entry_->path == path;
                if (stays)
                  entry_ = *wanted;
                else if (!entries_.empty())
                  open(wanted == entries_.end() ? entries_.front() : *wanted, select_name);
                fill_list();
                refresh();
              });
  refresh();
}

void LibraryPage::choose_row(int row) {
  if (row < 0) return;
  const auto number = list_->item(row)->data(Qt::UserRole);
  if (!number.isValid()) return;
  const auto& entry = entries_[number.toUInt()];
  if (entry_ && entry.path == entry_->path) return;
  keep_draft_now();
  open(entry, false);
}

void LibraryPage::open(const LibraryEntry& entry, bool select_name) {
  keep_draft_now();
  check_soon_.stop();
  entry_ = entry;
  former_.clear();
  error_.reset();
  loaded_ = checked_ = false;
  remark_->setText(std::exchange(remark_of_new_, {}));
  problem_->clear();
  go_to_->hide();
  showing_ = true;
  editor_->show_text("");
  showing_ = false;
  worker_.run(
      [files = files_, entry] {
        return Opened{files.read(entry), files.draft(entry)};
      },
      [this, select_name, number = ++opened_](const Opened& opened) {
        if (number != opened_) return;
        if (!opened.text) {
          error_ = opened.text.error();
          show_checked(error_);
          return;
        }
        loaded_ = true;
        former_ = *opened.text;
        showing_ = true;
        editor_->show_text(QString::fromStdString(former_));
        former_shown_ = text();
        // A draft from before the program ended is shown as if it had been typed now.
        if (opened.draft) editor_->replace_text(QString::fromStdString(*opened.draft));
        showing_ = false;
        refresh();  // it can be typed into from now on
        if (select_name && body_->currentIndex() == 0) editor_->select_name();
        if (select_name && body_->currentIndex() != 0) postures_->editor().select_name();
        if (opened.draft && *opened.draft != former_)
          remark_->setText(tr("Your unsaved changes are here again. Revert takes them back."));
        check();
      });
  refresh();
}

void LibraryPage::text_changed() {
  if (!entry_ || showing_) return;
  checked_ = false;
  remark_->clear();
  check_soon_.start();
  if (entry_->own) draft_soon_.start();
  refresh();
}

void LibraryPage::check() {
  check_soon_.stop();
  if (!entry_) return;
  worker_.run(
      [files = files_, entry = *entry_, text = text()]() -> Checked {
        if (auto good = files.check(entry.kind, text, entry.path); !good)
          return {good.error(), std::nullopt};
        Checked checked;
        checked.preview = preview_of(entry.kind, text, entry.path, files.shipped());
        if (auto good = files.check_name(entry.kind, text, entry.path); !good && entry.own)
          checked.error = good.error();
        return checked;
      },
      [this, number = ++checks_, opened = opened_](const Checked& checked) {
        if (number != checks_ || opened != opened_) return;
        if (checked.preview) view_->show_preview(*checked.preview);
        view_->show_outdated(!checked.preview);
        checked_ = !check_soon_.isActive();
        show_checked(checked.error);
      });
}

void LibraryPage::show_checked(const std::optional<Error>& error) {
  error_ = error;
  const bool here = error && entry_ && (error->file == entry_->path || error->file.empty());
  const auto line = here ? error->line : std::nullopt;
  editor_->mark_line(line);
  go_to_->setVisible(line.has_value());
  if (!error) {
    problem_->setText(tr("✓ It can be used."));
    problem_->setStyleSheet(QStringLiteral("color: %1").arg(look::kReady.name()));
  } else {
    // "Line 7, friction: is missing. Write …"
    QString place;
    if (!here) place = file_name(error->file);
    if (error->line) place += (place.isEmpty() ? tr("Line %1") : tr(", line %1")).arg(*error->line);
    if (!error->field.empty())
      place += (place.isEmpty() ? QString() : QStringLiteral(", ")) +
               QString::fromStdString(error->field);
    QString words = place.isEmpty() ? with_capital(translated(error->what))
                                    : place + QStringLiteral(": ") + translated(error->what);
    if (!error->remedy.empty())
      words += QStringLiteral(". ") + with_capital(translated(error->remedy));
    words = QStringLiteral("⚠ ") + words + QStringLiteral(".");
    problem_->setText(
        line ? QStringLiteral("<a href=\"line\" style=\"color:%1;text-decoration:none\">"
                              "%2</a>")
                   .arg(look::kFault.name(), words.toHtmlEscaped())
             : words);
    problem_->setStyleSheet(QStringLiteral("color: %1").arg(look::kFault.name()));
  }
  refresh();
}

void LibraryPage::keep_draft_now() {
  draft_soon_.stop();
  if (!entry_ || !entry_->own || !loaded_ || saving_) return;
  const bool differs = modified();
  const bool was = entry_->draft;
  if (!differs && !was) return;
  entry_->draft = differs;
  for (auto& entry : entries_)
    if (entry.path == entry_->path) entry.draft = differs;
  if (differs != was) fill_list();
  worker_.run(
      [files = files_, entry = *entry_, text = text(), differs]() -> Result<void> {
        if (differs) return files.keep_draft(entry, text);
        files.drop_draft(entry);
        return {};
      },
      [this](const Result<void>& kept) {
        if (!kept) say(tr("Not kept: %1").arg(translated(kept.error())));
      });
}

void LibraryPage::duplicate() {
  if (!entry_ || !loaded_) return;
  keep_draft_now();
  using Made = Result<LibraryEntry>;
  worker_.run([files = files_, entry = *entry_,
               text = text()]() -> Made { return files.duplicate(entry, text); },
              [this](const Made& made) {
                if (!made) return say(translated(made.error()));
                search_->clear();
                presenter_.library().reload();
                list_files(made->path, true);
              });
}

/// With a posture that was recorded: there at once, as a duplicate is.
void LibraryPage::add_file(const QString& text, const QString& remark) {
  keep_draft_now();
  remark_of_new_ = remark;
  using Made = Result<LibraryEntry>;
  worker_.run(
      [files = files_, text = text.toStdString()]() -> Made {
        return files.add(LibraryKind::postures, "recorded", text);
      },
      [this](const Made& made) {
        if (!made) return say(translated(made.error()));
        postures_->made(made->path);
        search_->clear();
        list_files(made->path, true);
      });
}

void LibraryPage::save() {
  if (!save_->isEnabled()) return;
  keep_draft_now();  // it may not be saved after all
  saving_ = true;
  editor_->setFocus();
  refresh();
  const auto save_as = [this, entry = *entry_, former = former_, now = text()](FileUse use) {
    using Saved = Result<LibraryFiles::Saved>;
    worker_.run([files = files_, entry, former, now,
                 use]() -> Saved { return files.save(entry, former, now, use); },
                [this, entry, now](const Saved& saved) {
                  saving_ = false;
                  if (saved) return show_saved(entry, *saved, now);
                  say(tr("Not saved: %1").arg(translated(saved.error())));
                });
  };
  const bool asked = clinic_.read(
      this,
      [kind = entry_->kind, former = former_, now = text(),
       planned = presenter_.state().session_open() &&
                 presenter_.state().has_protocol()](storage::SessionStore& store) {
        auto use = use_of(store, kind, former, now);
        if (use && planned) count_as_used(*use, kind, former, now);
        return use;
      },
      [this, save_as](const Result<FileUse>& use) {
        if (use) return save_as(*use);
        saving_ = false;
        say(tr("Not saved: %1").arg(translated(use.error())));
      });
  if (asked) return;
  saving_ = false;
  say(tr("Not saved: the database is not open, so that nobody knows what trials used."));
}

void LibraryPage::show_saved(const LibraryEntry& entry, const LibraryFiles::Saved& saved,
                             const std::string& sent) {
  presenter_.library().reload();
  if (!entry_ || entry_->path != entry.path) return;  // another one was chosen meanwhile
  former_ = saved.text;
  entry_->draft = false;
  if (saved.text != sent && text() == sent) {
    const int place = editor_->textCursor().position();
    showing_ = true;
    editor_->replace_text(QString::fromStdString(saved.text));
    showing_ = false;
    auto cursor = editor_->textCursor();
    cursor.setPosition(std::min(place, editor_->document()->characterCount() - 1));
    editor_->setTextCursor(cursor);
  }
  former_shown_ = saved.text == sent ? sent : text();
  check();
  list_files(entry_->path);
  if (saved.raised)
    say(tr("Saved as version %1: trials were recorded with the former text, which is kept.")
            .arg(saved.version));
  else if (!saved.kept.empty() && entry.kind == LibraryKind::postures)
    say(tr("Saved. Trials were recorded with the former postures, which are kept as %1: with these "
           "a new series begins.")
            .arg(file_name(saved.kept)));
  else if (!saved.kept.empty())
    say(tr("Saved. The former text was used and is kept as %1.").arg(file_name(saved.kept)));
  else
    say(tr("Saved."));
}

void LibraryPage::revert() {
  if (!modified()) return;
  worker_.run([files = files_, entry = *entry_] { return files.read(entry); },
              [this, number = opened_](const Result<std::string>& text) {
                if (number != opened_) return;
                if (!text) return say(translated(text.error()));
                former_ = *text;
                editor_->replace_text(QString::fromStdString(former_));
                former_shown_ = this->text();
                check();
                keep_draft_now();
              });
}

void LibraryPage::remove() {
  if (!entry_ || !entry_->own) return;
  keep_draft_now();
  using Put = Result<std::string>;
  worker_.run([files = files_, entry = *entry_]() -> Put { return files.remove(entry); },
              [this, entry = *entry_](const Put& put) {
                if (!put) return say(translated(put.error()));
                removed_ = Removed{entry, *put};
                entry_.reset();
                loaded_ = false;
                presenter_.library().reload();
                list_files("");
              });
}

void LibraryPage::bring_back() {
  if (!removed_) return;
  worker_.run(
      [files = files_, removed = *removed_]() -> Result<void> {
        return files.bring_back(removed.place, removed.entry);
      },
      [this, entry = removed_->entry](const Result<void>& done) {
        if (!done) return say(translated(done.error()));
        removed_.reset();
        kind_ = entry.kind;
        presenter_.library().reload();
        list_files(entry.path);
      });
}

}  // namespace isograsp::gui
