#include "ui/panels/sample_gallery.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QToolButton>

namespace tactum {

namespace {

constexpr QSize kPicture(112, 84); // pixels, in the proportions of the pictures
constexpr int kColumns = 5;

QString pictureOf(const QFileInfo& scene) {
    return scene.path() + u'/' + scene.completeBaseName() + QStringLiteral(".png");
}

/// "friction-ladder" as a person writes it.
QString titleOf(const QFileInfo& scene) {
    QString title = scene.completeBaseName().replace(u'-', u' ');
    return title.left(1).toUpper() + title.mid(1);
}

} // namespace

QStringList samplesIn(const QString& folder) {
    QStringList files;
    for (const QFileInfo& scene :
         QDir(folder).entryInfoList({QStringLiteral("*.glb")}, QDir::Files, QDir::Name))
        if (QFileInfo::exists(pictureOf(scene))) files << scene.canonicalFilePath();
    for (const QFileInfo& group : QDir(folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
        files << samplesIn(group.filePath());
    return files;
}

SampleGallery::SampleGallery(const QStringList& files, QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    for (int i = 0; i < files.size(); ++i) {
        const QFileInfo scene(files[i]);
        auto* button = new QToolButton;
        button->setObjectName(QStringLiteral("sample-") + scene.completeBaseName());
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setIcon(QIcon(pictureOf(scene)));
        button->setIconSize(kPicture);
        button->setText(titleOf(scene));
        button->setToolTip(files[i]);
        button->setFocusPolicy(Qt::StrongFocus); // the Tab key reaches it too
        connect(button, &QToolButton::clicked, this, [this, file = files[i]] { emit fileChosen(file); });
        grid->addWidget(button, i / kColumns, i % kColumns);
    }
    grid->setColumnStretch(kColumns, 1);
}

} // namespace tactum
