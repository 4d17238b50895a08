// What `tactum devices` finds, on a made-up USB tree.

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "device/registry.h"

using namespace tactum;

class TestDeviceRegistry : public QObject {
    Q_OBJECT

    static void plug(const QTemporaryDir& bus, const char* port, const char* vendor, const char* product) {
        QDir(bus.path()).mkpath(port);
        for (const auto& [name, text] : {std::pair("idVendor", vendor), std::pair("idProduct", product)}) {
            QFile file(bus.filePath(QString(port) + "/" + name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(QByteArray(text) + "\n");
        }
    }

private slots:
    void theSimulatedHandIsAlwaysThere() {
        const auto listings = listDevices("/no/such/bus");
        QVERIFY(listings.front().usable);
        QCOMPARE(listings.front().name, std::string("Simulated hand"));
        QVERIFY(!listings.back().usable);
    }

    void aFalconIsFoundAndExplained() {
        QTemporaryDir bus;
        plug(bus, "1-1", "0403", "6001"); // some other serial adapter
        plug(bus, "1-2", "0403", "cb48");
        const auto listings = listDevices(bus.path().toStdString());
        QCOMPARE(listings.size(), std::size_t(3));
        QCOMPARE(listings.back().name, std::string("Novint Falcon"));
        QVERIFY(!listings.back().usable);
        QVERIFY(listings.back().sentence.find("1-2") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(TestDeviceRegistry)
#include "test_device_registry.moc"
