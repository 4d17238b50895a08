#include "ui/tools/brush_stroke.h"

#include <algorithm>

namespace tactum {

namespace {

constexpr std::size_t kKeptCovers = 8;

PaintableSurfaces only(Index surface) {
    PaintableSurfaces one;
    one.allowed.resize(std::size_t(surface) + 1);
    one.allowed[surface] = true;
    return one;
}

template <class Stroke> void follow(Stroke& stroke, const PaintStep& step) {
    if (step)
        stroke.moveTo(*step);
    else
        stroke.lift();
}

} // namespace

std::optional<TexelMap> texelMapOf(const TexturePattern& pattern,
                                   const std::shared_ptr<const TriangleSoup>& soup, Index surface) {
    if (pattern.source != TextureSource::Image || !usesUvs(pattern)) return std::nullopt;
    TextureLayer layer;
    layer.pattern = pattern;
    const auto stack = compileTextures({layer}, soup, surface);
    return stack ? std::optional(texelMapOf(stack->layers.front().pattern)) : std::nullopt;
}

std::shared_ptr<const SoupReach> PaintGround::reach() {
    if (!reach_) reach_ = std::make_shared<const SoupReach>(soup_);
    return reach_;
}

std::shared_ptr<const TexelCover> PaintGround::coverOf(Index surface, const TexturePattern& pattern) {
    const auto map = texelMapOf(pattern, soup_, surface);
    if (!map) return nullptr;
    for (const Cover& known : covers_)
        if (known.surface == surface && known.cover->map() == *map) return known.cover;
    if (covers_.size() == kKeptCovers) covers_.erase(covers_.begin());
    covers_.push_back({surface, std::make_shared<const TexelCover>(*soup_, only(surface), *map)});
    return covers_.back().cover;
}

void BrushStroke::begin() {
    for (const Part& part : parts_) {
        Strokes& made = strokes_.emplace_back();
        const PaintableSurfaces surfaces = only(part.surface);
        if (part.pattern.source == TextureSource::Painted)
            made.values = std::make_unique<VertexStroke>(ground_->reach(), surfaces,
                                                         part.pattern.painted.values, brush_);
        else if (auto cover = ground_->coverOf(part.surface, part.pattern))
            made.image = std::make_unique<ImageStroke>(ground_->reach(), surfaces, std::move(cover),
                                                       part.pattern.image, brush_);
    }
}

const std::vector<BrushStroke::Part>& BrushStroke::work(const std::vector<PaintStep>& steps) {
    if (strokes_.empty()) begin();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        Strokes& stroke = strokes_[i];
        for (const PaintStep& step : steps) {
            if (stroke.values) follow(*stroke.values, step);
            if (stroke.image) follow(*stroke.image, step);
        }
        if (stroke.values) parts_[i].pattern.painted.values = stroke.values->values();
        if (stroke.image) parts_[i].pattern.image = stroke.image->image();
    }
    return parts_;
}

} // namespace tactum
