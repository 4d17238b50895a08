#include "app/window.h"

#include <clocale>
#include <memory>

#include <QApplication>
#include <QIcon>
#include <QLocale>

#include "core/protocol/credentials.h"
#include "core/protocol/remote_engine.h"
#include "core/runtime/local_engine.h"
#include "device/registry.h"
#include "device/simulated_hand.h"
#include "ui/base/language.h"
#include "ui/base/preferences.h"
#include "ui/base/style.h"
#include "ui/engine/device_link.h"
#include "ui/panels/sample_gallery.h"
#include "ui/view/surface_format.h"
#include "ui/window/main_window.h"

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

/// As a factor beside that of the screen; before there is an application. Who sets Qt's own variable knows
/// better.
void usePreferredSize() {
    const double size = Preferences::instance().value(Preferred::Size) / 100;
    if (size != 1 && !qEnvironmentVariableIsSet("QT_SCALE_FACTOR"))
        qputenv("QT_SCALE_FACTOR", QByteArray::number(size));
}

/// So that two windows of one person are told apart.
std::string nameForOthers() {
    const QString name =
        QStringLiteral("%1@%2 %3")
            .arg(qEnvironmentVariable("USER", QStringLiteral("window")), QSysInfo::machineHostName())
            .arg(QCoreApplication::applicationPid());
    return name.toStdString();
}

/// The loops are the server's, and so is the device.
int runConnected(const WindowRequest& request, const std::shared_ptr<HandTarget>& hand) {
    RemoteSettings settings;
    settings.target = request.connect;
    settings.name = nameForOthers();
    settings.patience = 1.5; // longer than most need, and nobody likes to wait for a window
    const auto secrets =
        request.credentials.empty() ? Result<Credentials>() : loadClientCredentials(request.credentials);
    if (secrets) settings.certificate = secrets->certificate, settings.token = secrets->token;
    RemoteEngine engine(std::move(settings), hand);
    const auto started = secrets ? engine.start() : Result<void>(tl::unexpected(secrets.error()));
    // As at home: a simulated hand can hurt nobody. Where another client edits, it is theirs to say.
    for (std::size_t each = 0; started && engine.holdsPen() && each < engine.hands(); ++each)
        if (!engine.told(each).device.real) engine.setArmedOf(each, true);
    Document document;
    MainWindow window(document, engine, hand, sampleScenes());
    window.setShared(engine);
    QApplication::setWindowIcon(logo(128));
    window.show();
    if (!started) window.showFault(QString::fromStdString(started.error().text));
    return QApplication::exec();
}

} // namespace

int runWindow(int argc, char** argv, const WindowRequest& request) {
    useViewSurfaceFormat();
    // The names first: what the person prefers is found by them.
    QCoreApplication::setOrganizationName(QStringLiteral("Tactum"));
    QCoreApplication::setApplicationName(QStringLiteral("Tactum"));
    QCoreApplication::setApplicationVersion(QStringLiteral(TACTUM_VERSION));
    usePreferredSize();
    QApplication app(argc, argv);
    useNumbersOfC(); // after the application, which takes over the user's locale
    applyLanguage();
    applyTheme(rememberedTheme());

    auto hand = std::make_shared<HandTarget>();
    if (!request.connect.empty()) return runConnected(request, hand);
    LocalEngine engine(withOwnLimit(std::make_unique<SimulatedHand>(hand)));
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
    if (request.scene) window.open(QString::fromStdU16String(request.scene->u16string()));
    return QApplication::exec();
}

} // namespace tactum
