// What a file manager shows of a bundle: the picture that lies in it, smaller.
#include <fstream>
#include <iterator>

#include <QBuffer>
#include <QImage>
#include <QImageReader>

#include "app/commands.h"
#include "core/archive/bundle_files.h"
#include "core/base/atomic_file.h"

namespace tactum {
namespace {

/// More than any picture that a bundle of ours has: a file manager asks about files that nobody trusts.
constexpr int kLargestBundle = 1 << 30, kLargestSide = 4096;

Result<std::string> bytesOfBundle(const std::filesystem::path& bundle) {
    std::error_code fault;
    const auto size = std::filesystem::file_size(bundle, fault);
    std::ifstream in(bundle, std::ios::binary);
    if (fault || !in) return inputError(bundle.string() + ": cannot be read; check the path");
    if (size > kLargestBundle) return inputError(bundle.string() + ": is too large for a thumbnail");
    return std::string(std::istreambuf_iterator<char>(in), {});
}

/// The preview alone is unpacked.
Result<std::string> previewIn(const std::string& zip) {
    const auto archive = ZipArchive::open(zip);
    if (!archive) return tl::unexpected(archive.error());
    for (std::size_t i = 0; i < archive->names().size(); ++i)
        if (archive->names()[i] == bundle_name::kPreview) return archive->read(i);
    return inputError("has no picture in it; export the bundle again");
}

QImage decoded(const std::string& png) {
    QByteArray bytes = QByteArray::fromRawData(png.data(), qsizetype(png.size()));
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer, "png");
    const QSize size = reader.size();
    if (size.isEmpty() || std::max(size.width(), size.height()) > kLargestSide) return {};
    return reader.read();
}

} // namespace

Result<int> runThumbnail(const ThumbnailOptions& options) {
    const auto named = [&](const Error& error) {
        return tl::unexpected(Error{error.kind, options.bundle.string() + ": " + error.text});
    };
    const auto zip = bytesOfBundle(options.bundle);
    if (!zip) return tl::unexpected(zip.error());
    const auto png = previewIn(*zip);
    if (!png) return named(png.error());
    const QImage picture = decoded(*png);
    if (picture.isNull())
        return named({Error::Kind::Input, "the picture in it is damaged; export the bundle again"});
    QByteArray small;
    QBuffer out(&small);
    out.open(QIODevice::WriteOnly);
    picture.scaled(options.size, options.size, Qt::KeepAspectRatio, Qt::SmoothTransformation)
        .save(&out, "png");
    if (const auto written =
            writeFileAtomically(options.out, {small.constData(), std::size_t(small.size())}, 0);
        !written)
        return tl::unexpected(written.error());
    return 0;
}

} // namespace tactum
