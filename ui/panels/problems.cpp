#include "ui/panels/problems.h"

#include "ui/style.h"

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
        return Problems::tr("Error");
    case Finding::Severity::Warning:
        return Problems::tr("Warning");
    case Finding::Severity::Note:
        break;
    }
    return Problems::tr("Note");
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

QString lineOf(const Finding& finding) {
    const QString sentence = QString::fromStdString(finding.sentence);
    if (finding.object.empty()) return sentence;
    return Problems::tr("%1: %2").arg(QString::fromStdString(finding.object), sentence);
}

} // namespace

Problems::Problems(Document& document, QWidget* parent)
    : HintedTree(tr("No problems found. What is doubtful about a mesh or a value will be listed here."),
                 parent),
      document_(document) {
    setObjectName(QStringLiteral("problems"));
    setAccessibleName(tr("Problems"));
    setRootIsDecorated(false);
    setWrapping();
    connect(this, &QTreeWidget::itemActivated, this, &Problems::selectObjectOf);
    connect(this, &QTreeWidget::itemClicked, this, &Problems::selectObjectOf);
    connect(&document_, &Document::changed, this, [this](const SceneChange& change) {
        using What = SceneChange::What;
        if (change.touchesShape() || change.what == What::Sides || change.what == What::Names) check();
    });
}

void Problems::check() {
    job_.start([this, scene = document_.scene()](const Progress&) -> BackgroundJob::Delivery {
        return [this, health = validate(scene)] { fill(health); };
    });
}

void Problems::fill(const std::vector<Finding>& health) {
    clear();
    for (const Finding& finding : document_.findings())
        add(finding);
    for (const Finding& finding : health) // the reader has said some of it already
        if (!has(finding)) add(finding);
    wrapRows();
    emit counted(topLevelItemCount());
}

bool Problems::has(const Finding& finding) const {
    return !findItems(lineOf(finding), Qt::MatchExactly).isEmpty();
}

void Problems::add(const Finding& finding) {
    const QString remedy = QString::fromStdString(finding.remedy);
    auto* item = new QTreeWidgetItem(this, {lineOf(finding)});
    item->setIcon(0, icon(iconOf(finding.severity), colourOf(finding.severity)));
    item->setData(0, Qt::UserRole, QString::fromStdString(finding.object));
    item->setToolTip(
        0, QStringLiteral("<p><b>%1</b> %2</p><p>%3</p>")
               .arg(wordOf(finding.severity), lineOf(finding).toHtmlEscaped(), remedy.toHtmlEscaped()));
}

void Problems::selectObjectOf(const QTreeWidgetItem* item) {
    const std::string name = item->data(0, Qt::UserRole).toString().toStdString();
    for (const SceneObject& object : document_.scene().objects)
        if (object.name == name) return document_.select(SurfaceRef{object.id, 0});
}

} // namespace tactum
