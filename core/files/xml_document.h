// A file of XML as a tree of nodes, and how to speak of a place in it. For the readers of XML formats only.
#pragma once

#include <pugixml.hpp>

#include "core/files/source.h"

namespace tactum {

using XmlNode = pugi::xml_node;

class XmlDocument {
public:
    /// `source` outlives this. Throws ReadFault with the line where it is no XML.
    explicit XmlDocument(const Source& source);

    XmlNode root() const { return document_.document_element(); }

    /// Names the node and its line.
    [[noreturn]] void fail(XmlNode node, const std::string& text) const;

private:
    const Source& source_;
    pugi::xml_document document_;
};

} // namespace tactum
