#include "ui/view/poly_arrays.h"

#include <algorithm>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTypeInt32Array.h>

namespace tactum {

vtkSmartPointer<vtkFloatArray> vectorArray(const std::vector<float>& values) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(vtkIdType(values.size() / 3));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

vtkSmartPointer<vtkCellArray> cellArray(const std::vector<int>& corners, int each) {
    vtkNew<vtkTypeInt32Array> offsets, connectivity;
    offsets->SetNumberOfValues(vtkIdType(corners.size()) / each + 1);
    for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
        offsets->SetValue(i, int(i) * each);
    connectivity->SetNumberOfValues(vtkIdType(corners.size()));
    std::copy(corners.begin(), corners.end(), connectivity->GetPointer(0));
    auto array = vtkSmartPointer<vtkCellArray>::New();
    array->SetData(offsets, connectivity);
    return array;
}

vtkSmartPointer<vtkPolyData> corneredMesh(vtkPolyData& mesh) {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    std::vector<float> positions, normals;
    vtkDataArray* normalOf = mesh.GetPointData()->GetNormals();
    const auto append = [](std::vector<float>& to, vtkDataArray& from, vtkIdType vertex) {
        for (int k = 0; k < 3; ++k)
            to.push_back(float(from.GetComponent(vertex, k)));
    };
    const auto ownCells = [&](vtkCellArray* cells, int each) {
        std::vector<int> corners;
        vtkIdType count = 0;
        const vtkIdType* vertices = nullptr;
        for (cells->InitTraversal(); cells->GetNextCell(count, vertices);)
            for (vtkIdType i = 0; i < count; ++i) {
                corners.push_back(int(positions.size() / 3));
                append(positions, *mesh.GetPoints()->GetData(), vertices[i]);
                if (normalOf) append(normals, *normalOf, vertices[i]);
            }
        return cellArray(corners, each);
    };
    result->SetPolys(ownCells(mesh.GetPolys(), 3));
    if (mesh.GetNumberOfLines() > 0) result->SetLines(ownCells(mesh.GetLines(), 2));
    if (mesh.GetNumberOfVerts() > 0) result->SetVerts(ownCells(mesh.GetVerts(), 1));
    vtkNew<vtkPoints> points;
    points->SetData(vectorArray(positions));
    result->SetPoints(points);
    if (normalOf) result->GetPointData()->SetNormals(vectorArray(normals));
    return result;
}

} // namespace tactum
