// The program with a catalogue of devices whose plugging and making ready the test decides.
#pragma once

#include <algorithm>
#include <memory>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include "tests/ui/fake_devices.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/engine/device_link.h"
#include "ui/panels/device_panel.h"

namespace tactum {

inline const QString kFake = QStringLiteral("fake:1-2");

/// The program with a catalogue, the dock Device in front.
struct Desk {
    /// `hurried`: the window looks for devices again and again instead of every second; too often to see that
    /// one in use sends no readings any more.
    /// `second`: of another device beside the example.
    explicit Desk(bool hurried = false, const std::shared_ptr<FakeDesk>& second = nullptr)
        : desk(std::make_shared<FakeDesk>()), catalogue(std::make_unique<FakeCatalogue>(desk, nullptr)) {
        catalogue->hand = program.hand;
        catalogue->otherDesk = second;
        catalogue->other = second != nullptr;
        program.window->setCatalogue(*catalogue);
        program.command("device-panel").trigger();
        QObject::connect(&looking_, &QTimer::timeout, &looking_, [this] { link().look(); });
        if (hurried) looking_.start(30);
    }

    QWidget& widget(const char* name) {
        auto* found = program.window->findChild<QWidget*>(QString::fromLatin1(name));
        if (!found) qFatal("no widget %s", name);
        return *found;
    }
    QString text(const char* name) {
        QWidget& label = widget(name);
        if (!label.isVisible()) return {};
        auto* button = qobject_cast<QPushButton*>(&label);
        return button ? button->text() : static_cast<QLabel&>(label).text();
    }
    void click(const char* name) { QTest::mouseClick(&widget(name), Qt::LeftButton); }
    QTreeWidget& list() { return static_cast<QTreeWidget&>(widget("device-list")); }
    QStringList rows() {
        QStringList texts;
        for (int i = 0; i < list().topLevelItemCount(); ++i)
            texts << list().topLevelItem(i)->text(0);
        return texts;
    }
    bool listed(const char* name) {
        return test::waitFor([&] { return !rows().filter(QString::fromLatin1(name)).isEmpty(); });
    }
    void chooseRow(const char* name) {
        if (!listed(name)) qFatal("%s is not listed", name);
        const auto found = list().findItems(QString::fromLatin1(name), Qt::MatchStartsWith);
        list().setCurrentItem(found.front());
    }
    /// Chooses it in the list and presses Connect.
    void begin() {
        chooseRow("Example arm");
        click("device-connect-button");
    }
    bool ready() {
        return test::waitFor([this] { return link().current() == kFake && !link().preparing(); });
    }
    bool connectIt() {
        desk->go = 3;
        begin();
        return ready();
    }
    void page(DevicePanel::Page page) {
        QTest::mouseClick(&widget(qPrintable(QStringLiteral("device-page-%1").arg(int(page)))),
                          Qt::LeftButton);
        program.frames(10);
    }
    void pick(const char* name, int row) {
        auto& box = static_cast<QComboBox&>(widget(name));
        box.setCurrentIndex(row);
        emit box.activated(row);
    }
    DeviceLink& link() { return program.window->devices(); }
    Engine& engine() { return program.engine; }
    bool fullForce() { return program.fullForce(); }
    QString steps() { return widget("device-give-up").parentWidget()->accessibleName(); }

    std::shared_ptr<FakeDesk> desk;
    std::unique_ptr<FakeCatalogue> catalogue; // outlives the window
    TouchedWindow program;

private:
    QTimer looking_;
};

/// Settings of their own for each test.
inline void beginDeviceTest(const QTemporaryDir& folder) {
    useSettingsIn(folder.path()); // every fault is saved as a recording there
    QSettings().clear();
}

} // namespace tactum
