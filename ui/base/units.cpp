#include "ui/base/units.h"

#include <cmath>
#include <numbers>

#include <QString>

namespace tactum {

namespace {

struct Symbol {
    const char* text; ///< UTF-8
    Unit unit;
    bool takesPrefix;
};
constexpr double kDegree = std::numbers::pi / 180;
const Symbol kSymbols[] = {
    {"N", {1, {1, 1, -2}}, true},       {"m", {1, {0, 1, 0}}, true},      {"s", {1, {0, 0, 1}}, true},
    {"g", {1e-3, {1, 0, 0}}, true},     {"Hz", {1, {0, 0, -1}}, true},    {"rad", {1, {}}, true},
    {"deg", {kDegree, {}}, false},      {"\u00b0", {kDegree, {}}, false}, {"%", {0.01, {}}, false},
    {"in", {0.0254, {0, 1, 0}}, false}, {"min", {60, {0, 0, 1}}, false}};
struct Prefix {
    char16_t letter;
    double factor;
};
constexpr Prefix kPrefixes[] = {{u'n', 1e-9}, {u'u', 1e-6}, {u'\u00b5', 1e-6}, {u'\u03bc', 1e-6},
                                {u'm', 1e-3}, {u'c', 1e-2}, {u'k', 1e3},       {u'M', 1e6}};

std::optional<Unit> readSymbol(QStringView text) {
    for (const Symbol& symbol : kSymbols)
        if (text == QString::fromUtf8(symbol.text)) return symbol.unit;
    for (const Prefix& prefix : kPrefixes)
        for (const Symbol& symbol : kSymbols)
            if (symbol.takesPrefix && !text.isEmpty() && text.front() == prefix.letter &&
                text.mid(1) == QString::fromUtf8(symbol.text))
                return Unit{prefix.factor * symbol.unit.factor, symbol.unit.dimension};
    return std::nullopt;
}

bool isJoint(QChar c) {
    return c == u' ' || c == u'*' || c == u'\u00b7' || c == u'\u22c5';
}

/// "2" after "^", "²" and "³"; takes them off the end of a symbol.
int takePower(QStringView& symbol) {
    if (symbol.endsWith(u'\u00b2') || symbol.endsWith(u"^2")) {
        symbol.chop(symbol.endsWith(u"^2") ? 2 : 1);
        return 2;
    }
    if (symbol.endsWith(u'\u00b3') || symbol.endsWith(u"^3")) {
        symbol.chop(symbol.endsWith(u"^3") ? 2 : 1);
        return 3;
    }
    return 1;
}

} // namespace

std::optional<Unit> readUnit(QStringView text) {
    Unit product;
    bool divides = false, needed = false; // after * or / something has to follow
    for (qsizetype i = 0; i < text.size();) {
        if (isJoint(text[i]) || text[i] == u'/') {
            if (text[i] != u' ' && needed) return std::nullopt;
            if (text[i] == u'/') divides = true;
            if (text[i] != u' ') needed = true;
            ++i;
            continue;
        }
        qsizetype end = i;
        while (end < text.size() && !isJoint(text[end]) && text[end] != u'/')
            ++end;
        QStringView symbol = text.mid(i, end - i);
        const int power = (divides ? -1 : 1) * takePower(symbol);
        const auto unit = symbol == u"1" ? std::optional(Unit{}) : readSymbol(symbol);
        if (!unit) return std::nullopt;
        product.factor *= std::pow(unit->factor, power);
        for (std::size_t k = 0; k < 3; ++k)
            product.dimension[k] += power * unit->dimension[k];
        divides = needed = false;
        i = end;
    }
    return needed ? std::nullopt : std::optional(product);
}

} // namespace tactum
