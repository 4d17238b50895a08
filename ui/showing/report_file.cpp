#include "ui/showing/report_file.h"

#include <vector>

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextLayout>
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
        painter.end();
        image.setDevicePixelRatio(kSharper); // its height is that of the page, beside a width that is given
        return image;
    }
};

/// As QTextDocument::print() lays out a page: with margins of two centimetres, which are said in dots of the
/// screen and scaled to those of the paper.
void layOut(QTextDocument& document, QPagedPaintDevice& paper) {
    constexpr double kInches = 2 / 2.54;
    const QImage screen(1, 1, QImage::Format_RGB32);
    const int across = int(kInches * screen.logicalDpiX()), along = int(kInches * screen.logicalDpiY());
    document.documentLayout()->setPaintDevice(&paper);
    QTextFrameFormat frame = document.rootFrame()->frameFormat();
    frame.setLeftMargin(across);
    frame.setRightMargin(across);
    frame.setTopMargin(along);
    frame.setBottomMargin(along);
    document.rootFrame()->setFrameFormat(frame);
    document.setPageSize(QSizeF(paper.width(), paper.height()));
}

/// Of its first line: the cell of a table may begin at the foot of a page and its words on the next one.
int pageOf(const QTextDocument& document, const QTextBlock& block) {
    document.pageCount(); // lays out to the end: as far as it is asked for only, a picture stands elsewhere
    const QRectF box = document.documentLayout()->blockBoundingRect(block);
    const double line = block.layout()->lineCount() > 0 ? block.layout()->lineAt(0).y() : 0;
    return int((box.top() + line) / document.pageSize().height());
}

void beginPage(QTextDocument& document, int block) {
    QTextCursor cursor(document.findBlockByNumber(block));
    QTextBlockFormat format = cursor.blockFormat();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    cursor.setBlockFormat(format);
}

/// A heading, or the words over a picture.
bool leads(const QTextBlock& block) {
    const QString picture(QChar::ObjectReplacementCharacter);
    const auto isPicture = [&](const QTextBlock& one) { return one.text().trimmed() == picture; };
    const bool isCaption = block.length() > 1 && !isPicture(block) && isPicture(block.next());
    return isCaption || block.blockFormat().headingLevel() > 0;
}

/// The headings and captions, by the numbers of their blocks, that begin a page because what they are over is
/// on the next one. Where several follow each other the first of them does. `trial`: a copy that is laid out
/// for it.
std::vector<int> leadsOnNewPages(QTextDocument& trial, QPagedPaintDevice& paper) {
    layOut(trial, paper);
    std::vector<int> begin;
    for (QTextBlock block = trial.begin(); block.isValid(); block = block.next()) {
        if (!leads(block)) continue;
        QTextBlock below = block.next();
        while (below.isValid() && (leads(below) || below.length() <= 1))
            below = below.next(); // and what is empty
        if (!below.isValid() || pageOf(trial, below) == pageOf(trial, block)) continue;
        begin.push_back(block.blockNumber());
        beginPage(trial, begin.back());
    }
    return begin;
}

QByteArray pdfOf(const QString& html, const ReportSubject& subject) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setTitle(QString::fromStdString(subject.name));
    writer.setCreator(QStringLiteral("Tactum ") + QString::fromStdString(subject.version));
    ReportDocument document, trial;
    document.setHtml(html);
    trial.setHtml(html);
    for (const int block : leadsOnNewPages(trial, writer))
        beginPage(document, block);
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
