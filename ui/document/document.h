// The open scene as the window sees it: values, history, file, selection, and the one way to edit.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "core/files/journal.h"
#include "core/files/load_scene.h"
#include "core/scene/compose.h"
#include "core/scene/scene.h"
#include "core/scene/selection_sets.h"
#include "core/scene/surface_ref.h"
#include "ui/base/background_job.h"
#include "ui/document/selection.h"
#include "ui/document/taken_as.h"

namespace tactum {

/// What an edit, an undo or a click has changed.
struct SceneChange {
    enum class What {
        Everything, ///< another scene
        Objects,    ///< objects came, went, appeared, disappeared or got another mesh
        Surfaces,   ///< surfaces appeared or disappeared, or triangles went to others
        Names,      ///< or locks, or how hands reach: nothing that is compiled or drawn
        Material,   ///< of `surface`
        Shading,    ///< of `surface`: its normals may have to be computed
        Sides,      ///< of `surface`
        Layers,     ///< of `surface`: its haptic texture
        ProxyRadius,
        Bodies,    ///< masses, joints, what moves with what: nothing that is drawn
        Selection, ///< not a part of the scene, and not undoable
    };
    What what = What::Everything;
    SurfaceRef surface{}; ///< only for Material, Shading, Sides and Layers; the first of several

    /// Whether a World compiled before has other shapes than one compiled now.
    bool touchesShape() const;
    /// Whether to compile it takes long enough for a worker.
    bool takesTime() const { return what == What::Shading || what == What::Bodies || touchesShape(); }
    /// Whether the loops notice it at all.
    bool touchesFeel() const {
        return what == What::Material || what == What::Sides || what == What::Layers || takesTime();
    }
    bool operator==(const SceneChange&) const = default;
};

/// Everything that is felt of a surface, to be given to others; `soup` is what its painted values belong to.
struct Feel {
    Surface surface;
    std::shared_ptr<const TriangleSoup> soup;
};

/// The object with another form of its mesh. What is painted, and its selection sets, go along. Thread: any
/// but real time.
SceneObject withGeometry(SceneObject object, std::shared_ptr<const TriangleSoup> geometry);

/// A file as it was when it was last read or written.
struct FileStamp {
    std::filesystem::path path;
    std::filesystem::file_time_type written{};
    std::uintmax_t bytes = 0;

