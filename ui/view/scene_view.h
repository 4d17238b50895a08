// The 3-D view: the model, the finger and the proxy on it, and the mouse that leads the finger.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <QImage>
#include <QPolygonF>
#include <QRectF>
#include <QStringList>

#include "core/geometry/triangle_set.h"
#include "core/haptics/world.h"
#include "core/runtime/channels.h"
#include "core/scene/scene.h"
#include "core/scene/surface_ref.h"
#include "ui/view/arrange_gizmo.h"
#include "ui/view/camera_manners.h"
#include "ui/view/collider_marks.h"
#include "ui/view/felt_options.h"
#include "ui/view/joint_gizmo.h"
#include "ui/view/mapping_gizmo.h"
#include "ui/view/mass_mark.h"
#include "ui/view/measure.h"
#include "ui/view/painted_picture.h"
#include "ui/view/path_gizmo.h"
#include "ui/view/scene_picker.h"
#include "ui/view/section_gizmo.h"
#include "ui/view/view_split.h"
#include "ui/view/vtk_widget.h"

class QMimeData;
class QPainter;

namespace tactum {

/// What the left mouse button does on the model: touch it with the finger, select its surfaces, paint,
/// select objects and arrange them by their handles, or measure between places.
enum class ViewTool { Touch, Select, Paint, Arrange, Measure };

/// What a stroke of the brush does next: the pointer comes down, goes on over the model, leaves it, goes up,
/// or the stroke is given up.
enum class StrokeStep { Begin, Move, Lift, End, Cancel };

/// The ring that the brush shows on the model.
struct BrushRing {
    double radius = 0; ///< m
    double core = 0;   ///< part of the radius where it counts whole
};

/// What the next drag draws over the view.
enum class RegionShape { Box, Lasso };

/// Looking along -Z, -X, -Y, or from the corner between them. Y is up.
enum class StandardView { Front, Right, Top, Isometric };

/// How the loupe is drawn.
struct LoupeLook {
    int side = 200;   ///< of its square, logical pixels
    double times = 5; ///< as large as in the view
};

/// Whose a touch is.
struct HandMark {
    std::size_t number = 0; ///< of the hand: its colours
    QString name;           ///< written at the finger where there are several
    bool led = true;        ///< the mouse leads it
};

/// A hand beside the one that setHaptics() tells of.
struct HandBeside {
    HandMark mark;
    TouchTelemetry touch;
    ServoTelemetry servo;
    double forceLimit = 0; ///< N
    bool armed = false;
};

/// Camera: left drag on empty space or Alt + left drag orbits, other buttons and the wheel as CameraManners
/// say; Home fits, 1, 3 and 7 of the number pad are the standard views.
/// Touch tool: a press on the model brings the finger there and into the surface a little, and dragging
/// strokes it along; a press on the finger itself drags it in the camera's plane. Wheel or Ctrl + vertical
/// drag move it along the view; G lets it follow the mouse until a click or Esc. Arrow keys and Page Up and
/// Page Down nudge it.
/// Arrange tool: G, R and S take hold of the selected objects, which follow the mouse until a click or Enter;
/// X, Y and Z keep them to an axis, Ctrl snaps, Shift is fine; Esc and the right button give it up.
/// Measure tool: two clicks on the model are a distance, a third makes an angle at the second, the next
/// begins anew; Esc takes the points away. Thread: ui.
class SceneView : public VtkWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// Shows a scene. Objects whose geometry is still the same keep what was made of it. The first scene
    /// with an extent is fitted into the view; later ones leave the camera alone.
    void setScene(const Scene& scene);
    /// Colours and gloss of a scene that has the shapes of the last one.
    void setLooks(const Scene& scene);
    /// Which bodies move, of a scene that has the shapes of the last one: they darken nothing, and cast their
    /// shadow when they rest.
    void setCasters(const Scene& scene);
    /// Outlines surfaces.
    void setSelection(std::vector<SurfaceRef> surfaces);
    /// Lays the selection's colour over triangles of an object, in the numbers of its geometry.
    void setSelectedFaces(ObjectId object, std::vector<Index> faces);
    /// The same over what a stroke has gone over; small sets cost little, however large the model is.
    void setBrushedFaces(ObjectId object, const std::vector<Index>& faces);
    /// The next drag with the left button draws a box, or a line round something; Esc gives it up.
    void beginRegion(RegionShape shape);
    /// With the select tool the left button brushes, with a ring of this radius in logical pixels; nothing:
    /// it does not.
    void setSelectBrush(std::optional<double> radius);
    void setTool(ViewTool tool);
    /// Asked of a double click on an object with any tool but touch, before it is taken for a second click.
    void setDoubleClick(std::function<bool(const PickHit&)> taken) { doubleClick_ = std::move(taken); }
    /// Shown at the pointer while the tool is Paint.
    void setBrush(const BrushRing& ring);
    /// Lays what is painted over the model.
    void setPainted(const PaintedPicture& picture);
    /// What the loops reported, once a frame: bodies that move by themselves are shown at its time, while
    /// picking sees them at the time 0. forceLimit in N, > 0.
    void setHaptics(const ProxyTelemetry& proxy, const ServoTelemetry& servo, double forceLimit, bool armed);
    /// Before setHaptics(): whose its touch is, and the others, none by default. They have finger, proxy,
    /// spring, force and contacts; the trail and the cone are of the one.
    void setHands(const HandMark& mark, const std::vector<HandBeside>& beside);
    void setProxyRadius(double metres);

