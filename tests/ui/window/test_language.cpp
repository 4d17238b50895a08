// The window in German. The oracle of what has to be translated is lupdate, Qt's own reader of sources, and
// what the tables hold; that words are right no test can see.
#include <cerrno>
#include <cstring>

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QMutex>
#include <QProcess>
#include <QRegularExpression>
#include <QTest>
#include <QUndoStack>
#include <QXmlStreamReader>

#include "core/loop/urgency.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/table_texts.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/language.h"
#include "ui/base/mnemonics.h"
#include "ui/base/preferences.h"
#include "ui/base/words.h"

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
    void whatTheProgramBringsIsGerman();
    void theLoopsAreSaidInGerman();
    void oneIsNotMany();
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

void TestLanguage::whatTheProgramBringsIsGerman() {
    Language german;
    QVERIFY(german.begin(QStringLiteral("de")));
    QVERIFY(QCoreApplication::installTranslator(&german));
    {
        TouchedWindow program({1500, 900});
        QVERIFY(program.open(writeCube(folder_)));
        const auto* device = program.window->findChild<QLabel*>(QStringLiteral("status-device"));
        QTRY_VERIFY_WITH_TIMEOUT(device->text().startsWith(QStringLiteral("Simulierte Hand")), kPatience);
        auto* presets = program.window->findChild<QListWidget*>(QStringLiteral("preset-list"));
        QTRY_VERIFY_WITH_TIMEOUT(presets->count() > 20, kPatience);
        const auto honey = presets->findItems(QStringLiteral("Honig"), Qt::MatchExactly);
        QCOMPARE(honey.size(), 1);
        QVERIFY(presets->findItems(QStringLiteral("Honey"), Qt::MatchExactly).isEmpty());
        presets->setCurrentItem(honey.front());
        program.document.select(SurfaceRef{program.document.scene().objects[0].id, 0});
        program.command("preset-apply").trigger();
        COMPARE_CONTAINS(program.document.history().undoText(), QStringLiteral("Honig"));
        // What is the person's is theirs.
        const auto before = program.document.scene().objects[0].name;
        QCOMPARE(before, std::string("cube"));
    }
    QCoreApplication::removeTranslator(&german);
}

void TestLanguage::theLoopsAreSaidInGerman() {
    Language german;
    QVERIFY(german.begin(QStringLiteral("de")));
    QVERIFY(QCoreApplication::installTranslator(&german));
    const auto words = [](const Urgency& urgency, int unlocked) {
        return wordsInside(sentenceOf(urgency, unlocked), kUrgencyWords);
    };
    COMPARE_BEGINS(words({.asked = 80, .priority = 80}, 0), QStringLiteral("Echtzeit"));
    const Urgency states[] = {
        {.asked = 80, .refusal = EPERM},
        {.asked = 80, .refusal = EPERM, .nice = -11, .slice = true},
        {.asked = 80, .priority = 20, .broker = PriorityBroker::RealtimeKit, .refusal = EPERM},
        {.asked = 80, .priority = 20, .broker = PriorityBroker::Portal, .refusal = EPERM}};
    for (const Urgency& urgency : states)
        for (const int unlocked : {0, ENOMEM}) {
            QString said = words(urgency, unlocked);
            said.remove(QString::fromLocal8Bit(std::strerror(EPERM)));
            for (const char* english : {" the ", " with ", " by ", " and ", "priority", "allow"})
                QVERIFY2(!said.contains(QLatin1String(english)), qPrintable(said));
        }
    QCoreApplication::removeTranslator(&german);
}

void TestLanguage::oneIsNotMany() {
    Language english;
    QVERIFY(english.begin(QStringLiteral("en")));
    QVERIFY(QCoreApplication::installTranslator(&english));
    for (const Text& each : textsOf(translations_ + QStringLiteral("/tactum_en.ts"))) {
        QCOMPARE(each.words.size(), 2);
        QVERIFY2(!each.words.join(u' ').contains(QStringLiteral("(s)")), qPrintable(each.english));
        QVERIFY(each.words[0] != each.words[1]);
        for (const int count : {1, 2}) {
            const QString said = QObject::tr(qPrintable(each.english), nullptr, count);
            QCOMPARE(said,
                     QString(each.words[count - 1]).replace(QStringLiteral("%n"), QString::number(count)));
        }
    }
    QCOMPARE(QObject::tr("%n trial(s)", nullptr, 1), QStringLiteral("1 trial"));
    QCOMPARE(QObject::tr("%n trial(s)", nullptr, 12), QStringLiteral("12 trials"));
    QCoreApplication::removeTranslator(&english);
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
