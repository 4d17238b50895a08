// Saving a scene from the window, and not losing it by closing or opening.
#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/ask_where.h"
#include "ui/widgets/notice_bar.h"

namespace test_saving {

using namespace tactum;

namespace {

void setStiffness(TouchedWindow& program, double stiffness) {
    const SurfaceRef first{program.document.scene().objects.front().id, 0};
    for (const MaterialField& field : kMaterialFields)
        if (field.parameter->key == "stiffness") program.document.setMaterialValue(first, field, stiffness);
}

/// A mesh that takes longer to save than a cube to open.
QString writeFine(const QTemporaryDir& folder) {
    constexpr int kSide = 300;
    QByteArray text;
    for (int i = 0; i < kSide * kSide; ++i)
        text += "v " + QByteArray::number(1e-4 * (i % kSide)) + ' ' + QByteArray::number(1e-4 * (i / kSide)) +
                " 0\n";
    for (int i = 0; i + kSide + 1 < kSide * kSide; ++i)
        if ((i + 1) % kSide != 0)
            text += "f " + QByteArray::number(i + 1) + ' ' + QByteArray::number(i + 2) + ' ' +
                    QByteArray::number(i + kSide + 1) + '\n';
    return writeFile(folder, QStringLiteral("fine.obj"), text);
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
            COMPARE_CONTAINS(program.window->windowTitle(), QStringLiteral("felt.glb"));
            const auto* notice = program.window->findChild<NoticeBar*>();
            COMPARE_CONTAINS(notice->text(), QStringLiteral("felt.glb"));
            QVERIFY(notice->isVisible());
            QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(program.window->isWindowModified()); // not what is in the file
            QVERIFY(!notice->isVisible());               // nor what it says
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
        QVERIFY(program.fullForce()); // as the button says
        QCOMPARE(program.command("armed").isChecked(), program.engine.armed());
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

    void whatIsEditedWhileTheQuestionsSaveRunsIsAskedForAgain() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        program.type(QStringLiteral("stiffness"), QStringLiteral("223"));
        answerFileDialog(file(QStringLiteral("first.glb")));
        program.window->close();
        question(program)->button(QMessageBox::Save)->click(); // comes back when the save has begun
        setStiffness(program, 224);
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(file(QStringLiteral("first.glb"))) && question(program),
                                 kPatience);
        QVERIFY(program.window->isVisible());
        question(program)->button(QMessageBox::Discard)->click();
    }

