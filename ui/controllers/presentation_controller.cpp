#include "ui/controllers/presentation_controller.h"

#include "ui/showing/presentation.h"

namespace tactum {

PresentationController::PresentationController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), presentation_(*new Presentation(bench.window, bench.view)) {
    connect(&bench.actions["present"], &QAction::toggled, this, &PresentationController::present);
    bench.on("panels", this, [this] {
        if (presentation_.on()) panelsWereHidden_ = bench_.actions["panels"].isChecked();
    });
}

bool PresentationController::leave() {
    const bool was = presentation_.on();
    bench_.actions["present"].setChecked(false);
    return was;
}

void PresentationController::present(bool on) {
    QAction& panels = bench_.actions["panels"];
    if (on) panelsWereHidden_ = panels.isChecked();
    panels.setChecked(on || panelsWereHidden_);
    presentation_.set(on);
}

} // namespace tactum
