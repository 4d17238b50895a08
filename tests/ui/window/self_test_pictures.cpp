#include "tests/ui/window/self_test_pictures.h"

#include "tests/ui/window/self_test_desk.h"
#include "ui/base/language.h"

namespace tactum {

namespace {

void save(SelfTestDesk& desk, const QDir& folder, const QString& name) {
    desk.program.frames(60);
    const QString file = folder.filePath(name + QStringLiteral(".png"));
    if (!desk.person.dialog()->grab().save(file)) qFatal("%s cannot be written", qPrintable(file));
    qInfo("%s", qPrintable(file));
}

void must(bool held) {
    if (!held) qFatal("the self-test does not come so far");
}

void take(const QDir& folder, const char* theme, const QString& suffix) {
    SelfTestDesk desk;
    desk.program.command(theme).trigger();
    SelfTestPerson& person = desk.person;
    must(desk.connectIt());
    person.open();
    save(desk, folder, QStringLiteral("self-test-begin") + suffix);
    person.click("self-test-start");
    must(person.goThrough([&] { return person.asked() && person.ask() == TrialAsk::Up; }));
    desk.bench.device->putGrip({0.004, 0.026, 0.001}); // on its way
    save(desk, folder, QStringLiteral("self-test") + suffix);
    must(person.goThrough([&] { return desk.bench.device->force().norm() > 0.8; }));
    save(desk, folder, QStringLiteral("self-test-measuring") + suffix);
    must(person.goThrough());
    save(desk, folder, QStringLiteral("self-test-result") + suffix);
}

} // namespace

void takeSelfTestPictures(const QDir& folder, bool all) {
    take(folder, "theme-dark", {});
    if (!all) return;
    Language german;
    if (!german.begin(QStringLiteral("de"))) qFatal("there is no German");
    QCoreApplication::installTranslator(&german);
    take(folder, "theme-light", QStringLiteral("-light-de"));
    QCoreApplication::removeTranslator(&german);
}

} // namespace tactum
