// Two threads at full speed: nothing torn, nothing out of order, the newest never lost.
#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include <QTest>

#include "core/base/wait_free.h"
#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_wait_free {

using namespace tactum;
using test::mayBeBusy;

namespace {

/// Where others want the processors, the threads may take turns with them all for each of these.
std::uint64_t timesToMeet() {
    return mayBeBusy() ? 100'000 : 1'000'000;
}

/// Large enough that a copy is never one instruction; every word says the same.
struct Message {
    std::array<std::uint64_t, 24> word{};

    static Message of(std::uint64_t number) {
        Message message;
        message.word.fill(number);
        return message;
    }
    bool torn() const {
        return std::any_of(word.begin(), word.end(), [this](std::uint64_t w) { return w != word[0]; });
    }
    std::uint64_t number() const { return word[0]; }
};

} // namespace

class TestWaitFree : public QObject {
    Q_OBJECT

private slots:
    void newestValueIsReadWholeAndInOrder() {
        // The writer goes on until the reader has met it often enough, or has had its chances: they meet once
        // in each turn where they never run at the same time.
        constexpr std::uint64_t kMeetings = 100'000, kChances = 20'000'000;
        TripleBuffer<Message> buffer;
        std::atomic<std::uint64_t> seen{0}, written{0};
        std::thread writer([&] {
            std::uint64_t n = 0;
            while (seen.load(std::memory_order_relaxed) < kMeetings && n < kChances)
                buffer.write(Message::of(++n));
            written.store(n);
        });
        std::uint64_t torn = 0, backward = 0, last = 0;
        while (written.load() == 0 || last < written.load()) {
            if (!buffer.update()) {
                std::this_thread::yield();
                continue;
            }
            seen.fetch_add(1, std::memory_order_relaxed);
            torn += buffer.value().torn();
            backward += buffer.value().number() <= last;
            last = buffer.value().number();
        }
        writer.join();
        QCOMPARE_GT(seen.load(), 0u);
        QCOMPARE(torn, 0u);
        QCOMPARE(backward, 0u);
        QCOMPARE(last, written.load()); // the newest is never lost: the loop ends
        QVERIFY(!buffer.update());
    }

    void readerSeesDefaultUntilTheFirstWrite() {
        TripleBuffer<int> buffer;
        QVERIFY(!buffer.update());
        QCOMPARE(buffer.read(), 0);
        buffer.write(7);
        buffer.write(8);
        QCOMPARE(buffer.read(), 8);
        QCOMPARE(buffer.read(), 8);
    }

    void everyQueuedValueArrivesOnceInOrder() {
        SpscQueue<Message, 64> queue;
        const std::uint64_t writes = timesToMeet();
        std::thread writer([&] {
            for (std::uint64_t n = 1; n <= writes; ++n)
                while (!queue.push(Message::of(n)))
                    std::this_thread::yield();
        });
        std::uint64_t torn = 0, outOfOrder = 0;
        Message message;
        for (std::uint64_t expected = 1; expected <= writes; ++expected) {
            while (!queue.pop(message))
                std::this_thread::yield();
            torn += message.torn();
            outOfOrder += message.number() != expected;
        }
        writer.join();
        QCOMPARE(torn, 0u);
        QCOMPARE(outOfOrder, 0u);
        QVERIFY(!queue.pop(message));
    }

    void fullQueueRefusesAndKeepsWhatItHolds() {
        SpscQueue<int, 4> queue;
        for (int i = 0; i < 4; ++i)
            QVERIFY(queue.push(i));
        QVERIFY(!queue.push(4));
        int value = -1;
        for (int i = 0; i < 4; ++i) {
            QVERIFY(queue.pop(value));
            QCOMPARE(value, i);
        }
        QVERIFY(!queue.pop(value));
    }
};

TACTUM_TEST(TestWaitFree)

} // namespace test_wait_free

#include "test_wait_free.moc"
