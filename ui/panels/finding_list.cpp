#include "ui/panels/finding_list.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/base/style.h"

namespace tactum {

namespace {

QString iconOf(Finding::Severity severity) {
    switch (severity) {
    case Finding::Severity::Error:
        return QStringLiteral("error");
    case Finding::Severity::Warning:
        return QStringLiteral("warning");
    case Finding::Severity::Note:
        break;
    }
    return QStringLiteral("note");
}

QString wordOf(Finding::Severity severity) {
    switch (severity) {
    case Finding::Severity::Error:
        return QObject::tr("Error");
    case Finding::Severity::Warning:
        return QObject::tr("Warning");
    case Finding::Severity::Note:
        break;
    }
    return QObject::tr("Note");
}

QColor colourOf(Finding::Severity severity) {
    switch (severity) {
    case Finding::Severity::Error:
        return theme().fault;
    case Finding::Severity::Warning:
        return theme().stick;
    case Finding::Severity::Note:
        break;
    }
    return theme().textDimmed;
}

/// A remedy begins small, for it follows a colon elsewhere.
QString withCapital(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

QString asSentence(QString text) {
    if (!text.isEmpty() && !text.endsWith(u'.')) text += u'.';
    return text;
}

/// With the remedy below each sentence: nothing is shown in the view that would explain it.
class FindingList : public HintedTree {
public:
    explicit FindingList(const std::vector<Finding>& findings) : HintedTree({}) {
        setObjectName(QStringLiteral("findings"));
        setRootIsDecorated(false);
        setSelectionMode(QAbstractItemView::NoSelection);
        setWrapping();
        for (const Finding& finding : findings) {
            auto* row = addFindingRow(*this, finding);
            const QString remedy = asSentence(withCapital(QString::fromStdString(finding.remedy)));
            row->setText(0, (asSentence(row->text(0)) + u'\n' + remedy).trimmed());
            row->setToolTip(0, {}); // it says the same
        }
        wrapRows();
    }
};

} // namespace

QString findingLine(const Finding& finding) {
    const QString sentence = QString::fromStdString(finding.sentence);
    if (finding.object.empty()) return sentence;
    return QObject::tr("%1: %2").arg(QString::fromStdString(finding.object), sentence);
}

QTreeWidgetItem* addFindingRow(QTreeWidget& tree, const Finding& finding) {
    const QString line = findingLine(finding);
    auto* row = new QTreeWidgetItem(&tree, {line});
    row->setIcon(0, icon(iconOf(finding.severity), colourOf(finding.severity)));
    row->setToolTip(0, QStringLiteral("<p><b>%1</b> %2</p><p>%3</p>")
                           .arg(wordOf(finding.severity), line.toHtmlEscaped(),
                                QString::fromStdString(finding.remedy).toHtmlEscaped()));
    return row;
}

QDialog* showFindings(const QString& title, const QString& sentence, const std::vector<Finding>& findings,
                      QWidget* parent) {
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(QStringLiteral("finding-list"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* text = new QLabel(sentence);
    text->setTextFormat(Qt::PlainText); // names come from files
    text->setWordWrap(true);
    auto* list = new FindingList(findings);
    list->setAccessibleName(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(2 * kRhythm, 2 * kRhythm, 2 * kRhythm, 2 * kRhythm);
    column->setSpacing(kRhythm);
    column->addWidget(text);
    column->addWidget(list, 1);
    column->addWidget(buttons);
    dialog->resize(70 * kRhythm, 45 * kRhythm);
    dialog->show();
    return dialog;
}

} // namespace tactum
