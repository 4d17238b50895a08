#include "ui/tools/paint_tool.h"

#include <algorithm>

#include "ui/base/words.h"

namespace tactum {

namespace {

constexpr std::size_t kKeptGrounds = 4;

Brush brushFor(Brush brush, Qt::KeyboardModifiers modifiers) {
    if (modifiers & Qt::ShiftModifier) brush.mode = BrushMode::Smooth;
    if (!(modifiers & Qt::ControlModifier)) return brush;
    if (brush.mode == BrushMode::Add)
        brush.mode = BrushMode::Subtract;
    else if (brush.mode == BrushMode::Subtract)
        brush.mode = BrushMode::Add;
    else if (brush.mode == BrushMode::Set)
        brush.value = 1 - brush.value;
    return brush;
}

/// What a pattern is before anything was painted: a mask of which the first stroke takes something away is
/// full.
TexturePattern emptyPattern(const Brush& brush, bool mask, std::size_t positions) {
    TexturePattern pattern;
    pattern.source = TextureSource::Painted;
    if (mask && brush.mode == BrushMode::Subtract)
        pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(positions, 1.0F));
    return pattern;
}

} // namespace

PaintTool::PaintTool(Document& document, SceneView& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
    connect(&view_, &SceneView::stroked, this, &PaintTool::follow);
    connect(&view_, &SceneView::surfaceHovered, this, [this](const std::optional<SurfaceRef>& surface) {
        if (!surface || surface->object == shown_) return;
        shown_ = surface->object;
        show();
    });
    connect(&document_, &Document::changed, this, [this](const SceneChange& change) {
        if (change.touchesFeel()) show();
    });
    showRing();
}

void PaintTool::setActive(bool active) {
    active_ = active;
    show();
}

void PaintTool::setBrush(const Brush& brush) {
    brush_ = madeSafe(brush);
    showRing();
    emit brushChanged();
}

void PaintTool::setGoal(PaintGoal goal) {
    goal_ = goal;
    show();
}

void PaintTool::setLayer(std::optional<int> layer) {
    layer_ = layer;
    show();
}

void PaintTool::showRing() {
    view_.setBrush({brush_.radius, 1 - brush_.falloff});
}

std::optional<int> PaintTool::layerFor(SurfaceRef ref) const {
    return document_.selection() == ref ? layer_ : std::nullopt;
}

/// Kept for the meshes painted last.
std::shared_ptr<PaintGround> PaintTool::groundOf(ObjectId id) {
    const auto& soup = document_.scene().find(id)->geometry;
    for (const auto& ground : grounds_)
        if (ground->soup() == soup) return ground;
    if (grounds_.size() == kKeptGrounds) grounds_.erase(grounds_.begin());
    return grounds_.emplace_back(std::make_shared<PaintGround>(soup));
}

void PaintTool::follow(StrokeStep step, const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers) {
    switch (step) {
    case StrokeStep::Begin:
        if (hit) beginStroke(*hit, modifiers);
        break;
    case StrokeStep::Move:
    case StrokeStep::Lift:
        addStep(hit);
        break;
    case StrokeStep::End:
        if (!strokes_.empty()) strokes_.back().ended = true;
        break;
    case StrokeStep::Cancel:
        giveUp();
        break;
    }
    goOn();
}

void PaintTool::beginStroke(const PickHit& hit, Qt::KeyboardModifiers modifiers) {
    Stroke stroke;
    const SurfaceRefs& selected = document_.selected();
    if (std::ranges::find(selected, hit.surface) == selected.end())
        stroke.surfaces = hit.surface;
    else
        std::ranges::copy_if(selected, std::back_inserter(stroke.surfaces),
                             [&](SurfaceRef ref) { return ref.object == hit.surface.object; });
    if (document_.surface(hit.surface)->locked)
        return emit refused(tr("%1 is locked; unlock it first (L).")
                                .arg(QString::fromStdString(document_.surface(hit.surface)->name)));
    std::erase_if(stroke.surfaces, [this](SurfaceRef ref) { return document_.surface(ref)->locked; });
    stroke.brush = brushFor(brush_, modifiers);
    stroke.goal = goal_;
    strokes_.push_back(std::move(stroke));
    shown_ = hit.surface.object;
    addStep(hit);
}

void PaintTool::addStep(const std::optional<PickHit>& hit) {
    if (strokes_.empty() || strokes_.back().ended) return;
    Stroke& stroke = strokes_.back();
    const ObjectId id = stroke.surfaces.front().object;
    const SceneObject* object = document_.scene().find(id);
    if (!hit || hit->surface.object != id || !object) return stroke.steps.push_back(std::nullopt);
    stroke.steps.push_back(
        Dab{object->pose.applyInverse(hit->point), object->pose.rotateInverse(hit->normal)});
}

