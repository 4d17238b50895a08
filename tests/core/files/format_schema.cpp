#include "tests/core/files/format_schema.h"

#include "core/dynamics/path.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/scene/selection_sets.h"
#include "core/scene/world_fields.h"

namespace tactum {
namespace {

using Schema = nlohmann::ordered_json;

Schema text(const std::string& sentence) {
    return {{"type", "string"}, {"description", sentence}};
}
Schema flag(const std::string& sentence) {
    return {{"type", "boolean"}, {"description", sentence}};
}
Schema index(const std::string& sentence) {
    return {{"type", "integer"}, {"minimum", 0}, {"description", sentence}};
}
Schema numbers(int count, const std::string& sentence) {
    return {{"type", "array"},
            {"items", {{"type", "number"}}},
            {"minItems", count},
            {"maxItems", count},
            {"description", sentence}};
}

Schema listOf(Schema items) {
    return {{"type", "array"}, {"items", std::move(items)}};
}
Schema listOf(Schema items, std::size_t least, std::size_t most) {
    Schema list = listOf(std::move(items));
    list["minItems"] = least, list["maxItems"] = most;
    return list;
}

Schema number(const Parameter& parameter) {
    std::string sentence(parameter.sentence);
    if (!parameter.unit.empty()) sentence += " Unit: " + std::string(parameter.unit) + ".";
    return {{"type", "number"},
            {"minimum", parameter.minimum},
            {"maximum", parameter.maximum},
            {"default", parameter.initial},
            {"description", sentence}};
}
template <class Table> void addNumbers(Schema& properties, const Table& table) {
    for (const auto& field : table)
        properties[jsonKey(field.parameter->key)] = number(*field.parameter);
}

template <std::size_t N> Schema word(const std::array<NamedChoice, N>& choices, const std::string& sentence) {
    Schema words = Schema::array();
    for (const NamedChoice& choice : choices)
        words.push_back(choice.key);
    return {{"enum", words}, {"description", sentence}};
}

Schema object(const std::string& sentence, Schema properties) {
    return {{"type", "object"}, {"description", sentence}, {"properties", std::move(properties)}};
}

Schema reference(const char* name) {
    return {{"$ref", std::string("#/$defs/") + name}};
}

/// What has to be true of the extension wherever it stands.
Schema extended(const char* name) {
    const Schema extensions{{"type", "object"}, {"properties", {{kExtension, reference(name)}}}};
    return {{"type", "object"}, {"properties", {{"extensions", extensions}}}};
}
Schema eachExtended(const char* name) {
    return {{"type", "array"}, {"items", extended(name)}};
}

Schema patternSchema() {
    Schema properties{
        {"source", word(kTextureSources, "Where the values from 0 to 1 come from.")},
        {"mapping", word(kTextureMappings, "How the pattern comes onto the surface.")},
        {"texture",
         object("Of the source image: a glTF texture, linear, 0 to 1 in its first channel, 8 or 16 bits.",
                {{"index", index("Of the glTF texture.")}})},
        {"painted",
         object(
             "Of the source painted: where its values from 0 to 1 are.",
             {{"attribute",
               index("Attribute _TACTUM_PAINT_n of the primitives of the mesh: a scalar for each "
                     "vertex, the same wherever vertices repeat a position.")},
              {"bufferView", index("Instead, where there are not as many values as positions: floats.")}})},
        {"frame", object("Of the mappings without texture coordinates, in the frame of the node.",
                         {{"translation", numbers(3, "Unit: m.")},
                          {"rotation", numbers(4, "Quaternion x, y, z, w.")}})}};
    addNumbers(properties, kPatternFields);
    return object("A field of values from 0 to 1 over the surface.", properties);
}

Schema layerSchema() {
    return object(
        "One layer of haptic texture; the first one lies lowest.",
        {{"name", text("For the person.")},
         {"enabled", flag("Whether it is felt.")},
         {"pattern", reference("pattern")},
         {"target", word(kTextureTargets, "What the layer changes.")},
         {"strength",
          {{"type", "number"},
           {"description", std::string("Of height in m: ") + std::string(kTextureHeight.sentence) +
                               " Of another target as a ratio: " + std::string(kTextureRatio.sentence)}}},
         {"blend", word(kTextureBlends, "How the layer joins what lies below it.")},
         {"opacity", number(kTextureOpacity)},
         {"mask",
          {{"anyOf", {reference("pattern"), {{"type", "null"}}}}, {"description", "Multiplies opacity."}}},
         {"ownPlane", flag("Of height: a constraint plane for this layer alone.")}});
}

Schema materialSchema() {
    Schema properties;
    addNumbers(properties, kMaterialFields);
    properties["sides"] = {
        {"enum", kSidesNames},
        {"description", "From which side it is felt; the front sees the corners counter-clockwise."}};
    properties["visible"] = flag("Not there: true. Else neither seen nor felt.");
    properties["locked"] = flag("Not there: false. Else an editor leaves it as it is.");
    properties["shading"] =
        object("Whether facets feel like the round surface that they stand for.",
               {{"on", flag("Whether it is so.")},
                {"normals",
                 {{"enum", {"file", "computed"}}, {"description", "NORMAL of the mesh, or from its shape."}}},
                {jsonKey(kCreaseAngle.key), number(kCreaseAngle)}});
    properties["layers"] = {{"type", "array"}, {"items", reference("layer")}};
    properties["copies"] = {
        {"type", "array"},
        {"items", {{"type", "string"}}},
        {"description",
         "Members of the material that Tactum wrote for others, and makes anew: normalTexture."}};
    return object("extensions.TACTUM_haptics of a material: how a surface feels.", properties);
}

Schema trackSchema(const char* of) {
    const Schema list{{"type", "array"}, {"items", {{"type", "number"}}}};
    return object(of, {{"interpolation", {{"enum", {"STEP", "LINEAR", "CUBICSPLINE"}}}},
                       {"times", list},
                       {"values", list},
                       {"arriving", list},
                       {"leaving", list}});
}

} // namespace

std::string formatSchema() {
    const auto view = [](const char* sentence) { return index(std::string("Buffer view: ") + sentence); };
    const Schema root = object(
        "extensions.TACTUM_haptics of the root. The members workspace and safety are reserved.",
        {{"version",
          {{"type", "string"},
           {"pattern", "^[0-9]+\\.[0-9]+$"},
           {"description", "Of the format. A reader refuses another major number."}}},
         {jsonKey(kProxyRadius.key), number(kProxyRadius)},
         {"reach",
          word(kReachChoices,
               "How hands reach beyond their device's workspace: the finger follows the hand and nothing "
               "else, rate control beyond a shell, or a slow drift.")},
         {jsonKey(kShellRadius.key), number(kShellRadius)},
         {"finger", view("a stroke that shows the scene, four doubles a row: time in s, position in m in the "
                         "world frame.")},
         {"gravity", numbers(3, "Of a scene with bodies, world frame. Unit: m/s^2.")},
         {jsonKey(kAirDensity.key), number(kAirDensity)},
         {jsonKey(kForceScale.key), number(kForceScale)},
         {jsonKey(kTimeScale.key), number(kTimeScale)},
         {"foreign",
          object(
              "How many elements of each array, and bytes of the buffer, are not Tactum's: they stand first.",
              Schema::object())},
         {"copies",
          {{"type", "array"},
           {"items", {{"type", "string"}}},
           {"description", "Extensions that Tactum wrote for others, and makes anew."}}}});
    const Schema mesh = object(
        "extensions.TACTUM_haptics of a mesh: what single precision and drawing lose, where they lose "
        "anything.",
        {{"surfaces",
          {{"type", "array"},
           {"items", {{"type", "integer"}}},
           {"description", "The materials of its surfaces, in their order."}}},
         {"positions", view("the positions exactly, three doubles each.")},
         {"copies",
          view("unsigned 32 bits for each vertex beyond the positions: the position that it repeats.")},
         {"order", view("unsigned 32 bits for each element as drawn: its place in the author's order.")},
         {"uvs", view("texture coordinates with v upward, two floats for each vertex.")},
         {"sets",
          object(
              "Selection sets: triangles under names, by their numbers in the author's order.",
              {{"of", index("How many triangles the mesh has; with another number no set counts.")},
               {"parts", listOf(object("A set.", {{"name", text("Not empty, each once.")},
                                                  {"ranges", view("unsigned 32 bits, two for each run of "
                                                                  "neighbouring triangles: the first, and "
                                                                  "the first that is not in it; rising.")}}),
                                0, kMaxSets)}})}});
    const Schema node = object(
        "extensions.TACTUM_haptics of a node.",
        {{"visible", flag("Whether it is seen and felt.")},
         {"role",
          {{"enum", {"body", "collider", "joint", "camera", "group"}},
           {"description", "Of a node that Tactum made for KHR_physics_rigid_bodies, for a camera of its own "
                           "or for a group of objects, and makes anew."}}},
         {"ahead",
          {{"type", "number"},
           {"exclusiveMinimum", 0},
           {"description", "From a camera to what the view turns about. Unit: m."}}},
         {"pose",
          object(
              "Exactly where it is at the time 0 in the world; the node has it below another node.",
              {{"translation", numbers(3, "Unit: m.")}, {"rotation", numbers(4, "Quaternion x, y, z, w.")}})},
         {"velocity", numbers(3, "Of a body at the time 0, world frame, exactly. Unit: m/s.")},
         {"angularVelocity", numbers(3, "Of a body at the time 0, world frame, exactly. Unit: rad/s.")},
         {"detents",
          {{"type", "array"},
           {"items", object("As a drive of KHR_physics_rigid_bodies, that rests in many places.",
                            {{"spacing",
                              {{"type", "number"},
                               {"description", "From one place of rest to the next. Unit: m or rad."}}}})}}},
         {"path",
          object("Of a joint: a curve that the other node rides on, with x along it and y up.",
                 {{"closed", flag("Not there: false. Whether the last point leads to the first again.")},
                  {"points", listOf(numbers(3, "Where it goes through, in the frame of the node. Unit: m."),
                                    2, kMostPathPoints)},
                  {"ups", listOf(numbers(3, "Roughly up for what rides, at each point; not along the curve."),
                                 2, kMostPathPoints)},
                  {"limits", listOf(object("As in KHR_physics_rigid_bodies; of the way from the first point "
                                           "those with linearAxes [0]. Unit: m.",
                                           Schema::object()))},
                  {"drives", listOf(object("As in KHR_physics_rigid_bodies; along the way those with type "
                                           "linear and axis 0.",
                                           Schema::object()))}})},
         {"frictions",
          {{"type", "array"},
           {"items", object("Dry friction of a joint: up to its force the joint stays.",
                            {{"type", {{"enum", {"linear", "angular"}}}},
                             {"axis", index("Of the joint: 0, 1 or 2.")},
                             {"force", {{"type", "number"}, {"description", "Unit: N or N m."}}}})}}},
         {"motion",
          object("The exact motion of the node relative to its parent; the animation is a copy for others.",
                 {{"duration",
                   {{"type", "number"}, {"description", "After it the motion starts again. Unit: s."}}},
                  {"translation", trackSchema("Three numbers a key. Unit: m.")},
                  {"rotation", trackSchema("Quaternions x, y, z, w.")}})}});
    Schema places = extended("root")["properties"];
    places["materials"] = eachExtended("material");
    places["meshes"] = eachExtended("mesh");
    places["nodes"] = eachExtended("node");
    Schema schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                  {"title", "TACTUM_haptics"},
                  {"description", "The extension by which a glTF 2.0 file holds a haptic scene. Unknown "
                                  "members are allowed everywhere and are kept. The schema "
                                  "is that of the file's JSON: it says of each place what may stand there."},
                  {"type", "object"},
                  {"properties", places},
                  {"$defs",
                   {{"root", root},
                    {"material", materialSchema()},
                    {"layer", layerSchema()},
                    {"pattern", patternSchema()},
                    {"mesh", mesh},
                    {"node", node}}}};
    return schema.dump(2) + "\n";
}

} // namespace tactum
