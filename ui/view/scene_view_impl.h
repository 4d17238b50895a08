// What scene_view.cpp and scene_view_events.cpp share. Private to this folder.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QVariantAnimation>

#include "ui/view/boundary_lines.h"
#include "ui/view/contact_loupe.h"
#include "ui/view/face_layer.h"
#include "ui/view/felt_view.h"
#include "ui/view/ground_layer.h"
#include "ui/view/hand_tool.h"
#include "ui/view/lagging_cursor.h"
#include "ui/view/mark_layer.h"
#include "ui/view/model_layer.h"
#include "ui/view/occlusion_layer.h"
#include "ui/view/paint_layer.h"
#include "ui/view/scene_picker.h"
#include "ui/view/scene_view.h"
#include "ui/view/touch_overlay.h"
#include "ui/view/view_panes.h"
#include "ui/view/view_stage.h"

namespace tactum {

/// A hand that holds still trembles by less than this.
inline constexpr double kUnseenPixels = 0.1;

/// What a mouse button that is down does.
enum class ViewDrag { None, Orbit, Pan, Hand, Box, Lasso, Brush, Paint, Handles, Lines };

struct SceneView::Impl {
    explicit Impl(SceneView& view);

    const Theme& theme() const { return themeFor(dark); }
    bool showsTouch() const { return touch.has_value() && overlayVisible; }

    /// Where the processor draws: as well as the time allows that the last picture took.
    void spareTime(PictureQuality quality);
    /// What a picture in motion leaves out where it takes too long.
    Coarse coarseInMotion() const;
    /// All that must not be clipped away for a camera.
    Bounds shownTo(const ViewCamera& camera) const;
    /// What distances of the camera are measured by: from one corner of the scene to the other, m.
    double extent() const;
    /// Of the active pane: what the mouse and the keys act upon.
    ViewCamera& camera() { return panes[panes.active()].camera; }
    const ViewCamera& camera() const { return panes[panes.active()].camera; }
    /// A logical pixel at the depth of a point in the pane that shows it largest, m.
    double finestPixel(const Vec3& p_W) const;
    /// Looks at the whole scene, from where the pane looks from now.
    void fit(ViewPane& pane);
    /// A drag, or something that follows the pointer, stays in the pane where it began.
    bool staysInPane() const { return drag != ViewDrag::None || hand.grip() == Grip::Follow; }
    /// Where a place of the view is in the pane that is active from now on.
    QPointF pointAt(QPointF place);
    /// The same for what is done there.
    QPointF actAt(QPointF place);
    ViewPane& pane() { return panes[panes.active()]; }
    const ViewPane& pane() const { return panes[panes.active()]; }
    QPoint inScreen(QPointF cursor) const;
    /// The lines between panes that a press there would take, or has taken.
    Qt::Orientations linesUnder(QPointF cursor) const;
    bool takeLines(QPointF place);
    void leadLines(QPointF place);
    void endLines(QPointF cursor);
    /// Whether there are any, which are in the middle again.
    bool evenLines(QPointF place);
    /// What the scene's objects cast shadows from; those that move are where they are now.
    void castShadows(bool rest);
    void refreshSelection();
    /// `part` of the way of a flight, 0 to 1.
    void fly(double part);
    void applyTheme();

    void showLoupe(bool on);
    /// Something has changed in what it shows.
    void askForLoupe();
    /// Opens and leaves it by the touch.
    void watchLoupe();
    void drawLoupe();

    /// The touch that the mouse leads; null: none is known.
    const TouchState* ledTouch() const;
    /// What the shadows of the hands fall on.
    Drop shadows() const;
    void placeBeside(const ViewCamera& camera);
    void drawBeside(QPainter& painter, const ViewCamera& camera) const;

