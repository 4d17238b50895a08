#include "tests/ui/window/device_pictures.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/ui/fake_devices.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/style.h"
#include "ui/engine/device_link.h"
#include "ui/view/scene_view.h"

namespace tactum {

namespace {

struct DevicePictures {
    DevicePictures(QDir theFolder, QSize size)
        : folder(std::move(theFolder)), desk(std::make_shared<FakeDesk>()),
          catalogue(std::make_unique<FakeCatalogue>(desk, nullptr)), program(size) {
        catalogue->hand = program.hand;
    }

    void save(const QString& name) {
        program.frames(40);
        const QString file = folder.filePath(name + suffix + QStringLiteral(".png"));
        if (!program.window->grab().save(file)) qFatal("%s cannot be written", qPrintable(file));
        qInfo("%s", qPrintable(file));
    }
    void click(const char* name) {
        program.window->findChild<QAbstractButton*>(QString::fromLatin1(name))->click();
        program.frames(20);
    }
    void until(const std::function<bool()>& held) {
        if (!test::waitFor(held)) qFatal("the device does not come so far");
    }
    void chooseArm() {
        auto* list = program.window->findChild<QTreeWidget*>(QStringLiteral("device-list"));
        const auto arm = [&] { return list->findItems(QStringLiteral("Example arm"), Qt::MatchStartsWith); };
        until([&] { return !arm().isEmpty(); });
        list->setCurrentItem(arm().front());
    }
    void takeConnecting() {
        program.window->setCatalogue(*catalogue);
        program.command("device-panel").trigger();
        chooseArm();
        click("device-connect-button");
        desk->go = 1;
        const DeviceLink& link = program.window->devices();
        until([&] { return !link.preparation().request.isEmpty(); });
        save(QStringLiteral("device"));
    }
    void takeFailure() {
        desk->failAt = 1;
        const DeviceLink& link = program.window->devices();
        until([&] { return !link.preparing(); });
        save(QStringLiteral("device-failed"));
        desk->failAt = -1;
        click("device-again");
    }
    void connectIt() {
        desk->go = 3;
        until([&] { return program.window->devices().connected(); });
        program.frames(20);
        program.window->findChild<QAbstractButton*>(QStringLiteral("notice-act"))->click();
    }
    void takePages() {
        desk->place(0.012, -0.008, 0.02);
        desk->buttons = 0b010;
        click("device-page-1");
        save(QStringLiteral("device-live"));
        click("device-page-2");
        save(QStringLiteral("device-workspace"));
        click("workspace-capture");
        save(QStringLiteral("device-axes"));
        click("workspace-capture");
        desk->buttons = 0;
    }
    void takeTrial() {
        click("device-page-3");
        desk->place(0, 0, 0);
        click("trial-friction-button");
        until([&] { return program.caughtUp(); });
        click("device-arm");
        until([&] { return program.engine.servo().gain == 1; });
        for (int i = 0; i < 60; ++i) {
            desk->place(1e-4 * i, -0.0155 - 5e-5 * i, 0);
            program.frames(1);
        }
        save(QStringLiteral("device-trial"));
        click("trial-end-button");
    }
    /// The hand pulls beyond the shell.
    void takeReach() {
        click("device-page-2");
        program.command("workspace-fit").trigger();
        auto* reach = program.window->findChild<QComboBox*>(QStringLiteral("workspace-reach"));
        reach->setCurrentIndex(1);
        emit reach->activated(1);
        desk->place(-0.016, 0.016, 0.016); // above the model, on its left
        program.frames(20);
        program.engine.restartProxy(); // it did not come there through the table
        program.frames(5);
        click("device-arm");
        until([&] { return program.engine.servo().gain == 1; });
        for (int i = 0; i <= 25; ++i) {
            desk->place(-0.016 - 8e-5 * i, 0.016 + 8e-5 * i, 0.016);
            program.frames(1);
        }
        save(QStringLiteral("device-reach"));
        program.command("undo").trigger();
        desk->place(0, 0, 0);
        program.frames(20);
        click("device-arm");
    }
    void setTheme(const char* id, const QString& newSuffix) {
        program.command(id).trigger();
        suffix = newSuffix;
    }

    QDir folder;
    QString suffix;
    std::shared_ptr<FakeDesk> desk;
    std::unique_ptr<FakeCatalogue> catalogue; // outlives the window
    TouchedWindow program;
};

} // namespace

void takeDevicePictures(const QDir& folder, const QString& sample, QSize size, bool all) {
    DevicePictures pictures(folder, size);
    if (!pictures.program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    pictures.takeConnecting();
    if (all) pictures.takeFailure();
    pictures.connectIt();
    if (all) pictures.takePages();
    pictures.takeTrial();
    pictures.takeReach();
    if (!all) return;
    pictures.setTheme("theme-light", QStringLiteral("-light"));
    pictures.takePages();
    pictures.takeTrial();
    pictures.click("device-page-0");
    pictures.save(QStringLiteral("device-connected"));
}

} // namespace tactum
