// Archives that lie, each refused for its own reason before it can do harm.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/archive/zip_archive.h"
#include "tests/core/archive/raw_zip.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_hostile_zips {

using namespace tactum;
using namespace tactum::test;
using namespace std::string_literals;

namespace {

constexpr std::uint32_t kMega = 1 << 20;

std::string named(const std::string& name) {
    return rawZip({{.name = "good.txt", .packed = "good"}, {.name = name, .packed = "bad"}});
}

/// A good entry and this one.
std::string with(const RawEntry& entry) {
    return rawZip({{.name = "good.txt", .packed = "good"}, entry});
}

std::string ended(const RawEnd& end) {
    return rawZip({{.name = "good.txt", .packed = "good"}}, end);
}

/// So many bytes that say they unpack to so many more.
RawEntry inflating(std::string name, std::size_t packed, std::uint32_t size) {
    return {.name = std::move(name), .packed = std::string(packed, 'x'), .method = 8, .size = size};
}

/// An extra field, which says that it is longer than it is.
std::string extra(std::uint16_t id, const std::string& content, std::size_t lie = 0) {
    const std::size_t size = content.size() + lie;
    return std::string{char(id), char(id >> 8), char(size), char(size >> 8)} + content;
}

std::string many(int count) {
    std::vector<RawEntry> entries;
    for (int i = 0; i < count; ++i)
        entries.push_back({.name = std::to_string(i), .packed = ""});
    return rawZip(entries);
}

std::string tar() {
    std::string bytes(512, '\0');
    return bytes.replace(257, 5, "ustar");
}

/// The second entry's bytes hold a whole entry of their own, which the directory names as well.
std::string nestedEntry() {
    const std::string inner = rawZip({{.name = "inner", .packed = "bad"}});
    const std::string header = inner.substr(0, 30 + 5 + 3);
    return rawZip({{.name = "outer", .packed = header}, {.name = "inner", .packed = "bad", .begin = 30 + 5}});
}

struct Hostile {
    const char* name;
    std::string bytes;
    const char* reason;
};

std::vector<Hostile> hostileArchives() {
    const std::string good = rawZip({{.name = "good.txt", .packed = "good"}});
    const std::string zip64 = extra(1, "12345678");
    return {
        {"climbs out", named("../evil"), "\"../evil\": leaves its folder"},
        {"climbs out later", named("a/../../evil"), "leaves its folder"},
        {"climbs out at the end", named("a/.."), "leaves its folder"},
        {"absolute", named("/etc/passwd"), "begins at the root of the disk"},
        {"drive", named("C:/evil"), "is on a drive of its own"},
        {"drive without root", named("c:evil"), "is on a drive of its own"},
        {"backslash", named("..\\evil"), "has a backslash in its name"},
        {"zero", named("a.png\0.exe"s), "\"a.png?.exe\": has a zero in its name"},
        {"no name", rawZip({{.name = "", .packed = "bad"}}), "has no name"},
        {"empty part", named("a//b"), "has an empty part in its name"},
        {"this folder", named("./a"), "has an empty part in its name"},
        {"only a slash", with({.name = "/", .attributes = 0}), "has no name"},
        {"not ASCII", named("\xc3\xa4"), "has a sign in its name"},
        {"control sign", named("a\nb"), "\"a?b\": has a sign in its name"},
        {"wildcard", named("a*"), "has a sign in its name"},
        {"stream of NTFS", named("good.txt:hidden"), "has a sign in its name"},
        {"long name", named(std::string(241, 'a')), "has too long a name"},
        {"twice", named("good.txt"), "is there twice;"},
        {"twice but for capitals", named("GOOD.txt"), "is there twice but for its capitals"},
        {"file and folder", named("Good.txt/a"), "\"good.txt\": is a file and a folder"},
        {"file and folder entry", with({.name = "good.txt/", .attributes = 0}), "is there twice"},
        {"link", with({.packed = "/etc/passwd", .attributes = 0120777u << 16}), "\"bad\": is a link"},
        {"device", with({.packed = "", .attributes = 0020666u << 16}), "is neither a file nor a folder"},
        {"folder in disguise", with({.packed = "", .attributes = 0040755u << 16}), "is neither a file nor"},
        {"encrypted", with({.packed = "bad", .flags = 1}), "is encrypted"},
        {"strongly encrypted", with({.packed = "bad", .flags = 1 << 6}), "is encrypted"},
        {"masked", with({.packed = "bad", .flags = 1 << 13}), "is encrypted"},
        {"patch", with({.packed = "bad", .flags = 1 << 5}), "is a patch of another file"},
        {"AES", with({.packed = "bad", .method = 99}), "is packed in a way that is not read here (99)"},
        {"bzip2", with({.packed = "bad", .method = 12}), "is packed in a way that is not read here (12)"},
        {"nothing", "", "is no zip archive"},
        {"text", "Just a text, longer than the record at the end.", "is no zip archive"},
        {"only the beginning", "PK\3\4", "is a zip archive without its end"},
        {"cut off", good.substr(0, good.size() - 1), "is a zip archive without its end"},
        {"something follows", good + "x", "is a zip archive without its end"},
        {"comment", ended({.commentBytes = 3, .after = "PK!"}), "is a zip archive without its end"},
        {"comment missing", ended({.commentBytes = 3}), "whose comment is missing"},
        {"something before", "PK" + good, "whose directory is not where it says"},
        {"two ends", good + good.substr(good.size() - 22), "whose directory is not where it says"},
        {"split", ended({.disk = 1}), "is one part of several"},
        {"entry elsewhere", with({.packed = "bad", .disk = 1}), "is in another part of the archive"},
        {"fewer entries", ended({.entries = 2}), "with fewer entries than it says"},
        {"more entries", rawZip({{.name = "a", .packed = ""}, {.name = "b", .packed = ""}}, {.entries = 1}),
         "with more in its directory than it says"},
        {"zip64 count", ended({.entries = 0xffff}), "is a zip64 archive"},
        {"zip64 directory", ended({.begin = 0xffffffff}), "is a zip64 archive"},
        {"zip64 locator", ended({.before = "PK\6\7" + std::string(16, '\0')}), "is a zip64 archive"},
        {"zip64 entry", with({.packed = "bad", .extra = zip64, .size = 0xffffffff}), "is of zip64"},
        {"zip64 header", with({.packed = "bad", .localExtra = zip64}), "is of zip64"},
        {"zip64 without its field", with({.packed = "bad", .size = 0xffffffff}), "is larger than 1 GiB"},
        {"second name", with({.packed = "bad", .extra = extra(0x7075, "12345../x")}), "has a second name"},
        {"extra too long", with({.packed = "bad", .extra = extra(0x5455, "", 9)}),
         "an extra field is longer than its header"},
        {"directory elsewhere", ended({.begin = 1}), "whose directory is not where it says"},
        {"name over the end", std::string(good).replace(30 + 8 + 4 + 28, 1, "\x20"),
         "with a name that is longer than its directory"},
        {"other name in the header", with({.packed = "bad", .localName = "evil"}), "has another name"},
        {"other size in the header", with({.packed = "bad", .localSize = 4}), "contradict each other"},
        {"other method in the header", with({.packed = "bad", .localMethod = 8}), "contradict each other"},
        {"no header", with({.packed = "bad", .begin = 1}), "has no header"},
        {"header behind the files", with({.packed = "bad", .begin = 60}), "begins behind the end"},
        {"packed beyond the files", with({.packed = "bad", .packedSize = 4}), "reaches beyond the end"},
        {"one header for two",
         rawZip(
             {{.name = "a", .packed = "bad"}, {.name = "b", .packed = "bad", .begin = 0, .localName = "a"}}),
         "has another name"},
        {"over another", nestedEntry(), "\"inner\": lies over another entry"},
        {"many", many(4097), "of more than 4096 entries"},
        {"more than 1 GiB", with(inflating("bad", 2 * kMega, 1025 * kMega)), "is larger than 1 GiB"},
        {"more than 2 GiB",
         rawZip({inflating("a", kMega, 1000 * kMega), inflating("b", kMega, 1000 * kMega),
                 inflating("c", kMega, 1000 * kMega)}),
         "of more than 2 GiB"},
        {"bomb",
         with({.name = "bad",
               .packed = deflatedZeros(258 * 4'000'000 + 1),
               .method = 8,
               .size = 258 * 4'000'000 + 1}),
         "a bomb"},
        {"impossible size", with(inflating("bad", 3, 10'000)), "cannot be as large as it says"},
        {"stored and larger", with({.packed = "bad", .size = 4}), "cannot be as large as it says"},
        {"folder with bytes", with({.name = "bad/", .packed = "bad", .attributes = 0}),
         "a folder with bytes"},
        {"lying bomb", with({.packed = deflatedZeros(258 * 4'000'000 + 1), .method = 8, .size = 1000}),
         "\"bad\": holds more than it says"},
        {"less than it says", with({.packed = deflatedZeros(2581), .method = 8, .size = 2582}), "\"bad\": "},
        {"wrong sum", with({.packed = "bad", .crc = 1}), "\"bad\": is damaged"},
        {"no deflate", with({.packed = "\xff\xff\xff\xff", .method = 8}), "\"bad\": is damaged"},
        {"zip in a zip", with({.name = "model.glb", .packed = good}), "\"model.glb\": is an archive itself"},
        {"gzip in a zip", with({.packed = "\x1f\x8b\x08"}), "is an archive itself"},
        {"tar in a zip", with({.packed = tar()}), "is an archive itself"},
    };
}

} // namespace

class TestHostileZips : public QObject {
    Q_OBJECT

private slots:
    void isRefusedForItsReason_data() {
        QTest::addColumn<int>("which");
        const auto all = hostileArchives();
        QCOMPARE_GE(all.size(), 40);
        for (int i = 0; i < int(all.size()); ++i)
            QTest::newRow(all[std::size_t(i)].name) << i;
    }

    void isRefusedForItsReason() {
        QFETCH(int, which);
        static const auto all = hostileArchives();
        const Hostile& hostile = all[std::size_t(which)];
        const auto entries = readZip(hostile.bytes);
        QVERIFY(!entries);
        const std::string& text = entries.error().text;
        COMPARE_CONTAINS(text, hostile.reason);
        QVERIFY2(text.find('\n') == std::string::npos && text.ends_with("make it again"), text.c_str());
    }

    // Three archives that unpack to 2 GB each, and say so or not.
    void bombsTakeNoMemory() {
        const std::string zeros = deflatedZeros(258 * 4'000'000 + 1);
        std::vector<std::string> bombs;
        for (const std::uint32_t size : {1000u, 100u * kMega, 258u * 4'000'000 + 1}) {
            std::vector<RawEntry> entries;
            for (int i = 0; i < 16; ++i)
                entries.push_back({.name = std::to_string(i),
                                   .packed = i < 2 ? zeros : "",
                                   .method = 8,
                                   .size = i < 2 ? size : 0});
            bombs.push_back(rawZip(entries));
        }
        rusage before{};
        getrusage(RUSAGE_SELF, &before);
        const pid_t child = fork();
        if (child == 0) {
            for (const std::string& bomb : bombs)
                if (readZip(bomb)) _exit(1);
            rusage after{};
            getrusage(RUSAGE_SELF, &after);
            _exit(after.ru_maxrss < before.ru_maxrss + 256 * 1024 ? 0 : 2);
        }
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
    }

    void everyCutIsRefused() {
        const std::string whole =
            writeZip(std::vector<ZipEntry>{{"a", "first"}, {"b/c", std::string(999, 'x')}});
        VERIFY_RESULT(readZip(whole));
        for (std::size_t size = 0; size < whole.size(); ++size)
            QVERIFY2(!readZip(whole.substr(0, size)), QByteArray::number(qulonglong(size)));
    }

    void everyChangedByteIsRefusedOrChangesNothing() {
        const std::vector<ZipEntry> entries{{"a", "first"}, {"b/c", std::string(999, 'x')}};
        const std::string whole = writeZip(entries);
        int refused = 0, read = 0;
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (const int change : {0x01, 0x20, 0x80, 0xff}) {
                std::string changed = whole;
                changed[at] = char(changed[at] ^ change);
                const auto result = readZip(changed);
                QVERIFY2(!result || *result == entries, QByteArray::number(qulonglong(at)));
                ++(result ? read : refused);
            }
        qInfo("%d changed archives refused, %d read as before", refused, read);
        QCOMPARE_GT(refused, read);
    }
};

TACTUM_TEST(TestHostileZips)

} // namespace test_hostile_zips

#include "test_hostile_zips.moc"
