// What every field that searches means by its words.
#pragma once

#include <algorithm>

#include <QStringList>

namespace tactum {

inline QStringList searchWords(const QString& typed) {
    return typed.split(u' ', Qt::SkipEmptyParts);
}

/// Whether a text has all of them, in any case and order.
inline bool hasWords(const QString& text, const QStringList& words) {
    return std::ranges::all_of(words,
                               [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace tactum
