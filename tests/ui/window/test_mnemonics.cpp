// What a person reaches with Alt and a letter, and what a screen reader says: every dialog, menu and panel.
#include <functional>

#include <QAccessible>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyle>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/ask_where.h"
#include "ui/base/language.h"
#include "ui/base/mnemonics.h"
#include "ui/document/recent_files.h"
#include "ui/panels/finding_list.h"
#include "ui/view/scene_view.h"
#include "ui/window/connect_dialog.h"

namespace test_mnemonics {

using namespace tactum;

namespace {

QString letterOf(const QString& text) {
    return QKeySequence::mnemonic(text).toString().section(u'+', -1).toLower();
}

/// What is wrong with texts that one Alt reaches, a line for each.
QStringList troubleIn(const QString& where, const QStringList& texts) {
    QStringList trouble;
    QMap<QString, QString> taken;
    for (const QString& text : texts) {
        const QString letter = letterOf(text);
        if (letter.isEmpty())
            trouble << QStringLiteral("%1: no letter in \"%2\"").arg(where, text);
        else if (taken.contains(letter))
            trouble << QStringLiteral("%1: \"%2\" and \"%3\"").arg(where, taken[letter], text);
        taken[letter] = text;
    }
    return trouble;
}

QString whatIs(const QWidget& widget) {
    return QStringLiteral("%1 %2").arg(QString::fromLatin1(widget.metaObject()->className()),
                                       widget.objectName());
}

/// Parts of one control: the control has the name.
bool isPart(const QWidget& widget) {
    return widget.objectName().startsWith(QStringLiteral("qt_")) || widget.inherits("QTabBar") ||
           qobject_cast<const QComboBox*>(widget.parentWidget()) ||
           qobject_cast<const QAbstractSpinBox*>(widget.parentWidget());
}

/// Who can have the keys and has no name.
QStringList nameless(const QWidget& root) {
    QStringList found;
    for (QWidget* each : root.findChildren<QWidget*>()) {
        if (each->window() != root.window() || each->focusPolicy() == Qt::NoFocus || isPart(*each)) continue;
        // What waits to be shown gets its words then.
        const bool speaks = qobject_cast<QLabel*>(each) || qobject_cast<QAbstractButton*>(each);
        if (each->isHidden() || (speaks && !each->isVisible())) continue;
        QAccessibleInterface* told = QAccessible::queryAccessibleInterface(each);
        if (!told || told->text(QAccessible::Name).trimmed().isEmpty()) found << whatIs(*each);
    }
    return found;
}

QStringList troubleInDialog(QDialog& dialog) {
    QStringList texts;
    for (const auto* button : dialog.findChildren<QAbstractButton*>())
        if (button->isVisible() && !button->text().isEmpty()) texts << button->text();
    for (const auto* label : dialog.findChildren<QLabel*>())
        if (label->isVisible() && label->buddy()) texts << label->text();
    return troubleIn(whatIs(dialog), texts);
}

} // namespace

class TestMnemonics : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    /// Looks at the next modal dialog, then gives it up.
    static void whenModal(const std::function<void(QDialog&)>& look) {
        auto* timer = new QTimer;
        connect(timer, &QTimer::timeout, timer, [timer, look] {
            auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            if (!dialog || !dialog->isVisible()) return;
            timer->deleteLater();
            look(*dialog);
            dialog->reject();
        });
        timer->start(20);
    }
    static void lookAtMenus(QMenu& menu, QStringList& trouble) {
        emit menu.aboutToShow();
        QStringList texts;
        for (QAction* action : menu.actions()) {
            if (action->isSeparator() || !action->isVisible()) continue;
            texts << action->text();
            if (action->menu()) lookAtMenus(*action->menu(), trouble);
        }
        trouble << troubleIn(menu.title(), texts);
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aLetterIsFound();
    void everyMenuEntryHasItsLetter_data();
    void everyMenuEntryHasItsLetter();
    void everyDialogHasItsLetters();
    void whatHasTheKeysHasAName();
};

void TestMnemonics::aLetterIsFound() {
    QString used = QStringLiteral("s");
    QCOMPARE(withMnemonic(QStringLiteral("Save"), used), QStringLiteral("S&ave"));
    QCOMPARE(withMnemonic(QStringLiteral("S&ave as"), used), QStringLiteral("Sa&ve as")); // a is taken
    QCOMPARE(withMnemonic(QStringLiteral("&This && that"), used), QStringLiteral("&This && that"));
    QCOMPARE(used, QStringLiteral("savt"));
    QCOMPARE(withMnemonic(QStringLiteral("sav"), used), QStringLiteral("sav"));
}

void TestMnemonics::everyMenuEntryHasItsLetter_data() {
    QTest::addColumn<QString>("code");
    QTest::newRow("English") << QString();
    QTest::newRow("German") << QStringLiteral("de");
}

void TestMnemonics::everyMenuEntryHasItsLetter() {
    QFETCH(const QString, code);
    Language language;
    if (!code.isEmpty()) QVERIFY(language.begin(code) && QCoreApplication::installTranslator(&language));
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    rememberFile(writeFile(folder_, QStringLiteral("odd & even.obj"), "v 0 0 0\n"));
    program.type(QStringLiteral("stiffness"), QStringLiteral("500")); // the entries name what is undone
    program.document.history().undo();
    QStringList trouble, titles;
    for (QAction* title : program.window->menuBar()->actions()) {
        titles << title->text();
        lookAtMenus(*title->menu(), trouble);
    }
    trouble << troubleIn(QStringLiteral("menu bar"), titles);
    for (auto* button : program.window->findChildren<QToolButton*>())
        if (button->menu()) lookAtMenus(*button->menu(), trouble);
    // Whoever has a letter in the window itself would fight with the menus about Alt.
    for (const auto* button : program.window->findChildren<QAbstractButton*>())
        if (button->window() == program.window.get() && !letterOf(button->text()).isEmpty())
            trouble << whatIs(*button);
    QVERIFY2(trouble.empty(), qPrintable(trouble.join(u'\n')));
}

void TestMnemonics::everyDialogHasItsLetters() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QStringList trouble, seen;
    const auto look = [&](QDialog& dialog) {
        seen << whatIs(dialog);
        trouble << troubleInDialog(dialog);
        for (const QString& each : nameless(dialog))
            if (!qobject_cast<QFileDialog*>(&dialog)) trouble << whatIs(dialog) + QStringLiteral(": ") + each;
        if (dialog.style()->metaObject() != program.window->style()->metaObject())
            trouble << whatIs(dialog) + QStringLiteral(": another style");
    };
    const auto lookAtOpen = [&] {
        for (auto* dialog : program.window->findChildren<QDialog*>()) {
            if (!dialog->isVisible()) continue;
            look(*dialog);
            dialog->close();
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    for (const char* id : {"guide", "keyboard", "preferences", "preset-save"}) {
        program.command(id).trigger();
        program.frames(5);
        lookAtOpen();
    }
    for (const char* id : {"about", "open", "save-as", "save-picture", "connect", "preset-import"}) {
        const auto before = seen.size();
        whenModal(look);
        program.command(id).trigger();
        QTRY_VERIFY_WITH_TIMEOUT(seen.size() > before, kPatience);
    }
    showFindings(QStringLiteral("What was left out"), QStringLiteral("Two things."),
                 {{Finding::Severity::Note, "lid", "is blue", "paint it"}}, program.window.get());
    program.frames(5);
    lookAtOpen();
    program.type(QStringLiteral("stiffness"), QStringLiteral("500"));
    program.window->close();
    program.frames(5);
    lookAtOpen(); // asks what is to become of the edit
    QCOMPARE_GE(seen.size(), qsizetype(12));
    QVERIFY2(trouble.empty(), qPrintable(trouble.join(u'\n')));
    // A letter does what it says: D throws the edit away.
    program.window->close();
    auto* question = program.window->findChild<QMessageBox*>(QStringLiteral("unsaved"));
    QVERIFY(question);
    program.frames(2);
    auto* discard = question->button(QMessageBox::Discard);
    QApplication::setActiveWindow(question);
    const QString letter = letterOf(discard->text());
    QTest::keyClick(question, Qt::Key(letter.toUpper().front().unicode()), Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!program.window->isVisible(), kPatience);
}

void TestMnemonics::whatHasTheKeysHasAName() {
    TouchedWindow program;
    QStringList found = nameless(*program.window); // with the start page
    QVERIFY(program.open(writeCube(folder_)));
    for (auto* dock : program.window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        program.frames(2);
    }
    for (const char* id : {"select", "paint", "arrange", "layer-noise"})
        program.command(id).trigger();
    program.frames(5);
    found << nameless(*program.window);
    found.removeDuplicates();
    QCOMPARE(found.join(u'\n'), QString());
}

TACTUM_GUI_TEST(TestMnemonics)

} // namespace test_mnemonics

#include "test_mnemonics.moc"
