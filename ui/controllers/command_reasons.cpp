#include "ui/controllers/command_reasons.h"

#include <QObject>

namespace tactum {

namespace {

/// Why a command can be off, where there is one reason alone and whoever switches it off gives none.
struct Reason {
    const char* id;
    const char* sentence;
};
constexpr auto kNotOffered =
    QT_TR_NOOP("The file says it, or it could lose edits; see the bar over the view after opening.");
constexpr auto kNothingThere = QT_TR_NOOP("Nothing is open, or the scene is empty.");
constexpr auto kNoTriangles =
    QT_TR_NOOP("No triangles are selected but whole surfaces at most; take some by box, lasso or brush.");
constexpr Reason kReasons[] = {
    {"save", kNothingThere},
    {"save-as", kNothingThere},
    {"export", kNothingThere},
    {"update-geometry", kNothingThere},
    {"save-picture", kNothingThere},
    {"taken-m", kNotOffered},
    {"taken-cm", kNotOffered},
    {"taken-mm", kNotOffered},
    {"taken-in", kNotOffered},
    {"up-y", kNotOffered},
    {"up-z", kNotOffered},
    {"undo", QT_TR_NOOP("There is no edit to take back.")},
    {"redo", QT_TR_NOOP("No edit was taken back.")},
    {"stop", QT_TR_NOOP("The forces are off already.")},
    {"hand-next", QT_TR_NOOP("There is one hand.")},
    {"hand-remove", QT_TR_NOOP("The first hand is chosen, which always is there; Disconnect gives its "
                               "device back.")},
    {"trial-end", QT_TR_NOOP("The scene is felt already.")},
    {"preset-apply", QT_TR_NOOP("No preset is chosen in the library, or no surface is selected.")},
    {"preset-save", QT_TR_NOOP("No surface is selected.")},
    {"preset-export", QT_TR_NOOP("No preset is chosen in the library.")},
    {"grow", kNoTriangles},
    {"shrink", kNoTriangles},
    {"split", kNoTriangles},
    {"merge", QT_TR_NOOP("Fewer than two surfaces are selected.")},
    {"swap-ab", QT_TR_NOOP("No state was marked as A.")},
    {"compare-now", QT_TR_NOOP("There is no stroke, or no state was marked as A.")},
    {"compare-csv", QT_TR_NOOP("Nothing was compared yet.")},
    {"study-save", QT_TR_NOOP("The study has no condition yet.")},
    {"study-keep", kNothingThere},
    {"study-replace", QT_TR_NOOP("No condition is chosen in the dock Study.")},
    {"study-show", QT_TR_NOOP("No condition is chosen in the dock Study.")},
    {"study-remove", QT_TR_NOOP("No condition is chosen in the dock Study.")},
    {"study-run", QT_TR_NOOP("The study cannot be run yet; the dock Study says why.")},
    {"layer-duplicate", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"layer-remove", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"layer-up", QT_TR_NOOP("No layer lies above the selected one.")},
    {"layer-down", QT_TR_NOOP("No layer lies beneath the selected one.")},
    {"layer-show", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"layer-solo", QT_TR_NOOP("No layer is selected that can be edited.")},
    {"mapping",
     QT_TR_NOOP("No layer is selected whose mapping has a frame; choose Triplanar, Planar or a round one.")},
};

} // namespace

QString whyOff(const QString& command, bool recordingShown) {
    if (recordingShown) return QObject::tr("A recording is shown; end it first.");
    for (const Reason& reason : kReasons)
        if (command == QLatin1String(reason.id)) return QObject::tr(reason.sentence);
    return QObject::tr("It has no effect as things are.");
}

} // namespace tactum
