// Small pictures of recent files. Wrong itself if the cache were the person's: each run has its own.
#include <fstream>

#include <QDir>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "ui/document/recent_pictures.h"

namespace test_recent_pictures {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// "224 x 168 changed, none": what is found of each file.
QString told(const QList<RecentLook>& looks) {
    QStringList all;
    for (const RecentLook& look : looks)
        all << (look.picture.isNull()
                    ? QStringLiteral("none")
                    : QStringLiteral("%1 x %2").arg(look.picture.width()).arg(look.picture.height())) +
                   (look.changed ? QStringLiteral(" changed") : QString()) +
                   (look.gone ? QStringLiteral(" gone") : QString());
    return all.join(QStringLiteral(", "));
}

} // namespace

class TestRecentPictures : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void init() { useFoldersIn(folder_.path()); }

    void picturesAreKeptAsLongAsTheirFilesAreRecent() {
        const QString one = writeFile(folder_, QStringLiteral("one.glb"), "1"),
                      two = writeFile(folder_, QStringLiteral("two.glb"), "2");
        RecentPictures pictures;
        QSignalSpy kept(&pictures, &RecentPictures::kept), looked(&pictures, &RecentPictures::looked);
        const auto keep = [&](const QString& file) {
            pictures.keep(knownScene(), FileStamp(file.toStdString()));
            return waitFor([&, before = kept.size()] { return kept.size() > before; });
        };
        const auto look = [&](const QStringList& files) {
            pictures.look(files);
            if (!waitFor([&, before = looked.size()] { return looked.size() > before; }))
                qFatal("nobody looked");
            return looked.back()[0].value<QList<RecentLook>>();
        };
        QVERIFY(keep(one));
        const QList<RecentLook> found = look({one, two});
        QCOMPARE(found[0].path, one);
        QCOMPARE(found[1].path, two);
        QCOMPARE(told(found), "224 x 168, none");
        QVERIFY(keep(two));
        std::ofstream(one.toStdString(), std::ios::app) << "more";
        QCOMPARE(told(look({two, one})), "224 x 168, 224 x 168 changed"); // another file than it was made of
        QVERIFY(QFile::remove(one));
        QCOMPARE(told(look({one})), "224 x 168 gone");
        QCOMPARE(told(look({two})), "none"); // it was not among those of before
        QCOMPARE(told(look({one})), "none gone");
    }

    void withoutAPlaceThereIsNone() {
        qputenv("XDG_CACHE_HOME", "/dev/null");
        RecentPictures pictures;
        QSignalSpy kept(&pictures, &RecentPictures::kept);
        pictures.keep(knownScene(), FileStamp("/dev/null/none"));
        QVERIFY(waitFor([&] { return kept.size() == 1; }));
    }
};

TACTUM_TEST(TestRecentPictures)

} // namespace test_recent_pictures

#include "test_recent_pictures.moc"