    /// Divides it into panes, which share all that is shown; what is said here of the camera is that of the
    /// active one, and pixels of what is done with the mouse begin at its upper left corner.
    void setSplit(ViewSplit split);
    ViewSplit split() const;
    /// Parts of the width and the height that are left of and above what divides the panes.
    void setDivision(QPointF parts);
    QPointF division() const;
    /// Where the panes are, from left to right and from above; one that fills the view while it is whole.
    std::vector<QRect> panes() const;
    const ViewCamera& cameraOf(std::size_t pane) const;
    /// In that order.
    std::size_t activePane() const;
    /// Whether that is the person's own view, not a plan of it.
    bool ownIsActive() const;
    /// Draws the active one without vanishing points, or with them; the own view begins so with every scene.
    void setParallel(bool parallel);

    /// Shows the whole scene from where the camera looks now.
    void fit();
    /// The same in every pane.
    void fitAll();
    /// Every pane looks from where it did at first, at the whole scene.
    void planViews();
    void showStandardView(StandardView view);
    /// Moves the camera, within a moment, until a ball fills a good part of the view. `from_W`: where to look
    /// from, a direction of any length; zero: from where it looks now. World frame, metre.
    void flyTo(const Vec3& centre_W, double radius, const Vec3& from_W = Vec3::Zero());
    /// Moves the camera, within a moment, to look as another one does, in its projection at once.
    void flyTo(const ViewCamera& camera);
    /// Draws the edges of some triangles of a body in the colour of faults, also through what is before them.
    /// X_WB; no triangles: nothing.
    void setMarked(std::shared_ptr<const TriangleSoup> soup, const TriangleSet& triangles, const Pose& pose);
    bool hasMarked() const;
    /// The frame of a texture's mapping, with handles to drag; nothing: none. World frame, at the time 0.
    void setMapping(const std::optional<MappingFrame>& frame);
    const MappingGizmo& mapping() const;
    /// The free axis of a joint, with handles to drag; nothing: none. World frame, at the time 0.
    void setJoint(const std::optional<JointMark>& mark);
    const JointGizmo& joint() const;
    /// The curve of a path joint, with points to drag; nothing: none. World frame, at the time 0.
    void setPath(const std::optional<PathMark>& mark);
    const PathGizmo& path() const;
    /// The handles that move, turn and scale: X_W of their pivot and axes; nothing: none.
    void setArranging(const std::optional<Pose>& frame);
    const ArrangeGizmo& arranging() const;
    /// Cuts the model open, with handles to drag; nothing: it is whole. Finger, proxy, handles and the ground
    /// are never cut. World frame, at any time.
    void setSection(const std::optional<SectionPlane>& plane);
    const std::optional<SectionPlane>& section() const;
    const SectionGizmo& sectionHandles() const;
    /// Where the points of the measure are now, at most three. World frame, metre.
    std::vector<Vec3> measured() const;
    void clearMeasure();
    /// Where its numbers are written, in logical pixels.
    std::vector<QRectF> measuredBoxes() const;
    /// Other widgets lie over these parts of the view, in logical pixels: numbers are written beside them,
    /// and the axes stand below what covers their corner.
    void setCovered(const QRegion& covered);
    /// The box of the scene at the time 0, world frame; empty: nothing is in it.
    Bounds bounds() const;
    /// Ends the drag of any handle where it is.
    void dropHandles();
    /// Where an object is shown, X_WB; nothing for one that is hidden or none.
    std::optional<Pose> placeOf(ObjectId object) const;
    /// How a body of the shown World moves; nothing for what stands still.
    std::optional<BodyReading> readingOf(const ProxyTelemetry& proxy, BodyId body);
    /// Where the mass of a body is; nothing: none.
    void setMass(const std::optional<MassMark>& mark);
    const std::optional<MassMark>& mass() const;
    /// As what bodies meet each other; none: nothing is drawn.
    void setColliders(std::vector<ColliderMark> marks);
    const std::vector<ColliderMark>& colliders() const;
    /// The surface under a place of the view, in logical pixels, which is lit up as under the mouse; for what
    /// is dragged over the view from elsewhere.
    std::optional<PickHit> light(QPointF place);
    void endLight();
    const ViewCamera& camera() const;
    /// Turns about the focus, rad: to the right and up round the model; and comes nearer by a factor < 1.
    void moveCamera(double yaw, double pitch, double nearer = 1);
    void setManners(const CameraManners& manners);
    /// Proxy, finger, spring, force, contacts and their words.
    void setOverlayVisible(bool visible);
    /// Proxy, finger, spring and contacts so many times as large; the force's arrow keeps its length.
    void setTouchScale(double scale);
    void setTheme(bool dark);
    /// How many logical pixels of the lower edge something lies over, from side to side: legends are above.
    void setFoot(int pixels);

