#include "tests/ui/window/told_window.h"

#include <clocale>

#include <QApplication>

#include "ui/base/style.h"
#include "ui/document/journal.h"

namespace tactum {

ToldWindow::ToldWindow(std::size_t hands, const std::function<void(test::ToldEngine&)>& tell)
    : engine(hands) {
    std::setlocale(LC_NUMERIC, "C");
    if (tell) tell(engine);
    applyTheme(rememberedTheme());
    window = std::make_unique<MainWindow>(document, engine, hand, QStringList());
    window->resize(1200, 800);
    window->setAttribute(Qt::WA_DontShowOnScreen);
    window->setUpdatesEnabled(false);
    window->show();
    QApplication::setActiveWindow(window.get()); // as far as Qt knows: its keys are taken
}

ToldWindow::~ToldWindow() {
    window->journal().discard(); // nothing for the next one to recover
}

void ToldWindow::catchUp() {
    if (!test::waitFor([&] { return window->publisher().world() && !window->publisher().working(); }))
        qFatal("nothing is published");
    engine.proxyTold.worldRevision = window->publisher().world()->revision;
}

WindowEffects ToldWindow::effects(std::function<void()> prepare) {
    return {*window, document, [this] { return !window->publisher().working(); }, std::move(prepare)};
}

} // namespace tactum
