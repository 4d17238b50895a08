#include "ui/window/guide_browser.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QImage>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextFrame>
#include <QTextTable>
#include <QUrl>

#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr int kMargin = 3 * kRhythm, kCell = kRhythm * 3 / 4;

/// A line under each row, and no grid.
void dressTable(QTextTable& table) {
    QTextTableFormat format = table.format();
    format.setBorder(0);
    format.setCellSpacing(0);
    format.setCellPadding(0);
    format.setBorderCollapse(true);
    format.setTopMargin(kRhythm);
    format.setBottomMargin(2 * kRhythm);
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    table.setFormat(format);
    for (int row = 0; row < table.rows(); ++row)
        for (int column = 0; column < table.columns(); ++column) {
            QTextTableCell cell = table.cellAt(row, column);
            QTextTableCellFormat line = cell.format().toTableCellFormat();
            line.setPadding(kCell);
            line.setBottomBorder(1);
            line.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
            line.setBottomBorderBrush(theme().border);
            cell.setFormat(line);
        }
}

/// Headings have room above them; keys and commands stand on the ground of fields.
void dressBlock(const QTextBlock& block) {
    QTextCursor cursor(block);
    if (block.blockFormat().headingLevel() > 0) {
        QTextBlockFormat format;
        format.setTopMargin(block.position() == 0 ? 0 : 2 * kRhythm);
        format.setBottomMargin(kRhythm);
        cursor.mergeBlockFormat(format);
    }
    QTextCharFormat ground;
    ground.setBackground(theme().field);
    std::vector<std::pair<int, int>> fixed; // an iterator does not survive what is changed
    for (auto part = block.begin(); !part.atEnd(); ++part)
        if (part.fragment().charFormat().fontFixedPitch())
            fixed.emplace_back(part.fragment().position(), part.fragment().length());
    for (const auto& [from, length] : fixed) {
        cursor.setPosition(from);
        cursor.setPosition(from + length, QTextCursor::KeepAnchor);
        cursor.mergeCharFormat(ground);
    }
}

} // namespace

GuideBrowser::GuideBrowser(QWidget* parent) : QTextBrowser(parent) {
    setObjectName(QStringLiteral("guide-page"));
    setAccessibleName(tr("Page of the guide"));
    setOpenExternalLinks(true);
}

// A picture of a whole window does not fit a page.
QVariant GuideBrowser::loadResource(int type, const QUrl& name) {
    const QVariant found = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return found;
    const QImage picture = QImage::fromData(found.toByteArray());
    const int room = std::max(1, viewport()->width() - 3 * kMargin);
    return picture.width() > room ? picture.scaledToWidth(room, Qt::SmoothTransformation) : picture;
}

void GuideBrowser::doSetSource(const QUrl& url, QTextDocument::ResourceType type) {
    const bool isPlace = url.hasFragment() && url.adjusted(QUrl::RemoveFragment).path() ==
                                                  source().adjusted(QUrl::RemoveFragment).path();
    QTextBrowser::doSetSource(url, type);
    if (!isPlace) dress();
    mark(words_);
}

// As one edit: each of a long table's cells would have all of the page laid out anew.
void GuideBrowser::dress() {
    QTextCursor all(document());
    all.beginEditBlock();
    QTextFrame* root = document()->rootFrame();
    QTextFrameFormat whole = root->frameFormat();
    whole.setMargin(kMargin);
    root->setFrameFormat(whole);
    for (QTextFrame* frame : root->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame)) dressTable(*table);
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
        dressBlock(block);
    all.endEditBlock();
}

void GuideBrowser::openAt(const QString& file, int position, const QStringList& words) {
    words_ = words;
    if (const QUrl url = QUrl::fromLocalFile(file); url != source())
        setSource(url);
    else
        mark(words_);
    QTextCursor cursor(document());
    cursor.setPosition(std::min(position, document()->characterCount() - 1));
    setTextCursor(cursor);
    if (position > 0) // a third down: what stands above it says where it is
        verticalScrollBar()->setValue(verticalScrollBar()->value() + cursorRect().top() -
                                      viewport()->height() / 3);
    else
        verticalScrollBar()->setValue(0);
}

void GuideBrowser::mark(const QStringList& words) {
    QList<ExtraSelection> marks;
    QTextCharFormat ground;
    ground.setBackground(theme().accent);
    ground.setForeground(theme().accentText);
    for (const QString& word : words)
        for (QTextCursor at = document()->find(word); !at.isNull(); at = document()->find(word, at))
            marks.push_back({at, ground});
    setExtraSelections(marks);
}

void GuideBrowser::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || source().isEmpty()) return;
    const int scrolled = verticalScrollBar()->value();
    reload(); // links have the colour of the palette that they were read with
    verticalScrollBar()->setValue(scrolled);
}

} // namespace tactum
