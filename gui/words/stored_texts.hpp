// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences that stand in a database, or come from it, as English text: the translations know
// "Drifted by 0.2 N." as "Drifted by %1 N.". Everything else is a Text (core/text.hpp).
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace isograsp::gui {

/// The text with %1, %2 … for its numbers, which go behind those in `numbers`.
[[nodiscard]] QString without_numbers(const QString& text, QStringList& numbers);
/// The words with `values` at their places %1, %2 …
[[nodiscard]] QString filled(const QString& words, const QStringList& values);

/// In the language of the screen: as a whole, by its numbers, or sentence by sentence. What is not
/// known stays as it is.
[[nodiscard]] QString stored_text(const QString& english);

}  // namespace isograsp::gui
