// As test_program.h, for tests that show windows or draw pictures.
#pragma once

#include <QApplication>

#include "tests/support/test_program.h"

namespace tactum::test {

/// The application of a test: its own kind where it has one.
template <class Test> struct ApplicationOf { using Type = QApplication; };
template <class Test>
requires requires {
    typename Test::Application;
}
struct ApplicationOf<Test> {
    using Type = typename Test::Application;
};

/// An application with windows around one test class. What a class may have: initMain(), which runs before;
/// instead(), which says what the program returns when it was not started for the test.
template <class Test> int runGuiTest(int argc, char** argv) {
    if constexpr (requires { Test::initMain(); }) Test::initMain();
    typename ApplicationOf<Test>::Type application(argc, argv);
    application.setAttribute(Qt::AA_Use96Dpi, true);
    if constexpr (requires { Test::instead(); })
        if (const auto result = Test::instead()) return *result;
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace tactum::test

/// The last line of a GUI test's file, before its moc.
#define TACTUM_GUI_TEST(Test)                                                                                \
    static const tactum::test::TestEntry entryOf##Test{__FILE__, tactum::test::runGuiTest<Test>};
