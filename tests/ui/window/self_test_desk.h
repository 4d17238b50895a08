// A window with an emulated Falcon whose x is turned round, and a person who is led through the self-test.
#pragma once

#include "tests/device/falcon/falcon_bench.h"
#include "tests/ui/window/self_test_person.h"
#include "tests/ui/window/wrong_catalogue.h"
#include "ui/engine/device_link.h"

namespace tactum {

struct SelfTestDesk {
    explicit SelfTestDesk(QSize size = {1200, 800}) : program(size) {
        qputenv("TACTUM_FALCON_FIRMWARE", QByteArray::fromStdString(bench.firmware()));
        bench.device->startFirmware(true);
        bench.device->putGrip(Vec3::Zero());
        program.window->setCatalogue(catalogue);
        person.hurry({.rest = 2, .shake = 8});
    }
    ~SelfTestDesk() { qunsetenv("TACTUM_FALCON_FIRMWARE"); }
    SelfTestDesk(const SelfTestDesk&) = delete;
    SelfTestDesk& operator=(const SelfTestDesk&) = delete;

    bool connectIt() {
        const QString falcon = QStringLiteral("falcon:1-%1").arg(test::kSocket);
        DeviceLink& link = program.window->devices();
        if (!test::waitFor([&] { return link.find(falcon) != nullptr; })) return false;
        link.choose(falcon);
        return test::waitFor([&] {
            // A machine that is late lost an answer: a person tries once more.
            if (link.preparation().state == Preparation::State::Failed) link.choose(falcon);
            return link.current() == falcon;
        });
    }

    test::FalconBench bench{1}; // at the pace of a real one; it outlives the window
    QTemporaryDir profiles;
    WrongCatalogue catalogue{{.hand = {}, .profiles = profiles.path().toStdString(), .program = {}},
                             {.scale = {-1, 1, 1}}};
    TouchedWindow program;
    SelfTestPerson person{program, [this](TrialAsk what) {
                              test::doAsAsked(*bench.device, what);
                              return what != TrialAsk::Press; // the emulated hand has one finger
                          }};
};

} // namespace tactum