    /// What is shown of how things feel; it is that of the World given here, which belongs to the scene.
    void setFelt(const FeltOptions& options);
    const FeltOptions& felt() const;
    /// How many edges between surfaces are drawn as lines.
    std::size_t boundaryEdgesShown() const;
    /// Between two lines of the ground's grid, m; 0: there is none.
    double gridStep() const;
    void setWorld(std::shared_ptr<const World> world);
    /// Where the proxy was at each tick since the last call; `touch` is of the last one.
    void addTrail(std::span<const TracePoint> points, const HapticOutput& touch);
    void clearTrail();
    /// Whether something of it, or the ground, is still being made on a worker.
    bool makesFelt() const;
    /// Whether meshes of the model are.
    bool makesMeshes() const;
    /// How many actors there are, seen or not: a count that grows with switching on and off is a leak.
    int actorCount() const;
    /// How often the model was drawn: not at all while only the touch changes.
    int modelPictures() const;
    /// How long pictures may take where the processor draws; what is beyond it is drawn less well.
    void setPictureLimits(const PictureLimits& limits);
    /// Whether the last picture was of coarser meshes.
    bool drawsCoarse() const;
    /// Draws the model anew although nothing of it has changed, to compare and to measure.
    void forgetPicture();

    /// A place beside the model where a finger is seen: well inside the view, nothing before it. At most
    /// `reach` from the origin; 0: anywhere. Nothing where there is no model. World frame, metre.
    std::optional<Vec3> placeBeside(double reach = 0) const;
    /// The name of the surface that is touched, which is written beside the proxy; empty: none is.
    void setTouched(const QString& name);

    /// Where the mouse leads the finger. World frame, metre.
    Vec3 handGoal() const;
    /// Puts the goal there without telling anybody; ends a glide that is under way.
    void setHandGoal(const Vec3& p_W);
    /// Lets go of the finger at once, whatever the mouse does: it is lifted off.
    void endTouch();

    /// The visible surface at a place of the view, in logical pixels.
    std::optional<SurfaceRef> surfaceAt(QPointF at) const;
    /// Data of these MIME types can be dropped onto a surface, which is lit up meanwhile.
    void setDropTypes(const QStringList& types);

