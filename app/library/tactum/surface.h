// A surface of an object and its layers of haptic texture. What is set here changes the scene that it is of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tactum/export.h>
#include <tactum/preset.h>

namespace tactum::library {

struct SceneState;

// Thread of everything here: any but real time, one at a time for one scene. What names something that is not
// in the scene any more is an Error.

/// The picture of a layer.
struct Image {
    std::size_t width = 0, height = 0; ///< texels, from 1 to 16384 each
    std::span<const double> values{}; ///< from 0 to 1, row by row, the first one at v = 0; others are clamped
};

/// A layer of haptic texture: a field of values from 0 to 1 that changes the height or the material of its
/// surface.
class TACTUM_API Layer {
public:
    Layer(const Layer&) = default; // no moves: what names something goes on to
    Layer& operator=(const Layer&) = default;

    std::string name() const;
    /// A number by its key: "strength" (m where the target is height, else a ratio), "opacity", or one of a
    /// pattern such as "size" (parameters()). Error: no such number, or out of its range.
    void set(std::string_view key, double value);
    double get(std::string_view key) const;
    /// A choice: "mapping", "target" or "blend", by the words of files. Error: no such choice or word.
    void set(std::string_view key, std::string_view word);
    std::string word(std::string_view key) const;
    void setEnabled(bool enabled); ///< whether it counts

private:
    friend struct Parts;
    TACTUM_INTERNAL Layer(std::shared_ptr<SceneState> scene, std::uint32_t object, std::size_t surface,
                          std::size_t index);

    std::shared_ptr<SceneState> scene_;
    std::uint32_t object_;
    std::size_t surface_, index_;
};

/// A part of an object with one feel: a group or material of the file.
class TACTUM_API Surface {
public:
    Surface(const Surface&) = default; // as Layer
    Surface& operator=(const Surface&) = default;

    std::string name() const;
    /// A number by its key, SI: "stiffness", "damping", "static-friction", "dynamic-friction", "viscosity",
    /// "crease-angle". Dynamic friction is never above static: the other one follows. Error: no such number,
    /// or out of its range.
    void set(std::string_view key, double value);
    double get(std::string_view key) const;
    /// A choice: "sides" (both, front, back, none) or "normals" (file, computed).
    void set(std::string_view key, std::string_view word);
    std::string word(std::string_view key) const;
    void setShading(bool on); ///< whether it feels smooth although it is made of facets
    bool shading() const;
    void setVisible(bool visible); ///< else it is neither seen nor felt
    bool visible() const;
    /// Gives it a preset; what that does not set stays.
    void apply(const Preset& preset);

    /// Lowest first.
    std::vector<Layer> layers() const;
    /// On top of the others; source: noise, grooves, dots or weave. Error: no such source, or more than 16
    /// layers.
    Layer addLayer(std::string_view source);
    /// The same of a picture.
    Layer addLayer(const Image& image);
    void clearLayers();

private:
    friend struct Parts;
    TACTUM_INTERNAL Surface(std::shared_ptr<SceneState> scene, std::uint32_t object, std::size_t index);

    std::shared_ptr<SceneState> scene_;
    std::uint32_t object_;
    std::size_t index_;
};

} // namespace tactum::library
