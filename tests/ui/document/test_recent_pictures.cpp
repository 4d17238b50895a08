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
#include "tests/ui/panels/panels.h"
#include "ui/document/recent_pictures.h"

namespace test_recent_pictures {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

class TestRecentPictures : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void init() { qputenv("XDG_CACHE_HOME", folder_.path().toLocal8Bit()); }

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
        QList<RecentLook> found = look({one, two});
        QCOMPARE(found.size(), 2);
        QCOMPARE(found[0].path, one);
        QCOMPARE(found[0].picture.size(), QSize(224, 168));
        QVERIFY(!found[0].changed && !found[0].gone);
        QVERIFY(found[1].picture.isNull() && !found[1].changed && !found[1].gone);
        QVERIFY(keep(two));
        std::ofstream(one.toStdString(), std::ios::app) << "more";
        found = look({two, one});
        QVERIFY(!found[0].changed && !found[0].picture.isNull());
        QVERIFY(found[1].changed && !found[1].picture.isNull()); // another file than it was made of
        QVERIFY(QFile::remove(one));
        found = look({one});
        QVERIFY(found[0].gone && !found[0].changed && !found[0].picture.isNull());
        QVERIFY(look({two})[0].picture.isNull()); // it was not among those of before
        QVERIFY(look({one})[0].picture.isNull());
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
