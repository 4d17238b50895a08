#include "tests/ui/window/moving_picture.h"

#include <QApplication>
#include <QPainter>

#include "ui/view/scene_view.h"

namespace tactum {
namespace {

constexpr QSize kWindow{1200, 750};
constexpr int kWide = 720; ///< pixels, of the picture
constexpr int kSkip = 2;   ///< frames of the display for one of the picture

class Frames {
public:
    Frames(TouchedWindow& program, const QDir& folder) : program_(program), folder_(folder) {}

    /// So many pictures of what happens now, with the pointer where it is.
    void take(int count, QPoint pointer) {
        for (int i = 0; i < count; ++i) {
            program_.frames(kSkip);
            save(pointer);
        }
    }
    void stroke(QPoint from, QPoint to, int count) {
        for (int i = 1; i <= count; ++i) {
            const QPoint at = from + (to - from) * i / count;
            program_.moveTo(at);
            take(1, at);
        }
    }

private:
    void save(QPoint pointer) {
        QPixmap picture = program_.window->grab();
        {
            QPainter painter(&picture);
            painter.setRenderHint(QPainter::Antialiasing);
            painter.setPen(QPen(Qt::black, 1));
            painter.setBrush(Qt::white);
            const QPoint tip = program_.window->view().mapTo(program_.window.get(), pointer);
            painter.drawPolygon(
                QPolygon{{tip, tip + QPoint(0, 18), tip + QPoint(4, 14), tip + QPoint(12, 13)}});
        }
        const QString name = QStringLiteral("touch-%1.png").arg(count_++, 3, 10, QLatin1Char('0'));
        if (!picture.scaledToWidth(kWide, Qt::SmoothTransformation).save(folder_.filePath(name)))
            qFatal("%s cannot be written", qPrintable(name));
    }

    TouchedWindow& program_;
    QDir folder_;
    int count_ = 0;
};

} // namespace

void takeTouchFrames(const QDir& folder, const QString& sample) {
    TouchedWindow program(kWindow);
    if (!program.open(sample)) qFatal("%s cannot be touched", qPrintable(sample));
    program.type(QStringLiteral("stiffness"), QStringLiteral("350"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.6"));
    program.type(QStringLiteral("dynamic-friction"), QStringLiteral("0.4"));
    program.type(QStringLiteral("proxy-radius"), QStringLiteral("2"));
    program.wheel(program.centre() + QPoint(0, 20), 3);
    Frames frames(program, folder);
    QPoint at = program.centre() + QPoint(40, 20);
    program.moveTo(at);
    frames.take(4, at);
    program.press(at);
    frames.take(8, at);
    program.wheel(at, 5);
    frames.take(6, at);
    const QPoint left(-130, 25), back(70, -40);
    frames.stroke(at, at + left, 30);
    at += left;
    frames.stroke(at, at + back, 12);
    at += back;
    program.release(at);
    frames.take(8, at);
}

} // namespace tactum
