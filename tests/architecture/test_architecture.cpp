// The arrows of the house, read from sources and build files themselves; and the reader on sources with known
// faults.
#include <algorithm>

#include <QTest>

#include "tests/architecture/house_plan.h"
#include "tests/architecture/include_rules.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_architecture {

using namespace tactum::architecture;

namespace {

void expectNone(const Faults& faults) {
    QString all;
    for (const auto& fault : faults)
        all += "\n  " + QString::fromStdString(fault);
    QVERIFY2(faults.empty(), qPrintable(all));
}

Faults collect(const std::vector<SourceFile>& files, Faults (*rule)(const SourceFile&)) {
    Faults all;
    for (const auto& file : files)
        for (auto& fault : rule(file))
            all.push_back(std::move(fault));
    return all;
}

SourceFile source(const char* path, const char* include) {
    return {path, std::string("// A file.\n#pragma once\n\n#include ") + include + "\n"};
}

} // namespace

class TestArchitecture : public QObject {
    Q_OBJECT

    const std::vector<SourceFile> sources_ = readSources(TACTUM_SOURCE_DIR);
    const std::vector<SourceFile> buildFiles_ = readBuildFiles(TACTUM_SOURCE_DIR);

private slots:
    // The house as it stands.
    void sourcesAreFound() {
        QCOMPARE_GT(sources_.size(), 50);
        QCOMPARE_GT(buildFiles_.size(), 10);
    }
    void arrowsAreAllowed() { expectNone(collect(sources_, wrongIncludes)); }
    void roomsLinkAlongTheArrows() { expectNone(collect(buildFiles_, wrongLinks)); }
    void headersHaveTheirForm() { expectNone(collect(sources_, formFaults)); }
    void headersIncludeInOneDirection() { expectNone(includeRings(sources_)); }
    void planHasNoRing() { expectNone(roomRings()); }
    void realtimeFilesNeitherLockNorWrite();

    // The reader, on small sources with known faults.
    void readsEveryFormOfInclude();
    void findsTheInnermostRoom();
    void judgesAnInclude_data();
    void judgesAnInclude();
    void judgesALink();
    void reportsForm();
    void reportsRings();
    void findsWhatRunsInRealTime();
    void reportsALockInRealTime();
};

void TestArchitecture::realtimeFilesNeitherLockNorWrite() {
    const std::vector<SourceFile> files = realtimeSources(sources_);
    const auto isOneOfThem = [&](const char* path) {
        return std::ranges::any_of(files, [&](const SourceFile& file) { return file.path == path; });
    };
    // Some of each kind: loops, what they call, what that includes, drivers, and what never runs there.
    for (const char* path :
         {"core/runtime/servo_loop.cpp", "core/runtime/proxy_loop.cpp", "core/safety/servo_step.cpp",
          "core/haptics/haptic_step.cpp", "core/proxy/step_rounds.cpp",
          "core/collision/sphere_tree_sweep.cpp", "core/collision/kernel/lanes.inc",
          "core/surface/image_sample.cpp", "core/base/wait_free.h", "core/port/device_mailbox.h",
          "device/falcon/falcon_packet.cpp", "app/library/stepped_world.cpp"})
        QVERIFY2(isOneOfThem(path), path);
    for (const char* path : {"core/haptics/compile.cpp", "core/runtime/engine.cpp", "core/base/progress.h"})
        QVERIFY2(!isOneOfThem(path), path);
    expectNone(collect(files, realtimeFaults));
}

void TestArchitecture::readsEveryFormOfInclude() {
    const auto found = includesOf("#include <vector>\n"
                                  "  #  include \"core/base/vec.h\" // why\n"
                                  "// #include <mutex>\n"
                                  "const char* s = \"#include <map>\";\n"
                                  "#include\t<QTest>");
    QCOMPARE(found, (std::vector<std::string>{"vector", "core/base/vec.h", "QTest"}));
}