    FileStamp() = default;
    explicit FileStamp(const std::filesystem::path& file);
    bool operator==(const FileStamp&) const = default;
};

/// What an update of the geometry has given.
struct GeometryUpdate {
    std::filesystem::path file;
    bool changed = true;                    ///< else these are the shapes that were there, in their unit
    std::size_t surfaces = 0, withFeel = 0; ///< of the new geometry, and how many have got one
    std::size_t back = 0;                   ///< with the feel that they had before they were gone
    std::size_t surfacesBefore = 0, surfacesLost = 0;
    std::size_t layersLost = 0, bodiesLost = 0;
    std::optional<FileAxes> axesBefore, axes; ///< where the unit is another one, so that the size fits
    double grown = 1;              ///< how many times as large as before it is by the unit of before
    std::vector<Finding> findings; ///< what found no partner, what is lost, what the reader found
};

/// A model that is to come into the scene.
struct FileToAdd {
    std::filesystem::path file;
    AxesChoice choice; ///< of what it leaves open
};

/// What has come into the scene.
struct SceneAddition {
    std::vector<std::filesystem::path> files; ///< where it is from; none: it was made here
    std::vector<ObjectId> objects;
    /// m across, of files that were scaled to fit a hand.
    std::vector<std::pair<std::filesystem::path, double>> scaled;
    std::vector<std::string> refused; ///< a line for each file that could not be read
};

/// Edits of one gesture (a drag, a run of the wheel) become one step of the history. 0 is no gesture.
using Gesture = int;
Gesture newGesture();

/// Thread: ui. Whoever shows the scene listens to changed(); whoever edits it calls a setter here. Setters
/// ignore references to what does not exist and values that change nothing.
class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);

    const Scene& scene() const { return scene_; }
    bool empty() const { return scene_.objects.empty(); }
    /// Whether there is a scene, be it an empty one.
    bool isOpen() const { return scenes_ > 0; }
    /// File of the scene; empty before the first open(), and of a new scene before the first save().
    const std::filesystem::path& path() const { return file_.path; }
    /// The name of that file, or what a new scene is called.
    QString title() const;
    const FileStamp& stamp() const { return file_; }
    /// Where the geometry is from: a file of another program stays that when the scene gets a file of its
    /// own. Empty for a scene at a server.
    const FileStamp& source() const { return source_.file; }
    /// As what the source was taken, where it leaves that open and takeOtherwise() loses nothing: just
    /// opened, with no step done or undone since, or just updated from or added. Else nullptr.
    const TakenAs* takenAs() const;
    /// The file that this is about, and how far what is from it reaches, m.
    std::filesystem::path takenFile() const;
    double takenAcross() const;
    /// What the reader had to say about the file, of objects that are still there, by their present names.
    std::vector<Finding> findings() const;
    QUndoStack& history() { return history_; }

    /// A drag that may be given up: the edits of the gesture that it gives back count at once, but are no
    /// step of the history before keepTrial(). Any other edit keeps them, and undo gives them up.
    Gesture beginTrial();
    /// Of a gesture that is no trial any more they do nothing.
    void keepTrial(Gesture gesture);
    /// The scene, and what can be undone and redone, are as they were when it began.
    void giveUpTrial(Gesture gesture);
    void endTrial(Gesture gesture, bool givenUp) { givenUp ? giveUpTrial(gesture) : keepTrial(gesture); }

    /// nullptr for a reference to nothing.
    const Surface* surface(SurfaceRef ref) const;
    /// The active one of the selected surfaces: the last that was chosen.
    std::optional<SurfaceRef> selection() const;
    const SurfaceRefs& selected() const { return selected_; }
    /// Those with a selected surface, in the order of the scene.
    std::vector<ObjectId> selectedObjects() const;
    /// All surfaces of these objects.
    void selectObjects(const std::vector<ObjectId>& objects, SelectMode mode = SelectMode::Replace);
    void select(const SurfaceRefs& refs, SelectMode mode = SelectMode::Replace);
    const FaceSelection& selectedFaces() const { return faces_; }
    void selectFaces(FaceSelection faces, SelectMode mode = SelectMode::Replace);
    /// What is selected as triangles: those of the one object, else all of the selected surfaces.
    SceneTriangles selectedTriangles() const;
    /// Whole surfaces become selected as such, else triangles: of several objects those of the active one,
    /// or where it has none those of the one that has most. How many objects were left out.
    std::size_t selectTriangles(const SceneTriangles& triangles);

    /// The one way to change surfaces: `change` is applied to each, in one step of the history. Locked
    /// surfaces stay as they are. `text` names the step: "%1" in it becomes the surface's name, or their
    /// number.
    void editSurfaces(const SurfaceRefs& refs, SceneChange::What what, const QString& text,
                      const std::function<void(Surface&)>& change, Gesture gesture = 0);
    void setMaterialValue(const SurfaceRefs& refs, const MaterialField& field, double value,
                          Gesture gesture = 0);
    void setShading(const SurfaceRefs& refs, const Shading& shading, Gesture gesture = 0);
    void setSides(const SurfaceRefs& refs, Sides sides);
    /// Everything that is felt of `like`: material, shading, sides and layers. What is painted comes along
    /// where the mesh is the same, else its layers are left out.
    void setFeel(const SurfaceRefs& refs, const Feel& like, const QString& text);
    void setSurfacesVisible(const SurfaceRefs& refs, bool visible);
    void setLocked(const SurfaceRefs& refs, bool locked);
    /// Shows these surfaces and hides all others.
    void isolate(const SurfaceRefs& refs);
    void setProxyRadius(double metres, Gesture gesture = 0);
    void setReach(Reach reach, Gesture gesture = 0);
    void renameObject(ObjectId id, const QString& name);
    void renameSurface(SurfaceRef ref, const QString& name);
    void setVisible(ObjectId id, bool visible);
    void showAll();
    void removeObject(ObjectId id) { removeObjects({id}); }
    /// With what goes with them, in one step. What went.
    Removed removeObjects(const std::vector<ObjectId>& objects);
    /// Copies of objects and of all that is arranged with them, beside them and selected, in one step.
    void duplicate(const std::vector<ObjectId>& objects);
    /// Anything of the scene, in one step of the history.
    void editScene(const QString& text, SceneChange::What what, const std::function<void(Scene&)>& change,
                   Gesture gesture = 0);
    /// The order of the objects, and which groups they are in, by the functions of core/scene/order.h and
    /// groups.h, in one step of the history.
    void editOrder(const QString& text, const std::function<void(Scene&)>& change);
    void group(const std::vector<ObjectId>& objects);
    /// Those that these objects are in.
    void ungroup(const std::vector<ObjectId>& objects);
    void renameGroup(const std::string& group, const QString& name);
    void setGroupVisible(const std::string& group, bool visible);
    /// Bodies and joints, by the functions of core/scene/bodies.h, in one step of the history.
    void editBodies(const QString& text, const std::function<void(Scene&)>& change, Gesture gesture = 0);
    /// Another state of the scene in place of this one, as one step of the history.
    void replaceScene(const QString& text, const Scene& scene);
    /// Scales the whole scene about its centre, which comes to the origin.
    void scaleScene(double factor);

    /// The selected triangles become a surface of their own, which is then selected. Ends with editEnded().
    void splitSelection();
    /// The selected surfaces of the active one's object become one, which feels like the active one. Ends
    /// with editEnded().
    void mergeSelected();
    /// Another form of an object, found by its id, as one step of the history.
    void setObject(const SceneObject& object, const QString& text);
    /// Works out another form of an object on a worker and makes it one step of the history, then calls
    /// `then`. Nothing is changed when the object was edited meanwhile. Ends with editEnded().
    using ObjectWork = std::function<Result<SceneObject>(const SceneObject&, const Progress&)>;
    void changeObject(ObjectId id, const QString& text, const ObjectWork& work,
                      const std::function<void()>& then = {});
    void cancelEdit() { editing_.cancel(); }
    bool editing() const { return editing_.running(); }

    /// Begins with a scene that has no file yet, as the first of a new history. Ends with opened().
    void begin(Scene scene);
    /// Puts a scene beside what is there, selected, in one step. Ends with added().
    void add(Scene scene);
    /// The same of files, read on a worker and taken as by open(): one that cannot be read is left out. Ends
    /// with added(), or with openFailed() where there is none.
    void add(const std::vector<FileToAdd>& files) { startAdding(files, std::nullopt); }

    /// Reads a file on a worker. Ends with opened() or openFailed(); a failure leaves the scene untouched.
    /// A mesh of another program that does not fit a hand is scaled as the first, undoable step of the new
    /// history. A sample is a beginning: what is made of it gets a file of its own.
    void open(const std::filesystem::path& file, bool isSample = false, const AxesChoice& choice = {});
    /// The same file anew, taken otherwise. Only while nothing was edited, for it begins a new history; an
    /// edit that is made meanwhile is kept, and the file left.
    void reopen(const AxesChoice& choice);
    /// The shapes of a file with the feel of this scene, by names (carryFeel()), where the objects have been
    /// put: one step of the history. On a worker; ends with geometryUpdated() and editEnded(). Of a file of
    /// the source's format the axes are the source's, unless by another unit alone it is about as large as
    /// before. What came in besides stays as it is. Feel that finds no surface waits for the next update,
    /// until another scene is opened.
    void updateGeometry(const std::filesystem::path& file, const AxesChoice& choice = {}) {
        startUpdate(file, choice, false);
    }
    /// What takenAs() is about, by another choice: opened or added anew, or one more step that updates from
    /// it.
    void takeOtherwise(const AxesChoice& choice);
    void cancelOpen() { job_.cancel(); }
    /// Goes on with a scene that was not saved: under the name of its file, with unsaved changes. `own`:
    /// whether hasOwnFile() held. Ends with opened().
    void adoptRecovered(LoadedScene loaded, const FileStamp& file, bool own,
                        const SceneHistory& history = {});
    /// What can be undone and redone, at most so many steps next to the present. The scenes share meshes and
    /// images with this one.
    SceneHistory stepsAround(int most) const;

    /// Goes on with a scene that is kept elsewhere, at a haptic server: nothing of it is unsaved. `file`:
    /// where to offer to save it. Ends with opened().
    void adoptShared(Scene scene, const std::filesystem::path& file);

    /// Writes the scene as it is now, on a worker, and makes `file` its file. Ends with saved() or
    /// saveFailed(); edits, and opening another scene, can go on meanwhile. One save at a time: the others
    /// wait for their turn.
    void save(const std::filesystem::path& file);
    /// Writes a bundle of the scene for others; the scene's own file stays what it is. Ends with exported()
    /// or saveFailed().
    void exportBundle(const std::filesystem::path& file);
    void cancelSave() { saving_.cancel(); }
    /// Whether an edit is not in the file yet.
    bool modified() const { return trial_ || !history_.isClean(); }
    /// Whether the file is one that save() wrote, so that it can be written over.
    bool hasOwnFile() const;
    /// Whether another program has written the file since it was read or saved.
    bool changedOutside() const;
    bool opening() const { return job_.running(); }
    /// Whether what is being opened comes into the scene that is there.
    bool adding() const { return adding_ && job_.running(); }
    bool saving() const { return saving_.running(); }

