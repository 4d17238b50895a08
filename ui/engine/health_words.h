// The state of the loops and of the guard in sentences.
#pragma once

#include <QString>

#include "core/runtime/channels.h"
#include "core/scene/scene.h"

namespace tactum {

/// What happened, what was done about it and how to go on: three sentences.
QString guardSentences(InhibitReason why);

/// The stiffness that is rendered at most, N/m, and what keeps it from being more.
struct CeilingNow {
    double value = 0;
    QString reason;    ///< "limited by ..."
    bool late = false; ///< by a servo that comes late: it changes from tick to tick
};
/// Before the first tick: what the device promises.
CeilingNow ceilingNow(const ServoTelemetry& servo, const DeviceInfo& device);

/// What is left out, and why.
QString fidelityWords(Fidelity fidelity);

/// "3 of our own, 12 of the machine's".
QString lateWords(const ServoTelemetry& servo, bool recorded = false);

/// The stiffest surface that can be felt.
struct Stiffest {
    double value = 0; ///< N/m; 0: there is none
    QString name;
};
Stiffest stiffestOf(const Scene& scene);

} // namespace tactum
