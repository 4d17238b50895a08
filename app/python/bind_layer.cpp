// A layer of haptic texture.
#include <algorithm>
#include <cmath>

#include <pybind11/stl.h>

#include "app/python/scene_handles.h"
#include "app/python/texture_of.h"
#include "core/base/text.h"

namespace tactum::python {
namespace {

constexpr py::ssize_t kSide = TextureImage::kLargestSide;

std::shared_ptr<const TextureImage> imageOf(const py::object& values) {
    const Numbers rows = numbersOf(values, "image");
    if (rows.ndim() != 2 || rows.shape(0) < 1 || rows.shape(0) > kSide || rows.shape(1) < 1 ||
        rows.shape(1) > kSide || std::size_t(rows.size()) > TextureImage::kMaxTexels)
        throw Failure("image: is an array of rows and columns, each from 1 to " + std::to_string(kSide) +
                      ", with at most " + std::to_string(TextureImage::kMaxTexels) + " values");
    std::vector<std::uint16_t> texels(std::size_t(rows.size()));
    std::transform(rows.data(), rows.data() + rows.size(), texels.begin(), [](double value) {
        return std::uint16_t(std::nearbyint(65535 * std::clamp(value, 0.0, 1.0))); // as numpy rounds
    });
    return std::make_shared<const TextureImage>(int(rows.shape(1)), int(rows.shape(0)), std::move(texels));
}

py::object arrayOfImage(const TextureLayer& of) {
    if (!of.pattern.image) return py::none();
    const TextureImage& image = *of.pattern.image;
    py::array_t<double> rows({image.height(), image.width()});
    for (int y = 0; y < image.height(); ++y)
        std::transform(image.row(y), image.row(y) + image.width(), rows.mutable_data(y, 0),
                       [](std::uint16_t texel) { return texel / 65535.0; });
    return rows;
}

/// What is a height and what a ratio have other units: the strength begins anew.
Property<TextureLayer> targetOfLayer() {
    auto target = choice<TextureLayer>("target", "What it changes", kTextureTargets,
                                       [](TextureLayer& of) -> TextureTarget& { return of.target; });
    target.set = [set = target.set](TextureLayer& of, const py::handle& value) {
        const Parameter& before = strengthParameter(of.target);
        set(of, value);
        const Parameter& now = strengthParameter(of.target);
        if (&now != &before) of.strength = now.initial;
    };
    return target;
}

Property<TextureLayer> strengthOfLayer() {
    return {"strength",
            "float: How much it does: the parameter 'height' in m where the target is height, else 'ratio' "
            "(tactum.parameters).",
            [](const TextureLayer& of) { return py::float_(of.strength); },
            [](TextureLayer& of, const py::handle& value) {
                of.strength = allowed(strengthParameter(of.target), value, "strength");
            }};
}

Property<TextureLayer> nameOfLayer() {
    return {"name", "str: What the author calls it.", [](const TextureLayer& of) { return py::str(of.name); },
            [](TextureLayer& of, const py::handle& value) {
                of.name = printable(wordOf(value, "name"), kLongestName);
            }};
}

} // namespace

TextureLayer layerOf(const std::string& source, const py::object& image, const py::kwargs& values) {
    TextureLayer layer;
    auto from = choice<TextureLayer>("source", "", kTextureSources,
                                     [](TextureLayer& of) -> TextureSource& { return of.pattern.source; });
    from.set(layer, py::str(source));
    if (layer.pattern.source == TextureSource::Painted)
        throw Failure("source: what is painted belongs to its mesh, and cannot be made here");
    if ((layer.pattern.source == TextureSource::Image) == image.is_none())
        throw Failure("image: is for the source 'image', and only for that");
    if (!image.is_none()) layer.pattern.image = imageOf(image);
    layer.name = source;
    return changed(std::move(layer), layerProperties(), values);
}

const Properties<TextureLayer>& layerProperties() {
    static const Properties<TextureLayer> all = [] {
        Properties<TextureLayer> made{
            nameOfLayer(),
            truth("enabled", "bool: Whether it counts.", &TextureLayer::enabled),
            choice<TextureLayer>("mapping", "How it comes onto the surface", kTextureMappings,
                                 [](TextureLayer& of) -> TextureMapping& { return of.pattern.mapping; }),
            targetOfLayer(),
            strengthOfLayer(),
            choice<TextureLayer>("blend", "How it joins what lies below", kTextureBlends,
                                 [](TextureLayer& of) -> TextureBlend& { return of.blend; }),
            number<TextureLayer>(
                kTextureOpacity, [](const TextureLayer& of) { return of.opacity; },
                [](TextureLayer& of, double value) { of.opacity = value; }),
            truth("own_plane", "bool: Whether a height has a constraint plane of its own.",
                  &TextureLayer::ownPlane)};
        for (const PatternField& field : kPatternFields)
            made.push_back(number<TextureLayer>(
                *field.parameter, [&field](const TextureLayer& of) { return of.pattern.*field.value; },
                [&field](TextureLayer& of, double value) { of.pattern.*field.value = value; }));
        made.push_back({"source",
                        "str: Where its values come from.",
                        [](const TextureLayer& of) {
                            return py::str(std::string(kTextureSources[std::size_t(of.pattern.source)].key));
                        },
                        {}});
        made.push_back({"image",
                        "Optional[numpy.typing.NDArray[numpy.float64]]: A copy of its picture, rows and "
                        "columns of values from 0 to 1; None for another source.",
                        arrayOfImage,
                        {}});
        return made;
    }();
    return all;
}

void bindLayer(py::module_& module) {
    py::class_<LayerHandle> layer(
        module, "Layer",
        "A layer of haptic texture on a surface. Setting a property changes the scene. Thread: any, one at a "
        "time.");
    declare(layer, layerProperties());
    layer
        .def(
            "set",
            [](const LayerHandle& of, const py::kwargs& values) { setAll(of, layerProperties(), values); },
            "Several properties at once, all or none. An Error names what cannot be.")
        .def("__repr__", [](const LayerHandle& of) { return "<Layer " + inQuotes(of.get().name) + ">"; });
}

} // namespace tactum::python
