// One model part of a 3MF package: a file of XML whose resources have numbers. For the 3MF reader only.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "core/base/vec.h"
#include "core/files/xml_document.h"

namespace tactum {

class ThreeMfPart {
public:
    /// `name`: of the part, behind that of its file, for sentences. Throws ReadFault where it is no model.
    ThreeMfPart(const std::string& name, std::string_view xml);

    XmlNode model() const { return document_.root(); }
    /// The resource with this id, if it is of this kind; else empty.
    XmlNode resource(std::string_view id, std::string_view kind) const;

    /// An attribute that has to be there. Throws ReadFault where it is not, or is no number.
    double number(XmlNode node, const char* attribute) const;
    /// The same of a whole number below `end`.
    std::size_t index(XmlNode node, const char* attribute, std::size_t end) const;
    /// The attribute `transform`, or the identity.
    Eigen::Affine3d transform(XmlNode node) const;

    [[noreturn]] void fail(XmlNode node, const std::string& text) const { document_.fail(node, text); }

private:
    void demandReadable() const;
    void listResources();

    Source source_;
    XmlDocument document_{source_};
    std::unordered_map<std::string_view, XmlNode> resources_;
};

/// A name of XML without its prefix, which every file chooses as it likes.
std::string_view localName(std::string_view name);
/// The first child of this kind; empty for none.
XmlNode childOf(XmlNode node, std::string_view kind);
/// Of an extension, whose prefix every file chooses; empty for none.
std::string_view attributeOf(XmlNode node, std::string_view name);

} // namespace tactum
