// On how many pages a report is printed, and where the view and the plot lie in a picture of a video. Wrong
// itself if Qt broke lines elsewhere in another version: then all numbers of pages are others.
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/panels/panels.h"
#include "ui/showing/report_file.h"
#include "ui/showing/video_frame.h"

namespace test_report_and_frames {

using namespace tactum;

namespace {

QString text(const QRect& r) {
    return QStringLiteral("%1 %2 %3x%4").arg(r.x()).arg(r.y()).arg(r.width()).arg(r.height());
}

QImage plain(QSize size, Qt::GlobalColor colour) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(colour);
    return image;
}

/// Columns and rows of the picture at which its colour changes, along its middle.
QString bands(const VideoPicture& picture) {
    const QImage image(reinterpret_cast<const uchar*>(picture.pixels.data()), picture.width, picture.height,
                       QImage::Format_RGB32);
    QStringList lines;
    for (const bool across : {true, false}) {
        QStringList at;
        const int length = across ? picture.width : picture.height;
        QRgb last = 0;
        for (int i = 0; i < length; ++i) {
            const QRgb now = across ? image.pixel(i, picture.height / 3) : image.pixel(picture.width / 2, i);
            if (i == 0 || now != last) at << QStringLiteral("%1 %2").arg(i).arg(QColor(now).name());
            last = now;
        }
        lines << at.join(QStringLiteral(", "));
    }
    return lines.join(QStringLiteral(" | "));
}

} // namespace

class TestReportAndFrames : public QObject {
    Q_OBJECT

private slots:
    void pagesOfAReport() {
        QTemporaryDir folder;
        QStringList said;
        const auto write = [&](const Scene& scene, const char* name) {
            const ReportSubject subject{scene, "tried.glb", "", "1.2", "2026-12-01 10:00 UTC"};
            const auto file = std::filesystem::path(folder.path().toStdString()) / name;
            const auto written = writeReportFile(subject, file);
            if (!written) return QString::fromStdString(written.error().text);
            QFile read(QString::fromStdString(file.string()));
            if (!read.open(QIODevice::ReadOnly)) qFatal("it cannot be read");
            const QByteArray bytes = read.readAll();
            const auto pages =
                QString::fromLatin1(bytes).count(QRegularExpression(QStringLiteral("/Type /Page\\b")));
            return QStringLiteral("%1 %2").arg(QString::fromLatin1(bytes.left(5)).simplified()).arg(pages);
        };
        Scene scene;
        for (const int more : {1, 2, 0}) {
            said << QStringLiteral("%1 objects: %2").arg(scene.objects.size()).arg(write(scene, "a.pdf"));
            for (int i = 0; i < more; ++i) {
                SceneObject plate = testing::knownScene().objects[1];
                plate.id = 0;
                plate.name = "Plate " + std::to_string(scene.objects.size() + 1);
                TextureLayer layer = testing::layerOf("Grooves", TextureSource::Grooves);
                layer.strength = 1e-3;
                plate.surfaces[0].layers = {layer};
                scene.add(plate);
            }
        }
        said << QStringLiteral("as a page: ") + write(scene, "a.html");
        said << QStringLiteral("another kind: ") + write(scene, "a.txt");
        COMPARE_SHOWN(said.join(u'\n').replace(folder.path(), QStringLiteral("FOLDER")), "report-pages");
    }

    void whereTheViewAndThePlotLie() {
        QStringList said;
        for (const QSize size : {QSize(1280, 720), QSize(801, 601), QSize(10, 10), QSize(9000, 9000)})
            for (const bool plot : {false, true})
                for (const bool around : {false, true}) {
                    const VideoLayout layout =
                        around ? videoLayoutAround(size, plot) : videoLayout(size, plot);
                    said << QStringLiteral("%1x%2%3%4: %5x%6, view %7, plot %8, scale %9")
                                .arg(size.width())
                                .arg(size.height())
                                .arg(plot ? " with the plot" : "", around ? " around" : "")
                                .arg(layout.size.width())
                                .arg(layout.size.height())
                                .arg(text(layout.view), text(layout.plot))
                                .arg(layout.plotScale());
                }
        const VideoLayout layout = videoLayout({320, 240}, true);
        for (const QSize view : {layout.view.size(), layout.view.size() + QSize(1, 2),
                                 layout.view.size() - QSize(3, 0), QSize(100, 400), QSize(400, 100)})
            said << QStringLiteral("a view of %1x%2: ").arg(view.width()).arg(view.height()) +
                        bands(videoFrame(layout, plain(view, Qt::red), plain(layout.plot.size(), Qt::green),
                                         Qt::blue));
        said << QStringLiteral("without a plot: ") +
                    bands(videoFrame(layout, plain({100, 400}, Qt::red), QImage(), Qt::blue));
        COMPARE_SHOWN(said.join(u'\n'), "video-frames");
    }
};

TACTUM_GUI_TEST(TestReportAndFrames)

} // namespace test_report_and_frames

#include "test_report_and_frames.moc"
