#include "core/files/x3d/write_x3d.h"

#include <algorithm>
#include <cmath>

#include "core/base/realtime.h"
#include "core/files/unique_names.h"
#include "core/files/x3d/write_x3d_bodies.h"
#include "core/files/x3d/write_x3d_geometry.h"
#include "core/files/x3d/write_x3d_parts.h"
#include "core/files/x3d/write_x3d_surface.h"
#include "core/files/x3d/x3d_metadata.h"

namespace tactum {
namespace {

/// How far around the finger H3D looks for triangles at least. m
constexpr double kLookAround = 0.02;
/// A cubic becomes straight pieces of this length. s
constexpr double kCubicStep = 1e-3;
constexpr std::size_t kMaxCubicKeys = 1 << 16;

/// The keys of an interpolator: parts of the loop, and a value for each.
struct Keys {
    std::string times, values;

    void add(double part, const std::string& value) {
        if (!times.empty()) times += ' ', values += ", ";
        appendNumber(times, part);
        values += value;
    }
};

std::string text(const Vec3& v) {
    std::string list;
    for (int i = 0; i < 3; ++i) {
        if (i > 0) list += ' ';
        appendNumber(list, v[i]);
    }
    return list;
}
std::string text(const QuatCoefficients& q) {
    return axisAngle(Quat(q));
}

/// A step keeps its value up to the next key: two keys of one time. A cubic is sampled by the motion itself.
template <class Value, class At> Keys keysOf(const Track<Value>& track, double cycle, At&& at) {
    Keys keys;
    if (track.interpolation == Interpolation::CubicSpline) {
        const double length = track.times.back() - track.times.front();
        const auto pieces =
            std::clamp<std::size_t>(std::size_t(std::min(length / kCubicStep, 1e9)), 16, kMaxCubicKeys);
        for (std::size_t i = 0; i <= pieces; ++i) {
            const double t = track.times.front() + length * double(i) / double(pieces);
            keys.add(t / cycle, at(t));
        }
        return keys;
    }
    for (std::size_t i = 0; i < track.times.size(); ++i) {
        if (i > 0 && track.interpolation == Interpolation::Step)
            keys.add(track.times[i] / cycle, text(track.values[i - 1]));
        keys.add(track.times[i] / cycle, text(track.values[i]));
    }
    return keys;
}

class X3dWriter {
public:
    X3dWriter(const Scene& scene, const X3dNames& files, const Progress& progress)
        : scene_(scene), files_(files), progress_(progress) {
        for (const SceneObject& object : scene.objects)
            surfaces_ += object.surfaces.size();
        const std::vector<Loss> known = lossesOf(scene, ExportTarget::X3d);
        result_.losses.insert(result_.losses.begin(), known.begin(), known.end());
    }

    X3dExport write() {
        {
            XmlElement root(result_.scene, "X3D");
            root.set("profile", "Full").set("version", "3.2");
            writeHead(root);
            XmlElement scene(root, "Scene");
            writeSettings(scene);
            for (const SceneObject& object : scene_.objects)
                writeObject(scene, object);
            bodies_.write(scene);
        }
        writeDevice();
        return std::move(result_);
    }

private:
    void writeHead(XmlElement& root) const {
        XmlElement head(root, "head");
        XmlElement(head, "meta").set("name", "generator").set("content", "Tactum");
        XmlElement(head, "meta")
            .set("name", "description")
            .set("content",
                 "A haptic scene for H3DAPI; lengths in metres, y up. Start it with " + files_.device + ".");
    }

    void writeSettings(XmlElement& scene) const {
        XmlElement settings(scene, "GlobalSettings");
        XmlElement(settings, "HapticsOptions")
            .set("touchableFace", "FRONT_AND_BACK")
            .set("maxDistance", std::max(kLookAround, 4 * proxyRadius_))
            .set("dynamicMode", "TRANSFORM_CHANGED");
        XmlElement(settings, "GeometryBoundTreeOptions").set("boundType", "SPHERE");
    }

    void writeObject(XmlElement& scene, const SceneObject& object) {
        const std::string name = names_.take(plainName(object.name));
        writeSwitched(scene, object.visible, [&](XmlElement& place) { writeCarried(place, object, name); });
        if (object.motion) writeMotion(scene, object, name);
    }

