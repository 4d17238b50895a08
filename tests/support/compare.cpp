#include "tests/support/compare.h"

#include <cmath>

namespace tactum::test {
namespace {

constexpr qsizetype kLongest = 360; ///< of a text that is printed; Qt cuts a message at 1024

/// The shortest digits that give the same number again.
QByteArray digits(double value) {
    return QByteArray::number(value, 'g', QLocale::FloatingPointShortest);
}

QByteArray digits(const Vec3& v) {
    return '(' + digits(v.x()) + ", " + digits(v.y()) + ", " + digits(v.z()) + ')';
}

char* printed(const QByteArray& text) {
    return qstrdup(text.constData());
}

/// In quotes, so that one sees where it begins and ends.
QByteArray quoted(const QByteArray& text) {
    if (text.size() <= kLongest) return '"' + text + '"';
    return '"' + text.first(kLongest) + "\"... (" + QByteArray::number(text.size()) + " bytes)";
}

QByteArray quoted(const QString& text) {
    return quoted(text.toUtf8());
}

QByteArray quoted(std::string_view text) {
    return quoted(QByteArray(text.data(), qsizetype(text.size())));
}

template <class T>
bool report(bool holds, const QByteArray& why, const T& actual, const T& expected, const Comparison& at) {
    return QTest::compare_helper(
        holds, why.constData(), [&] { return static_cast<const char*>(printed(actual)); },
        [&] { return static_cast<const char*>(printed(expected)); }, at.actual, at.expected, at.file,
        at.line);
}

template <class T>
bool reportNear(double difference, const T& actual, const T& expected, double tolerance, const char* unit,
                const Comparison& at) {
    if (difference < tolerance) return report(true, {}, QByteArray(), QByteArray(), at);
    const QByteArray in = *unit ? QByteArray(" ") + unit : QByteArray();
    return report(false,
                  "The difference, " + digits(difference) + in + ", is not below " + digits(tolerance) + in,
                  digits(actual) + in, digits(expected) + in, at);
}

template <class T>
bool reportPart(bool holds, const char* why, const T& text, const T& part, const Comparison& at) {
    if (holds) return report(true, {}, QByteArray(), QByteArray(), at);
    return report(false, why, quoted(text), quoted(part), at);
}

constexpr const char* kLacks = "The part is not in the text";
constexpr const char* kBegins = "The text does not begin so";
constexpr const char* kContains = "The part is in the text, and should not be";

} // namespace

bool isNear(double actual, double expected, double tolerance, const char* unit, const Comparison& at) {
    return reportNear(std::abs(actual - expected), actual, expected, tolerance, unit, at);
}

bool isNear(const Vec3& actual, const Vec3& expected, double tolerance, const char* unit,
            const Comparison& at) {
    return reportNear((actual - expected).norm(), actual, expected, tolerance, unit, at);
}

bool contains(std::string_view text, std::string_view part, const Comparison& at) {
    return reportPart(text.find(part) != std::string_view::npos, kLacks, text, part, at);
}

bool contains(const QString& text, const QString& part, const Comparison& at) {
    return reportPart(text.contains(part), kLacks, text, part, at);
}

bool contains(const QByteArray& text, const QByteArray& part, const Comparison& at) {
    return reportPart(text.contains(part), kLacks, text, part, at);
}

bool contains(const QStringList& list, const QString& entry, const Comparison& at) {
    return reportPart(list.contains(entry), "The entry is not in the list", list.join(u'\n'), entry, at);
}

bool lacks(std::string_view text, std::string_view part, const Comparison& at) {
    return reportPart(text.find(part) == std::string_view::npos, kContains, text, part, at);
}

bool lacks(const QString& text, const QString& part, const Comparison& at) {
    return reportPart(!text.contains(part), kContains, text, part, at);
}

bool lacks(const QByteArray& text, const QByteArray& part, const Comparison& at) {
    return reportPart(!text.contains(part), kContains, text, part, at);
}

bool lacks(const QStringList& list, const QString& entry, const Comparison& at) {
    return reportPart(!list.contains(entry), "The entry is in the list, and should not be", list.join(u'\n'),
                      entry, at);
}

bool begins(std::string_view text, std::string_view start, const Comparison& at) {
    return reportPart(text.starts_with(start), kBegins, text, start, at);
}

bool begins(const QString& text, const QString& start, const Comparison& at) {
    return reportPart(text.startsWith(start), kBegins, text, start, at);
}

bool begins(const QByteArray& text, const QByteArray& start, const Comparison& at) {
    return reportPart(text.startsWith(start), kBegins, text, start, at);
}

bool hasNoError(const Error* error, const Comparison& at) {
    return QTest::qVerify(!error, at.actual, error ? error->text.c_str() : "", at.file, at.line);
}

std::string refusalOf(const Error* error) {
    if (!error) return "(nothing was refused)";
    return error->text.find('\n') == std::string::npos ? error->text : "(more than one line)";
}

} // namespace tactum::test

namespace QTest {

using tactum::test::digits;
using tactum::test::printed;
using tactum::test::quoted;

char* toString(double value) {
    return printed(digits(value));
}

template <> char* toString(const std::string& text) {
    return printed(quoted(std::string_view(text)));
}

template <> char* toString(const std::string_view& text) {
    return printed(quoted(text));
}

template <> char* toString(const std::filesystem::path& path) {
    return printed(quoted(std::string_view(path.native())));
}

template <> char* toString(const tactum::Vec3& v) {
    return printed(digits(v));
}

template <> char* toString(const tactum::Quat& q) {
    return printed(digits(q.w()) + ' ' + digits(q.vec()));
}

template <> char* toString(const tactum::Pose& pose) {
    return printed(digits(pose.rotation.w()) + ' ' + digits(pose.rotation.vec()) + " at " +
                   digits(pose.translation));
}

} // namespace QTest
