#include "core/files/x3d/x3d_document.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactum {
namespace {

bool separates(char c) {
    return isBlank(c) || c == '\n' || c == ',';
}

} // namespace

X3dDocument::X3dDocument(const Source& source) : XmlDocument(source) {
    if (root().name() == std::string_view("X3D")) scene_ = root().child("Scene");
    if (!scene_) source.fail("has no <X3D> with a <Scene>; export it as X3D in its XML form");
    visitAll([&](X3dNode node) {
        if (const auto name = node.attribute("DEF")) defined_.try_emplace(name.value(), node);
    });
}

template <class Visit> void X3dDocument::visitAll(Visit visit) const {
    const X3dNode top = root();
    X3dNode node = top;
    while (node) {
        if (node.type() == pugi::node_element) visit(node);
        if (node.first_child()) {
            node = node.first_child();
            continue;
        }
        while (node != top && !node.next_sibling())
            node = node.parent();
        if (node == top) return;
        node = node.next_sibling();
    }
}

X3dNode X3dDocument::resolved(X3dNode node) const {
    const auto use = node.attribute("USE");
    if (!use) return node;
    const auto found = defined_.find(use.value());
    return found == defined_.end() ? X3dNode() : found->second;
}

X3dNode X3dDocument::child(X3dNode node, std::initializer_list<std::string_view> names) const {
    for (const X3dNode each : node.children())
        if (std::ranges::find(names, std::string_view(each.name())) != names.end())
            if (const X3dNode found = resolved(each)) return found;
    return {};
}

template <class Number> std::vector<Number> X3dDocument::list(X3dNode node, const char* field) const {
    std::vector<Number> values;
    std::string_view rest = node.attribute(field).value();
    for (auto word = takeSeparated(rest, separates); !word.empty(); word = takeSeparated(rest, separates)) {
        Number value{};
        if (!parseNumber(word, value))
            fail(node,
                 std::string(field) + " has " + inQuotes(word) + ", which is no number; export it again");
        values.push_back(value);
    }
    return values;
}

std::vector<double> X3dDocument::numbers(X3dNode node, const char* field) const {
    return list<double>(node, field);
}

std::vector<std::int64_t> X3dDocument::integers(X3dNode node, const char* field) const {
    return list<std::int64_t>(node, field);
}

std::vector<double> X3dDocument::tuple(X3dNode node, const char* field, std::vector<double> otherwise) const {
    if (!node.attribute(field)) return otherwise;
    std::vector<double> values = numbers(node, field);
    const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
    if (values.size() != otherwise.size() || !finite)
        fail(node, std::string(field) + " has not " + std::to_string(otherwise.size()) +
                       " finite numbers; export it again");
    return values;
}

double X3dDocument::number(X3dNode node, const char* field, double otherwise) const {
    return tuple(node, field, {otherwise})[0];
}

bool X3dDocument::flag(X3dNode node, const char* field, bool otherwise) {
    const std::string word = lowerCase(trimmed(node.attribute(field).value()));
    return word.empty() ? otherwise : word == "true";
}

std::vector<std::string> X3dDocument::strings(X3dNode node, const char* field) {
    const std::string_view text = trimmed(node.attribute(field).value());
    std::vector<std::string> all;
    if (!text.starts_with('"')) {
        if (!text.empty()) all.emplace_back(text);
        return all;
    }
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') {
            if ((inside = !inside)) all.emplace_back();
        } else if (inside) {
            if (text[i] == '\\' && i + 1 < text.size()) ++i;
            all.back() += text[i];
        }
    }
    return all;
}

std::optional<double> X3dDocument::metadataNumber(X3dNode node, std::string_view set,
                                                  std::string_view key) const {
    for (const X3dNode each : node.children("MetadataSet")) {
        if (each.attribute("name").value() != set) continue;
        for (const X3dNode value : each.children("MetadataDouble"))
            if (value.attribute("name").value() == key) return number(value, "value", 0);
    }
    return std::nullopt;
}

std::optional<std::string> X3dDocument::metadata(X3dNode node, std::string_view set, std::string_view key) {
    for (const X3dNode each : node.children("MetadataSet")) {
        if (each.attribute("name").value() != set) continue;
        for (const X3dNode value : each.children("MetadataString"))
            if (const auto words = strings(value, "value");
                value.attribute("name").value() == key && words.size() == 1)
                return words[0];
    }
    return std::nullopt;
}

std::vector<X3dNode> X3dDocument::all(std::initializer_list<std::string_view> names) const {
    std::vector<X3dNode> found;
    visitAll([&](X3dNode node) {
        if (std::ranges::find(names, std::string_view(node.name())) != names.end()) found.push_back(node);
    });
    return found;
}

} // namespace tactum
