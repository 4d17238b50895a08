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

std::string knownToXml(std::string_view text) {
    std::string clean = printable(text, text.size() + 1); // never cut
    for (const std::string_view unknown : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
        for (std::size_t at = 0; (at = clean.find(unknown, at)) != std::string::npos;)
            clean.replace(at, unknown.size(), 1, '?');
    return clean;
}

struct Behind final : pugi::xml_writer {
    explicit Behind(std::string& text) : out(text) {}
    void write(const void* data, std::size_t size) override {
        out.append(static_cast<const char*>(data), size);
    }
    std::string& out;
};

} // namespace

XmlElement::XmlElement(std::string& out, std::string_view name)
    : out_(&out), document_(std::make_unique<pugi::xml_document>()),
      node_(document_->append_child(std::string(name).c_str())) {
    pugi::xml_node head = document_->prepend_child(pugi::node_declaration);
    head.append_attribute("version") = "1.0";
    head.append_attribute("encoding") = "UTF-8";
}

XmlElement::~XmlElement() {
    if (!document_) return;
    Behind writer(*out_);
    document_->save(writer, " ");
}

XmlElement& XmlElement::setPlain(std::string_view attribute, const std::string& text) {
    node_.append_attribute(std::string(attribute).c_str()) = text.c_str();
    return *this;
}

XmlElement& XmlElement::set(std::string_view attribute, std::string_view text) {
    return setPlain(attribute, knownToXml(text));
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
