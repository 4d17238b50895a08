#include <tactum/surface.h>

#include <algorithm>
#include <cmath>

#include "app/library/parts.h"
#include "app/library/values.h"

namespace tactum::library {
namespace {

std::shared_ptr<const TextureImage> imageOf(const Image& image) {
    const auto side = std::size_t(TextureImage::kLargestSide);
    if (image.width < 1 || image.width > side || image.height < 1 || image.height > side ||
        image.width * image.height > TextureImage::kMaxTexels)
        refuse("image: its sides are from 1 to " + std::to_string(side) + " texels, with at most " +
               std::to_string(TextureImage::kMaxTexels) + " values");
    if (image.values.size() != image.width * image.height)
        refuse("image: has " + std::to_string(image.values.size()) + " values, and width times height is " +
               std::to_string(image.width * image.height));
    std::vector<std::uint16_t> texels;
    texels.reserve(image.values.size());
    for (const double value : image.values) {
        if (!std::isfinite(value)) refuse("image: has a value that is not finite");
        texels.push_back(std::uint16_t(std::nearbyint(65535 * std::clamp(value, 0.0, 1.0))));
    }
    return std::make_shared<const TextureImage>(int(image.width), int(image.height), std::move(texels));
}

std::size_t append(core::Surface& to, core::TextureLayer layer) {
    if (to.layers.size() >= std::size_t(kMaxTextureLayers))
        refuse("a surface has at most " + std::to_string(kMaxTextureLayers) + " layers");
    to.layers.push_back(std::move(layer));
    return to.layers.size() - 1;
}

} // namespace

Layer::Layer(std::shared_ptr<SceneState> scene, std::uint32_t object, std::size_t surface, std::size_t index)
    : scene_(std::move(scene)), object_(object), surface_(surface), index_(index) {}

std::string Layer::name() const {
    return Parts::get(*this).name;
}

void Layer::set(std::string_view key, double value) {
    setNumber(Parts::get(*this), layerNumbers(), key, value);
}

double Layer::get(std::string_view key) const {
    return named(layerNumbers(), key).get(Parts::get(*this));
}

void Layer::set(std::string_view key, std::string_view word) {
    setWord(Parts::get(*this), layerChoices(), key, word);
}

std::string Layer::word(std::string_view key) const {
    return wordOf(Parts::get(*this), layerChoices(), key);
}

void Layer::setEnabled(bool enabled) {
    Parts::get(*this).enabled = enabled;
}

Surface::Surface(std::shared_ptr<SceneState> scene, std::uint32_t object, std::size_t index)
    : scene_(std::move(scene)), object_(object), index_(index) {}

std::string Surface::name() const {
    return Parts::get(*this).name;
}

void Surface::set(std::string_view key, double value) {
    setNumber(Parts::get(*this), surfaceNumbers(), key, value);
}

double Surface::get(std::string_view key) const {
    return named(surfaceNumbers(), key).get(Parts::get(*this));
}

void Surface::set(std::string_view key, std::string_view word) {
    setWord(Parts::get(*this), surfaceChoices(), key, word);
}

std::string Surface::word(std::string_view key) const {
    return wordOf(Parts::get(*this), surfaceChoices(), key);
}

void Surface::setShading(bool on) {
    Parts::get(*this).shading.on = on;
}

bool Surface::shading() const {
    return Parts::get(*this).shading.on;
}

void Surface::setVisible(bool visible) {
    Parts::get(*this).visible = visible;
}

bool Surface::visible() const {
    return Parts::get(*this).visible;
}

void Surface::apply(const Preset& preset) {
    core::Surface& surface = Parts::get(*this);
    surface = applied(surface, Parts::get(preset));
}

std::vector<Layer> Surface::layers() const {
    std::vector<Layer> all;
    for (std::size_t i = 0; i < Parts::get(*this).layers.size(); ++i)
        all.push_back(Parts::layer(*this, i));
    return all;
}

Layer Surface::addLayer(std::string_view source) {
    core::TextureLayer layer;
    layer.pattern.source = TextureSource(placeOf(source, layerSources(), "source"));
    if (layer.pattern.source == TextureSource::Painted)
        refuse("source: what is painted belongs to its mesh, and cannot be made here");
    if (layer.pattern.source == TextureSource::Image) refuse("source: give the picture itself");
    layer.name = source;
    return Parts::layer(*this, append(Parts::get(*this), std::move(layer)));
}

Layer Surface::addLayer(const Image& image) {
    core::TextureLayer layer;
    layer.pattern.source = TextureSource::Image;
    layer.pattern.image = imageOf(image);
    layer.name = "image";
    return Parts::layer(*this, append(Parts::get(*this), std::move(layer)));
}

void Surface::clearLayers() {
    Parts::get(*this).layers.clear();
}

} // namespace tactum::library
