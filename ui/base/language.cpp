#include "ui/base/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

#include "ui/base/preferences.h"
#include "ui/base/words.h"

// Outside of any namespace, as Qt wants it.
static void initTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace tactum {

namespace {

// Of all texts: see resources/translations/update.
constexpr auto kContext = "Tactum";

QString chosenCode() {
    switch (Preferences::instance().choice<LanguageChoice>(Preferred::Language)) {
    case LanguageChoice::English:
        return QStringLiteral("en");
    case LanguageChoice::German:
        return QStringLiteral("de");
    case LanguageChoice::System:
        break;
    }
    return QLocale::system().language() == QLocale::German ? QStringLiteral("de") : QStringLiteral("en");
}

} // namespace

QString wordsInside(std::string_view english, std::span<const std::string_view> parts) {
    QString text = asIs(english);
    for (const std::string_view part : parts)
        text.replace(asIs(part), wordsOf(part));
    return text;
}

bool Language::begin(const QString& code) {
    initTranslations();
    return load(QStringLiteral(":/translations/tactum_%1.qm").arg(code));
}

QString Language::translate(const char*, const char* english, const char* comment, int count) const {
    return QTranslator::translate(kContext, english, comment, count);
}

void applyLanguage() {
    const QString code = chosenCode();
    static QTranslator qt;
    if (qt.load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qt);
    static Language language;
    if (language.begin(code)) QCoreApplication::installTranslator(&language);
}

} // namespace tactum
