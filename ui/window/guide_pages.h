// The pages of the guide: in which groups they stand, and where in them words are.
#pragma once

#include <vector>

#include <QString>

class QTextDocument;

namespace tactum {

struct GuidePage {
    QString group; ///< the heading above it on the first page
    QString title;
    QString file; ///< whole path
};

/// A paragraph, or a row of a table.
struct GuidePlace {
    QString heading;  ///< above it
    QString text;     ///< in one line
    int position = 0; ///< in the page's document
};

/// As the first page lists them: headings, and under each a link in every line.
std::vector<GuidePage> guidePagesIn(const QString& firstPage);

class GuideIndex {
public:
    explicit GuideIndex(std::vector<GuidePage> pages) : pages_(std::move(pages)) {}

    const std::vector<GuidePage>& pages() const { return pages_; }
    /// The places of a page that have all words, in their text or in what stands above it, and in the text at
    /// least one. Reads the page when it is asked for the first time.
    std::vector<GuidePlace> find(std::size_t page, const QStringList& words);

private:
    std::vector<GuidePage> pages_;
    std::vector<std::vector<GuidePlace>> places_; ///< of each page; empty before the first search
};

/// Where the words begin, with some of what is around them.
QString excerptOf(const QString& text, const QStringList& words);

} // namespace tactum
