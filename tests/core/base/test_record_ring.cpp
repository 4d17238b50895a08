// The last rows of a loop: which are kept, under which numbers, also while the writer goes on.
#include <atomic>
#include <optional>
#include <thread>

#include <sys/resource.h>

#include <QTest>

#include "core/base/record_ring.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_record_ring {

using namespace tactum;

namespace {

struct Row {
    std::uint64_t a = 0, b = 0, c = 0;
    static Row of(std::uint64_t n) { return {n, 2 * n, ~n}; }
    bool isOf(std::uint64_t n) const { return a == n && b == 2 * n && c == ~n; }
};

} // namespace

class TestRecordRing : public QObject {
    Q_OBJECT

private slots:
    void theNewestRowsAreKept() {
        for (const std::size_t capacity : {1, 2, 7}) {
            RecordRing<Row> ring(capacity);
            QCOMPARE(ring.bytes(), capacity * sizeof(Row));
            for (std::uint64_t written = 0; written < 20; ++written) {
                for (const std::uint64_t most :
                     {std::uint64_t(0), std::uint64_t(1), std::uint64_t(3), ~std::uint64_t(0)}) {
                    const NumberedRows<Row> rows = ring.copy(most);
                    const std::uint64_t expected = std::min({written, std::uint64_t(capacity), most});
                    QCOMPARE(rows.rows.size(), expected);
                    QCOMPARE(rows.first, written - expected);
                    QCOMPARE(rows.end(), written);
                    for (std::uint64_t i = 0; i < expected; ++i)
                        QVERIFY(rows.rows[i].isOf(rows.first + i));
                }
                ring.push(Row::of(written));
            }
        }
    }

    /// A page of the machine's memory is taken when it is written to: none for a ring that nobody touches,
    /// all of one before its writer begins.
    void noMemoryIsTakenBeforeItIsTouched() {
        const auto faults = [](auto&& work) {
            rusage before{}, after{};
            getrusage(RUSAGE_THREAD, &before);
            work();
            getrusage(RUSAGE_THREAD, &after);
            return after.ru_minflt - before.ru_minflt;
        };
        constexpr std::size_t kRows = std::size_t(64) << 20 >> 5; // 48 MiB: pages of 2 MiB are 24 faults
        std::optional<RecordRing<Row>> ring;
        QCOMPARE_LT(faults([&] { ring.emplace(kRows); }), 12);
        QCOMPARE_GE(faults([&] { ring->touch(); }), 20);
        QCOMPARE_LT(faults([&] {
                        for (std::uint64_t n = 0; n < kRows; ++n)
                            ring->push(Row::of(n));
                    }),
                    12);
        QVERIFY(ring->copy(1).rows[0].isOf(kRows - 1));
    }

    /// A reader that is overtaken has fewer rows, and none that is torn or under another's number.
    void whatWasWrittenOverIsDropped() {
        RecordRing<Row> ring(64);
        std::atomic<bool> enough{false};
        std::thread writer([&] {
            for (std::uint64_t n = 0; !enough.load(std::memory_order_relaxed); ++n)
                ring.push(Row::of(n));
        });
        std::uint64_t torn = 0, tooMany = 0, backward = 0, last = 0;
        while (last < 200'000) {
            const NumberedRows<Row> rows = ring.copy();
            tooMany += rows.rows.size() > 64;
            backward += rows.end() < last;
            last = rows.end();
            for (std::size_t i = 0; i < rows.rows.size(); ++i)
                torn += !rows.rows[i].isOf(rows.first + i);
        }
        enough = true;
        writer.join();
        QCOMPARE(torn, 0u);
        QCOMPARE(tooMany, 0u);
        QCOMPARE(backward, 0u);
        QCOMPARE(ring.copy().rows.size(), 64u);
    }
};

TACTUM_TEST(TestRecordRing)

} // namespace test_record_ring

#include "test_record_ring.moc"
