#include "ui/showing/report_file.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextDocument>
#include <QUrl>

#include "core/base/atomic_file.h"
#include "core/base/text.h"

namespace tactum {

namespace {

constexpr double kSharper = 3; // dots of a drawing on paper for each of the page's pixels

/// With drawings as fine as paper shows them; by itself Qt would draw them as for the screen.
class ReportDocument : public QTextDocument {
protected:
    QVariant loadResource(int type, const QUrl& url) override {
        const QString text = url.toString(QUrl::FullyEncoded),
                      head = QStringLiteral("data:image/svg+xml;base64,");
        if (!text.startsWith(head)) return QTextDocument::loadResource(type, url);
        QSvgRenderer drawing(QByteArray::fromBase64(text.mid(head.size()).toLatin1()));
        QImage image(drawing.defaultSize() * kSharper, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        drawing.render(&painter);
        return image;
    }
};

QByteArray pdfOf(const QString& html, const ReportSubject& subject) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setTitle(QString::fromStdString(subject.name));
    writer.setCreator(QStringLiteral("Tactum ") + QString::fromStdString(subject.version));
    ReportDocument document;
    document.setHtml(html);
    document.print(&writer);
    return bytes;
}

} // namespace

Result<void> writeReportFile(const ReportSubject& subject, const std::filesystem::path& file,
                             const Progress& progress) {
    if (const auto known = checkReportFile(file); !known) return known;
    const auto html = sceneReport(subject, progress);
    if (!html) return tl::unexpected(html.error());
    if (lowerCase(file.extension().string()) != kPdfEnding) return writeFileAtomically(file, *html, 0);
    const QByteArray pdf = pdfOf(QString::fromStdString(*html), subject);
    return writeFileAtomically(file, {pdf.constData(), std::size_t(pdf.size())}, 0);
}

} // namespace tactum
