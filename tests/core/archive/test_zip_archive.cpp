// Archives of ours and of others, and the sums of what is in them.
#include <random>

#include <QTest>

#include "core/archive/sha256.h"
#include "core/archive/zip_archive.h"
#include "tests/core/archive/raw_zip.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_zip_archive {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Some entries of random lengths, some of noise and some that deflate well.
std::vector<ZipEntry> randomEntries(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<ZipEntry> entries;
    for (unsigned i = 0, count = random() % 20; i < count; ++i) {
        std::string bytes(random() % (1u << random() % 18), '\0');
        const unsigned signs = 1 + random() % 256;
        for (char& byte : bytes)
            byte = char(random() % signs);
        entries.push_back({"folder " + std::to_string(i % 3) + "/e_" + std::to_string(i) + ".bin", bytes});
    }
    return entries;
}

std::string faultOf(const auto& result) {
    return result ? "none" : result.error().text;
}

} // namespace

class TestZipArchive : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsRead() {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const auto entries = randomEntries(seed);
            const auto back = readZip(writeZip(entries));
            QCOMPARE(faultOf(back), "none");
            QVERIFY2(*back == entries, QByteArray::number(seed));
        }
    }

    void mayHoldNothing() {
        const auto back = readZip(writeZip({}));
        QCOMPARE(faultOf(back), "none");
        QVERIFY(back->empty());
    }

    void entriesAreReadOneByOne() {
        const std::string bytes = writeZip(std::vector<ZipEntry>{{"b", "second"}, {"a", ""}, {"c", "third"}});
        const auto archive = ZipArchive::open(bytes);
        QCOMPARE(faultOf(archive), "none");
        QCOMPARE(archive->names(), (std::vector<std::string>{"b", "a", "c"}));
        for (int again = 0; again < 2; ++again) {
            QCOMPARE(archive->read(2).value(), "third");
            QCOMPARE(archive->read(0).value(), "second");
            QCOMPARE(archive->read(1).value(), "");
        }
    }

    void asMuchAsIsAllowedIsRead() {
        std::vector<ZipEntry> many;
        for (std::size_t i = 0; i < kZipEntries; ++i)
            many.push_back({std::to_string(i), "x"});
        QVERIFY(readZip(writeZip(many)) == many);
        const std::vector<ZipEntry> calm{{"a", std::string(64 << 20, '\0')}}; // a thousandfold, but small
        QVERIFY(readZip(writeZip(calm)) == calm);
    }

    void theSameEntriesGiveTheSameBytes() {
        const auto entries = randomEntries(7);
        QCOMPARE_GT(entries.size(), 3);
        qputenv("TZ", "Pacific/Kiritimati");
        const std::string there = writeZip(entries);
        QTest::qWait(2100); // times in a zip are even seconds
        qputenv("TZ", "America/Adak");
        const std::string here = writeZip(entries);
        qunsetenv("TZ");
        QCOMPARE_EQ(there, here);
        auto other = entries;
        std::swap(other[0], other[1]);
        QCOMPARE_NE(writeZip(other), here);
    }

    // Where a field is, is told by APPNOTE.TXT 4.3.7.
    void timesAndMethodsAreFixed() {
        const std::string picture = "\x89PNG" + std::string(1000, 'x'), text(1000, 'x');
        const std::string zip = writeZip(std::vector<ZipEntry>{{"p", picture}, {"t", text}});
        const std::string header = zip.substr(0, 30);
        QCOMPARE(header.substr(8, 6), std::string("\0\0\0\0\x21\0", 6)); // stored, midnight, 1 January 1980
        const std::string next = zip.substr(30 + 1 + picture.size(), 30);
        QCOMPARE(next.substr(0, 4), "PK\3\4");
        QCOMPARE(next.substr(8, 6), std::string("\x08\0\0\0\x21\0", 6));
        QCOMPARE_LT(zip.size(), picture.size() + 400);
    }

    void archivesOfOthersAreRead() {
        const std::string body = "a text";
        const auto sum = crc32(body);
        std::string descriptor = "PK\7\x08";
        for (const std::uint32_t value : {sum, 6u, 6u})
            descriptor.append(reinterpret_cast<const char*>(&value), 4);
        const std::string zip =
            rawZip({{.name = "folder/", .packed = "", .attributes = 0040755u << 16 | 0x10},
                    {.name = "folder/streamed", .packed = body, .flags = 1 << 3, .descriptor = descriptor},
                    {.name = "of DOS", .packed = body, .attributes = 0x20},
                    {.name = "zeros",
                     .packed = deflatedZeros(259),
                     .method = 8,
                     .size = 259,
                     .crc = crc32(std::string(259, '\0'))}});
        const auto back = readZip(zip);
        QCOMPARE(faultOf(back), "none");
        const std::vector<ZipEntry> expected{
            {"folder/streamed", body}, {"of DOS", body}, {"zeros", std::string(259, '\0')}};
        QVERIFY(*back == expected);
    }

    void namesAreJudged() {
        for (const char* good : {"a", "scene.glb", "images/a b-c_d.PNG", ".hidden", "a..b", "..a/b.."})
            QVERIFY2(isZipName(good), good);
        for (const char* bad :
             {"", "/", "a/", "/a", "..", "a/../b", ".", "a//b", "a\\b", "c:a", "\xc3\xa4", "a\tb", "a?"})
            QVERIFY2(!isZipName(bad), bad);
    }

    // FIPS 180-4, examples of SHA-256.
    void sumsAreThoseOfTheStandard() {
        QCOMPARE(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        QCOMPARE(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        QCOMPARE(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
                 "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
        QCOMPARE(
            sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmnopqr"
                   "lmnopqrsmnopqrstnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
        QCOMPARE(sha256(std::string(1'000'000, 'a')),
                 "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    }
};

TACTUM_TEST(TestZipArchive)

} // namespace test_zip_archive

#include "test_zip_archive.moc"
