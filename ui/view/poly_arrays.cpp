#include "ui/view/poly_arrays.h"

#include <algorithm>

#include <vtkNew.h>
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

} // namespace tactum
