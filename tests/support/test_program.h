// One program holds all tests of a room: each test class says its kind in the last line of its file, and the
// program runs the one that it is asked for, alone in its process.
#pragma once

#include <string>

#include <QCoreApplication>
#include <QTest>

namespace tactum::test {

/// A test class under the name of its file, test_carry for tests/core/proxy/test_carry.cpp.
struct TestEntry {
    using Run = int (*)(int argc, char** argv);

    /// `file`: __FILE__ of the test. Entries add themselves before main() begins.
    TestEntry(const char* file, Run inIt);

    std::string name;
    Run run;
};

/// The name of the test that this process was started for.
const std::string& runningTest();

/// An application without windows around one test class.
template <class Test> int runTest(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace tactum::test

/// The last line of a test's file, before its moc.
#define TACTUM_TEST(Test)                                                                                    \
    static const tactum::test::TestEntry entryOf##Test{__FILE__, tactum::test::runTest<Test>};
