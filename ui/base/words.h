// Words that a table of the program holds in English, as the person reads them.
#pragma once

#include <string>
#include <string_view>

#include <QObject>
#include <QString>

namespace tactum {

/// A label, a unit's word or a sentence in the language that is on; as it is where that has no other words
/// for it. What a person wrote (names of objects, of presets) is none. Thread: ui.
inline QString wordsOf(std::string_view english) {
    return english.empty() ? QString() : QObject::tr(std::string(english).c_str());
}

/// What is the same in every language: a key, a name. Thread: any.
inline QString asIs(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

} // namespace tactum
