// The language of the window.
#pragma once

#include <span>
#include <string_view>

#include <QTranslator>

namespace tactum {

/// The program's texts in one language. Whoever asks, the same English has the same words: the context that
/// Qt gives is not looked at. Thread: any, once it has begun.
class Language : public QTranslator {
    Q_OBJECT
public:
    /// `code`: as in "de"; whether the program has it.
    bool begin(const QString& code);

    QString translate(const char* context, const char* english, const char* comment = nullptr,
                      int count = -1) const override;
    bool isEmpty() const override { return false; }
};

/// A sentence that is made of such parts (see wordsOf()) and of what is the same in every language. Thread:
/// ui.
QString wordsInside(std::string_view english, std::span<const std::string_view> parts);

/// Installs the language that the person chose, with Qt's own words for its dialogs, before any widget is
/// made. English has words of its own where they depend on a number: "1 trial", "2 trials".
void applyLanguage();

} // namespace tactum
