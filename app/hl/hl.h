// HL: the client library of the haptic server, in the shape of GL (section 7). docs/hl.md tells it as a
// whole.
//
// A context is made current, models are said as in GL, and a frame says what there is to feel:
//
//     hl::Context context("127.0.0.1:51270", "game");
//     const hl::List cube = hl::newList(); ... hl::begin(hl::Quads); hl::vertex(...); ... hl::end();
//     hl::endList(); hl::beginFrame(); hl::translate(x, y, z); hl::callList(cube); hl::endFrame();
//
// What a frame calls that the last one did not is sent and added, what it no longer calls is removed, what
// has moved or has another material is changed: all of it in one transaction, felt whole. Lists are sent
// once. SI, world frame, y up.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace hl {

using Vec = std::array<double, 3>;
/// w, x, y, z.
using Turn = std::array<double, 4>;

struct Options {
    std::string certificate, token; ///< of a server on another machine: PEM, and its token
    double stateRate = 60;          ///< Hz
    double patience = 5;            ///< s, that the constructor waits for the server
};

/// A connection to a server. The last one that was made is current until makeCurrent(). Thread of everything
/// here: one, the application's; nothing blocks for longer than a call over the network, and what the server
/// tells comes in beside it.
class Context {
public:
    /// Attends, and asks for the pen. On an error it is not open, and error() says why.
    explicit Context(const std::string& target, const std::string& name, const Options& options = {});
    /// Leaves; what it holds is let go, the scene stays.
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Whether the server is there and was heard of late.
    bool open() const;
    struct Impl;

private:
    friend void makeCurrent(Context& context);
    std::unique_ptr<Impl> impl_;
};
void makeCurrent(Context& context);

/// The first thing that went wrong since the last call, in one sentence; empty: nothing did. As glGetError().
std::string error();

// ---- models ----

enum Mode { Triangles, TriangleStrip, TriangleFan, Quads, Polygon };

/// Between begin() and end(): corners, counter-clockwise from the front. A normal or a texture coordinate is
/// that of all corners after it. Polygons are convex.
void begin(Mode mode);
void normal(double x, double y, double z);
void texCoord(double u, double v);
void vertex(double x, double y, double z);
void end();

using List = std::uint32_t; ///< 0 is none
/// Everything until endList() goes into a list instead of the frame: corners with the matrix of the moment,
/// in the list's own frame.
List newList();
void endList();
/// Arrays as a list: positions and triangles by index.
List meshList(const std::vector<Vec>& positions, const std::vector<std::array<std::uint32_t, 3>>& triangles);

// ---- the matrix ----

void loadIdentity();
void pushMatrix();
void popMatrix();
void translate(double x, double y, double z);
void rotate(double degrees, double x, double y, double z); ///< as glRotate()
/// Of what it holds every size is another mesh at the server: once for each list and scale.
void scale(double x, double y, double z);

// ---- what it feels like ----

enum Parameter { Stiffness, Damping, StaticFriction, DynamicFriction, Viscosity };
/// Of everything that is called after it. N/m, N s/m, ratios, N s/m. Out of its range: endFrame() says so.
void material(Parameter parameter, double value);
enum Sides { Both, Front, Back };
void sides(Sides sides);
/// Facets feel round.
void shading(bool on);
/// Values from 0 to 1, row by row, as height or friction; `size`: m, width of a repeat. An empty image: none.
struct Texture {
    std::uint32_t width = 0, height = 0;
    std::vector<float> values;
    double strength = 0; ///< m of height, or the share of the friction
    double size = 0.01;
    bool friction = false;
};
void texture(const Texture& texture);

// ---- what moves by forces ----

/// Of the next callList(): a body of that mass, kg; 0: it is still. Where it is only its first frame says.
void mass(double kilograms);
struct Joint {
    enum Kind { Loose, Hinge, Slider } kind = Loose;
    Vec at{}, axis{0, 1, 0};         ///< world frame
    double low = -1e30, high = 1e30; ///< stops, rad or m
    double stiffness = 0, rest = 0, damping = 0, friction = 0;
    double speed = 0, strength = 0; ///< of its motor
    double spacing = 0, detent = 0;
};
/// Of the next callList() with a mass.
void joint(const Joint& joint);
void gravity(double x, double y, double z);
/// Of the proxy, m.
void proxyRadius(double metres);

// ---- a frame ----

/// What is called in a frame: names it in events and states. The n-th call of a list in one frame is the n-th
/// of it in the next.
using Instance = std::uint32_t;
void beginFrame();
Instance callList(List list);
/// Sends what differs from the last frame. False: nothing of it was made, and error() says why.
bool endFrame();

// ---- orders ----

bool arm(bool on);
bool stop(); ///< all force ends at once, whoever has the pen
/// N, added to what the finger feels; said again within 100 ms, or it fades.
void push(double x, double y, double z);
/// Where the simulated hand goes, m.
bool leadHand(double x, double y, double z);

// ---- what comes back ----

struct State {
    std::uint64_t number = 0;   ///< 0: none came yet
    std::uint64_t revision = 0; ///< of the scene that is felt
    Vec finger{}, proxy{}, force{};
    unsigned contacts = 0;
    std::uint32_t buttons = 0;
    bool armed = false;
    double gain = 0;
};
/// The newest; never waits.
State state();

struct Place {
    Vec position{};
    Turn turn{1, 0, 0, 0};
};
/// Of a body, the newest: false while none came. For the picture.
bool placeOf(Instance instance, Place& place);

struct Event {
    enum Kind {
        None,
        Touch,
        Leave,
        Pressed,
        Released,
        Force,
        Scene,
        Pen,
        PenAsked,
        Attends,
        Lost,
        Detent
    } kind = None;
    Instance instance = 0; ///< that is touched; 0: none of ours
    std::uint32_t button = 0;
    std::string text;
    int detent = 0; ///< which its joint has gone on to: 0 is where its spring rests
};
/// The next that was not told yet; false: there is none.
bool nextEvent(Event& event);

} // namespace hl
