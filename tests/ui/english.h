// English as the program speaks it: "1 trial", "2 trials".
#pragma once

#include <QCoreApplication>

#include "ui/base/language.h"

namespace tactum::test {

/// From now on, in this process.
inline void speakEnglish() {
    static Language english;
    static const bool speaks =
        english.begin(QStringLiteral("en")) && QCoreApplication::installTranslator(&english);
    if (!speaks) qFatal("there are no words for numbers in English");
}

} // namespace tactum::test
