#include "ui/controllers/import_controller.h"

#include <QUndoStack>

#include "ui/document/document.h"
#include "ui/panels/import_bar.h"
#include "ui/showing/playback.h"
#include "ui/tools/touch_hint.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

/// In the order of kLengthUnits.
constexpr const char* kUnitCommands[] = {"taken-m", "taken-cm", "taken-mm", "taken-in"};
constexpr std::pair<const char*, bool> kUpCommands[] = {{"up-y", false}, {"up-z", true}};
static_assert(std::size(kUnitCommands) == std::size(kLengthUnits));

} // namespace

ImportController::ImportController(const Workbench& bench, ImportBar& bar, const QWidget& playbackBar,
                                   TouchHint& hint)
    : QObject(&bench.window), bench_(bench), bar_(bar), playbackBar_(playbackBar), hint_(hint) {
    connect(&bar, &ImportBar::chosen, this, &ImportController::takeOtherwise);
    connect(&bar, &ImportBar::arranged, this, &ImportController::keepFootFree);
    connect(&bar, &ImportBar::closed, this, [this] {
        seen_ = true;
        show();
    });
    connectCommands();
    connectDocument();
    connect(&bench.playback, &Playback::begun, this, &ImportController::show);
    connect(&bench.playback, &Playback::ended, this, &ImportController::show);
    show();
}

void ImportController::connectCommands() {
    for (std::size_t i = 0; i < std::size(kUnitCommands); ++i)
        bench_.on(kUnitCommands[i], this, [this, i] {
            if (const auto shown = shownAxes()) takeOtherwise({kLengthUnits[i].metres, shown->zUp});
        });
    for (const auto& [id, zUp] : kUpCommands)
        bench_.on(id, this, [this, up = zUp] {
            if (const auto shown = shownAxes()) takeOtherwise({shown->unit, up});
        });
}

void ImportController::connectDocument() {
    Document& document = bench_.document;
    const auto another = [this] {
        seen_ = false;
        endAsking();
    };
    connect(&document, &Document::opened, this, [this, another] {
        another();
        if (bench_.document.history().count() == 0) bench_.notice.takeBack(fitted_); // of another scene
    });
    connect(&document, &Document::geometryUpdated, this, another);
    connect(&document, &Document::added, this, another);
    connect(&document, &Document::openFailed, this, &ImportController::endAsking); // the choice is as before
    connect(&document, &Document::editEnded, this, &ImportController::endAsking);
    connect(&document, &Document::saved, this, &ImportController::show);
    connect(&document, &Document::noted, this, [this](const QString& sentence) {
        fitted_ = sentence;
        bench_.notice.showNote(sentence);
    });
    // A trial is no step of the history, and not there yet when it is announced.
    connect(&document, &Document::changed, this, &ImportController::show, Qt::QueuedConnection);
    connect(&document.history(), &QUndoStack::indexChanged, this, &ImportController::show);
    connect(&document.history(), &QUndoStack::cleanChanged, this, &ImportController::show);
}

/// As what the file was taken, or is about to be.
std::optional<FileAxes> ImportController::shownAxes() const {
    const TakenAs* taken = bench_.document.takenAs();
    return taken ? std::optional(asked_.value_or(taken->axes)) : std::nullopt;
}

void ImportController::takeOtherwise(const FileAxes& axes) {
    const auto shown = shownAxes();
    if (!shown || axes == *shown) return show(); // a command that holds already stays ticked
    const std::filesystem::path file = bench_.document.takenFile();
    const FileAxes guess = bench_.document.takenAs()->guess;
    if (axes.unit != shown->unit) rememberUnit(file, axes.unit, guess.unit);
    if (axes.zUp != shown->zUp) rememberUp(file, axes.zUp, guess.zUp);
    asked_ = axes;
    bench_.notice.takeBack(fitted_); // its size is another one soon
    bench_.document.takeOtherwise({axes.unit, axes.zUp});
    show();
}

void ImportController::endAsking() {
    asked_.reset();
    show();
}

/// Offered only while there is nothing to lose: to open a file again begins a new history, and an update ends
/// what could be done again.
void ImportController::show() {
    const TakenAs* offered = seen_ || bench_.playback.active() ? nullptr : bench_.document.takenAs();
    showCommands(offered);
    if (offered) {
        TakenAs taken = *offered;
        if (asked_) {
            taken.axes = *asked_;
            taken.by = TakenAs::By::Choice;
        }
        bar_.display(QString::fromStdU16String(bench_.document.takenFile().filename().u16string()), taken,
                     asked_ ? std::nullopt : std::optional(bench_.document.takenAcross()));
    } else
        bar_.hide();
    keepFootFree();
}

/// What the view says at its lower edge stays above the bars that lie there.
void ImportController::keepFootFree() {
    const auto heightOf = [](const QWidget& bar) { return bar.isHidden() ? 0 : bar.sizeHint().height(); };
    hint_.keepAbove(heightOf(bar_) + heightOf(playbackBar_));
    bench_.view.setFoot(heightOf(playbackBar_));
}

void ImportController::showCommands(const TakenAs* taken) {
    const auto shown = shownAxes();
    for (std::size_t i = 0; i < std::size(kUnitCommands); ++i) {
        bench_.actions[kUnitCommands[i]].setEnabled(taken && taken->unitOpen);
        bench_.actions[kUnitCommands[i]].setChecked(shown && shown->unit == kLengthUnits[i].metres);
    }
    for (const auto& [id, zUp] : kUpCommands) {
        bench_.actions[id].setEnabled(taken && taken->upOpen);
        bench_.actions[id].setChecked(shown && shown->zUp == zUp);
    }
}

} // namespace tactum
