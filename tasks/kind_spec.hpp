// SPDX-License-Identifier: GPL-3.0-or-later
// What a task asks, of whichever kind: the spec of that kind and the facts about the kind. A value
// like any other: a copy shares nothing, and reading it neither allocates nor locks.
#pragma once

#include <any>
#include <concepts>
#include <utility>

#include "tasks/kind_facts.hpp"

namespace isograsp::tasks {

/// The spec of one kind: it names the facts about its kind.
template <class Spec>
concept SpecOfKind = std::same_as<decltype(Spec::kFacts), const KindFacts>;

class KindSpec {
 public:
  /// Of no kind: kNoKind.
  KindSpec() = default;
  template <SpecOfKind Spec>
  KindSpec(Spec spec) : facts_(&Spec::kFacts), spec_(std::move(spec)) {}

  [[nodiscard]] const KindFacts* operator->() const noexcept { return facts_; }
  [[nodiscard]] const KindFacts& operator*() const noexcept { return *facts_; }
  template <SpecOfKind Spec>
  [[nodiscard]] bool is() const noexcept {
    return facts_ == &Spec::kFacts;
  }

  // For the files of one kind; all others ask the facts.
  /// Null: of another kind.
  template <SpecOfKind Spec>
  [[nodiscard]] const Spec* get_if() const noexcept {
    return std::any_cast<Spec>(&spec_);
  }
  /// @pre is<Spec>()
  template <SpecOfKind Spec>
  [[nodiscard]] const Spec& as() const {
    return std::any_cast<const Spec&>(spec_);
  }
  template <SpecOfKind Spec>
  [[nodiscard]] Spec& as() {
    return std::any_cast<Spec&>(spec_);
  }

 private:
  const KindFacts* facts_ = &kNoKind;
  std::any spec_;
};

}  // namespace isograsp::tasks
