// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/can_error.hpp"

#include <cassert>

#include <linux/can/error.h>

namespace isograsp {

CanErrorNews read_can_error(const BusFrame& frame) noexcept {
  assert(frame.error);
  CanErrorNews news;
  const unsigned controller = (frame.id & CAN_ERR_CRTL) != 0 ? frame.data[1] : 0U;
  const auto says = [&](unsigned bits) { return (controller & bits) != 0; };
  news.overflow = says(CAN_ERR_CRTL_RX_OVERFLOW | CAN_ERR_CRTL_TX_OVERFLOW);
  if ((frame.id & CAN_ERR_BUSOFF) != 0)
    news.state = BusEvent::bus_off;
  else if (says(CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE))
    news.state = BusEvent::error_passive;
  else if (says(CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING))
    news.state = BusEvent::error_warning;
  else if ((frame.id & CAN_ERR_RESTARTED) != 0)
    news.state = BusEvent::restarted;
  else if (says(CAN_ERR_CRTL_ACTIVE))
    news.state = BusEvent::error_active;
  return news;
}

}  // namespace isograsp
