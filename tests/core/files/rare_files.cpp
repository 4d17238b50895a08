#include "tests/core/files/rare_files.h"

#include <cstdint>

namespace tactum {
namespace {

template <class T> std::string raw(T value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A chunk of 3DS: its number, its length with this head, its content.
std::string chunk(std::uint16_t number, const std::string& content) {
    return raw(number) + raw(std::uint32_t(content.size() + 6)) + content;
}

} // namespace

std::string as3ds(const TriangleSoup& soup, const std::string& object, const std::string& material) {
    std::string vertices = raw(std::uint16_t(soup.positions.size()));
    for (const Vec3& p : soup.positions)
        vertices += raw(float(p.x())) + raw(float(p.y())) + raw(float(p.z()));
    std::string faces = raw(std::uint16_t(soup.triangles.size())),
                users = material + '\0' + raw(std::uint16_t(soup.triangles.size()));
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        for (const Index corner : soup.triangles[f])
            faces += raw(std::uint16_t(corner));
        faces += raw(std::uint16_t(7));
        users += raw(std::uint16_t(f));
    }
    const std::string red = chunk(0xA020, chunk(0x0011, "\xff" + std::string(2, '\0')));
    const std::string mesh = chunk(0x4110, vertices) + chunk(0x4120, faces + chunk(0x4130, users));
    const std::string node = chunk(0xB010, object + '\0' + raw(std::uint32_t(0)) + raw(std::int16_t(-1)));
    return chunk(0x4D4D, chunk(0x3D3D, chunk(0xAFFF, chunk(0xA000, material + '\0') + red) +
                                           chunk(0x4000, object + '\0' + chunk(0x4100, mesh))) +
                             chunk(0xB000, chunk(0xB002, node)));
}

std::string asDae(const std::string& unit) {
    const auto material = [](const std::string& name, const std::string& colour) {
        return "<effect id='" + name + "-fx'><profile_COMMON><technique sid='c'><lambert><diffuse><color>" +
               colour + " 1</color></diffuse></lambert></technique></profile_COMMON></effect>";
    };
    return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
           "version='1.4.1'>"
           "<asset>" +
           unit + "<up_axis>Y_UP</up_axis></asset><library_effects>" + material("red", "1 0 0") +
           material("blue", "0 0 1") +
           "</library_effects><library_materials>"
           "<material id='red' name='red'><instance_effect url='#red-fx'/></material>"
           "<material id='blue' name='blue'><instance_effect url='#blue-fx'/></material></library_materials>"
           "<library_geometries><geometry id='g' name='g'><mesh>"
           "<source id='p'><float_array id='pa' count='15'>0 0 0 1 0 0 1 1 0 0 1 0 0 0 1</float_array>"
           "<technique_common><accessor source='#pa' count='5' stride='3'><param name='X' type='float'/>"
           "<param name='Y' type='float'/><param name='Z' "
           "type='float'/></accessor></technique_common></source>"
           "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
           "<polylist material='m1' count='1'><input semantic='VERTEX' source='#v' "
           "offset='0'/><vcount>4</vcount>"
           "<p>0 1 2 3</p></polylist>"
           "<triangles material='m2' count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 "
           "4</p></triangles>"
           "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='s'>"
           "<node id='n' name='plate'><scale>-2 1 1</scale><instance_geometry url='#g'><bind_material>"
           "<technique_common><instance_material symbol='m1' target='#red'/><instance_material symbol='m2' "
           "target='#blue'/></technique_common></bind_material></instance_geometry></node></visual_scene>"
           "</library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

std::string asFbx(double centimetres, const FbxWords& words) {
    const auto axis = [](const std::string& name, int number, int sign) {
        return "  P: \"" + name + "Axis\", \"int\", \"Integer\", \"\"," + std::to_string(number) +
               "\n  P: \"" + name + "AxisSign\", \"int\", \"Integer\", \"\"," + std::to_string(sign) + "\n";
    };
    const auto square = [](const std::string& number) {
        return " Geometry: " + number +
               ", \"Geometry::shape\", \"Mesh\" {\n"
               "  Vertices: *12 {\n   a: 0,0,0,1,0,0,1,1,0,0,1,0\n  }\n"
               "  PolygonVertexIndex: *4 {\n   a: 0,1,2,-4\n  }\n  GeometryVersion: 124\n"
               "  LayerElementMaterial: 0 {\n   Version: 101\n   Name: \"\"\n   MappingInformationType: "
               "\"AllSame\"\n"
               "   ReferenceInformationType: \"IndexToDirect\"\n   Materials: *1 {\n    a: 0\n   }\n  }\n"
               "  Layer: 0 {\n   Version: 100\n   LayerElement:  {\n    Type: \"LayerElementMaterial\"\n"
               "    TypedIndex: 0\n   }\n  }\n }\n";
    };
    const auto node = [](const std::string& number, const std::string& name, const std::string& properties) {
        return " Model: " + number + ", \"Model::" + name +
               "\", \"Mesh\" {\n  Version: 232\n  Properties70:  {\n" + properties + "  }\n }\n";
    };
    const bool two = !words.child.empty();
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
           "GlobalSettings:  {\n Version: 1000\n Properties70:  {\n" +
           axis("Up", words.up, words.upSign) + axis("Front", words.front, words.frontSign) +
           axis("Coord", words.side, words.sideSign) +
           "  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," + std::to_string(centimetres) +
           "\n }\n}\nObjects:  {\n" + square("1000") +
           node("2000", "plate",
                "   P: \"Lcl Translation\", \"Lcl Translation\", \"\", \"A\",0,0,5\n" + words.node) +
           (two ? square("1001") + node("2001", "lid", words.child) : "") +
           " Material: 3000, \"Material::red\", \"\" {\n  Version: 102\n  ShadingModel: \"lambert\"\n"
           "  Properties70:  {\n   P: \"DiffuseColor\", \"Color\", \"\", \"A\",1,0,0\n  }\n }\n}\n"
           "Connections:  {\n C: \"OO\",2000,0\n C: \"OO\",1000,2000\n C: \"OO\",3000,2000\n" +
           (two ? " C: \"OO\",2001,2000\n C: \"OO\",1001,2001\n C: \"OO\",3000,2001\n" : "") + "}\n";
}

std::string threeMfModel(const std::string& resources, const std::string& build, const std::string& head) {
    return "<?xml version='1.0'?>\n<model " + head +
           " xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'>\n<resources>" + resources +
           "</resources>\n<build>" + build + "</build></model>";
}

std::string as3mf(const std::string& model, std::vector<ZipEntry> more) {
    std::vector<ZipEntry> entries{
        {"_rels/.rels",
         "<?xml version='1.0'?><Relationships "
         "xmlns='http://schemas.openxmlformats.org/package/2006/relationships'>"
         "<Relationship Target='/Metadata/thumbnail.png' Id='t' Type='http://schemas.openxmlformats.org/"
         "package/2006/relationships/metadata/thumbnail'/><Relationship Target='/3D/3dmodel.model' Id='r' "
         "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>"},
        {"3D/3dmodel.model", model}};
    for (ZipEntry& each : more)
        entries.push_back(std::move(each));
    return writeZip(entries);
}

} // namespace tactum