void TestArchitecture::findsTheInnermostRoom() {
    QCOMPARE(roomOf("core/base/vec.h"), "core/base");
    QCOMPARE(roomOf("ui/view/scene_view.h"), "ui/view");
    QCOMPARE(roomOf("ui/main.h"), "");
    QCOMPARE(roomOf("uikit/button.h"), "");
    QCOMPARE(roomOf("core/version.h"), "");
}

void TestArchitecture::judgesAnInclude_data() {
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("include");
    QTest::addColumn<bool>("allowed");
    auto add = [](const char* path, const char* include, bool allowed) {
        QTest::addRow("%s %s", path, include) << QByteArray(path) << QByteArray(include) << allowed;
    };
    add("core/proxy/a.h", "\"core/proxy/b.h\"", true);
    add("core/proxy/a.h", "\"core/base/vec.h\"", true); // over several arrows
    add("core/proxy/a.h", "\"core/scene/scene.h\"", false);
    add("core/base/a.h", "\"core/geometry/triangle.h\"", false);
    add("core/surface/a.h", "\"core/collision/sphere_tree.h\"", false);
    add("core/port/a.h", "\"core/haptics/world.h\"", false);
    add("core/haptics/a.h", "\"core/port/haptic_device.h\"", false);
    add("core/haptics/a.h", "\"core/loop/metronome.h\"", false); // no thread, no clock
    add("core/safety/a.h", "\"core/loop/metronome.h\"", false);
    add("core/runtime/a.cpp", "\"core/motion/body_motion.h\"", true);
    add("core/runtime/a.cpp", "\"device/simulated_hand.h\"", false);
    add("device/a.h", "\"core/port/haptic_device.h\"", true);
    add("device/a.h", "\"core/scene/scene.h\"", false);
    add("ui/window/a.cpp", "\"core/runtime/engine.h\"", true);
    add("ui/view/a.cpp", "\"ui/base/theme.h\"", true);
    add("ui/view/a.cpp", "\"ui/document/document.h\"", false); // the view knows no history
    add("ui/widgets/a.cpp", "\"ui/document/document.h\"", false);
    add("ui/panels/a.cpp", "\"ui/window/main_window.h\"", false);
    add("ui/window/a.cpp", "\"device/simulated_hand.h\"", false);
    add("ui/window/a.cpp", "\"app/main.h\"", false);
    add("app/a.cpp", "\"device/simulated_hand.h\"", true);
    add("app/a.cpp", "\"tests/architecture/house_plan.h\"", false);
    add("core/scene/a.cpp", "\"scene.h\"", false); // not from the root
    add("core/scene/a.cpp", "<vector>", true);
    add("core/scene/a.cpp", "<Eigen/Core>", true);
    add("core/scene/a.cpp", "<QString>", false);
    add("core/scene/a.cpp", "<vtkPolyData.h>", false);
    add("core/scene/a.cpp", "<libusb-1.0/libusb.h>", false);
    add("core/geometry/soup.cpp", "<OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>", false);
    add("core/files/gltf/gltf_model.h", "<tiny_gltf.h>", true);
    add("core/files/gltf/read_gltf.cpp", "<tiny_gltf.h>", false);
    add("device/a.cpp", "<QTimer>", false);
    add("ui/panels/a.cpp", "<QWidget>", true);
    add("ui/panels/a.cpp", "<vtkActor.h>", false);
    add("ui/panels/a.cpp", "\"a.moc\"", true);
    add("ui/view/a.cpp", "<vtkActor.h>", true);
    add("ui/view/a.cpp", "<boost/any.hpp>", false);
    add("attic/a.cpp", "<vector>", false); // no room
}

void TestArchitecture::judgesAnInclude() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, include);
    QFETCH(bool, allowed);
    QCOMPARE(wrongIncludes(source(path.constData(), include.constData())).empty(), allowed);
}

