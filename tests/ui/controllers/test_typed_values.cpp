// Values typed into the palette: what is offered for which words, and what the chosen one changes. Wrong
// itself if an entry had more than its lines tell: its effect stands beside it for that.
#include <QUndoStack>

#include "tests/support/as_shown.h"
#include "tests/support/test_program.h"
#include "tests/ui/document/scene_figures.h"
#include "tests/ui/english.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "ui/base/preferences.h"
#include "ui/controllers/value_entries.h"

namespace test_typed_values {

using namespace tactum;
using namespace tactum::testing;
using tactum::test::speakEnglish;

namespace {

/// What is offered, and what choosing it does to the scene; the edit is taken back.
QString offersFor(Document& document, const char* typed) {
    QString text = QStringLiteral("\"%1\"\n").arg(QString::fromUtf8(typed));
    for (const PaletteEntry& entry : valueEntries(document, QString::fromUtf8(typed))) {
        text += QStringLiteral("  %1 (%2): %3\n").arg(entry.text, entry.menu, entry.sentence);
        if (!entry.whyNot.isEmpty()) {
            text += QStringLiteral("  not now: %1\n").arg(entry.whyNot);
            continue;
        }
        const QStringList before = figuresOf(document.scene());
        entry.run();
        text += changedLines(before, figuresOf(document.scene()));
        text += QStringLiteral("  = \"%1\"\n").arg(document.history().undoText());
        document.history().undo();
    }
    return text;
}

} // namespace

class TestTypedValues : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;

private slots:
    void init() {
        speakEnglish();
        folders_.next();
    }

    void valuesAreOffered() {
        Document document;
        adopt(document, knownScene());
        document.select(kTop);
        QString text;
        for (const char* typed : {"stiffness 300",
                                  "stiff 300",
                                  "STIFF 0.25",
                                  "stiff 300 N/m",
                                  "stiff 300 mm",
                                  "stiffness 1e9",
                                  "stiffness -1",
                                  "stiffness",
                                  "300",
                                  "stiffness300",
                                  "static friction 0.3",
                                  "friction 0,3",
                                  "fric sta 0.3",
                                  "friction 0.3 N",
                                  "friction .5",
                                  "friction +0.5",
                                  "dynamic friction 9",
                                  "damp 1.5",
                                  "viscosity 2",
                                  "visc 2 N s/m",
                                  "proxy radius 2",
                                  "radius 2 mm",
                                  "rad 0.3 cm",
                                  "radius 900",
                                  "radius 2 N",
                                  "s 1",
                                  "d 0.5",
                                  "v 1 2",
                                  "colour 3",
                                  "",
                                  "  stiffness  12  "})
            text += offersFor(document, typed);
        COMPARE_SHOWN(text, "typed-values");
    }

    void ofSeveralOrLockedOnes() {
        Document document;
        adopt(document, knownScene());
        QString text = QStringLiteral("nothing selected: ") + offersFor(document, "stiffness 300");
        text += offersFor(document, "radius 2");
        document.select({kLid, kFloor, kTop});
        text += QStringLiteral("all: ") + offersFor(document, "stiffness 300");
        document.setLocked({kLid}, true);
        text += QStringLiteral("one locked: ") + offersFor(document, "static 0.9");
        document.setLocked({kFloor}, true);
        text += QStringLiteral("two locked: ") + offersFor(document, "static 0.9");
        document.setLocked({kTop}, true);
        text += QStringLiteral("all locked: ") + offersFor(document, "static 0.9 mm");
        COMPARE_SHOWN(text, "typed-values-selected");
    }

    /// Those in which they are shown everywhere.
    void inThePreferredUnits() {
        Document document;
        adopt(document, knownScene());
        document.select(kTop);
        Preferences& all = Preferences::instance();
        all.set(Preferred::Stiffnesses, 1);
        QString text;
        for (const char* typed : {"stiffness 0.3", "stiffness 0.3 N/mm", "stiffness 300 N/m", "radius 2"})
            text += offersFor(document, typed);
        COMPARE_SHOWN(text, "typed-values-units");
    }
};

TACTUM_TEST(TestTypedValues)

} // namespace test_typed_values

#include "test_typed_values.moc"
