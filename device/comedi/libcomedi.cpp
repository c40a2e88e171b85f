// SPDX-License-Identifier: GPL-3.0-or-later
// A card behind libcomedi.
#include <cerrno>
#include <utility>

#include <comedilib.h>

#include "device/comedi/comedi_card.hpp"

namespace isograsp {

namespace {

struct Close {
  void operator()(comedi_t* card) const noexcept { comedi_close(card); }
};
using Handle = std::unique_ptr<comedi_t, Close>;

class LibComediCard final : public ComediCard {
 public:
  LibComediCard(std::string path, Handle card) : path_(std::move(path)), card_(std::move(card)) {}

  Reading read(unsigned subdevice, unsigned channel, std::uint32_t& sample) noexcept override {
    if (!card_) return Reading::failed;
    constexpr unsigned kRange = 0;
    lsampl_t value = 0;
    if (comedi_data_read(card_.get(), subdevice, channel, kRange, AREF_GROUND, &value) == 1) {
      sample = value;
      return Reading::good;
    }
    return comedi_errno() == EAGAIN ? Reading::not_ready : Reading::failed;
  }
  unsigned subdevices() noexcept override {
    return card_ ? positive(comedi_get_n_subdevices(card_.get())) : 0;
  }
  unsigned channels(unsigned subdevice) noexcept override {
    return card_ ? positive(comedi_get_n_channels(card_.get(), subdevice)) : 0;
  }
  std::uint32_t highest_sample(unsigned subdevice, unsigned channel) noexcept override {
    return card_ ? comedi_get_maxdata(card_.get(), subdevice, channel) : 0;
  }
  std::optional<Range> range(unsigned subdevice, unsigned channel) noexcept override {
    const comedi_range* found =
        card_ ? comedi_get_range(card_.get(), subdevice, channel, 0) : nullptr;
    if (found == nullptr) return std::nullopt;
    return Range{found->min, found->max};
  }
  bool reopen() noexcept override {
    card_.reset();
    card_.reset(comedi_open(path_.c_str()));
    return card_ != nullptr;
  }

 private:
  [[nodiscard]] static unsigned positive(int count) noexcept {
    return count > 0 ? static_cast<unsigned>(count) : 0;
  }

  std::string path_;
  Handle card_;
};

}  // namespace

Result<std::unique_ptr<ComediCard>> open_comedi_card(const std::string& path) {
  Handle card(comedi_open(path.c_str()));
  if (!card)
    return failed("the card cannot be opened: %1"_text(Known{comedi_strerror(comedi_errno())}),
                  "check that the driver jr3_pci is loaded and that you may read the file"_text)
        .at(path);
  return std::unique_ptr<ComediCard>(std::make_unique<LibComediCard>(path, std::move(card)));
}

}  // namespace isograsp
