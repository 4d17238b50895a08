#include "core/files/mesh/threemf_part.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"

namespace tactum {
namespace {

/// What a file may need that is read, or that only the eye misses.
bool isReadable(std::string_view extension) {
    constexpr std::string_view kKnown[] = {"/3dmanufacturing/production/", "/3dmanufacturing/material/",
                                           "/3dmanufacturing/trianglesets/"};
    return std::ranges::any_of(
        kKnown, [&](std::string_view known) { return extension.find(known) != std::string_view::npos; });
}

} // namespace

std::string_view localName(std::string_view name) {
    return name.substr(name.find(':') + 1); // npos + 1 is 0
}

XmlNode childOf(XmlNode node, std::string_view kind) {
    for (const XmlNode child : node.children())
        if (localName(child.name()) == kind) return child;
    return {};
}

std::string_view attributeOf(XmlNode node, std::string_view name) {
    for (const pugi::xml_attribute attribute : node.attributes())
        if (localName(attribute.name()) == name) return attribute.value();
    return {};
}

ThreeMfPart::ThreeMfPart(const std::string& name, std::string_view xml)
    : source_(Source::ofBytes(name, xml)) {
    if (localName(model().name()) != "model") fail(model(), "is no <model>; export it as 3MF again");
    demandReadable();
    listResources();
}

void ThreeMfPart::demandReadable() const {
    Fields prefixes(model().attribute("requiredextensions").value());
    for (std::string_view prefix = prefixes.next(); !prefix.empty(); prefix = prefixes.next()) {
        const std::string_view extension =
            model().attribute(("xmlns:" + std::string(prefix)).c_str()).value();
        if (!isReadable(extension))
            fail(model(), "needs the extension " + inQuotes(extension.empty() ? prefix : extension) +
                              ", which is not read; export it without");
    }
}

void ThreeMfPart::listResources() {
    for (const XmlNode each : childOf(model(), "resources").children()) {
        const auto id = each.attribute("id");
        if (id && !resources_.try_emplace(id.value(), each).second)
            fail(each, "has the id " + inQuotes(id.value()) + " of another one; export it again");
    }
}

XmlNode ThreeMfPart::resource(std::string_view id, std::string_view kind) const {
    const auto found = resources_.find(id);
    const bool is = found != resources_.end() && localName(found->second.name()) == kind;
    return is ? found->second : XmlNode();
}

double ThreeMfPart::number(XmlNode node, const char* attribute) const {
    const auto found = node.attribute(attribute);
    double value = 0;
    if (!found) fail(node, "has no " + std::string(attribute) + "; export it again");
    if (!parseNumber(trimmed(found.value()), value))
        fail(node, std::string(attribute) + " is " + inQuotes(found.value()) +
                       ", which is no number; export it again");
    return value;
}

std::size_t ThreeMfPart::index(XmlNode node, const char* attribute, std::size_t end) const {
    const double value = number(node, attribute);
    if (!(value >= 0 && value < double(end)) || value != std::floor(value))
        fail(node, std::string(attribute) + " is " + inQuotes(node.attribute(attribute).value()) +
                       ", but only " + std::to_string(end) + " vertices are there (from 0); export it again");
    return std::size_t(value);
}

/// Rows that are multiplied by from the left, so that the last one is the translation.
Eigen::Affine3d ThreeMfPart::transform(XmlNode node) const {
    Eigen::Affine3d affine = Eigen::Affine3d::Identity();
    const auto given = node.attribute("transform");
    if (!given) return affine;
    std::array<double, 12> m{};
    Fields fields(given.value());
    const bool fits = std::ranges::all_of(
        m, [&](double& each) { return parseNumber(fields.next(), each) && std::isfinite(each); });
    if (!fits || !fields.next().empty())
        fail(node, "has a transform that is not twelve finite numbers; export it again");
    affine.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4>>(m.data());
    return affine;
}

} // namespace tactum
