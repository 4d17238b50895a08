#include "ui/window/guide_pages.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>

#include "ui/base/search.h"

namespace tactum {

namespace {

constexpr int kBefore = 12; // characters of an excerpt

QString markdownOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Table and row that a block lies in; nothing outside of tables.
std::optional<std::pair<int, int>> rowOf(const QTextBlock& block) {
    const QTextCursor cursor(block);
    const QTextTable* table = cursor.currentTable();
    if (!table) return std::nullopt;
    return std::pair(table->objectIndex(), table->cellAt(cursor).row());
}

std::vector<GuidePlace> placesOf(const QString& path) {
    QTextDocument document;
    document.setMarkdown(markdownOf(path));
    std::vector<GuidePlace> places;
    QString heading;
    std::optional<std::pair<int, int>> before;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const QString text = block.text().simplified();
        const auto row = rowOf(block);
        if (block.blockFormat().headingLevel() > 1) heading = text;
        if (row && row == std::exchange(before, row))
            places.back().text += u' ' + text;
        else
            places.push_back({heading, text, block.position()});
        before = row;
    }
    return places;
}

bool hasOne(const QString& text, const QStringList& words) {
    return std::ranges::any_of(words,
                               [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace

std::vector<GuidePage> guidePagesIn(const QString& firstPage) {
    static const QRegularExpression link(QStringLiteral(R"(^- \[([^\]]+)\]\(([^)]+\.md)\))"));
    std::vector<GuidePage> pages;
    QString group;
    for (const QString& line : markdownOf(firstPage).split(u'\n')) {
        if (line.startsWith(QStringLiteral("## "))) group = line.mid(3).trimmed();
        const auto found = link.match(line);
        if (found.hasMatch() && !group.isEmpty())
            pages.push_back(
                {group, found.captured(1), QFileInfo(firstPage).path() + u'/' + found.captured(2)});
    }
    return pages;
}

std::vector<GuidePlace> GuideIndex::find(std::size_t page, const QStringList& words) {
    if (places_.empty())
        for (const GuidePage& each : pages_)
            places_.push_back(placesOf(each.file));
    std::vector<GuidePlace> found;
    for (const GuidePlace& place : places_[page])
        if (hasOne(place.text, words) &&
            hasWords(QStringList{pages_[page].title, place.heading, place.text}.join(u' '), words))
            found.push_back(place);
    return found;
}

QString excerptOf(const QString& text, const QStringList& words) {
    qsizetype first = text.size();
    for (const QString& word : words)
        if (const qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0)
            first = std::min(first, at);
    if (first <= kBefore || first == text.size()) return text;
    const qsizetype from = text.indexOf(u' ', first - kBefore);
    return QStringLiteral("\u2026 ") + text.mid(from < 0 || from >= first ? first : from + 1);
}

} // namespace tactum
