#include "ui/window/guide_window.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidgetItemIterator>
#include <QUrl>
#include <QVBoxLayout>

#include "ui/base/search.h"
#include "ui/base/style.h"
#include "ui/widgets/hinted_tree.h"
#include "ui/window/guide_browser.h"

namespace tactum {

namespace {

constexpr int kListWidth = 34 * kRhythm, kPageWidth = 92 * kRhythm, kPageHeight = 88 * kRhythm;
constexpr int kFileRole = Qt::UserRole, kPositionRole = Qt::UserRole + 1;
constexpr int kMostPlaces = 12; // of a page: more is no answer

QTreeWidgetItem* addBold(QTreeWidget& tree, const QString& text) {
    auto* item = new QTreeWidgetItem(&tree, {text});
    QFont bold = tree.font();
    bold.setWeight(QFont::DemiBold);
    item->setFont(0, bold);
    return item;
}

} // namespace

GuideWindow::GuideWindow(const QString& firstPage, QWidget* parent)
    : QDialog(parent), first_(firstPage), index_(guidePagesIn(firstPage)), page_(new GuideBrowser),
      field_(new QLineEdit), list_(new HintedTree(tr("No page has these words."))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName(QStringLiteral("guide"));
    setWindowTitle(tr("Guide"));
    build();
    const QSize room = parent->screen()->availableSize();
    resize(QSize(kListWidth + kPageWidth, kPageHeight).boundedTo(room));
    connect(field_, &QLineEdit::textChanged, this, &GuideWindow::search);
    connect(field_, &QLineEdit::returnPressed, this, &GuideWindow::openFirst);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) { open(item); });
    connect(list_, &QTreeWidget::itemActivated, page_, qOverload<>(&QWidget::setFocus));
    connect(page_, &QTextBrowser::sourceChanged, this, &GuideWindow::showWhere);
    auto* find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, field_, [this] {
        field_->setFocus(Qt::ShortcutFocusReason);
        field_->selectAll();
    });
    listPages();
    if (firstPage.isEmpty())
        page_->setPlainText(tr("The guide was not installed with the program."));
    else
        list_->setCurrentItem(list_->topLevelItem(0));
}

void GuideWindow::build() {
    field_->setObjectName(QStringLiteral("guide-search"));
    field_->setPlaceholderText(tr("Search the guide"));
    field_->setToolTip(tr("Finds what has all these words, on every page (%1)")
                           .arg(QKeySequence(QKeySequence::Find).toString(QKeySequence::NativeText)));
    field_->setAccessibleName(field_->placeholderText());
    field_->setClearButtonEnabled(true);
    field_->installEventFilter(this);
    list_->setObjectName(QStringLiteral("guide-list"));
    list_->setAccessibleName(tr("Pages of the guide"));
    list_->setIndentation(kRhythm);
    list_->setRootIsDecorated(false);
    list_->setItemsExpandable(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    auto* back = new QPushButton(tr("Back", "to the page before"));
    back->setAutoDefault(false);
    back->setEnabled(false);
    connect(back, &QPushButton::clicked, page_, &QTextBrowser::backward);
    connect(page_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
    auto* left = new QWidget;
    left->setObjectName(QStringLiteral("dockBody"));
    left->setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, kRhythm, 0, kRhythm);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(kRhythm, 0, kRhythm, 0);
    top->addWidget(field_, 1);
    top->addWidget(back);
    column->addLayout(top);
    column->addWidget(list_, 1);
    auto* halves = new QSplitter;
    halves->addWidget(left);
    halves->addWidget(page_);
    halves->setStretchFactor(1, 1);
    halves->setChildrenCollapsible(false);
    halves->setSizes({kListWidth, kPageWidth});
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(halves);
}

void GuideWindow::search() {
    const QStringList words = searchWords(field_->text());
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        words.isEmpty() ? listPages() : listPlaces(words);
    }
    if (words.isEmpty()) showWhere(page_->source());
    page_->openAt(page_->source().toLocalFile(), page_->textCursor().position(), words);
}

void GuideWindow::listPages() {
    if (!first_.isEmpty()) addBold(*list_, tr("Contents"))->setData(0, kFileRole, first_);
    QTreeWidgetItem* group = nullptr;
    for (const GuidePage& page : index_.pages()) {
        if (!group || group->text(0) != page.group) {
            group = addBold(*list_, page.group);
            group->setFlags(Qt::ItemIsEnabled); // a heading is no page
            group->setForeground(0, theme().textDimmed);
        }
        auto* item = new QTreeWidgetItem(group, {page.title});
        item->setData(0, kFileRole, page.file);
    }
    list_->expandAll();
}

void GuideWindow::listPlaces(const QStringList& words) {
    for (std::size_t i = 0; i < index_.pages().size(); ++i) {
        const auto places = index_.find(i, words);
        if (places.empty()) continue;
        const GuidePage& page = index_.pages()[i];
        QTreeWidgetItem* heading = addBold(*list_, page.title);
        heading->setData(0, kFileRole, page.file);
        heading->setData(0, kPositionRole, places.front().position);
        for (std::size_t k = 0; k < std::min<std::size_t>(places.size(), kMostPlaces); ++k) {
            auto* item = new QTreeWidgetItem(heading, {excerptOf(places[k].text, words)});
            item->setToolTip(0, (places[k].heading.isEmpty() ? page.title : places[k].heading) +
                                    QStringLiteral("\n") + places[k].text);
            item->setData(0, kFileRole, page.file);
            item->setData(0, kPositionRole, places[k].position);
        }
    }
    list_->expandAll();
}

void GuideWindow::open(const QTreeWidgetItem* item) {
    const QString file = item ? item->data(0, kFileRole).toString() : QString();
    if (file.isEmpty()) return;
    page_->openAt(file, item->data(0, kPositionRole).toInt(), searchWords(field_->text()));
}

void GuideWindow::openFirst() {
    if (list_->topLevelItemCount() > 0 && !searchWords(field_->text()).isEmpty())
        list_->setCurrentItem(list_->topLevelItem(0)->child(0));
}

/// The row of the page that a link led to; while something is searched the places stay.
void GuideWindow::showWhere(const QUrl& page) {
    if (!searchWords(field_->text()).isEmpty()) return;
    const QSignalBlocker quiet(list_);
    for (QTreeWidgetItemIterator each(list_); *each; ++each)
        if ((*each)->data(0, kFileRole).toString() == page.toLocalFile()) list_->setCurrentItem(*each);
}

bool GuideWindow::eventFilter(QObject* watched, QEvent* event) {
    if (watched != field_ || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Down) return false;
    list_->setFocus(Qt::OtherFocusReason);
    if (!list_->currentItem()) openFirst();
    return true;
}

void GuideWindow::reject() {
    if (field_->text().isEmpty()) return QDialog::reject();
    field_->clear();
}

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
    auto* window = new GuideWindow(guidePage(), parent);
    window->show();
}

} // namespace tactum
