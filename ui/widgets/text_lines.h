// A text in as many lines as it is given.
#pragma once

#include <QFont>
#include <QStringList>

namespace tactum {

/// In lines of that width, `most` of them; what has no room ends with dots.
QStringList linesOf(const QString& text, const QFont& font, int width, int most);

} // namespace tactum
