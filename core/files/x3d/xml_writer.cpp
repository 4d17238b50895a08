#include "core/files/x3d/xml_writer.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace tactum {
namespace {

template <class Values> std::string listOf(const Values& values) {
    std::string text;
    for (int i = 0; i < values.size(); ++i) {
        if (i > 0) text += ' ';
        appendNumber(text, values[i]);
    }
    return text;
}

} // namespace

std::string xmlText(std::string_view text) {
    std::string clean = printable(text, text.size() + 1); // never cut
    for (const std::string_view unknown : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
        for (std::size_t at = 0; (at = clean.find(unknown, at)) != std::string::npos;)
            clean.replace(at, unknown.size(), 1, '?');
    std::string escaped;
    for (const char c : clean)
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    return escaped;
}

XmlElement::XmlElement(std::string& out, std::string_view name) : out_(out), name_(name) {
    out_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<" + name_;
}

XmlElement::XmlElement(XmlElement& parent, std::string_view name)
    : out_(parent.out_), name_(name), depth_(parent.depth_ + 1) {
    if (!parent.hasChildren_) out_ += ">\n";
    parent.hasChildren_ = true;
    out_.append(std::size_t(depth_), ' ');
    out_ += "<" + name_;
}

XmlElement::~XmlElement() {
    if (!hasChildren_) {
        out_ += "/>\n";
        return;
    }
    out_.append(std::size_t(depth_), ' ');
    out_ += "</" + name_ + ">\n";
}

XmlElement& XmlElement::setPlain(std::string_view attribute, std::string_view text) {
    out_.append(" ").append(attribute).append("=\"").append(text).append("\"");
    return *this;
}

XmlElement& XmlElement::set(std::string_view attribute, std::string_view text) {
    return setPlain(attribute, xmlText(text));
}

XmlElement& XmlElement::set(std::string_view attribute, double number) {
    std::string text;
    appendNumber(text, number);
    return setPlain(attribute, text);
}

XmlElement& XmlElement::set(std::string_view attribute, const Vec3& v) {
    return setPlain(attribute, listOf(v));
}

XmlElement& XmlElement::set(std::string_view attribute, const Eigen::Vector3f& v) {
    return setPlain(attribute, listOf(v));
}

XmlElement& XmlElement::setStrings(std::string_view attribute,
                                   std::initializer_list<std::string_view> texts) {
    std::string list;
    for (const std::string_view text : texts) {
        list += list.empty() ? "\"" : " \"";
        for (const char c : text) {
            if (c == '"' || c == '\\') list += '\\';
            list += c;
        }
        list += '"';
    }
    return set(attribute, list);
}

} // namespace tactum