    /// Of the picture that loupeDrawn() gives away while FeltOptions::loupe is on.
    void setLoupe(const LoupeLook& look);

    /// What is shown now, in device pixels, drawn as well as this machine can.
    QImage grabPicture();
    /// The same to be kept: without what the tools are dragged by, and which pane is active.
    QImage grabWithoutHandles();

signals:
    /// The surface under the cursor changed.
    void surfaceHovered(std::optional<tactum::SurfaceRef> surface);
    /// A click chose a place on a surface, or nothing.
    void picked(std::optional<tactum::PickHit> hit, Qt::KeyboardModifiers modifiers);
    /// The right button was pressed and let go at a place, or the key for menus; `at`: of the screen.
    void menuAsked(std::optional<tactum::PickHit> hit, const QPoint& at);
    /// Whether the active pane is drawn without vanishing points may be another answer now: another one is
    /// active, or it was changed.
    void projectionChanged();
    /// The person has led the lines between the panes elsewhere.
    void divided();
    /// A box, or a closed line, was drawn, in logical pixels.
    void boxDrawn(QRectF box, Qt::KeyboardModifiers modifiers);
    void lassoDrawn(const QPolygonF& line, Qt::KeyboardModifiers modifiers);
    /// The select tool's brush came from one place of the view to another, in logical pixels; `step` is never
    /// Lift. Esc without a stroke asks for its end.
    void selectBrushed(tactum::StrokeStep step, QPointF from, QPointF to, Qt::KeyboardModifiers modifiers);
    void selectBrushLeft();
    /// The tool Paint: places on the way of the pointer, a few pixels apart. Without a place for Lift, End
    /// and Cancel.
    void stroked(tactum::StrokeStep step, const std::optional<tactum::PickHit>& hit,
                 Qt::KeyboardModifiers modifiers);
    /// A press, a drag, the wheel or a key moved the finger's goal. World frame, metre; it should be there
    /// in `time`, s.
    void handGoalMoved(tactum::Vec3 goal_W, double time);
    /// Something of the drop types was let go over a surface; `data` lives until the signal returns.
    void droppedOn(tactum::SurfaceRef surface, const QMimeData& data);
    /// The contact from nearby, again and again while something is touched, where it is in the view, and the
    /// name of the pane that it is seen from, empty while the view is whole; and nothing was for a moment.
    void loupeDrawn(const QImage& picture, QPointF contact, const QString& pane);
    void loupeLeft();
    /// The mouse took hold of the finger, or let it go.
    void handGrabbed(bool grabbed);
    /// The mouse took hold of a handle of the mapping; what it does to it follows until it lets go.
    void mappingGrabbed();
    void mappingDragged(const tactum::MappingFrame& frame);
    /// Likewise of the joint.
    void jointGrabbed();
    void jointDragged(const tactum::JointMark& mark);
    /// Likewise of the points of a path.
    void pathGrabbed();
    void pathDragged(const std::vector<tactum::Vec3>& points);
    /// Likewise of the handles that arrange; all of what the drag comes to, from where it began.
    void arrangeGrabbed();
    void arrangeDragged(const tactum::Arrangement& by);
    /// A handle of the section leads it there.
    void sectionDragged(const tactum::SectionPlane& plane);
    /// The drag of any handle has ended. Given up, nothing of it is to be left.
    void handlesLeft(bool givenUp);
    /// A point of the measure came or all of them went. `left`: Esc without any, the tool is to be left.
    void measureChanged(bool left);
    /// G, R or S without anything that could be arranged.
    void arrangeAsked();
    /// G with the select tool: the mapping is to be moved, or has been.
    void mappingAsked();

protected:
    bool event(QEvent* event) override;
    PictureQuality atRest() const override;
    std::vector<QRect> pictures() override;
    void prepareFrame() override;
    void preparePicture(std::size_t number) override;
    void paintOver() override;
    /// All that is painted over the pictures. Logical pixels.
    void drawOver(QPainter& painter) const;
    void rested() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void fadeOn();

    struct Impl;
    std::function<bool(const PickHit&)> doubleClick_ = [](const PickHit&) { return false; };
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
