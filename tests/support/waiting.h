// The waits of Qt Test, while events are handled, with the patience of all other tests.
#pragma once

#include <QTest>

#include "tests/support/patience.h"

namespace tactum::test {

/// True as soon as the condition holds; false when it did not for as long as Patience has, or when the test
/// has failed already. Handles events.
template <class Condition> bool waitFor(Condition condition) {
    constexpr int kStep = 5; // ms
    for (Patience patience; !condition(); QTest::qWait(kStep))
        if (patience.isOver() || QTest::currentTestFailed()) return condition();
    return true;
}

} // namespace tactum::test

// Qt's own waits twice as long again, only to say that more patience might have helped: three minutes for
// what was clear after one. It counts its steps, too, and not how long they take.
#undef QTRY_IMPL
#define QTRY_IMPL(expr, timeout)                                                                             \
    (void)(timeout);                                                                                         \
    (void)tactum::test::waitFor([&]() -> bool { return bool(expr); });
