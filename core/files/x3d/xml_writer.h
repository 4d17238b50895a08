// XML as text, element by element: escaped, well formed, the same bytes for the same calls.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "core/base/vec.h"

namespace tactum {

/// Text as it may stand in an attribute: valid UTF-8 without the characters that XML does not know, the
/// others escaped.
std::string xmlText(std::string_view text);

/// An element from its making to its end, inside of the one that was made before and still lives.
/// Names of elements and attributes are taken as they are.
class XmlElement {
public:
    /// The outermost; begins the document in `out`, which must outlive it.
    XmlElement(std::string& out, std::string_view name);
    XmlElement(XmlElement& parent, std::string_view name);
    XmlElement(const XmlElement&) = delete;
    XmlElement& operator=(const XmlElement&) = delete;
    ~XmlElement();

    // Attributes, before the first child.
    XmlElement& set(std::string_view attribute, std::string_view text);
    XmlElement& set(std::string_view attribute, const char* text) {
        return set(attribute, std::string_view(text));
    }
    XmlElement& set(std::string_view attribute, double number);
    XmlElement& set(std::string_view attribute, bool value) {
        return set(attribute, value ? "true" : "false");
    }
    XmlElement& set(std::string_view attribute, const Vec3& v);
    XmlElement& set(std::string_view attribute, const Eigen::Vector3f& v);
    /// A list of strings as X3D has it: each in quotes.
    XmlElement& setStrings(std::string_view attribute, std::initializer_list<std::string_view> texts);
    /// Text of digits, blanks and commas, which needs no escape.
    XmlElement& setPlain(std::string_view attribute, std::string_view text);

private:
    std::string& out_;
    std::string name_;
    int depth_ = 0;
    bool hasChildren_ = false;
};

} // namespace tactum
