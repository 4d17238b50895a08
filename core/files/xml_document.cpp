#include "core/files/xml_document.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactum {

XmlDocument::XmlDocument(const Source& source) : source_(source) {
    const std::string_view bytes = source.bytes();
    const auto result = document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default);
    if (result) return;
    const auto at =
        std::min<std::size_t>(std::size_t(std::max<std::ptrdiff_t>(result.offset, 0)), bytes.size());
    source.failAtLine(source.lineAt(bytes.data() + at),
                      std::string("is no XML: ") + result.description() + "; export it again");
}

void XmlDocument::fail(XmlNode node, const std::string& text) const {
    const std::string what = "<" + printable(node.name()) + ">: " + text;
    const auto at = node.offset_debug();
    if (at < 0 || std::size_t(at) > source_.bytes().size()) source_.fail(what);
    source_.failAtLine(source_.lineAt(source_.bytes().data() + at), what);
}

} // namespace tactum
