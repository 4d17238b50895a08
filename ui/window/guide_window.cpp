#include "ui/window/guide_window.h"

#include <QCoreApplication>
#include <QDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImage>
#include <QPushButton>
#include <QTextBrowser>
#include <QUrl>

#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr int kPageWidth = 92 * kRhythm, kPageHeight = 88 * kRhythm, kMargin = 6 * kRhythm;

/// Pictures of a whole window do not fit a page.
class Pages : public QTextBrowser {
public:
    QVariant loadResource(int type, const QUrl& name) override {
        const QVariant found = QTextBrowser::loadResource(type, name);
        if (type != QTextDocument::ImageResource) return found;
        const QImage picture = QImage::fromData(found.toByteArray());
        const int room = kPageWidth - kMargin;
        return picture.width() > room ? picture.scaledToWidth(room, Qt::SmoothTransformation) : picture;
    }
};

} // namespace

QString guidePage() {
    const QString program = QCoreApplication::applicationDirPath();
    for (const QString& docs :
         {program + QStringLiteral("/../share/tactum/docs"),
          program + QStringLiteral("/../../share/tactum/docs"), QStringLiteral(TACTUM_DOCS)})
        if (const QFileInfo page(docs + QStringLiteral("/guide/README.md")); page.exists())
            return page.canonicalFilePath();
    return {};
}

void showGuide(QWidget* parent) {
    auto* window = new QDialog(parent);
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->setObjectName(QStringLiteral("guide"));
    window->setWindowTitle(QObject::tr("Guide"));
    window->resize(kPageWidth, kPageHeight);
    auto* pages = new Pages;
    pages->setOpenExternalLinks(true);
    pages->setAccessibleName(QObject::tr("Page of the guide"));
    auto* contents = new QPushButton(QObject::tr("Contents"));
    auto* back = new QPushButton(QObject::tr("Back", "to the page before"));
    back->setEnabled(false);
    for (QPushButton* button : {contents, back})
        button->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->addWidget(contents);
    row->addWidget(back);
    row->addStretch();
    auto* column = new QVBoxLayout(window);
    column->addLayout(row);
    column->addWidget(pages, 1);
    const QUrl first = QUrl::fromLocalFile(guidePage());
    QObject::connect(contents, &QPushButton::clicked, pages, [pages, first] { pages->setSource(first); });
    QObject::connect(back, &QPushButton::clicked, pages, &QTextBrowser::backward);
    QObject::connect(pages, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    if (first.isEmpty())
        pages->setPlainText(QObject::tr("The guide was not installed with the program."));
    else
        pages->setSource(first);
    window->show();
    pages->setFocus();
}

} // namespace tactum
