// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/consent_words.hpp"

#include <QCoreApplication>

#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct ConsentTexts {
  Q_DECLARE_TR_FUNCTIONS(Consent)
};

}  // namespace

QString purpose_words(std::string_view purpose) {
  if (purpose == "treatment") return ConsentTexts::tr("Treatment");
  if (purpose == "research") return ConsentTexts::tr("Research", "purpose");
  if (purpose == "teaching") return ConsentTexts::tr("Teaching");
  return qt(purpose);
}

QString basis_words(std::string_view basis) {
  if (basis == "consent") return ConsentTexts::tr("Consent");
  if (basis == "contract") return ConsentTexts::tr("Contract");
  if (basis == "legal_obligation") return ConsentTexts::tr("Legal obligation");
  if (basis == "vital_interests") return ConsentTexts::tr("Vital interests");
  if (basis == "public_interest") return ConsentTexts::tr("Public interest");
  if (basis == "legitimate_interest") return ConsentTexts::tr("Legitimate interest");
  if (basis == "care") return ConsentTexts::tr("Care");
  if (basis == "research") return ConsentTexts::tr("Research", "lawful basis");
  return qt(basis);
}

QString article_of(std::string_view basis) {
  if (basis == "consent") return ConsentTexts::tr("Art. 6 (1) a GDPR");
  if (basis == "contract") return ConsentTexts::tr("Art. 6 (1) b GDPR");
  if (basis == "legal_obligation") return ConsentTexts::tr("Art. 6 (1) c GDPR");
  if (basis == "vital_interests") return ConsentTexts::tr("Art. 6 (1) d GDPR");
  if (basis == "public_interest") return ConsentTexts::tr("Art. 6 (1) e GDPR");
  if (basis == "legitimate_interest") return ConsentTexts::tr("Art. 6 (1) f GDPR");
  if (basis == "care") return ConsentTexts::tr("Art. 9 (2) h GDPR");
  if (basis == "research") return ConsentTexts::tr("Art. 9 (2) j GDPR");
  return {};
}

QString answer_words(std::string_view state) {
  if (state == "given") return ConsentTexts::tr("given");
  if (state == "refused") return ConsentTexts::tr("refused");
  if (state == "withdrawn") return ConsentTexts::tr("withdrawn");
  return qt(state);
}

QString consent_words(const storage::Consent& consent) {
  const auto said = ConsentTexts::tr("%1 %2: %3 on %4 (%5)")
                        .arg(consent.state == "given" ? QStringLiteral("✓") : QStringLiteral("✗"),
                             purpose_words(consent.purpose), answer_words(consent.state),
                             translated_date(consent.on_date), basis_words(consent.basis));
  if (consent.recorded_by.empty()) return said;
  return ConsentTexts::tr("%1, recorded by %2").arg(said, qt(consent.recorded_by));
}

}  // namespace isograsp::gui
