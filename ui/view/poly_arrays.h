// Lists of numbers as VTK has them. Private to this folder.
#pragma once

#include <vector>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace tactum {

/// x, y, z of each.
vtkSmartPointer<vtkFloatArray> vectorArray(const std::vector<float>& values);
/// Cells of `each` corners.
vtkSmartPointer<vtkCellArray> cellArray(const std::vector<int>& corners, int each);
/// The same triangles, lines and points, in this order, with vertices that no two of them share.
vtkSmartPointer<vtkPolyData> corneredMesh(vtkPolyData& mesh);

} // namespace tactum