    /// A body that moves leads it from the body's origin, where it is put back from.
    void writeCarried(XmlElement& parent, const SceneObject& object, const std::string& name) {
        const std::optional<Vec3> origin = bodies_.originOf(object.body);
        if (!origin) return writePlaced(parent, object, name);
        const std::string carrier = names_.take(name + "-carried");
        bodies_.lead(object.body, carrier);
        XmlElement carried(parent, "Transform");
        carried.set("DEF", carrier).set("translation", *origin);
        XmlElement back(carried, "Transform");
        back.set("translation", Vec3(-*origin));
        writePlaced(back, object, name);
    }

    void writePlaced(XmlElement& parent, const SceneObject& object, const std::string& name) {
        XmlElement placed(parent, "Transform");
        placed.set("DEF", name)
            .set("translation", object.pose.translation)
            .setPlain("rotation", axisAngle(object.pose.rotation));
        writeName(placed, object.name);
        if (!object.motion) return writeShapes(placed, object, name);
        XmlElement moved(placed, "Transform");
        moved.set("DEF", moverOf(name));
        writeShapes(moved, object, name);
    }

    static void writeName(XmlElement& node, const std::string& name) {
        XmlElement set(node, "MetadataSet");
        set.set("containerField", "metadata").set("name", kX3dObjectSet);
        XmlElement(set, "MetadataString")
            .set("containerField", "value")
            .set("name", "name")
            .setStrings("value", {name});
    }

    void writeShapes(XmlElement& parent, const SceneObject& object, const std::string& name) {
        const std::vector<FacesByKind> faces = facesBySurface(object);
        for (Index i = 0; i < object.surfaces.size(); ++i)
            if (std::ranges::any_of(faces[i], [](auto& list) { return !list.empty(); }))
                writeSurfaceShapes(parent, object, i, faces[i],
                                   names_.take(name + "-" + plainName(object.surfaces[i].name)));
    }

    void writeSurfaceShapes(XmlElement& parent, const SceneObject& object, Index index,
                            const FacesByKind& faces, const std::string& name) {
        const Surface& surface = object.surfaces[index];
        const auto part = [&](double of) { return (double(written_) + of) / double(surfaces_); };
        const X3dSurface flat = x3dSurfaceOf(object, index, partOf(progress_, part(0), part(1)));
        ++written_;
        if (progress_.isCancelled()) return;
        for (const std::string& sentence : flat.lost)
            result_.losses.push_back({ExportTarget::X3d, object.name + " / " + surface.name, "layers",
                                      LossKind::Degraded, sentence});
        bool isFirst = true;
        for (const int corners : {3, 2, 1}) {
            const std::vector<Index>& list = faces[std::size_t(corners - 1)];
            if (list.empty()) continue;
            const auto writeShape = [&](XmlElement& place) {
                XmlElement shape(place, "Shape");
                if (isFirst) shape.set("DEF", name);
                writeAppearance(shape, surface, flat, name, corners);
                writeGeometry(shape, object, surface, corners, list, flat.canvas());
            };
            writeSwitched(parent, surface.visible, writeShape);
            isFirst = false;
        }
    }

    /// What is not visible is neither seen nor felt in H3D either.
    template <class Write> static void writeSwitched(XmlElement& parent, bool visible, Write&& write) {
        if (visible) return write(parent);
        XmlElement hidden(parent, "Switch");
        hidden.set("whichChoice", -1.0);
        write(hidden);
    }

    void writeAppearance(XmlElement& shape, const Surface& surface, const X3dSurface& flat,
                         const std::string& name, int corners) {
        XmlElement appearance(shape, "Appearance");
        XmlElement(appearance, "Material")
            .set(corners == 3 ? "diffuseColor" : "emissiveColor", surface.colour);
        if (surface.sides == Sides::None) // H3D feels what has a surface node
            return writeUnfeltSurface(appearance, surface);
        writeSurface(appearance, corners == 3 ? flat : withoutPictures(flat), surface,
                     {files_.maps + "/" + name, result_.images, progress_});
    }

