#include "app/window.h"

#include <clocale>
#include <memory>

#include <QApplication>
#include <QIcon>
#include <QLocale>

#include "device/registry.h"
#include "device/simulated_hand.h"
#include "ui/main_window.h"
#include "ui/panels/sample_gallery.h"
#include "ui/style.h"
#include "ui/view/surface_format.h"

namespace tactum {

namespace {

/// Beside an installed program, or in the tree that it was built from; empty when in neither.
QStringList sampleScenes() {
    const QString program = QCoreApplication::applicationDirPath();
    for (const QString& folder :
         {program + QStringLiteral("/../share/tactum"), program + QStringLiteral("/../../share/tactum"),
          QStringLiteral(TACTUM_RESOURCES)}) {
        const QStringList samples = samplesIn(folder + QStringLiteral("/scenes"));
        if (!samples.isEmpty()) return samples;
    }
    return {};
}

/// Numbers have a point everywhere: on the screen, in files and in the libraries that read them.
void useNumbersOfC() {
    std::setlocale(LC_NUMERIC, "C");
    QLocale::setDefault(QLocale::c());
}

} // namespace

int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& scene) {
    useViewSurfaceFormat();
    QApplication app(argc, argv);
    useNumbersOfC(); // after the application, which takes over the user's locale
    QCoreApplication::setOrganizationName(QStringLiteral("Tactum"));
    QCoreApplication::setApplicationName(QStringLiteral("Tactum"));
    applyTheme(rememberedTheme());

    auto hand = std::make_shared<HandTarget>();
    Engine engine(std::make_unique<SimulatedHand>(hand));
    const auto started = engine.start();
    engine.setArmed(started.has_value()); // a simulated hand can hurt nobody
    Document document;
    const QString apart = qEnvironmentVariable("TACTUM_DEVICES_APART");
    const QString program = apart == u"none" ? QString() : QCoreApplication::applicationFilePath();
    DeviceRegistry devices({.hand = hand,
                            .profiles = personsProfiles(),
                            .program = program.toStdString(),
                            .allApart = apart == u"all"});
    MainWindow window(document, engine, hand, sampleScenes());
    window.setCatalogue(devices);
    QApplication::setWindowIcon(logo(128));
    window.show();
    if (!started) window.showFault(QString::fromStdString(started.error().text));
    if (scene) window.open(QString::fromStdU16String(scene->u16string()));
    return QApplication::exec();
}

} // namespace tactum
