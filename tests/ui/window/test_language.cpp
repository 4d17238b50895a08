// The window in German. The oracle of what has to be translated is lupdate, Qt's own reader of sources, and
// what the tables hold; that words are right no test can see.
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QMenuBar>
#include <QMutex>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/table_texts.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/language.h"
#include "ui/base/mnemonics.h"
#include "ui/base/preferences.h"

namespace test_language {

using namespace tactum;

namespace {

/// As the program's, and notes what it has no words for.
class NotingLanguage : public Language {
public:
    QString translate(const char* context, const char* english, const char* comment,
                      int count) const override {
        const QString words = Language::translate(context, english, comment, count);
        const QLatin1String asker(context);
        // Qt's own classes have words of their own, in another translator.
        if (words.isNull() &&
            (asker == QLatin1String("QObject") || asker.startsWith(QLatin1String("tactum::")))) {
            const QMutexLocker lock(&mutex_);
            missed_ << QString::fromUtf8(english);
        }
        return words;
    }
    QStringList missed() const {
        QStringList all = missed_;
        all.removeDuplicates();
        return all;
    }

private:
    mutable QMutex mutex_;
    mutable QStringList missed_;
};

struct Text {
    QString english;
    QStringList words; ///< several where they depend on a number
    bool finished = true;
};

QList<Text> textsOf(const QString& file) {
    QFile source(file);
    QList<Text> texts;
    if (!source.open(QIODevice::ReadOnly)) return texts;
    QXmlStreamReader xml(&source);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("source"))
            texts << Text{xml.readElementText(), {}};
        else if (xml.name() == QLatin1String("numerusform"))
            texts.back().words << xml.readElementText();
        else if (xml.name() == QLatin1String("translation")) {
            texts.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            if (!texts.back().english.contains(QStringLiteral("%n")))
                texts.back().words << xml.readElementText();
        }
    }
    return texts;
}

QStringList placesIn(const QString& text) {
    static const QRegularExpression kPlace(QStringLiteral("%L?[0-9n]+|</?[a-z0-9]+"));
    QStringList places;
    for (auto each = kPlace.globalMatch(text); each.hasNext();)
        places << each.next().captured();
    places.sort();
    return places;
}

bool hasMnemonic(QString text) {
    return text.remove(QStringLiteral("&&")).contains(u'&');
}

QStringList faultsOf(const Text& text) {
    QStringList faults;
    const auto fault = [&](const char* what) {
        faults << QLatin1String(what) + QStringLiteral(": ") + text.english;
    };
    if (!text.finished) fault("without words");
    for (const QString& words : text.words) {
        if (words.isEmpty() != text.english.isEmpty()) fault("empty");
        if (placesIn(words) != placesIn(text.english)) fault("other places");
        if (hasMnemonic(words) != hasMnemonic(text.english)) fault("letter");
        if (words.endsWith(u' ') != text.english.endsWith(u' ') ||
            words.startsWith(u' ') != text.english.startsWith(u' '))
            fault("space at an end");
        if (words.endsWith(QStringLiteral("...")) != text.english.endsWith(QStringLiteral("...")))
            fault("dots");
    }
    return faults;
}

} // namespace

class TestLanguage : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    const QString translations_ = QStringLiteral(TACTUM_RESOURCES "/translations");

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void everyTextHasWords();
    void nothingIsMissingOrGone();
    void theWindowIsGerman();
    void otherLanguagesStayEnglish();
};

void TestLanguage::everyTextHasWords() {
    const QList<Text> texts = textsOf(translations_ + QStringLiteral("/tactum_de.ts"));
    QCOMPARE_GT(texts.size(), 1000);
    QStringList faults;
    for (const Text& each : texts)
        faults << faultsOf(each);
    QCOMPARE(faults.join(u'\n'), QString());
}

void TestLanguage::nothingIsMissingOrGone() {
    QFile tables(folder_.filePath(QStringLiteral("tables.txt")));
    QVERIFY(tables.open(QIODevice::WriteOnly));
    for (const QString& text : tableTexts())
        tables.write(text.toUtf8() + '\n');
    tables.close();
    QProcess check;
    check.setProcessChannelMode(QProcess::MergedChannels);
    check.start(QStringLiteral("/usr/bin/python3"),
                {translations_ + QStringLiteral("/update"), QStringLiteral("--check"),
                 QStringLiteral("--tables"), tables.fileName()});
    QVERIFY(check.waitForFinished(kPatience));
    const QByteArray said = check.readAll();
    QVERIFY2(check.exitCode() == 0, said.constData());
    COMPARE_CONTAINS(said, QByteArray(" 0 without words, 0 that are gone"));
}

void TestLanguage::theWindowIsGerman() {
    NotingLanguage german;
    QVERIFY(german.begin(QStringLiteral("de")));
    QVERIFY(QCoreApplication::installTranslator(&german));
    {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        QCOMPARE(program.window->menuBar()->actions().front()->text(), QStringLiteral("&Datei"));
        for (auto* dock : program.window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            program.frames(2);
        }
        for (const char* id :
             {"select", "paint", "arrange", "layer-noise", "keyboard", "preferences", "palette"}) {
            program.command(id).trigger();
            program.frames(3);
        }
        program.type(QStringLiteral("stiffness"), QStringLiteral("500"));
        for (auto* menu : program.window->findChildren<QMenu*>())
            emit menu->aboutToShow();
        for (auto* dialog : program.window->findChildren<QDialog*>())
            dialog->close();
    }
    QCoreApplication::removeTranslator(&german);
    QCOMPARE(german.missed().join(u'\n'), QString());
}

void TestLanguage::otherLanguagesStayEnglish() {
    Language none;
    QVERIFY(!none.begin(QStringLiteral("xx")));
    Preferences::instance().set(Preferred::Language, double(LanguageChoice::English));
    applyLanguage();
    QCOMPARE(QObject::tr("Undo"), QStringLiteral("Undo"));
}

TACTUM_GUI_TEST(TestLanguage)

} // namespace test_language

#include "test_language.moc"
