// SPDX-License-Identifier: GPL-3.0-or-later
// The plotting library, which is written with the words that Qt adds to the language. Here they
// mean that for its header only: "signals" is a word of the store, "emit" one of everybody.
#pragma once

#include <QtCore/qglobal.h>
#include <QtCore/qobjectdefs.h>

#pragma push_macro("signals")
#pragma push_macro("slots")
#pragma push_macro("emit")
#pragma push_macro("foreach")
#define signals Q_SIGNALS
#define slots Q_SLOTS
#define emit
#define foreach Q_FOREACH
#include <qcustomplot.h>
#pragma pop_macro("signals")
#pragma pop_macro("slots")
#pragma pop_macro("emit")
#pragma pop_macro("foreach")
