// The cone of forces that friction holds, at a contact. Private to this folder.
#pragma once

#include "ui/base/theme.h"
#include "ui/view/touch_overlay.h"
#include "ui/view/touch_shape.h"

namespace tactum {

/// Opens from the proxy along the contact's normal, tan of its half angle the coefficient that counts now:
/// the static one while it sticks, the dynamic one while it slips. As high as the normal part of the force's
/// arrow, so that the arrow's tip lies inside while the contact holds, and on the rim when it gives way.
class FrictionCone {
public:
    FrictionCone(vtkRenderer& solid, vtkRenderer& ghost);

    void setTheme(const Theme& theme) { theme_ = &theme; }
    void setVisible(bool visible);
    /// Of the contact that pushes most; hidden when it has no friction.
    void update(const TouchState& state, const ViewCamera& camera);

private:
    const Theme* theme_ = &kDarkTheme;
    bool visible_ = false;
    TouchShape mantle_, rim_, inner_;
};

/// The contact that pushes most; null in free motion.
const ContactReport* mainContact(const TouchState& state);

} // namespace tactum
