#include "ui/document/recent_pictures.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QStandardPaths>

#include "core/base/atomic_file.h"
#include "core/bundle/preview.h"

namespace tactum {

namespace {

constexpr QSize kPicture(224, 168); // pixels: a card on a screen with twice as many
const auto kStamp = QStringLiteral("file");

QString folder() {
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent");
}

QString nameFor(const QString& path) {
    return QString::fromLatin1(QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex()) +
           QStringLiteral(".png");
}

QString textOf(const FileStamp& stamp) {
    return QStringLiteral("%1 %2").arg(stamp.written.time_since_epoch().count()).arg(stamp.bytes);
}

/// A cache: where the disk refuses, there is no picture.
void draw(const Scene& scene, const QString& path, const QString& stamp) {
    const std::string png = previewOf(scene, kPicture.width(), kPicture.height());
    QImage picture = QImage::fromData(QByteArray::fromStdString(png));
    picture.setText(kStamp, stamp);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!QDir().mkpath(folder()) || !picture.save(&buffer, "PNG")) return;
    const QString file = folder() + u'/' + nameFor(path);
    (void)writeFileAtomically(file.toStdU16String(), {bytes.constData(), std::size_t(bytes.size())}, 0);
}

RecentLook lookAt(const QString& path) {
    const std::filesystem::path file(path.toStdU16String());
    std::error_code fault;
    RecentLook look{path, !std::filesystem::exists(file, fault), false, {}};
    look.picture.load(folder() + u'/' + nameFor(path));
    look.changed =
        !look.gone && !look.picture.isNull() && look.picture.text(kStamp) != textOf(FileStamp(file));
    return look;
}

void removeAllBut(const QStringList& files) {
    QStringList names;
    for (const QString& path : files)
        names << nameFor(path);
    QDir there(folder());
    for (const QString& name : there.entryList(QDir::Files))
        if (!names.contains(name)) there.remove(name);
}

} // namespace

RecentPictures::RecentPictures(QObject* parent) : QObject(parent) {
    connect(&drawing_, &BackgroundJob::finished, this, &RecentPictures::kept);
}

void RecentPictures::keep(const Scene& scene, const FileStamp& file) {
    const QString path = QString::fromStdU16String(file.path.u16string());
    drawing_.start([scene, path, stamp = textOf(file)](const Progress&) -> BackgroundJob::Delivery {
        draw(scene, path, stamp);
        return [] {};
    });
}

void RecentPictures::look(const QStringList& files) {
    looking_.start([this, files](const Progress&) -> BackgroundJob::Delivery {
        removeAllBut(files);
        QList<RecentLook> looks;
        for (const QString& file : files)
            looks << lookAt(file);
        return [this, looks] { emit looked(looks); };
    });
}

} // namespace tactum
