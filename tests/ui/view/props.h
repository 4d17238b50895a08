// What stands in a renderer, as text: a line for each actor with how it is drawn, where, and of what.
#pragma once

#include <QString>
#include <QStringList>

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace tactum::testing {

inline QString numbersOf(const double* values, int count, int digits = 4) {
    QStringList texts;
    for (int i = 0; i < count; ++i) {
        const QString text = QString::number(values[i], 'g', digits);
        texts << (std::abs(values[i]) < 1e-12 ? QStringLiteral("0") : text);
    }
    return u'(' + texts.join(u' ') + u')';
}

/// How it is drawn, where, and of what.
inline QString propOf(vtkActor& actor) {
    vtkProperty* how = actor.GetProperty();
    QString line = QStringLiteral("colour %1 glow %2 opacity %3")
                       .arg(numbersOf(how->GetDiffuseColor(), 3), numbersOf(how->GetAmbientColor(), 3))
                       .arg(how->GetOpacity(), 0, 'g', 3);
    if (how->GetLineWidth() != 1) line += QStringLiteral(" line %1").arg(how->GetLineWidth());
    if (how->GetPointSize() != 1) line += QStringLiteral(" point %1").arg(how->GetPointSize());
    if (how->GetRenderPointsAsSpheres()) line += QStringLiteral(" as spheres");
    if (!how->GetLighting()) line += QStringLiteral(" unlit");
    if (how->GetBackfaceCulling()) line += QStringLiteral(" front faces");
    if (actor.GetForceOpaque()) line += QStringLiteral(" opaque");
    if (actor.GetForceTranslucent()) line += QStringLiteral(" translucent");
    if (!actor.GetPickable()) line += QStringLiteral(" not picked");
    if (vtkMatrix4x4* matrix = actor.GetUserMatrix())
        for (int row = 0; row < 3; ++row)
            line += (row ? QStringLiteral("") : QStringLiteral(" at ")) + numbersOf(matrix->Element[row], 4);
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
    if (!mapper) return line;
    mapper->Update();
    if (vtkPolyData* data = mapper->GetInput()) {
        double box[6];
        data->GetBounds(box);
        line += QStringLiteral(" of %1 points, %2 lines, %3 polygons, %4 dots")
                    .arg(data->GetNumberOfPoints())
                    .arg(data->GetNumberOfLines())
                    .arg(data->GetNumberOfPolys())
                    .arg(data->GetNumberOfVerts());
        if (data->GetNumberOfPoints() > 0) line += QStringLiteral(" in ") + numbersOf(box, 6);
    }
    if (mapper->GetResolveCoincidentTopology() == VTK_RESOLVE_POLYGON_OFFSET)
        line += QStringLiteral(" before what it lies on");
    return line;
}

/// Of hidden ones nothing but that they are hidden.
inline QString propsOf(vtkRenderer& renderer) {
    QStringList lines;
    vtkActorCollection* actors = renderer.GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
        lines << (actor->GetVisibility() ? propOf(*actor) : QStringLiteral("hidden"));
    return lines.join(u'\n') + u'\n';
}

} // namespace tactum::testing
