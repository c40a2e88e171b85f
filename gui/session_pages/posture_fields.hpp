// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of posture and straps; of both hands those of one at a time, under its name.
#pragma once

#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <array>
#include <optional>
#include <string>

#include "gui/look/choice_box.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class PostureFields final : public QWidget {
  Q_OBJECT

 public:
  explicit PostureFields(SessionPresenter& presenter, QWidget* parent = nullptr);
  /// Shows what was said.
  void refresh();

 private:
  struct Field {
    ChoiceBox* choice = nullptr;  ///< null: it is written
    QLineEdit* written = nullptr;
    [[nodiscard]] QWidget* widget() const;
    [[nodiscard]] std::string value() const;
  };

  [[nodiscard]] QWidget* make_heads();
  [[nodiscard]] Field make_field(PostureItem item);
  /// The one hand, or the one of both whose fields are shown.
  [[nodiscard]] Hand hand() const;
  void show_hand(Hand hand);
  void say();
  void show_value(const Field& field, PostureItem item, const std::string& value) const;
  void name_fields();

  SessionPresenter& presenter_;
  QWidget* of_hands_;
  OfHands<QPushButton*> heads_{};
  std::array<Field, kPostureItems> fields_;
  Hand of_both_ = Hand::left;
  std::optional<Hand> seen_;  ///< whose values are in the fields
};

}  // namespace isograsp::gui
