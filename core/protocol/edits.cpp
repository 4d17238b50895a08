#include "core/protocol/edits.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/text.h"
#include "core/geometry/soup_builder.h"
#include "core/scene/bodies.h"

namespace tactum {
namespace {

constexpr std::size_t kMostLayers = 16;

/// Thrown inside of this file alone.
struct Refused {
    std::string why;
};

template <class T> T valueOr(Result<T> result) {
    if (!result) throw Refused{result.error().text};
    return std::move(*result);
}

double within(const Parameter& parameter, double value) {
    if (parameter.allows(value)) return value;
    throw Refused{std::string(parameter.key) + " is out of its range; see tactum info"};
}

SceneObject& objectOf(Scene& scene, ObjectId id) {
    if (SceneObject* object = scene.find(id)) return *object;
    throw Refused{"there is no object " + std::to_string(id)};
}

template <class Each> void forEach(Scene& scene, const v1::Where& where, Each each) {
    const auto surfacesOf = [&](SceneObject& object) {
        if (where.has_surface() && where.surface() >= object.surfaces.size())
            throw Refused{"object " + std::to_string(object.id) + " has no surface " +
                          std::to_string(where.surface())};
        for (std::size_t i = 0; i < object.surfaces.size(); ++i)
            if (!where.has_surface() || where.surface() == i) each(object.surfaces[i]);
    };
    if (where.object() != 0) return surfacesOf(objectOf(scene, where.object()));
    for (SceneObject& object : scene.objects)
        surfacesOf(object);
}

void setMaterial(Scene& scene, const v1::SetMaterial& set) {
    // Static friction first: each of the two brings the other one along, and the second of both has the last
    // word.
    const auto make = [&](Material& material, const Parameter& parameter, bool given, double value) {
        if (!given) return;
        for (const MaterialField& field : kMaterialFields)
            if (field.parameter == &parameter)
                material = withValue(material, field, within(parameter, value));
    };
    if (set.has_static_friction() && set.has_dynamic_friction() &&
        set.dynamic_friction() > set.static_friction())
        throw Refused{"dynamic friction is above static friction"};
    const auto sides = set.has_sides() ? sidesNamed(set.sides()) : std::nullopt;
    if (set.has_sides() && !sides)
        throw Refused{inQuotes(set.sides()) + " is none of both, front, back and none"};
    forEach(scene, set.where(), [&](Surface& surface) {
        Material& material = surface.material;
        make(material, kStiffness, set.has_stiffness(), set.stiffness());
        make(material, kDamping, set.has_damping(), set.damping());
        make(material, kStaticFriction, set.has_static_friction(), set.static_friction());
        make(material, kDynamicFriction, set.has_dynamic_friction(), set.dynamic_friction());
        make(material, kViscosity, set.has_viscosity(), set.viscosity());
        if (set.has_shading()) surface.shading.on = set.shading();
        if (sides) surface.sides = *sides;
    });
}

template <class Choice, std::size_t N>
Choice choiceOf(const std::array<NamedChoice, N>& names, const std::string& word, Choice otherwise) {
    if (word.empty()) return otherwise;
    for (std::size_t i = 0; i < N; ++i)
        if (names[i].key == word) return Choice(i);
    throw Refused{inQuotes(word) + " is no choice that there is for a layer"};
}

std::shared_ptr<const TextureImage> imageOf(const v1::Image& image) {
    constexpr std::uint32_t kSide = TextureImage::kLargestSide;
    if (image.width() < 1 || image.width() > kSide || image.height() < 1 || image.height() > kSide ||
        image.texels().size() != std::size_t(2) * image.width() * image.height())
        throw Refused{"an image has not as many texels as it says"};
    std::vector<std::uint16_t> texels(image.texels().size() / 2);
    std::memcpy(texels.data(), image.texels().data(), image.texels().size());
    return std::make_shared<const TextureImage>(int(image.width()), int(image.height()), std::move(texels));
}

TextureLayer layerOf(const v1::Layer& layer) {
    TextureLayer made;
    made.name = layer.source();
    made.pattern.source = choiceOf(kTextureSources, layer.source(), TextureSource::Noise);
    made.pattern.mapping = choiceOf(kTextureMappings, layer.mapping(), TextureMapping::Triplanar);
    made.target = choiceOf(kTextureTargets, layer.target(), TextureTarget::Height);
    made.blend = choiceOf(kTextureBlends, layer.blend(), TextureBlend::Add);
    made.strength = within(strengthParameter(made.target), layer.strength());
    if (layer.size() != 0) made.pattern.size = within(kTextureSize, layer.size());
    if (layer.has_opacity()) made.opacity = within(kTextureOpacity, layer.opacity());
    if (made.pattern.source == TextureSource::Painted)
        throw Refused{"what is painted cannot be sent as a layer"};
    if (made.pattern.source == TextureSource::Image) made.pattern.image = imageOf(layer.image());
    return made;
}

void setLayers(Scene& scene, const v1::SetLayers& set) {
    if (std::size_t(set.layer_size()) > kMostLayers)
        throw Refused{"a surface has at most " + std::to_string(kMostLayers) + " layers"};
    std::vector<TextureLayer> layers;
    for (const v1::Layer& layer : set.layer())
        layers.push_back(layerOf(layer));
    forEach(scene, set.where(), [&](Surface& surface) { surface.layers = layers; });
}

void setBody(Scene& scene, const v1::SetBody& set) {
    SceneObject& object = objectOf(scene, set.object());
    if (set.mass() == 0) {
        if (object.body != kWorldBody) makeStill(scene, object.body);
        return;
    }
    const double mass = within(kBodyMass, set.mass());
    const double gravity = set.has_gravity_factor() ? within(kGravityFactor, set.gravity_factor()) : 1;
    if (object.motion) throw Refused{"an object that moves by its keys cannot be a body"};
    const BodyId id = object.body != kWorldBody ? object.body : makeBody(scene, set.object());
    RigidBody* body = findBody(scene, id);
    if (!body) throw Refused{"this object encloses nothing, so it cannot be a body"};
    setMass(*body, mass);
    if (set.has_gravity_factor()) body->gravityFactor = gravity;
}

double within(const AxisField& field, AxisKind kind, double value) {
    return within(kind == AxisKind::Hinge ? *field.hinge : *field.slider, value);
}

AxisJoint jointOf(const v1::SetJoint& set) {
    AxisJoint joint;
    joint.kind = set.kind() == "hinge" ? AxisKind::Hinge : AxisKind::Slider;
    joint.at = valueOr(vectorOf(set.at()));
    joint.axis = valueOr(vectorOf(set.axis()));
    if (!(joint.axis.norm() > 1e-6)) throw Refused{"the axis of a joint has no length"};
    joint.axis.normalize();
    if (set.has_low()) joint.low = set.low();
    if (set.has_high()) joint.high = set.high();
    joint.stiffness = set.stiffness(), joint.rest = set.rest(), joint.damping = set.damping();
    joint.friction = set.friction(), joint.speed = set.speed(), joint.strength = set.strength();
    joint.spacing = set.spacing(), joint.detent = set.detent();
    for (const AxisField& field : kAxisFields) {
        const double value = joint.*field.value;
        if (!(field.isStop() && value == field.endless())) within(field, joint.kind, value);
    }
    return joint;
}

void setJoint(Scene& scene, const v1::SetJoint& set) {
    const BodyId body = objectOf(scene, set.object()).body;
    if (body == kWorldBody) throw Refused{"an object has to be a body before it has a joint"};
    if (set.kind().empty()) return setLoose(scene, body);
    if (set.kind() != "hinge" && set.kind() != "slider")
        throw Refused{inQuotes(set.kind()) + " is neither hinge nor slider"};
    setAxisJoint(scene, body, jointOf(set));
}

const LoadedScene& uploadedOf(const std::shared_ptr<const LoadedScene>& found, std::uint64_t number) {
    if (found) return *found;
    throw Refused{"there is no upload " + std::to_string(number) +
                  " of this client: it was used up or never came"};
}

void addUpload(Scene& scene, const v1::AddUpload& add, const UploadOf& uploadOf) {
    const auto kept = uploadOf(add.upload());
    const LoadedScene& loaded = uploadedOf(kept, add.upload());
    if (!loaded.scene.mechanics.bodies.empty())
        throw Refused{"a file with bodies can only be opened, not added to a scene"};
    const Pose pose = valueOr(poseOf(add.pose()));
    for (SceneObject object : loaded.scene.objects) {
        object.pose = pose * object.pose;
        if (add.hidden()) object.visible = false;
        if (!add.name().empty()) object.name = printable(add.name(), kLongestName);
        scene.add(std::move(object));
    }
}

void openUpload(Scene& scene, const v1::OpenUpload& open, const UploadOf& uploadOf) {
    const auto kept = uploadOf(open.upload());
    scene = uploadedOf(kept, open.upload()).scene;
    if (open.fit_diagonal() == 0) return;
    if (!(open.fit_diagonal() >= 1e-6 && open.fit_diagonal() <= kFarthest))
        throw Refused{"fit_diagonal is out of its range: from 1e-6 to 1e6 m"};
    fitDiagonal(scene, open.fit_diagonal());
}

void removeObject(Scene& scene, ObjectId id) {
    objectOf(scene, id);
    removeMechanics(scene, id);
    std::erase_if(scene.objects, [id](const SceneObject& object) { return object.id == id; });
}

/// An object that moves with a body is moved with it.
void setPose(Scene& scene, const v1::SetPose& set) {
    SceneObject& object = objectOf(scene, set.object());
    const Pose pose = valueOr(poseOf(set.pose()));
    if (object.body != kWorldBody) throw Refused{"an object that forces move goes where they take it"};
    object.pose = pose;
}

void makeEdit(Scene& scene, const v1::Edit& edit, const UploadOf& uploadOf, SceneParts& parts) {
    switch (edit.what_case()) {
    case v1::Edit::kAdd:
        return addUpload(scene, edit.add(), uploadOf);
    case v1::Edit::kOpen:
        return openUpload(scene, edit.open(), uploadOf);
    case v1::Edit::kRemove:
        return removeObject(scene, edit.remove());
    case v1::Edit::kMaterial:
        return setMaterial(scene, edit.material());
    case v1::Edit::kPose:
        return setPose(scene, edit.pose());
    case v1::Edit::kVisible:
        objectOf(scene, edit.visible().object()).visible = edit.visible().visible();
        return;
    case v1::Edit::kLayers:
        return setLayers(scene, edit.layers());
    case v1::Edit::kBody:
        return setBody(scene, edit.body());
    case v1::Edit::kJoint:
        return setJoint(scene, edit.joint());
    case v1::Edit::kProxyRadius:
        scene.proxyRadius = within(kProxyRadius, edit.proxy_radius());
        return;
    case v1::Edit::kGravity:
        scene.mechanics.gravity = valueOr(vectorOf(edit.gravity()));
        return;
    case v1::Edit::kClear:
        scene = Scene{};
        return;
    case v1::Edit::kScene:
        scene = valueOr(parts.read(edit.scene(), scene));
        return;
    case v1::Edit::WHAT_NOT_SET:
        break;
    }
    throw Refused{"says nothing that this server knows: is the client newer?"};
}

} // namespace

Result<Vec3> vectorOf(const v1::Vector& vector) {
    const Vec3 v(vector.x(), vector.y(), vector.z());
    if (isCoordinate(v.x()) && isCoordinate(v.y()) && isCoordinate(v.z())) return v;
    return inputError("a number is not finite or beyond 1e6");
}

Result<Pose> poseOf(const v1::Pose& pose) {
    auto position = vectorOf(pose.position());
    if (!position) return tl::unexpected(position.error());
    Pose made{Quat::Identity(), *position};
    if (!pose.has_rotation()) return made;
    const Quat turn(pose.rotation().w(), pose.rotation().x(), pose.rotation().y(), pose.rotation().z());
    const double norm = turn.norm();
    if (!(norm > 1e-6 && norm < 1e6)) return inputError("a rotation has no length");
    made.rotation = turn.normalized();
    return made;
}

Result<Workspace> workspaceOf(const v1::Workspace& workspace) {
    const auto offset = vectorOf(workspace.offset());
    if (!offset) return tl::unexpected(offset.error());
    if (workspace.axis_size() != 3) return inputError("a workspace has three axes");
    Workspace made{.scale = workspace.scale(), .offset = *offset, .clutch = workspace.clutch()};
    for (int i = 0; i < 3; ++i)
        made.axes[std::size_t(i)] =
            std::int8_t(std::clamp(workspace.axis(i), -4, 4)); // 4 is none, and is refused
    made.bump = workspace.bump();
    made.centring = workspace.centring();
    made.reach.mode = ReachMode(std::min<std::uint32_t>(workspace.reach(), kReachModes));
    if (workspace.has_shell()) made.reach.shell = workspace.shell();
    return checkWorkspace(made).map([&] { return made; });
}

Result<void> makeEdits(Scene& scene, const google::protobuf::RepeatedPtrField<v1::Edit>& edits,
                       const UploadOf& uploadOf, SceneParts& parts) {
    int place = 0;
    try {
        for (const v1::Edit& edit : edits) {
            ++place;
            makeEdit(scene, edit, uploadOf, parts);
        }
        return {};
    } catch (const Refused& refused) {
        return inputError("edit " + std::to_string(place) + ": " + refused.why);
    }
}

} // namespace tactum
