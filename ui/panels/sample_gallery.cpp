#include "ui/panels/sample_gallery.h"

#include <algorithm>
#include <string_view>

#include <QDir>
#include <QFileInfo>
#include <QVBoxLayout>

#include "ui/widgets/picture_card.h"

namespace tactum {

namespace {

/// What a sample teaches, by the name of its file.
struct Lesson {
    const char* sample;
    const char* sentence;
};

constexpr Lesson kLessons[] = {
    {"blind-box", QT_TR_NOOP("A shape that the eye does not see: find it out with the finger")},
    {"friction-ladder",
     QT_TR_NOOP("Six plates from smooth to rough: where the finger sticks and breaks loose")},
    {"layered-leather", QT_TR_NOOP("Grain, stitches and a worn place: textures laid over each other")},
    {"relief-coin", QT_TR_NOOP("A flat face that feels like a relief, from one picture")},
    {"stiffness-ladder", QT_TR_NOOP("Six plates from soft to hard, up to what the device can give")},
    {"teapot", QT_TR_NOOP("Glaze and cork, and facets that feel round")},
    {"texture-wall", QT_TR_NOOP("Brick, tiles, weave and sandpaper, from pictures and formulas")},
    {"thin-wall-maze", QT_TR_NOOP("Walls thinner than the proxy: around them, never through")},
    {"viscosity-ladder", QT_TR_NOOP("Six plates like honey: the faster, the harder to slide")},
    {"ball-table", QT_TR_NOOP("Loose balls: push one, and it meets the others")},
    {"bell", QT_TR_NOOP("A bell on a rope, to be struck and held")},
    {"cabinet", QT_TR_NOOP("A door and two drawers with detents, friction and stops")},
    {"crank", QT_TR_NOOP("A knob turns the crank, and the crank drives a piston")},
    {"dominoes", QT_TR_NOOP("One blow goes through all of them")},
    {"kettle", QT_TR_NOOP("A lid on a hinge, which its own weight closes")},
    {"keyboard", QT_TR_NOOP("Keys on springs, with preload and stops")},
    {"marionette", QT_TR_NOOP("Twenty bodies on strings, all moved by one finger")},
    {"micro-sensor", QT_TR_NOOP("A mass on flexures: stiff in one direction, soft in another")},
    {"rocket-car", QT_TR_NOOP("Push the car back along its track against the thrust")},
    {"roller-coaster", QT_TR_NOOP("Push three cars over the hill, and they go through the loop")},
    {"turntable", QT_TR_NOOP("A motor that a finger can brake")},
    {"windmill", QT_TR_NOOP("Hold the sails against the wind")},
};

/// Nothing of a scene that is none of ours.
QStringList lessonOf(const QFileInfo& scene) {
    const std::string name = scene.completeBaseName().toStdString();
    const auto lesson = std::ranges::find(kLessons, std::string_view(name), &Lesson::sample);
    return lesson == std::end(kLessons) ? QStringList() : QStringList(SampleGallery::tr(lesson->sentence));
}

QString pictureOf(const QFileInfo& scene, const QString& ending = QStringLiteral(".png")) {
    return scene.path() + u'/' + scene.completeBaseName() + ending;
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
    auto* cards = new CardGrid;
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(cards);
    for (const QString& file : files) {
        const QFileInfo scene(file);
        auto* card = new PictureCard(titleOf(scene));
        card->setObjectName(QStringLiteral("sample-") + scene.completeBaseName());
        card->setPicture(QPixmap(pictureOf(scene)));
        card->setMoving(pictureOf(scene, QStringLiteral(".gif")));
        card->setDetails(lessonOf(scene));
        card->setToolTip(file);
        connect(card, &PictureCard::clicked, this, [this, file] { emit fileChosen(file); });
        cards->add(card);
    }
}

} // namespace tactum
