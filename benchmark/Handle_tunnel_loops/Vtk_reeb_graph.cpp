#include "Vtk_reeb_graph.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataToReebGraphFilter.h>
#include <vtkReebGraph.h>

#include <chrono>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * static_cast<double>(usage.ru_maxrss);
}

Vtk_result run(vtkPolyData* mesh) {
  Vtk_result result;
  const double before = peak_bytes();
  const auto began = std::chrono::steady_clock::now();
  vtkNew<vtkPolyDataToReebGraphFilter> filter;
  filter->SetInputData(mesh);
  filter->SetFieldId(0);
  filter->Update();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  result.bytes = peak_bytes() - before;
  result.nodes = filter->GetOutput()->GetNumberOfVertices();
  result.arcs = filter->GetOutput()->GetNumberOfEdges();
  result.is_done = true;
  return result;
}

} // namespace

// The peak of a process does not go down again; so there is a new one for each run.
Vtk_result vtk_reeb_graph(const std::vector<std::array<double, 3>>& points,
                          const std::vector<std::array<std::uint32_t, 3>>& triangles,
                          const std::vector<double>& function,
                          unsigned limit) {
  int ends[2];
  if(pipe(ends) != 0)
    return {};
  const pid_t child = fork();
  if(child == 0) {
    alarm(limit);
    vtkNew<vtkPoints> vtk_points;
    vtk_points->SetDataTypeToDouble();
    for(const auto& p : points)
      vtk_points->InsertNextPoint(p.data());
    vtkNew<vtkCellArray> cells;
    for(const auto& t : triangles)
      cells->InsertNextCell({vtkIdType(t[0]), vtkIdType(t[1]), vtkIdType(t[2])});
    vtkNew<vtkDoubleArray> values;
    for(double value : function)
      values->InsertNextValue(value);
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(vtk_points);
    mesh->SetPolys(cells);
    mesh->GetPointData()->AddArray(values);
    const Vtk_result result = run(mesh);
    const bool is_sent = write(ends[1], &result, sizeof(result)) == sizeof(result);
    _exit(is_sent ? 0 : 1);
  }
  close(ends[1]);
  Vtk_result result;
  if(child < 0 || read(ends[0], &result, sizeof(result)) != sizeof(result))
    result = {};
  close(ends[0]);
  if(child > 0)
    waitpid(child, nullptr, 0);
  return result;
}
