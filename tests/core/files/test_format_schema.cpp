// The schema in the documentation is that of this program.
#include <fstream>
#include <iterator>

#include <QTest>

#include "tests/core/files/format_schema.h"

class TestFormatSchema : public QObject {
    Q_OBJECT

private slots:
    void theDocumentedSchemaIsTheProgrammed() {
        std::ifstream in(TACTUM_SCHEMA);
        const std::string documented(std::istreambuf_iterator<char>(in), {});
        QVERIFY2(documented == tactum::formatSchema(),
                 "run make-schema docs/schema/TACTUM_haptics.schema.json");
    }
};

QTEST_APPLESS_MAIN(TestFormatSchema)
#include "test_format_schema.moc"
