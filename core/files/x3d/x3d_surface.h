// The appearance of an X3D shape as a surface: its colour, and H3D's surface nodes as a feel. For the X3D
// reader only.
#pragma once

#include "core/files/bump_layers.h"
#include "core/files/x3d/x3d_document.h"

namespace tactum {

/// Of a whole file: which device the relative values are about, which sides are felt.
class X3dSurfaces {
public:
    X3dSurfaces(const X3dDocument& document, const Source& source, std::vector<Finding>& findings);

    /// `shape`: a Shape node. Findings say what was converted and what could not be kept.
    Surface surfaceOf(X3dNode shape);
    /// The proxy of the file's first RuspiniRenderer, in m; none without one.
    std::optional<double> proxyRadius();

private:
    void feel(X3dNode node, Surface& surface);
    void readOurs(X3dNode node, Surface& surface);
    double stiffnessOf(X3dNode node, const char* field, double initial, const Surface& surface);
    void setFriction(Surface& surface, double fixed, double sliding);
    void depthMap(X3dNode node, Surface& surface);
    void parameterMap(X3dNode node, Surface& surface, const char* what, TextureTarget target,
                      const MaterialField& field, double unit);
    std::optional<TextureLayer> layerOf(X3dNode texture);
    std::optional<Sides> sidesOf(X3dNode geometry, bool haptic) const;
    double kept(const Parameter& parameter, double value, const Surface& surface);
    void say(Finding::Severity severity, const Surface& surface, const std::string& sentence,
             const std::string& remedy);

    const X3dDocument& document_;
    std::vector<Finding>& findings_;
    BumpLayers pictures_;
    double deviceStiffness_ = 700; ///< N/m, of HAPI's devices that name none
    std::string device_ = "H3D's devices in general";
    std::string touchable_; ///< of the global options; empty for none
};

} // namespace tactum
