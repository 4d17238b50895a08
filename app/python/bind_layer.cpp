// A layer of haptic texture.
#include <algorithm>
#include <iterator>

#include <pybind11/stl.h>

#include "app/python/pattern_of.h"
#include "app/python/texture_of.h"
#include "core/base/text.h"

namespace tactum::python {
namespace {

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

void setMask(const LayerHandle& of, const py::object& mask, const py::kwargs& values) {
    TextureLayer& layer = of.get();
    if (mask.is_none())
        layer.mask.reset();
    else
        layer.mask = changed(maskOf(mask, layer.pattern, of.vertices()), patternProperties(), values);
}

} // namespace

TextureLayer layerOf(const std::string& source, const PatternArrays& arrays, const py::object& mask,
                     const py::kwargs& values, std::size_t vertices) {
    TextureLayer layer;
    setSource(layer.pattern, source, arrays, vertices);
    layer.name = source;
    layer = changed(std::move(layer), layerProperties(), values);
    if (!mask.is_none()) layer.mask = maskOf(mask, layer.pattern, vertices);
    return layer;
}

const Properties<TextureLayer>& layerProperties() {
    static const Properties<TextureLayer> all = [] {
        Properties<TextureLayer> made{
            nameOfLayer(),
            truth("enabled", "bool: Whether it counts.", &TextureLayer::enabled),
            targetOfLayer(),
            strengthOfLayer(),
            choice<TextureLayer>("blend", "How it joins what lies below", kTextureBlends,
                                 [](TextureLayer& of) -> TextureBlend& { return of.blend; }),
            number<TextureLayer>(
                kTextureOpacity, [](const TextureLayer& of) { return of.opacity; },
                [](TextureLayer& of, double value) { of.opacity = value; }),
            truth("own_plane", "bool: Whether a height has a constraint plane of its own.",
                  &TextureLayer::ownPlane)};
        std::ranges::copy(
            lifted<TextureLayer>(patternProperties(),
                                 [](TextureLayer& of) -> TexturePattern& { return of.pattern; }),
            std::back_inserter(made));
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
    declarePaint(
        layer, [](const LayerHandle& of) -> TexturePattern& { return of.get().pattern; },
        [](const LayerHandle& of) { return of; });
    layer
        .def(
            "set",
            [](const LayerHandle& of, const py::kwargs& values) { setAll(of, layerProperties(), values); },
            "Several properties at once, all or none. An Error names what cannot be.")
        .def_property_readonly(
            "mask",
            [](const LayerHandle& of) {
                return of.get().mask ? std::optional(MaskHandle{of}) : std::nullopt;
            },
            "Optional[Mask]: Where it counts; None: everywhere.")
        .def("set_mask", setMask, py::arg("mask"),
             "Says where it counts, 1 all and 0 nothing.\n\n"
             "mask: a picture, (rows, columns) of values from 0 to 1, row 0 at v = 0; or what is painted, a "
             "value for each of the object's vertices; or noise, grooves, dots or weave; None takes it away. "
             "It lies as the layer does unless further words, properties of a Mask, say otherwise: "
             "set_mask(picture, mapping='uv-unit').")
        .def("__repr__", [](const LayerHandle& of) { return "<Layer " + inQuotes(of.get().name) + ">"; });
}

} // namespace tactum::python
