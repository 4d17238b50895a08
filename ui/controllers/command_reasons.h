// Why a command is off, in words.
#pragma once

#include <QString>

namespace tactum {

/// One sentence. `recordingShown`: a recording is seen in the document's place. Thread: ui.
QString whyOff(const QString& command, bool recordingShown);

} // namespace tactum
