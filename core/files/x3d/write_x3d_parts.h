// What the writers of X3D share. For write_x3d*.cpp only.
#pragma once

#include <string>
#include <string_view>

#include "core/base/numbers.h"
#include "core/files/x3d/xml_writer.h"

namespace tactum {

/// Axis and angle as one attribute. The identity has an axis too.
inline std::string axisAngle(const Quat& rotation) {
    const Eigen::AngleAxisd turn(rotation.normalized());
    std::string text;
    for (const double x : turn.axis()) {
        appendNumber(text, x);
        text += ' ';
    }
    appendNumber(text, turn.angle());
    return text;
}

/// A field of the node with that DEF.
struct X3dField {
    std::string_view node, field;
};

inline void writeRoute(XmlElement& parent, const X3dField& from, const X3dField& to) {
    XmlElement(parent, "ROUTE")
        .set("fromNode", from.node)
        .set("fromField", from.field)
        .set("toNode", to.node)
        .set("toField", to.field);
}

} // namespace tactum
