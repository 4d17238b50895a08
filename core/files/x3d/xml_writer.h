// XML as text, element by element: escaped, well formed, the same bytes for the same calls.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "core/base/vec.h"

namespace tactum {

/// An element from its making to its end, inside of the one that was made before and still lives.
/// Names of elements and attributes are taken as they are.
class XmlElement {
public:
    /// The outermost; its end puts the whole document behind `out`, which must outlive it.
    XmlElement(std::string& out, std::string_view name);
    XmlElement(XmlElement& parent, std::string_view name)
        : node_(parent.node_.append_child(std::string(name).c_str())) {}
    XmlElement(const XmlElement&) = delete;
    XmlElement& operator=(const XmlElement&) = delete;
    ~XmlElement();

    /// Valid UTF-8 afterwards, without the characters that XML does not know.
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
    /// Digits, blanks and commas, as many as there are: not looked at.
    XmlElement& setPlain(std::string_view attribute, const std::string& text);

private:
    std::string* out_ = nullptr;                   ///< of the outermost alone, as
    std::unique_ptr<pugi::xml_document> document_; ///< the document
    pugi::xml_node node_;
};

} // namespace tactum
