#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh INIT STATE TESTS: runs the program TESTS where there is a kernel CAN bus. STATE lets the
# guest kernel run on processors newer than itself. 77 = skipped.
set -u
init=$1
state=$2
tests=$3

# A bus of this kernel's own: needs the vcan module and the right to add interfaces.
own=isograsp-vcan
if ip link add dev "$own" type vcan 2>/dev/null; then
  trap 'ip link delete dev "$own" 2>/dev/null' EXIT
  ip link set "$own" up
  ISOGRASP_CAN_INTERFACE=$own "$tests"
  exit $?
fi

uml=$(command -v linux.uml || true)
if [ -z "$uml" ] || ! ls /usr/lib/uml/modules/*/kernel/drivers/net/can/vcan.ko >/dev/null 2>&1; then
  echo "No CAN bus: this kernel has no vcan and the package user-mode-linux is not installed."
  echo "Run scripts/setup, or: sudo modprobe vcan"
  [ "${CI:-}" = true ] && exit 1
  exit 77
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
# One processor: the host stops the guest at every call of its kernel, and to hand it from one
# processor to another costs up to forty times more.
processor=$(taskset -cp $$ | sed 's/.*[^0-9]//')
# Boots the guest; true if the tests passed there. The root is the host's own file tree, read-only;
# /mnt is the guest's. Words behind -- go to init. More urgent than a busy computer's other work,
# where that is allowed.
passes() {
  nice -n -20 taskset -c "$processor" \
    env LD_PRELOAD="$state" "$uml" mem=384M rootfstype=hostfs rootflags=/ ro init="$init" con=null con0=null,fd:1 quiet \
    ${ISOGRASP_LONG:+"ISOGRASP_LONG=1"} -- "$tests" </dev/null >"$log" 2>&1
  tr -d '\r' <"$log"
  grep -q '^guest: exit status 77' "$log" && exit 77
  if grep -q '^userspace - ptrace set fp regs failed' "$log"; then
    echo "run.sh: this guest kernel does not run on this processor"
    exit 77
  fi
  grep -q '^guest: exit status 0' "$log"
}
# A computer shared with others can stand still once; a fault of ours comes again.
passes || { echo "run.sh: once more"; passes; }
