// Saving a scene from the window, and not losing it by closing or opening.
#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "tests/ui/window/window_fixture.h"

using namespace tactum;

namespace {

/// Answers the next file dialog as a person does.
void answerFileDialog(const QString& file) {
    auto* timer = new QTimer;
    QObject::connect(timer, &QTimer::timeout, timer, [timer, file] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        dialog->selectFile(file);
        QMetaObject::invokeMethod(dialog, "accept");
        timer->deleteLater();
    });
    timer->start(20);
}

QMessageBox* question(TouchedWindow& program) {
    return program.window->findChild<QMessageBox*>(QStringLiteral("unsaved"));
}

} // namespace

class TestSaving : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString file(const QString& name) const { return folder_.filePath(name); }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aSavedSceneOpensAsItWas() {
        const QString saved = file(QStringLiteral("felt.glb"));
        {
            TouchedWindow program;
            QVERIFY(program.open(writeCube(folder_)));
            QVERIFY(!program.window->isWindowModified());
            program.type(QStringLiteral("stiffness"), QStringLiteral("321"));
            QVERIFY(program.window->isWindowModified());
            QSignalSpy done(&program.document, &Document::saved);
            answerFileDialog(saved);
            QTest::keyClick(program.window.get(), Qt::Key_S, Qt::ControlModifier);
            QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
            QVERIFY(!program.window->isWindowModified());
            QVERIFY(program.window->windowTitle().contains(QStringLiteral("felt.glb")));
            QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(program.window->isWindowModified()); // not what is in the file
            QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QVERIFY(!program.window->isWindowModified());
            QVERIFY(program.window->close());
        }
        TouchedWindow program;
        QVERIFY(program.open(saved));
        QCOMPARE(program.document.scene().objects[0].surfaces[0].material.stiffness, 321.0);
        program.type(QStringLiteral("stiffness"), QStringLiteral("444"));
        QSignalSpy done(&program.document, &Document::saved);
        QTest::keyClick(program.window.get(), Qt::Key_S, Qt::ControlModifier); // it has its own file now
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        QVERIFY(QFileInfo::exists(saved + u'1')); // the version before
    }

    void closingAsksWhenSomethingWouldBeLost() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        program.type(QStringLiteral("stiffness"), QStringLiteral("222"));
        QVERIFY(!program.window->close());
        QVERIFY(question(program));
        question(program)->button(QMessageBox::Cancel)->click();
        QTRY_VERIFY(!question(program));
        QVERIFY(program.window->isVisible());
        QVERIFY(!program.window->close());
        question(program)->button(QMessageBox::Discard)->click();
        QTRY_VERIFY(!program.window->isVisible());
    }

    void savingFromTheQuestionGoesOn() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        program.type(QStringLiteral("stiffness"), QStringLiteral("223"));
        const QString saved = file(QStringLiteral("kept.glb"));
        answerFileDialog(saved);
        program.window->close();
        question(program)->button(QMessageBox::Save)->click();
        QTRY_VERIFY_WITH_TIMEOUT(!program.window->isVisible(), kPatience);
        QVERIFY(QFileInfo::exists(saved));
    }

    void aFailedSaveLosesNothing() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        program.type(QStringLiteral("stiffness"), QStringLiteral("224"));
        QSignalSpy failed(&program.document, &Document::saveFailed);
        program.document.save((folder_.path() + QStringLiteral("/no such folder/a.glb")).toStdString());
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(program.window->isWindowModified());
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("a.glb")));
    }
};

QTEST_MAIN(TestSaving)
#include "test_saving.moc"
