#include "app/hl/hl.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "app/hl/model.h"
#include "core/protocol/connection.h"

namespace hl {
namespace {

/// What surfaces of an instance feel like.
struct Feel {
    std::array<double, 5> values{800, 0, 0, 0, 0}; ///< by Parameter
    Sides sides = Both;
    bool shading = false;
    std::shared_ptr<const Texture> texture;

    bool operator==(const Feel&) const = default;
};

/// What one callList() of a frame asked for.
struct Wanted {
    List list = 0;
    Vec scale{1, 1, 1};
    Place place;
    Feel feel;
    double mass = 0;
    Joint joint;
};

/// What of it the server has.
struct Kept {
    std::uint32_t object = 0;
    Wanted as;
};

/// The n-th call of a list.
using Key = std::pair<List, std::uint32_t>;

bool same(const Place& a, const Place& b) {
    return a.position == b.position && a.turn == b.turn;
}

void write(tactum::v1::Vector* to, const Vec& v) {
    to->set_x(v[0]);
    to->set_y(v[1]);
    to->set_z(v[2]);
}

Vec vecOf(const tactum::v1::Vector& v) {
    return {v.x(), v.y(), v.z()};
}

void write(tactum::v1::Pose* to, const Place& place) {
    write(to->mutable_position(), place.position);
    tactum::v1::Rotation* turn = to->mutable_rotation();
    turn->set_w(place.turn[0]);
    turn->set_x(place.turn[1]);
    turn->set_y(place.turn[2]);
    turn->set_z(place.turn[3]);
}

void write(tactum::v1::SetMaterial* to, const Feel& feel) {
    constexpr std::array<const char*, 3> kSides{"both", "front", "back"};
    to->set_stiffness(feel.values[Stiffness]);
    to->set_damping(feel.values[Damping]);
    to->set_static_friction(feel.values[StaticFriction]);
    to->set_dynamic_friction(feel.values[DynamicFriction]);
    to->set_viscosity(feel.values[Viscosity]);
    to->set_shading(feel.shading);
    to->set_sides(kSides[feel.sides]);
}

void write(tactum::v1::SetLayers* to, const std::shared_ptr<const Texture>& texture) {
    if (!texture) return; // none: no layers
    tactum::v1::Layer* layer = to->add_layer();
    layer->set_source("image");
    layer->set_target(texture->friction ? "dynamic-friction" : "height");
    layer->set_strength(texture->strength);
    layer->set_size(texture->size);
    tactum::v1::Image* image = layer->mutable_image();
    image->set_width(texture->width);
    image->set_height(texture->height);
    for (const float value : texture->values) {
        const auto texel = std::uint16_t(std::lround(65535 * std::fmin(std::fmax(value, 0.0f), 1.0f)));
        image->mutable_texels()->append(reinterpret_cast<const char*>(&texel), sizeof texel);
    }
}

void write(tactum::v1::SetJoint* to, const Joint& joint) {
    constexpr double kEndless = 1e29;
    if (joint.kind == Joint::Loose) return;
    to->set_kind(joint.kind == Joint::Hinge ? "hinge" : "slider");
    write(to->mutable_at(), joint.at);
    write(to->mutable_axis(), joint.axis);
    if (joint.low > -kEndless) to->set_low(joint.low);
    if (joint.high < kEndless) to->set_high(joint.high);
    to->set_stiffness(joint.stiffness), to->set_rest(joint.rest), to->set_damping(joint.damping);
    to->set_friction(joint.friction), to->set_speed(joint.speed), to->set_strength(joint.strength);
    to->set_spacing(joint.spacing), to->set_detent(joint.detent);
}

} // namespace

struct Context::Impl {
    std::unique_ptr<tactum::Connection> link; ///< null: nobody hears
    std::string fault;

    // Models.
    std::map<List, Model> lists;
    List lastList = 0, open = 0;
    std::optional<Mode> mode;
    std::vector<Corner> corners;
    Corner next;
    bool normals = false, uvs = false;

    // The state that calls take along.
    std::vector<Matrix> matrices{Matrix{}};
    Feel feel;
    double mass = 0;
    Joint joint;
    std::optional<Vec> gravity;
    std::optional<double> radius;

    // Frames.
    bool inFrame = false;
    std::map<Key, Wanted> wanted;
    std::map<List, std::uint32_t> calls;
    std::map<Key, Kept> kept; ///< of the last frame that was made
    std::map<Key, Instance> instances;