void TestArchitecture::judgesALink() {
    const auto faults = [](const char* path, const char* text) { return wrongLinks({path, text}).size(); };
    QCOMPARE(
        faults("core/proxy/CMakeLists.txt", "tactum_room(proxy\n SOURCES a.cpp\n USES collision motion)"),
        std::size_t(0));
    QCOMPARE(faults("core/proxy/CMakeLists.txt", "tactum_room(proxy USES collision\n scene)"),
             std::size_t(1));
    QCOMPARE(faults("core/base/CMakeLists.txt", "tactum_room(base)"), std::size_t(0));
    const char* const panels = "ui/panels/CMakeLists.txt";
    QCOMPARE(faults(panels, "tactum_ui_room(panels USES ui_view runtime PRIVATE device)"), std::size_t(0));
    QCOMPARE(faults(panels, "tactum_ui_room(panels USES device)"), std::size_t(1));
    QCOMPARE(faults(panels, "tactum_ui_room(panels USES ui_window ui_attic)"), std::size_t(2));
    QCOMPARE(faults(panels, "tactum_ui_room(panels USES attic)"), std::size_t(1));
}

void TestArchitecture::reportsForm() {
    QVERIFY(formFaults({"core/base/a.h", "// What it is.\n#pragma once\n"}).empty());
    QCOMPARE(formFaults({"core/base/a.h", "// What it is.\n"}).size(), std::size_t(1));
    QCOMPARE(formFaults({"core/base/a.h", "#pragma once\n"}).size(), std::size_t(2));
    QCOMPARE(formFaults(source("core/base/a.h", "<iostream>")).size(), std::size_t(1));
    QVERIFY(formFaults(source("app/a.h", "<iostream>")).empty());
}

void TestArchitecture::reportsRings() {
    const auto a = source("ui/a.h", "\"ui/b.h\""), b = source("ui/b.h", "\"ui/c.h\"");
    QVERIFY(includeRings({a, b, source("ui/c.h", "<vector>")}).empty());
    QCOMPARE(includeRings({a, b, source("ui/c.h", "\"ui/a.h\"")}),
             Faults{"these include each other: ui/a.h -> ui/b.h -> ui/c.h -> ui/a.h"});
}

void TestArchitecture::findsWhatRunsInRealTime() {
    const SourceFile loop{"core/a/loop.cpp", "#include \"core/a/step.h\"\nconst RealtimeScope scope;"},
        step{"core/a/step.h", "// A step.\n/// Bounded. Thread:\n/// real time.\nvoid f();"},
        stepSource{"core/a/step.cpp", "#include \"core/a/data.h\"\n"},
        data{"core/a/data.h", "// Values.\n#include <functional>\n"},
        maker{"core/a/data.cpp", "#include <map>\n"},
        compile{"core/a/compile.h", "/// Thread: any but real time.\nvoid g();"};
    QVERIFY(isMarkedRealtime(step));
    QVERIFY(!isMarkedRealtime(compile));
    QVERIFY(!isMarkedRealtime(
        {"core/a/b.h", "/// Thread: any, outside every RealtimeScope. In real time: no.\n"}));
    QStringList paths;
    for (const SourceFile& file : realtimeSources({loop, step, stepSource, data, maker, compile}))
        paths += QString::fromStdString(file.path);
    QCOMPARE(paths, (QStringList{"core/a/loop.cpp", "core/a/step.h", "core/a/step.cpp"}));
}

void TestArchitecture::reportsALockInRealTime() {
    QVERIFY(realtimeFaults(source("core/proxy/proxy.cpp", "<atomic>")).empty());
    QCOMPARE(realtimeFaults(source("core/proxy/proxy.cpp", "<mutex>")).size(), std::size_t(1));
    QCOMPARE(realtimeFaults(source("core/proxy/proxy.cpp", "<condition_variable>")).size(), std::size_t(1));
}

TACTUM_TEST(TestArchitecture)

} // namespace test_architecture

#include "test_architecture.moc"
