// The schema in the documentation is that of this program.
#include <fstream>
#include <iterator>

#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/core/files/format_schema.h"
#include "tests/support/test_program.h"

namespace test_format_schema {

class TestFormatSchema : public QObject {
    Q_OBJECT

private slots:
    void theDocumentedSchemaIsTheProgrammed() {
        std::ifstream in(TACTUM_SCHEMA);
        const std::string documented(std::istreambuf_iterator<char>(in), {});
        QVERIFY2(documented == tactum::formatSchema(),
                 "run make-schema docs/schema/TACTUM_haptics.schema.json");
    }

    // A schema of definitions alone would find every file right.
    void everyPlaceOfTheExtensionIsHeldAgainstIt() {
        const auto schema = nlohmann::json::parse(tactum::formatSchema());
        const auto at = [&](const char* path) {
            const nlohmann::json::json_pointer place(std::string(path) + "/properties/extensions/properties/"
                                                                         "TACTUM_haptics/$ref");
            return schema.contains(place) ? schema[place].get<std::string>() : std::string();
        };
        QCOMPARE(at(""), std::string("#/$defs/root"));
        QCOMPARE(at("/properties/materials/items"), std::string("#/$defs/material"));
        QCOMPARE(at("/properties/meshes/items"), std::string("#/$defs/mesh"));
        QCOMPARE(at("/properties/nodes/items"), std::string("#/$defs/node"));
        for (const char* name : {"root", "material", "mesh", "node"})
            QVERIFY2(schema["$defs"].contains(name), name);
    }
};

TACTUM_TEST(TestFormatSchema)

} // namespace test_format_schema

#include "test_format_schema.moc"
