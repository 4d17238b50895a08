// Size and alignment of every public struct: programs that were built before have them inside. Whoever
// changes one gives the library another number (docs/library.md).
#include <QTest>

#include "tests/app/library/plates.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_library_layout {

using namespace tactum;
using namespace tactum::test;

class TestLibraryLayout : public QObject {
    Q_OBJECT

private slots:
    void isWhatProgramsWereBuiltWith_data();
    void isWhatProgramsWereBuiltWith();
};

template <class T> void addLayout(const char* name, std::size_t size, std::size_t alignment = 8) {
    QTest::newRow(name) << sizeof(T) << size << alignof(T) << alignment;
}

void TestLibraryLayout::isWhatProgramsWereBuiltWith_data() {
    for (const char* column : {"size", "wantedSize", "alignment", "wantedAlignment"})
        QTest::addColumn<std::size_t>(column);
    addLayout<lib::Vec3>("Vec3", 24);
    addLayout<lib::Quaternion>("Quaternion", 32);
    addLayout<lib::Pose>("Pose", 56);
    addLayout<lib::FingerPoint>("FingerPoint", 32);
    addLayout<lib::Triangle>("Triangle", 12, 4);
    addLayout<lib::TouchRow>("TouchRow", 88);
    addLayout<lib::Contact>("Contact", 72);
    addLayout<lib::Step>("Step", 376);
    addLayout<lib::EngineState>("EngineState", 432);
    addLayout<lib::Workspace>("Workspace", 32);
    addLayout<lib::OpenOptions>("OpenOptions", 32);
    addLayout<lib::Image>("Image", 32);
    addLayout<lib::Parameter>("Parameter", 184);
    addLayout<lib::Device>("Device", 104);
    addLayout<lib::Bundle>("Bundle", 64);
    addLayout<lib::Error>("Error", 24);
    addLayout<lib::Preset>("Preset", 16);
    addLayout<lib::Layer>("Layer", 40);
    addLayout<lib::Surface>("Surface", 32);
    addLayout<lib::Object>("Object", 24);
    addLayout<lib::Scene>("Scene", 16);
    addLayout<lib::World>("World", 8);
    addLayout<lib::Engine>("Engine", 8);
    addLayout<lib::Hand>("Hand", 16);
}

void TestLibraryLayout::isWhatProgramsWereBuiltWith() {
    QFETCH(std::size_t, size);
    QFETCH(std::size_t, wantedSize);
    QFETCH(std::size_t, alignment);
    QFETCH(std::size_t, wantedAlignment);
    QCOMPARE(size, wantedSize);
    QCOMPARE(alignment, wantedAlignment);
}

TACTUM_TEST(TestLibraryLayout)

} // namespace test_library_layout

#include "test_library_layout.moc"
