// A pattern of haptic texture, and the mask of a layer, which is one.
#include "app/python/pattern_of.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactum::python {
namespace {

constexpr py::ssize_t kSide = TextureImage::kLargestSide;

std::shared_ptr<const TextureImage> imageOf(const py::handle& values, const std::string& what) {
    const Numbers rows = numbersOf(values, what);
    if (rows.ndim() != 2 || rows.shape(0) < 1 || rows.shape(0) > kSide || rows.shape(1) < 1 ||
        rows.shape(1) > kSide || std::size_t(rows.size()) > TextureImage::kMaxTexels)
        throw Failure(what + ": is an array of rows and columns, each from 1 to " + std::to_string(kSide) +
                      ", with at most " + std::to_string(TextureImage::kMaxTexels) + " values");
    std::vector<std::uint16_t> texels(std::size_t(rows.size()));
    std::transform(rows.data(), rows.data() + rows.size(), texels.begin(), [](double value) {
        return std::uint16_t(std::nearbyint(65535 * std::clamp(value, 0.0, 1.0))); // as numpy rounds
    });
    return std::make_shared<const TextureImage>(int(rows.shape(1)), int(rows.shape(0)), std::move(texels));
}

py::object arrayOfImage(const TexturePattern& of) {
    if (!of.image) return py::none();
    const TextureImage& image = *of.image;
    py::array_t<double> rows({image.height(), image.width()});
    for (int y = 0; y < image.height(); ++y)
        std::transform(image.row(y), image.row(y) + image.width(), rows.mutable_data(y, 0),
                       [](std::uint16_t texel) { return texel / 65535.0; });
    return rows;
}

SharedPaint paintOf(const py::handle& values, const std::string& what, std::size_t vertices) {
    const Numbers numbers = numbersOf(values, what);
    if (numbers.ndim() != 1 || std::size_t(numbers.size()) != vertices)
        throw Failure(what + ": has the shape " + std::string(py::str(numbers.attr("shape"))) +
                      ", and a value for each of the " + std::to_string(vertices) + " vertices is wanted");
    return {std::make_shared<const PaintedValues>(
        std::vector<float>(numbers.data(), numbers.data() + numbers.size()))};
}

TextureSource sourceNamed(const std::string& word) {
    TexturePattern pattern;
    const auto from = choice<TexturePattern>("source", "", kTextureSources,
                                             [](TexturePattern& of) -> TextureSource& { return of.source; });
    from.set(pattern, py::str(word));
    return pattern.source;
}

void expect(const py::object& array, bool wanted, const std::string& name, const std::string& source) {
    if (array.is_none() == wanted)
        throw Failure(name + ": is for the source '" + source + "', and only for that");
}

} // namespace

void setSource(TexturePattern& pattern, const std::string& source, const PatternArrays& arrays,
               std::size_t vertices) {
    const TextureSource from = sourceNamed(source);
    expect(arrays.image, from == TextureSource::Image, "image", "image");
    expect(arrays.paint, from == TextureSource::Painted, "paint", "painted");
    pattern.source = from;
    pattern.image = arrays.image.is_none() ? nullptr : imageOf(arrays.image, "image");
    pattern.painted = arrays.paint.is_none() ? SharedPaint{} : paintOf(arrays.paint, "paint", vertices);
}

TexturePattern maskOf(const py::handle& values, const TexturePattern& layer, std::size_t vertices) {
    TexturePattern mask = layer;
    mask.image = nullptr, mask.painted = {};
    if (py::isinstance<py::str>(values)) {
        setSource(mask, values.cast<std::string>(), {py::none(), py::none()}, vertices);
    } else if (numbersOf(values, "mask").ndim() == 1) {
        mask.source = TextureSource::Painted;
        mask.painted = paintOf(values, "mask", vertices);
    } else {
        mask.source = TextureSource::Image;
        mask.image = imageOf(values, "mask");
    }
    return mask;
}

py::object arrayOfPaint(const TexturePattern& of, std::size_t vertices) {
    if (of.source != TextureSource::Painted) return py::none();
    py::array_t<double> values{py::ssize_t(vertices)};
    std::fill_n(values.mutable_data(), vertices, 0.0);
    if (of.painted.values)
        std::copy_n(of.painted.values->all().begin(), std::min(vertices, of.painted.values->size()),
                    values.mutable_data());
    return values;
}

void setPaint(TexturePattern& of, const py::handle& values, std::size_t vertices) {
    if (of.source != TextureSource::Painted)
        throw Failure("paint: is for the source 'painted', and only for that");
    of.painted = paintOf(values, "paint", vertices);
}

const Properties<TexturePattern>& patternProperties() {
    static const Properties<TexturePattern> all = [] {
        Properties<TexturePattern> made{
            choice<TexturePattern>("mapping", "How it comes onto the surface", kTextureMappings,
                                   [](TexturePattern& of) -> TextureMapping& { return of.mapping; })};
        for (const PatternField& field : kPatternFields)
            made.push_back(number<TexturePattern>(
                *field.parameter, [&field](const TexturePattern& of) { return of.*field.value; },
                [&field](TexturePattern& of, double value) { of.*field.value = value; }));
        made.push_back({"source",
                        "str: Where its values come from: image, noise, grooves, dots, weave or painted.",
                        [](const TexturePattern& of) {
                            return py::str(std::string(kTextureSources[std::size_t(of.source)].key));
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

void bindMask(py::module_& module) {
    py::class_<MaskHandle> mask(
        module, "Mask",
        "Where a layer counts: all where the mask is 1, nothing where it is 0. Setting a property changes "
        "the scene. Thread: any, one at a time.");
    declare(mask, patternProperties());
    declarePaint(
        mask, [](const MaskHandle& of) -> TexturePattern& { return of.get(); },
        [](const MaskHandle& of) { return of.layer; });
    mask.def(
            "set",
            [](const MaskHandle& of, const py::kwargs& values) { setAll(of, patternProperties(), values); },
            "Several properties at once, all or none. An Error names what cannot be.")
        .def("__repr__",
             [](const MaskHandle& of) { return "<Mask of " + inQuotes(of.layer.get().name) + ">"; });
}

} // namespace tactum::python