    bool isNearFinger(QPointF cursor) const;
    /// Whether a press there takes the finger itself, and not the place.
    bool takesFinger(QPointF cursor, const std::optional<PickHit>& hit) const;
    bool lags() const;
    /// The force on the finger that the mouse leads, N, right and down.
    QPointF pushInPicture() const;
    void leaveHand(bool givenUp);
    void liftHand();
    void liftAgain();
    Vec3 clearPlace() const;
    bool isSeen(const Vec3& p_W) const;
    std::optional<PickHit> pick(QPointF cursor, ScenePicker::Patience patience) const;
    /// At a place of the view, in whichever pane it is.
    std::optional<PickHit> pickAt(QPointF place, ScenePicker::Patience patience) const;
    void pressLeft(QPointF cursor, bool alt);
    void takeHold(QPointF cursor, const std::optional<PickHit>& hit);
    void release(QPointF cursor, Qt::KeyboardModifiers modifiers);
    /// Takes the handle under the cursor, if there is one.
    bool takeHandles(QPointF cursor);
    std::optional<Vec3> axisUnder(QPointF cursor) const;
    void lookAlong(const Vec3& axis);
    void grabbed(ViewHandles& which);
    void leadHandles(QPointF cursor, Qt::KeyboardModifiers modifiers);
    void giveUpHandles();
    bool holdsArranging() const { return drag == ViewDrag::Handles && taken == &arranging; }
    bool arrangeKey(int key);
    void askForMenu(QPointF cursor);
    bool drawsRegion() const { return drag == ViewDrag::Box || drag == ViewDrag::Lasso; }
    void endRegion(QPointF cursor, Qt::KeyboardModifiers modifiers);
    bool brushes() const { return tool == ViewTool::Select && selectBrush; }
    void drawRegion(QPainter& painter) const;
    void drawHandles(QPainter& painter, const ViewPane& pane) const;
    /// All that is drawn over the picture of a pane, whose upper left corner is the painter's origin.
    void drawPane(QPainter& painter, std::size_t number) const;
    void drawWords(QPainter& painter, const ViewPane& pane, double below) const;
    void drawLines(QPainter& painter) const;
    void dragTo(QPointF cursor, Qt::KeyboardModifiers modifiers);
    /// Everything on the way of the pointer from where it was.
    void strokeTo(QPointF cursor, Qt::KeyboardModifiers modifiers);
    void endStroke(StrokeStep how);
    void letGo(bool givenUp = false);
    void setGrip(Grip grip, QPointF cursor);
    void glide();
    void hoverAt(QPointF cursor);
    /// Lights up what the drag would fall onto; whether there is anything.
    bool dragOver(QDropEvent& event);
    void refreshHover();
    void hoverOn(const std::optional<PickHit>& hit);
    void setHovered(std::optional<SurfaceRef> surface);
    std::optional<MeasurePoint> measureAt(QPointF cursor, ScenePicker::Patience patience) const;
    void measureFrom(QPointF cursor);
    void giveUpMeasure();
    /// Points on what is not there any more, or has another shape, are taken away.
    void weedMeasure();
    void drawMeasured(QPainter& painter, const ViewPane& pane) const;
    /// What lies over a pane, in its own pixels.
    QRegion coveredIn(const ViewPane& pane) const { return covered.translated(-pane.place.topLeft()); }
    void showCursor(QPointF cursor);
    void zoomAt(QPointF cursor, double notches);
    void goalMoved();
    bool handKey(int key, QPointF cursor);
    bool cameraKey(int key);
    bool nudgeKey(int key, double scale);

    SceneView& view;
    ViewStage stage;
    OcclusionLayer occlusion;
    GroundLayer ground; ///< drawn before all else that one looks through
    ModelLayer model;
    BoundaryLines boundaries;
    FaceLayer faces, brushed;
    PaintLayer paint;
    MarkLayer marks;
    ArrangeGizmo arranging;
    MappingGizmo mapping;
    JointGizmo joint;
    PathGizmo path;
    SectionGizmo sectionHandles;
    /// In the order they are taken.
    std::array<ViewHandles*, 5> handles{&arranging, &mapping, &joint, &path, &sectionHandles};
    ViewHandles* taken = nullptr; ///< by the drag Handles
    bool handlesDrawn = true;
    std::optional<Arrangement> arranged;     ///< of the drag
    std::vector<MeasurePoint> measure;       ///< at most three
    std::optional<MeasurePoint> measureNext; ///< where the next click would put one
    std::optional<MassMark> mass;
    std::vector<ColliderMark> colliders;
    TouchOverlay overlay;
    struct Beside {
        HandMark mark;
        TouchState touch;
        std::unique_ptr<TouchOverlay> overlay;
    };
    struct Loupe {
        Loupe(GlWindow& window, ViewStage& stage);

        ContactLoupe picture;
        QTimer due; ///< the next picture
        std::chrono::milliseconds pause{0};
        QElapsedTimer lastTouched, drawn;
        bool open = false;
    };
    std::unique_ptr<Loupe> loupe; ///< null: it is not wanted
    LoupeLook loupeLook;
    HandMark mark;              ///< of the touch
    std::vector<Beside> beside; ///< the other hands
    FeltView felt;
    std::shared_ptr<const World> world; ///< that the bodies below are of
    BodyPlaces bodies;
    ScenePicker picker;
    std::size_t triangles = 0; ///< of the scene
    ViewPanes panes;
    Qt::Orientations ledLines; ///< by the drag Lines
    std::size_t flying = 0;    ///< the pane of the flight
    ViewCamera flownFrom, flownTo;
    CameraManners manners;
    QVariantAnimation flight;
    HandTool hand;
    LaggingCursor lagging;

    std::optional<TouchState> touch;
    QString touchedName;
    double proxyRadius = kProxyRadius.initial, touchScale = 1;
    bool overlayVisible = true;
    bool dark = true;
    int foot = 0;    ///< logical pixels
    QRegion covered; ///< by what lies over the view, likewise
    std::vector<SurfaceRef> selection;
    std::optional<SurfaceRef> hovered;
    std::optional<PickHit> brushAt; ///< where the tool Paint shows its ring
    BrushRing brush;
    ObjectId facesOf = 0, brushedOf = 0;   ///< whose triangles are selected, and gone over
    std::optional<RegionShape> regionNext; ///< what the next drag draws
    QPolygonF lasso;                       ///< where the drag went that draws it
    std::optional<double> selectBrush;     ///< its radius, logical pixels
    std::optional<QPointF> pointer;        ///< in all of the view, while it is over it
    QStringList dropTypes;

    ViewTool tool = ViewTool::Touch;
    ViewDrag drag = ViewDrag::None;
    QPointF pressedAt, cursorAt;
    bool moved = false;
    bool menuNext = false; ///< the right button is down, and has given nothing up
    std::vector<std::pair<ObjectId, ShadowCaster>> casters; ///< of the scene
    QTimer glideTimer, meshTimer, shadowTimer;
    QElapsedTimer glideClock, fadeClock;
};

} // namespace tactum