    void fail(const std::string& why) {
        if (fault.empty()) fault = why;
    }
    bool done(const std::string& why) {
        if (!why.empty()) fail(why);
        return why.empty();
    }
    Instance instanceOf(const Key& key) {
        return instances.try_emplace(key, Instance(instances.size() + 1)).first->second;
    }
    bool add(tactum::v1::Transaction& transaction, const Wanted& one);
    bool addAll(std::map<Key, Kept>& now);
    bool change(std::map<Key, Kept>& now);
};

namespace {

Context::Impl* current = nullptr;

/// Without a current one, one that nobody hears.
Context::Impl& context() {
    static Context::Impl nobody;
    return current ? *current : nobody;
}

/// A new mesh at the server, unless it is the same list in the same scale: that one is shared there.
bool isAnother(const Wanted& a, const Wanted& b) {
    return a.list != b.list || a.scale != b.scale || a.mass != b.mass;
}

} // namespace

Context::Context(const std::string& target, const std::string& name, const Options& options)
    : impl_(std::make_unique<Impl>()) {
    impl_->link = std::make_unique<tactum::Connection>(
        target, name,
        tactum::ConnectionOptions{options.certificate, options.token, options.stateRate, options.patience});
    if (!impl_->link->open()) impl_->fail(impl_->link->fault());
    makeCurrent(*this);
}
Context::~Context() {
    if (current == impl_.get()) current = nullptr;
}
bool Context::open() const {
    return impl_->link->open();
}
void makeCurrent(Context& given) {
    current = given.impl_.get();
}

std::string error() {
    return std::exchange(context().fault, {});
}

// ---- models ----

void begin(Mode mode) {
    context().mode = mode;
    context().corners.clear();
    context().normals = context().uvs = false;
}

void normal(double x, double y, double z) {
    context().normals = true;
    const Vec n = context().matrices.back().direction({x, y, z});
    context().next.normal = {float(n[0]), float(n[1]), float(n[2])};
}

void texCoord(double u, double v) {
    context().uvs = true;
    context().next.uv = {float(u), float(v)};
}

void vertex(double x, double y, double z) {
    Context::Impl& c = context();
    c.next.position = c.matrices.back().apply({x, y, z});
    c.corners.push_back(c.next);
}

void end() {
    Context::Impl& c = context();
    if (!c.mode) return c.fail("end() without begin()");
    const Mode mode = *std::exchange(c.mode, std::nullopt);
    if (c.open == 0) return c.fail("corners belong into a list: newList() before begin()");
    Model& model = c.lists[c.open];
    if (!model.empty() && (model.normals != c.normals || model.uvs != c.uvs))
        return c.fail("in a list either all corners have normals and texture coordinates, or none");
    model.normals = c.normals;
    model.uvs = c.uvs;
    appendTriangles(model, mode, c.corners);
}

List newList() {
    Context::Impl& c = context();
    if (c.open != 0) c.fail("newList() before the last one's endList()");
    pushMatrix();
    loadIdentity();
    return c.open = ++c.lastList;
}

void endList() {
    if (context().open == 0) return context().fail("endList() without newList()");
    context().open = 0;
    popMatrix();
}

List meshList(const std::vector<Vec>& positions, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const List list = newList();
    begin(Triangles);
    for (const auto& triangle : triangles)
        for (const std::uint32_t corner : triangle) {
            if (corner >= positions.size()) {
                context().fail("a triangle names a corner that there is not");
                continue;
            }
            vertex(positions[corner][0], positions[corner][1], positions[corner][2]);
        }
    end();
    endList();
    return list;
}

// ---- the matrix ----

void loadIdentity() {
    context().matrices.back() = Matrix{};
}
void pushMatrix() {
    context().matrices.push_back(context().matrices.back());
}
void popMatrix() {
    if (context().matrices.size() < 2) return context().fail("popMatrix() without pushMatrix()");
    context().matrices.pop_back();
}
void translate(double x, double y, double z) {
    Matrix& top = context().matrices.back();
    top = top * Matrix::ofTranslation({x, y, z});
}
void rotate(double degrees, double x, double y, double z) {
    Matrix& top = context().matrices.back();
    top = top * Matrix::ofRotation(degrees, {x, y, z});
}
void scale(double x, double y, double z) {
    Matrix& top = context().matrices.back();
    top = top * Matrix::ofScale({x, y, z});
}

// ---- what it feels like ----

void material(Parameter parameter, double value) {
    context().feel.values[parameter] = value;
}
void sides(Sides sides) {
    context().feel.sides = sides;
}
void shading(bool on) {
    context().feel.shading = on;
}
void texture(const Texture& texture) {
    Context::Impl& c = context();
    if (texture.values.size() != std::size_t(texture.width) * texture.height)
        return c.fail("a texture has not as many values as it says");
    c.feel.texture = texture.values.empty() ? nullptr : std::make_shared<const Texture>(texture);
}
void mass(double kilograms) {
    context().mass = kilograms;
}
void joint(const Joint& joint) {
    context().joint = joint;
}
void gravity(double x, double y, double z) {
    context().gravity = Vec{x, y, z};
}
void proxyRadius(double metres) {
    context().radius = metres;
}

// ---- a frame ----

void beginFrame() {
    Context::Impl& c = context();
    if (c.inFrame) c.fail("beginFrame() before the last one's endFrame()");
    c.inFrame = true;
    c.wanted.clear();
    c.calls.clear();
    c.matrices.assign(1, Matrix{});
}

Instance callList(List list) {
    Context::Impl& c = context();
    const double mass = std::exchange(c.mass, 0);
    const Joint joint = std::exchange(c.joint, {});
    const auto found = c.lists.find(list);
    if (!c.inFrame || found == c.lists.end() || found->second.empty()) {
        c.fail(c.inFrame ? "callList() of a list without corners" : "callList() outside of a frame");
        return 0;
    }
    const Placement placement = placementOf(c.matrices.back());
    if (!placement.possible) {
        c.fail("a matrix that shears or flattens cannot be felt");
        return 0;
    }
    const Key key{list, c.calls[list]++};
    c.wanted[key] = {list, placement.scale, placement.place, c.feel, mass, joint};
    return c.instanceOf(key);
}

/// The mesh of one, and an edit that adds it.
bool Context::Impl::add(tactum::v1::Transaction& transaction, const Wanted& one) {
    const Model& model = lists[one.list];
    MeshBytes mesh = bytesOf(model, one.scale);
    tactum::v1::UploadHead head;
    tactum::v1::MeshHead* about = head.mutable_mesh();
    about->set_positions(mesh.positions);
    about->set_triangles(mesh.triangles);
    about->set_doubles(true);
    about->set_normals(model.normals);
    about->set_uvs(model.uvs);
    std::uint64_t number = 0;
    if (!done(link->upload(head, mesh.bytes, number))) return false;
    tactum::v1::AddUpload* to = transaction.add_edit()->mutable_add();
    to->set_upload(number);
    to->set_hidden(true); // until its material is known
    to->set_name("list " + std::to_string(one.list));
    write(to->mutable_pose(), one.place);
    return true;
}

/// What the last frame did not have: the server gives their numbers.
bool Context::Impl::addAll(std::map<Key, Kept>& now) {
    tactum::v1::Transaction transaction;
    std::vector<Key> keys;
    for (const auto& [key, one] : wanted) {
        const auto before = kept.find(key);
        if (before != kept.end() && !isAnother(before->second.as, one)) continue;
        if (!add(transaction, one)) return false;
        keys.push_back(key);
    }
    if (keys.empty()) return true;
    tactum::v1::Applied applied;
    if (!done(link->apply(transaction, applied))) return false;
    if (std::size_t(applied.added_size()) != keys.size()) return done("the server added something else");
    for (std::size_t i = 0; i < keys.size(); ++i)
        now[keys[i]] = {applied.added(int(i)), {}};
    return true;
}

/// Everything else in one transaction.
bool Context::Impl::change(std::map<Key, Kept>& now) {
    tactum::v1::Transaction transaction;
    for (const auto& [key, before] : kept)
        if (const auto found = now.find(key); found == now.end() || found->second.object != before.object)
            transaction.add_edit()->set_remove(before.object);
    for (auto& [key, one] : now) {
        const Wanted& want = wanted.at(key);
        const bool isNew = one.as.list == 0;
        if (isNew || !(want.feel == one.as.feel)) {
            tactum::v1::SetMaterial* material = transaction.add_edit()->mutable_material();
            material->mutable_where()->set_object(one.object);
            write(material, want.feel);
        }
        if (isNew ? want.feel.texture != nullptr : want.feel.texture != one.as.feel.texture) {
            tactum::v1::SetLayers* layers = transaction.add_edit()->mutable_layers();
            layers->mutable_where()->set_object(one.object);
            write(layers, want.feel.texture);
        }
        if (isNew && want.mass > 0) {
            tactum::v1::SetBody* body = transaction.add_edit()->mutable_body();
            body->set_object(one.object);
            body->set_mass(want.mass);
            tactum::v1::SetJoint* hold = transaction.add_edit()->mutable_joint();
            hold->set_object(one.object);
            write(hold, want.joint);
        }
        if (isNew) {
            tactum::v1::SetVisible* visible = transaction.add_edit()->mutable_visible();
            visible->set_object(one.object);
            visible->set_visible(true);
        }
        if (!isNew && want.mass == 0 && !same(want.place, one.as.place)) {
            tactum::v1::SetPose* pose = transaction.add_edit()->mutable_pose();
            pose->set_object(one.object);
            write(pose->mutable_pose(), want.place);
        }
        one.as = want;
    }
    if (gravity) write(transaction.add_edit()->mutable_gravity(), *gravity);
    if (radius) transaction.add_edit()->set_proxy_radius(*radius);
    tactum::v1::Applied applied;
    if (transaction.edit_size() > 0 && !done(link->apply(transaction, applied))) return false;
    gravity.reset();
    radius.reset();
    return true;
}

bool endFrame() {
    Context::Impl& c = context();
    if (!std::exchange(c.inFrame, false)) {
        c.fail("endFrame() without beginFrame()");
        return false;
    }
    if (!c.link || !c.fault.empty()) return false;
    std::map<Key, Kept> now;
    for (const auto& [key, one] : c.wanted)
        if (const auto before = c.kept.find(key);
            before != c.kept.end() && !isAnother(before->second.as, one))
            now[key] = before->second;
    if (!c.addAll(now) || !c.change(now)) return false;
    c.kept = std::move(now);
    return true;
}

// ---- orders ----

namespace {

bool order(tactum::v1::OrderRequest& request) {
    Context::Impl& c = context();
    tactum::v1::OrderReply reply;
    return c.link && c.done(c.link->order(request, reply));
}

} // namespace

bool arm(bool on) {
    tactum::v1::OrderRequest request;
    request.set_arm(on);
    return order(request);
}
bool stop() {
    tactum::v1::OrderRequest request;
    request.mutable_stop();
    return order(request);
}
void push(double x, double y, double z) {
    tactum::v1::Word word;
    write(word.mutable_push()->mutable_force(), Vec{x, y, z});
    if (context().link) context().link->say(word);
}
bool leadHand(double x, double y, double z) {
    tactum::v1::OrderRequest request;
    write(request.mutable_hand(), Vec{x, y, z});
    return order(request);
}

// ---- what comes back ----

State state() {
    State out;
    if (!context().link) return out;
    const tactum::v1::State state = context().link->state();
    out.number = state.number();
    out.revision = state.revision();
    out.finger = vecOf(state.finger());
    out.proxy = vecOf(state.proxy());
    out.force = vecOf(state.force());
    out.contacts = state.contacts();
    out.buttons = state.buttons();
    out.armed = state.armed();
    out.gain = state.gain();
    return out;
}

bool placeOf(Instance instance, Place& place) {
    Context::Impl& c = context();
    if (!c.link) return false;
    std::uint32_t object = 0;
    for (const auto& [key, one] : c.kept)
        if (c.instances.at(key) == instance) object = one.object;
    const tactum::v1::State state = c.link->state();
    for (const tactum::v1::Placed& body : state.body()) {
        if (object == 0 || body.object() != object) continue;
        const tactum::v1::Rotation& turn = body.pose().rotation();
        place = {vecOf(body.pose().position()), {turn.w(), turn.x(), turn.y(), turn.z()}};
        return true;
    }
    return false;
}

bool nextEvent(Event& event) {
    Context::Impl& c = context();
    tactum::v1::Event told;
    if (!c.link || !c.link->nextEvent(told)) return false;
    event = {Event::Kind(told.kind()), 0, told.button(), told.text(), told.detent()};
    for (const auto& [key, one] : c.kept)
        if (one.object == told.object()) event.instance = c.instances.at(key);
    return true;
}

} // namespace hl