    void anotherEditAtTheSameStepIsNotSaved() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        setStiffness(program, 111);
        QSignalSpy done(&program.document, &Document::saved);
        program.document.save(file(QStringLiteral("step.glb")).toStdString());
        program.document.history().undo();
        setStiffness(program, 333);
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        QVERIFY(program.window->isWindowModified());
    }

    void aSceneOpenedMeanwhileKeepsItsFile() {
        TouchedWindow program;
        QVERIFY(program.open(writeFine(folder_)));
        const QString cube = writeCube(folder_);
        QSignalSpy saved(&program.document, &Document::saved), opened(&program.document, &Document::opened);
        program.document.save(file(QStringLiteral("fine.glb")).toStdString());
        program.document.open(cube.toStdString());
        QTRY_VERIFY_WITH_TIMEOUT(saved.size() == 1 && opened.size() == 1, kPatience);
        QCOMPARE(program.document.path(), std::filesystem::path(cube.toStdString()));
        QVERIFY(program.window->windowTitle().contains(QFileInfo(cube).fileName()));
    }

    void everySaveAskedForIsMade() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        for (const char* name : {"one.glb", "two.glb", "three.glb"})
            program.document.save(file(QString::fromUtf8(name)).toStdString());
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(file(QStringLiteral("three.glb"))), kPatience);
        QVERIFY(QFileInfo::exists(file(QStringLiteral("two.glb"))));
    }

    /// A model is scaled to fit a hand; a scene that somebody has made is as large as it was meant to be.
    void aSavedSceneKeepsItsSize() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_, 20)));
        const double fitted = boundsOf(program.document.scene()).diagonal();
        program.document.history().undo();
        const double own = boundsOf(program.document.scene()).diagonal();
        QCOMPARE_GT(own, 2 * fitted);
        QSignalSpy done(&program.document, &Document::saved);
        const QString saved = file(QStringLiteral("large.glb"));
        program.document.save(saved.toStdString());
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        QVERIFY(program.open(saved));
        QCOMPARE(boundsOf(program.document.scene()).diagonal(), own);
        QVERIFY(!program.document.history().canUndo());
    }

    void anotherEndingGetsOursBehindIt() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        QSignalSpy done(&program.document, &Document::saved);
        answerFileDialog(file(QStringLiteral("felt.stl")));
        QTest::keyClick(program.window.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        QVERIFY(!QFileInfo::exists(file(QStringLiteral("felt.stl"))));
        QVERIFY(QFileInfo::exists(file(QStringLiteral("felt.stl.glb"))));
    }

    void whatIsWrittenGetsTheEndingOfItsKind() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        const std::pair<const char*, const char*> commands[]{
            {"export-plot", "plot.csv"}, {"export-plot", "plot.svg"}, {"save-picture", "view.png"}};
        for (const auto& [command, wanted] : commands) {
            const QString expected = file(QString::fromLatin1(wanted));
            answerFileDialog(expected.endsWith(QStringLiteral("svg")) ? expected : expected.chopped(4));
            program.command(command).trigger();
            QVERIFY2(QFileInfo::exists(expected), wanted);
        }
    }

    void whoChoosesAnotherKindGetsItsEnding() {
        const QList<FileKind> kinds{{QStringLiteral("Numbers"), QStringLiteral("csv")},
                                    {QStringLiteral("Pictures"), QStringLiteral("png")}};
        QTimer chooser;
        connect(&chooser, &QTimer::timeout, this, [] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!dialog) return;
            auto* kind = dialog->findChild<QComboBox*>(QStringLiteral("fileTypeCombo"));
            kind->setFocus();
            QTest::keyClick(kind, Qt::Key_Down);
            QMetaObject::invokeMethod(dialog, "accept");
        });
        chooser.start(20);
        QCOMPARE(askWhere(nullptr, QStringLiteral("Where"), kinds, file(QStringLiteral("v1.2.csv"))),
                 file(QStringLiteral("v1.2.png")));
    }

    void aSampleIsNotWrittenOver() {
        const QString sample = file(QStringLiteral("sample.glb"));
        {
            TouchedWindow program;
            QVERIFY(program.open(writeCube(folder_)));
            QSignalSpy done(&program.document, &Document::saved);
            program.document.save(sample.toStdString());
            QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        }
        TouchedWindow program({1200, 800}, {QFileInfo(sample).canonicalFilePath()});
        QVERIFY(program.open(sample));
        QSignalSpy done(&program.document, &Document::saved);
        QString offered; // not beside the samples
        answerFileDialog(file(QStringLiteral("mine.glb")), &offered);
        QTest::keyClick(program.window.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        QVERIFY(!offered.isEmpty());
        QVERIFY(offered != QFileInfo(sample).canonicalPath());
        QVERIFY(!QFileInfo::exists(sample + u'1')); // would be what was written over
        QVERIFY(program.document.hasOwnFile());
    }

    void whatAnotherProgramWroteIsAskedFor() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        const QString shared = file(QStringLiteral("shared.glb"));
        QSignalSpy done(&program.document, &Document::saved);
        program.document.save(shared.toStdString());
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
        writeFile(folder_, QStringLiteral("shared.glb"), "theirs");
        setStiffness(program, 222);
        QTest::keyClick(program.window.get(), Qt::Key_S, Qt::ControlModifier);
        auto* asked = program.window->findChild<QMessageBox*>(QStringLiteral("changed-outside"));
        QVERIFY(asked);
        asked->button(QMessageBox::Save)->click();
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 2, kPatience);
        QFile backup(shared + u'1');
        QVERIFY(backup.open(QIODevice::ReadOnly));
        QCOMPARE(backup.readAll(), QByteArray("theirs"));
        QVERIFY(!program.window->isWindowModified());
    }

    void theKeysOfTheWindowWorkInANumber() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        QDoubleSpinBox& box = program.box(QStringLiteral("stiffness"));
        box.setFocus();
        QSignalSpy done(&program.document, &Document::exported);
        answerFileDialog(file(QStringLiteral("bundle.zip")));
        QTest::keyClick(&box, Qt::Key_E, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
    }

    void aFailedSaveLosesNothing() {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        program.type(QStringLiteral("stiffness"), QStringLiteral("224"));
        QSignalSpy failed(&program.document, &Document::saveFailed);
        program.document.save((folder_.path() + QStringLiteral("/no such folder/a.glb")).toStdString());
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(program.window->isWindowModified());
        COMPARE_CONTAINS(failed[0][0].toString(), QStringLiteral("a.glb"));
    }
};

TACTUM_GUI_TEST(TestSaving)

} // namespace test_saving

#include "test_saving.moc"
