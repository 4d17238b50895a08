// The Falcon's program: what is one, and where the person's copy is looked for. The ones here are made up.
#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "device/falcon/falcon_firmware.h"
#include "tests/device/falcon/boot_stream.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_falcon_firmware {

using namespace tactum;
using test::makeBootStream;
using test::refusal;

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// A folder of files that goes away with the test.
struct Folder {
    fs::path put(const std::string& name, const Bytes& bytes) const {
        const fs::path file = path / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        return file;
    }
    QTemporaryDir made;
    fs::path path = made.path().toStdString();
};

} // namespace

class TestFalconFirmware : public QObject {
    Q_OBJECT

private slots:
    void init() { qunsetenv("TACTUM_FALCON_FIRMWARE"); }

    void aStreamKnowsItsLength() {
        for (const std::vector<int>& blocks : {std::vector<int>{}, {1}, {100, 1, 7}, {4000, 200}}) {
            Bytes bytes = makeBootStream(blocks);
            QCOMPARE(bootStreamLength(bytes), bytes.size());
            for (std::size_t size = 0; size < bytes.size(); ++size)
                QCOMPARE(bootStreamLength(std::span(bytes).first(size)), std::size_t(0));
            const std::size_t length = bytes.size();
            bytes.push_back(1);
            bytes.push_back(2);
            QCOMPARE(bootStreamLength(bytes), length);
        }
    }

    void whatIsNoStream() {
        Bytes bytes = makeBootStream();
        bytes[0] = 0xab;
        QCOMPARE(bootStreamLength(bytes), std::size_t(0));
        bytes = makeBootStream();
        bytes[22] = bytes[23] = 0xff; // a block that is longer than all
        QCOMPARE(bootStreamLength(bytes), std::size_t(0));
    }

    void onlyWholeStreamsAreRead() {
        const Folder folder;
        const Bytes whole = makeBootStream();
        const auto read = readFalconFirmware(folder.put("good.bin", whole));
        VERIFY_RESULT(read);
        QCOMPARE_EQ(read->bytes, whole);
        QVERIFY(read->name.empty());
        QCOMPARE(read->file, folder.path / "good.bin");

        Bytes longer = whole;
        longer.push_back(0);
        const Bytes shorter(whole.begin(), whole.end() - 2);
        for (const Bytes& bad : {Bytes{}, longer, shorter, Bytes(100, 7), Bytes(1'000'000, 0)})
            COMPARE_CONTAINS(refusal(readFalconFirmware(folder.put("bad.bin", bad))),
                             "no firmware of a Falcon");
        COMPARE_CONTAINS(refusal(readFalconFirmware(folder.path / "missing.bin")), "There is no file");
        COMPARE_CONTAINS(refusal(readFalconFirmware(folder.path)), "There is no file");
    }

    void theChosenFileIsTakenAndNoOther() {
        const Folder folder;
        const fs::path chosen = folder.put("chosen", makeBootStream({5})),
                       other = folder.put("other.bin", makeBootStream({6})),
                       bad = folder.put("bad", Bytes(50, 1));
        qputenv("TACTUM_FALCON_FIRMWARE", other.c_str());
        QCOMPARE(findFalconFirmware(chosen, {other})->file, chosen);
        QCOMPARE(findFalconFirmware({}, {chosen})->file, other);
        COMPARE_CONTAINS(refusal(findFalconFirmware(bad, {other})), "bad");
        qputenv("TACTUM_FALCON_FIRMWARE", bad.c_str());
        COMPARE_CONTAINS(refusal(findFalconFirmware({}, {other})), "bad");
    }

    void placesAreLookedAtInTheirOrder() {
        const Folder folder;
        folder.put("first/broken.bin", Bytes(50, 1));
        folder.put("first/readme.txt", makeBootStream());
        const fs::path b = folder.put("second/b.bin", makeBootStream({5}));
        const std::vector<fs::path> places{folder.path / "none", folder.path / "first",
                                           folder.path / "second",
                                           folder.put("third.bin", makeBootStream({9}))};
        QCOMPARE(findFalconFirmware({}, places)->file, b);
        const fs::path a = folder.put("second/a.bin", makeBootStream({6}));
        QCOMPARE(findFalconFirmware({}, places)->file, a);
        fs::remove_all(folder.path / "second");
        QCOMPARE(findFalconFirmware({}, places)->file, places.back());
    }

    void whoHasNoneIsToldWhereToGetOne() {
        const Folder folder;
        const auto none = findFalconFirmware({}, {folder.path / "falcon"});
        COMPARE_CONTAINS(refusal(none), "nvent_firmware.bin");
        COMPARE_CONTAINS(refusal(none), (folder.path / "falcon").c_str());
        QCOMPARE(none.error().kind, Error::Kind::Input);
    }

    void aFileThatIsGivenIsKept() {
        const Folder folder;
        qputenv("XDG_CONFIG_HOME", folder.path.c_str());
        const Bytes bytes = makeBootStream({7});
        const auto kept = keepFalconFirmware(folder.put("from elsewhere/novint.fw", bytes));
        VERIFY_RESULT(kept);
        QCOMPARE_EQ(kept->file, folder.path / "Tactum/falcon/novint.bin");
        fs::remove_all(folder.path / "from elsewhere");
        const auto found = findFalconFirmware({});
        VERIFY_RESULT(found);
        QCOMPARE_EQ(found->file, kept->file);
        QCOMPARE_EQ(found->bytes, bytes);
        // What is none replaces nothing.
        COMPARE_CONTAINS(refusal(keepFalconFirmware(folder.put("novint.bin", Bytes(50, 1)))),
                         "no firmware of a Falcon");
        QCOMPARE_EQ(findFalconFirmware({})->bytes, bytes);
        // Chosen where it is already.
        VERIFY_RESULT(keepFalconFirmware(kept->file));
        QCOMPARE_EQ(findFalconFirmware({})->bytes, bytes);
        // A file where the folder should be.
        fs::remove_all(folder.path / "Tactum");
        folder.put("Tactum", {1});
        COMPARE_CONTAINS(refusal(keepFalconFirmware(folder.put("novint.bin", bytes))), "cannot be made");
        qunsetenv("XDG_CONFIG_HOME");
    }

    void thePersonsOwnFolderIsFirst() {
        qputenv("XDG_CONFIG_HOME", "/somewhere");
        QCOMPARE(falconFirmwarePlaces().front(), fs::path("/somewhere/Tactum/falcon"));
        qunsetenv("XDG_CONFIG_HOME");
        qputenv("HOME", "/home/her");
        QCOMPARE(falconFirmwarePlaces().front(), fs::path("/home/her/.config/Tactum/falcon"));
    }
};

TACTUM_TEST(TestFalconFirmware)

} // namespace test_falcon_firmware

#include "test_falcon_firmware.moc"
