// X3D in its XML form as a tree of nodes: fields, DEF and USE. For the X3D reader only.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "core/files/xml_document.h"

namespace tactum {

using X3dNode = XmlNode;

/// A value of an attribute that cannot be read throws ReadFault with its line.
class X3dDocument : public XmlDocument {
public:
    /// Throws ReadFault where it is no XML or no X3D.
    explicit X3dDocument(const Source& source);

    X3dNode scene() const { return scene_; }
    /// What a node stands for: the DEF that its USE names, or itself. Empty for a USE of nothing.
    X3dNode resolved(X3dNode node) const;
    /// The first child with one of these names, resolved; empty for none.
    X3dNode child(X3dNode node, std::initializer_list<std::string_view> names) const;

    std::vector<double> numbers(X3dNode node, const char* field) const;
    std::vector<std::int64_t> integers(X3dNode node, const char* field) const;
    double number(X3dNode node, const char* field, double otherwise) const;
    /// As many numbers as `otherwise` has.
    std::vector<double> tuple(X3dNode node, const char* field, std::vector<double> otherwise) const;
    static bool flag(X3dNode node, const char* field, bool otherwise);
    /// The strings of an MFString; one without quotes is one string.
    static std::vector<std::string> strings(X3dNode node, const char* field);

    /// What a MetadataString of this key says in the node's MetadataSet of this name; nothing without one.
    static std::optional<std::string> metadata(X3dNode node, std::string_view set, std::string_view key);

    /// The same of a MetadataDouble.
    std::optional<double> metadataNumber(X3dNode node, std::string_view set, std::string_view key) const;

    /// Every node of a kind in the whole file.
    std::vector<X3dNode> all(std::initializer_list<std::string_view> names) const;

private:
    template <class Number> std::vector<Number> list(X3dNode node, const char* field) const;
    template <class Visit> void visitAll(Visit visit) const;

    X3dNode scene_;
    std::unordered_map<std::string_view, X3dNode> defined_;
};

} // namespace tactum
