#include "ui/controllers/sound_controller.h"

#include <QMenu>
#include <QMenuBar>

#include "ui/sound/sound_link.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

// Whether there is an output is asked when the menu opens: the answer may take a moment, and may change.
SoundController::SoundController(const Workbench& bench, SoundLink& link)
    : QObject(&bench.window), bench_(bench), sound_(link) {
    QAction& sound = bench.actions["sound"];
    connect(&sound, &QAction::toggled, this, &SoundController::setSound);
    auto* menu = bench.window.menuBar()->findChild<QMenu*>(QStringLiteral("View"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [&sound, usual = sound.toolTip()] {
        const QString why = SoundLink::whyNot();
        sound.setEnabled(why.isEmpty() || sound.isChecked());
        sound.setToolTip(why.isEmpty() ? usual : why);
    });
}

void SoundController::setSound(bool on) {
    if (!on) return sound_.stop();
    if (sound_.start()) return;
    const QString why = SoundLink::whyNot();
    bench_.notice.showNote(why.isEmpty()
                               ? tr("The audio output could not be opened; is another program holding it?")
                               : tr("%1: nothing can be heard.").arg(why));
    bench_.actions["sound"].setChecked(false);
}

} // namespace tactum