    /// Lines and points have no texture coordinates.
    static X3dSurface withoutPictures(X3dSurface flat) {
        for (FlatPicture* picture :
             {&flat.height, &flat.stiffness, &flat.staticFriction, &flat.dynamicFriction})
            picture->image = nullptr;
        return flat;
    }

    void writeMotion(XmlElement& parent, const SceneObject& object, const std::string& name) {
        const Motion& motion = *object.motion;
        const auto lastOf = [](const std::vector<double>& times) {
            return times.empty() ? 0.0 : times.back();
        };
        const double last = std::max(lastOf(motion.translation.times), lastOf(motion.rotation.times));
        const double cycle = motion.duration > 0 ? motion.duration : last > 0 ? last : 1;
        const std::string clock = names_.take(name + "-clock");
        XmlElement(parent, "TimeSensor")
            .set("DEF", clock)
            .set("cycleInterval", cycle)
            .set("loop", motion.duration > 0);
        if (!motion.translation.times.empty())
            writeTrack(
                parent, {"PositionInterpolator", "translation"}, clock, name,
                keysOf(motion.translation, cycle, [&](double t) { return text(motion.at(t).translation); }));
        if (!motion.rotation.times.empty())
            writeTrack(
                parent, {"OrientationInterpolator", "rotation"}, clock, name,
                keysOf(motion.rotation, cycle, [&](double t) { return axisAngle(motion.at(t).rotation); }));
        if (motion.translation.interpolation == Interpolation::CubicSpline ||
            motion.rotation.interpolation == Interpolation::CubicSpline)
            result_.losses.push_back({ExportTarget::X3d, object.name, "motion", LossKind::Degraded,
                                      "its curves are written as straight pieces of 1 ms"});
    }

    struct TrackNode {
        std::string_view node, field;
    };
    void writeTrack(XmlElement& parent, const TrackNode& track, const std::string& clock,
                    const std::string& name, const Keys& keys) {
        const std::string def = names_.take(name + "-" + std::string(track.field));
        XmlElement(parent, track.node)
            .set("DEF", def)
            .setPlain("key", keys.times)
            .setPlain("keyValue", keys.values);
        writeRoute(parent, {clock, "fraction_changed"}, {def, "set_fraction"});
        writeRoute(parent, {def, "value_changed"}, {moverOf(name), track.field});
    }

    /// Unique as `name` is: no other name ends so.
    static std::string moverOf(const std::string& name) { return name + "-moved"; }

    void writeDevice() {
        XmlElement root(result_.device, "X3D");
        root.set("profile", "Full").set("version", "3.2");
        {
            XmlElement head(root, "head");
            XmlElement(head, "meta").set("name", "generator").set("content", "Tactum");
            XmlElement(head, "meta")
                .set("name", "description")
                .set("content", "The device for scene.x3d. proxyRadius is the scene's, in m. forceLimit, in "
                                "N, is not: it is "
                                "what a light desk device gives for as long as one likes; report.md of a "
                                "bundle says what "
                                "its finger path needs.");
        }
        XmlElement scene(root, "Scene");
        XmlElement info(scene, "DeviceInfo");
        XmlElement device(info, "AnyDevice");
        device.set("forceLimit", kX3dForceLimit);
        XmlElement(device, "RuspiniRenderer").set("proxyRadius", proxyRadius_);
    }

    const Scene& scene_;
    const X3dNames& files_;
    const Progress& progress_;
    std::size_t surfaces_ = 0, written_ = 0;
    const double proxyRadius_ = kProxyRadius.clamped(scene_.proxyRadius);
    UniqueNames names_;
    X3dExport result_;
    X3dBodies bodies_{scene_, names_, result_.losses};
};

} // namespace

X3dNames X3dNames::beside(std::string_view stem) {
    const std::string own = sideFileStem(stem);
    return {own + "-maps", own + "-deviceinfo.x3d"};
}

X3dExport x3dOf(const Scene& scene, const X3dNames& names) {
    assertNotRealtime();
    return X3dWriter(scene, names, {}).write();
}

Result<X3dExport> x3dOf(const Scene& scene, const X3dNames& names, const Progress& progress) {
    assertNotRealtime();
    X3dExport written = X3dWriter(scene, names, progress).write();
    if (progress.isCancelled()) return cancelledError();
    return written;
}

} // namespace tactum