signals:
    void changed(const tactum::SceneChange& change);
    void opened();
    /// One line for the person.
    void openFailed(const QString& sentence);
    void openProgressed(double fraction, double secondsLeft);
    void saved(const QString& file);
    void exported(const QString& file);
    /// One line for the person; `file` is as it was.
    void saveFailed(const QString& sentence);
    void saveProgressed(double fraction, double secondsLeft);
    void editProgressed(double fraction, double secondsLeft);
    /// One line for the person where the edit failed, else empty.
    void editEnded(const QString& sentence);
    void geometryUpdated(const tactum::GeometryUpdate& update);
    void added(const tactum::SceneAddition& addition);
    /// Something done on the person's behalf, and how to take it back.
    void noted(const QString& sentence);

private:
    /// Finds the value that an edit exchanges; nullptr when it is gone.
    template <class T> using Place = std::function<T*(Scene&)>;
    class Step;
    struct Already;
    template <class T> class Exchange;
    class NewGeometry;
    class Arrival;
    template <class T>
    void edit(const QString& text, std::vector<Place<T>> places, std::vector<T> values, SceneChange change,
              Gesture gesture = 0);
    template <class T>
    void edit(const QString& text, Place<T> place, T value, SceneChange change, Gesture gesture = 0);
    void changeObjectNow(ObjectId id, const QString& text, const std::function<void(SceneObject&)>& change);
    void editObjects(const QString& text, SceneChange change, const std::function<void(SceneObject&)>& each);
    QString namesOf(const SurfaceRefs& refs) const;
    /// A finding of the reader, and the object that it is about; 0 for the scene.
    struct FileFinding {
        Finding finding;
        ObjectId object = 0;
    };

    /// Where the geometry is from.
    struct Source {
        FileStamp file;
        FileAxes axes;           ///< as which it was taken
        std::optional<Scene> as; ///< as the file has it, in metres with y up; nothing where that is not known
        std::optional<TakenAs> taken{};  ///< where another choice is offered
        std::vector<SceneObject> gone{}; ///< with surfaces whose feel waits for the next update
    };
    struct Updated {
        Scene scene;
        Source source;
        GeometryUpdate told;
    };
    /// A file whose objects have just come, where another choice is offered.
    struct TakenFile {
        std::filesystem::path file;
        TakenAs as;
        std::vector<ObjectId> objects;
    };
    struct ReadPart;
    struct ReadParts;
    static ReadParts readParts(const std::vector<FileToAdd>& files, const Progress& progress);
    void startAdding(const std::vector<FileToAdd>& files, std::optional<int> inPlaceOf);
    void bringIn(std::vector<ReadPart> parts, SceneAddition told);
    void arrive(const QString& text, Scene next, std::optional<TakenFile> taken);
    QString namesOf(const std::vector<ObjectId>& objects) const;
    const TakenFile* justAdded() const;
    struct NewShapes;
    static Result<NewShapes> readShapes(const Source& source, const std::filesystem::path& file,
                                        const AxesChoice& choice, bool chosen, const Progress& progress);
    static Result<Updated> updated(const Scene& whole, const Source& source, NewShapes shapes);
    void startUpdate(const std::filesystem::path& file, const AxesChoice& choice, bool chosen);
    bool justUpdated() const;
    void openAs(const std::filesystem::path& file, bool isSample, const AxesChoice& choice, bool anew);
    void takeGeometry(Updated updated);

    using Writer = Result<void>(const Scene&, const std::filesystem::path&, const Progress&);
    void write(Writer* writer, const std::filesystem::path& file, std::function<void()> done);
    void adopt(LoadedScene loaded, const FileStamp& file);
    /// Scaled to a hand's reach where it is out of it.
    static Scene fitted(Scene scene);
    void fit(const Scene& fitted);
    void announce(const SceneChange& change);
    void setSelection(SurfaceRefs refs);
    void keepSelection(const SceneChange& change);
    void rememberNames();
    SurfaceRef named(SurfaceRef ref, const std::string& name) const;

    Scene scene_;
    FileStamp file_;
    Source source_;
    bool own_ = false;    ///< the file was written by this program, and is no sample
    int scenes_ = 0;      ///< how many have been opened
    ObjectId lastId_ = 0; ///< no other object gets one that was in use
    bool adding_ = false; ///< what job_ reads is to be added
    std::vector<FileFinding> findings_;
    SurfaceRefs selected_;
    std::vector<std::string> selectedNames_; ///< theirs, when they were selected or renamed
    SurfaceRefs lost_; ///< what was selected when it went: selected again if it comes back
    std::vector<std::string> lostNames_;
    FaceSelection faces_;
    QUndoStack history_;
    Gesture trying_ = 0;                  ///< the gesture of the trial; 0: there is none
    std::unique_ptr<QUndoCommand> trial_; ///< its edits; null: they change nothing
    BackgroundJob job_, saving_, editing_;
    std::deque<std::function<void()>> nextSaves_; ///< asked for while another one was under way
};

} // namespace tactum
