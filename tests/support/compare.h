// Comparisons that print what they compared, where Qt's own do not: numbers and points within a tolerance, a
// part of a text, a Result that should hold a value.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QTest>

#include "core/base/result.h"
#include "core/base/vec.h"

/// |actual - expected| < tolerance, for numbers and for Vec3 (by the norm). A failure prints both, their
/// difference and the tolerance, in the unit: "N", or "" for a mere number. NaN is near to nothing.
/// As every macro here it evaluates each argument once and returns from the function when it fails, as
/// QVERIFY does. An argument with a comma in braces stands in parentheses.
#define COMPARE_NEAR(actual, expected, tolerance, unit)                                                      \
    TACTUM_COMPARE_(isNear(actual, expected, tolerance, unit, {#actual, #expected, __FILE__, __LINE__}))

/// A text contains a part of it, or a list an entry. A failure prints both.
#define COMPARE_CONTAINS(text, part) TACTUM_COMPARE_(contains(text, part, {#text, #part, __FILE__, __LINE__}))

/// The opposite of COMPARE_CONTAINS.
#define COMPARE_LACKS(text, part) TACTUM_COMPARE_(lacks(text, part, {#text, #part, __FILE__, __LINE__}))

/// A text begins with this. A failure prints both.
#define COMPARE_BEGINS(text, start) TACTUM_COMPARE_(begins(text, start, {#text, #start, __FILE__, __LINE__}))

/// A Result holds a value. A failure prints its error.
#define VERIFY_RESULT(result) TACTUM_COMPARE_(hasValue(result, {#result, "", __FILE__, __LINE__}))

#define TACTUM_COMPARE_(comparison)                                                                          \
    do {                                                                                                     \
        if (!tactum::test::comparison) return;                                                               \
    } while (false)

namespace tactum::test {

/// A comparison in the source: its two expressions and where it stands.
struct Comparison {
    const char* actual;
    const char* expected;
    const char* file;
    int line;
};

// What the macros call: false when the comparison, and with it the running test, has failed. Thread: ui
bool isNear(double actual, double expected, double tolerance, const char* unit, const Comparison& at);
bool isNear(const Vec3& actual, const Vec3& expected, double tolerance, const char* unit,
            const Comparison& at);
bool contains(std::string_view text, std::string_view part, const Comparison& at);
bool contains(const QString& text, const QString& part, const Comparison& at);
bool contains(const QByteArray& text, const QByteArray& part, const Comparison& at);
bool contains(const QStringList& list, const QString& entry, const Comparison& at);
bool lacks(std::string_view text, std::string_view part, const Comparison& at);
bool lacks(const QString& text, const QString& part, const Comparison& at);
bool lacks(const QByteArray& text, const QByteArray& part, const Comparison& at);
bool lacks(const QStringList& list, const QString& entry, const Comparison& at);
bool begins(std::string_view text, std::string_view start, const Comparison& at);
bool begins(const QString& text, const QString& start, const Comparison& at);
bool begins(const QByteArray& text, const QByteArray& start, const Comparison& at);
bool hasNoError(const Error* error, const Comparison& at);
std::string refusalOf(const Error* error);

template <class T> bool hasValue(const Result<T>& result, const Comparison& at) {
    return hasNoError(result ? nullptr : &result.error(), at);
}

/// What a refusal says, which has to be one line; what it should have been where it is none.
template <class T> std::string refusal(const Result<T>& result) {
    return refusalOf(result ? nullptr : &result.error());
}

} // namespace tactum::test

// How QCOMPARE and its kin print our types. Enumerations they print by their numbers.
namespace QTest {

template <> char* toString(const std::string& text);
template <> char* toString(const std::string_view& text);
template <> char* toString(const std::filesystem::path& path);
template <> char* toString(const tactum::Vec3& v);
template <> char* toString(const tactum::Quat& q); ///< w, x, y, z
template <> char* toString(const tactum::Pose& pose);

// For QCOMPARE_EQ, _LT and so on; QCOMPARE itself does not see an overload.
char* toString(double value); ///< all its digits: Qt prints 12, and then 0.3 is not 0.3
template <class T> char* toString(const std::optional<T>& value) {
    return value ? toString(*value) : qstrdup("nothing");
}

} // namespace QTest