/// What the stroke has painted already is taken back.
void PaintTool::giveUp() {
    if (strokes_.empty() || strokes_.back().ended) return;
    Stroke& stroke = strokes_.back();
    stroke.steps.clear();
    stroke.ended = true;
    stroke.seen.clear(); // whatever is still being worked out is not written
    document_.giveUpTrial(stroke.gesture);
}

void PaintTool::goOn() {
    while (!job_.running() && !strokes_.empty()) {
        Stroke& stroke = strokes_.front();
        if (stroke.steps.empty()) {
            if (!stroke.ended) return;
            document_.keepTrial(stroke.gesture);
            strokes_.pop_front();
            continue;
        }
        if (!stroke.work && !start(stroke)) {
            stroke.steps.clear();
            if (!stroke.ended) return;
            continue;
        }
        job_.start([this, work = stroke.work,
                    steps = std::exchange(stroke.steps, {})](const Progress&) -> BackgroundJob::Delivery {
            return [this, parts = work->work(steps)] {
                if (!strokes_.empty()) write(strokes_.front(), parts);
                goOn();
            };
        });
    }
}

/// Looks where each surface is painted: the strokes before this one are written now.
bool PaintTool::start(Stroke& stroke) {
    std::vector<BrushStroke::Part> parts;
    stroke.places.clear();
    stroke.seen.clear();
    const ObjectId id = stroke.surfaces.front().object;
    for (const SurfaceRef ref : stroke.surfaces) {
        const Surface* surface = document_.surface(ref);
        if (!surface) return false;
        const auto place = paintPlaceOf(*surface, stroke.goal, layerFor(ref));
        if (!place) {
            emit refused(QString::fromStdString(place.error().text));
            return false;
        }
        if (scalesNothing(*surface, stroke.goal))
            emit refused(tr("%1 has none of what you paint: the brush scales it. Set it above 0 to feel it.")
                             .arg(QString::fromStdString(surface->name)));
        const TexturePattern* now = patternAt(*surface, *place);
        const std::size_t positions = document_.scene().find(id)->geometry->positions.size();
        stroke.places.push_back(*place);
        stroke.seen.push_back(*surface);
        parts.push_back({ref.surface, now ? *now : emptyPattern(stroke.brush, place->mask, positions)});
    }
    stroke.work = std::make_shared<BrushStroke>(groundOf(id), stroke.brush, std::move(parts));
    stroke.gesture = document_.beginTrial();
    return true;
}

bool PaintTool::stillThere(const Stroke& stroke) const {
    if (stroke.seen.size() != stroke.surfaces.size()) return false;
    for (std::size_t i = 0; i < stroke.seen.size(); ++i) {
        const Surface* now = document_.surface(stroke.surfaces[i]);
        if (!now || now->locked || !(now->layers == stroke.seen[i].layers)) return false;
    }
    return true;
}

void PaintTool::write(Stroke& stroke, const std::vector<BrushStroke::Part>& parts) {
    if (!stillThere(stroke)) { // undone, or edited, meanwhile
        stroke.steps.clear();
        stroke.ended = true;
        return;
    }
    std::size_t i = 0;
    const QString goal = wordsOf(kPaintGoals[std::size_t(stroke.goal)].label).toLower();
    document_.editSurfaces(
        stroke.surfaces, SceneChange::What::Layers, tr("Paint %1 of %2").arg(goal, QStringLiteral("%1")),
        [&](Surface& each) {
            putPattern(each, stroke.places[i], stroke.goal, parts[i].pattern);
            stroke.seen[i++] = each;
        },
        stroke.gesture);
}

/// The paint of every surface of the object under the pointer, or that was there last.
void PaintTool::show() {
    PaintedPicture picture;
    const SceneObject* object = active_ && shown_ ? document_.scene().find(*shown_) : nullptr;
    if (!object) return view_.setPainted(picture);
    picture.object = object->id;
    picture.soup = object->geometry;
    for (Index i = 0; i < Index(object->surfaces.size()); ++i) {
        const Surface& surface = object->surfaces[i];
        const auto place = paintPlaceOf(surface, goal_, layerFor({object->id, i}));
        const TexturePattern* pattern = place ? patternAt(surface, *place) : nullptr;
        if (!pattern || !surface.visible) continue;
        PaintedPart part{i, pattern->painted.values, nullptr, {}};
        if (pattern->source == TextureSource::Image) {
            const auto map = texelMapOf(*pattern, object->geometry, i);
            if (!map) continue;
            part.image = pattern->image;
            part.map = *map;
        }
        picture.parts.push_back(std::move(part));
    }
    view_.setPainted(picture);
}

} // namespace tactum
