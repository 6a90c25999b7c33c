#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/together.h>
#include <magmpm/results/surface_output.h>
#include <magmpm/surface/body_volume.h>

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStripper.h>
#include <vtkWindowedSincPolyDataFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Where half of the lattice is full, within a slab of the box; triangles or lines. */
    template <int dim>
    vtkSmartPointer<vtkPolyData>
    contour(const NodeBox<dim> &slab, const NodeBox<dim> &box, const Lattice<dim> &lattice)
    {
      // Points are counted from the corner of the box, so that slabs agree on where they are.
      int extent[6]        = {};
      double corner[3]     = {0., 0., 0.};
      const Vector<dim> at = lattice.node_position(box.first);
      for (int d = 0; d < dim; ++d)
        {
          extent[2 * d]     = slab.first[d] - box.first[d];
          extent[2 * d + 1] = extent[2 * d] + slab.count[d] - 1;
          corner[d]         = at[d];
        }
      vtkNew<vtkImageData> image;
      image->SetExtent(extent);
      image->SetOrigin(corner);
      image->SetSpacing(lattice.spacing, lattice.spacing, lattice.spacing);
      vtkNew<vtkDoubleArray> values;
      values->SetNumberOfValues(slab.values.size());
      std::copy(slab.values.begin(), slab.values.end(), values->GetPointer(0));
      image->GetPointData()->SetScalars(values);

      vtkNew<vtkContourFilter> contour;
      contour->SetInputData(image);
      contour->SetValue(0, 0.5);
      contour->ComputeScalarsOff();
      contour->ComputeNormalsOff();
      contour->Update();
      return contour->GetOutput();
    }

    /** The contours of all slabs as one: points in which they meet become one. */
    vtkSmartPointer<vtkPolyData>
    joined(vtkAppendPolyData *contours)
    {
      vtkNew<vtkCleanPolyData> clean; // triangles of a contour through a node have no area
      clean->SetInputConnection(contours->GetOutputPort());
      clean->SetTolerance(0.);
      clean->ConvertPolysToLinesOff();
      clean->Update();
      return clean->GetOutput();
    }

    /** Without the steps that the lattice leaves. */
    template <int dim>
    vtkSmartPointer<vtkPolyData>
    smoothed(vtkPolyData *surface)
    {
      vtkNew<vtkStripper> lines; // a line is smoothed between its ends, so segments are joined
      lines->SetInputData(surface);
      lines->JoinContiguousSegmentsOn();
      vtkNew<vtkWindowedSincPolyDataFilter> smooth;
      if (dim == 2)
        smooth->SetInputConnection(lines->GetOutputPort());
      else
        smooth->SetInputData(surface);
      smooth->SetNumberOfIterations(20);
      smooth->SetPassBand(0.1);
      smooth->NormalizeCoordinatesOn();
      smooth->Update();
      return smooth->GetOutput();
    }

    /** The surface of a body, with its number on all cells. */
    template <int dim>
    vtkSmartPointer<vtkPolyData>
    surface_of(vtkAppendPolyData *contours, const std::size_t body)
    {
      vtkSmartPointer<vtkPolyData> surface = joined(contours);
      if (surface->GetNumberOfCells() > 0)
        surface = smoothed<dim>(surface);
      vtkNew<vtkFloatArray> number;
      number->SetName("body [-]");
      number->SetNumberOfValues(surface->GetNumberOfCells());
      number->Fill(static_cast<double>(body));
      surface->GetPointData()->Initialize();
      surface->GetCellData()->Initialize();
      surface->GetCellData()->AddArray(number);
      return surface;
    }

    bool
    write(vtkPolyData *surface, const std::string &path)
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetFileName(path.c_str());
      writer->SetInputData(surface);
      writer->SetDataModeToAppended();
      writer->EncodeAppendedDataOff();
      return writer->Write() == 1;
    }
  } // namespace

  template <int dim>
  SurfaceOutput<dim>::SurfaceOutput(const MPI_Comm communicator,
                                    const std::string &directory,
                                    const Lattice<dim> &lattice,
                                    const std::size_t n_nodes_at_once)
    : communicator(communicator)
    , lattice(lattice)
    , n_nodes_at_once(n_nodes_at_once)
    , series(communicator, directory, surface_frames)
  {
    series.make_folder();
  }

  template <int dim>
  void
  SurfaceOutput<dim>::write_frame(const unsigned int frame,
                                  const double time,
                                  const std::vector<Body<dim>> &bodies)
  {
    vtkNew<vtkAppendPolyData> all;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        const BodyVolume<dim> volume(bodies[b], lattice, communicator);
        vtkNew<vtkAppendPolyData> contours;
        volume.for_each_slab(
          [&](const NodeBox<dim> &slab) {
            contours->AddInputData(contour(slab, volume.box(), lattice));
          },
          n_nodes_at_once);
        if (contours->GetNumberOfInputConnections(0) > 0)
          all->AddInputData(surface_of<dim>(contours, b));
      }

    const std::string file = frame_name(series.name(), frame) + ".vtp";
    const std::string path = series.folder() + "/" + file;
    parallel::on_first_rank(communicator, [&]() {
      vtkSmartPointer<vtkPolyData> surface = vtkSmartPointer<vtkPolyData>::New();
      surface->SetPoints(vtkNew<vtkPoints>()); // none, but readers want to see them
      if (all->GetNumberOfInputConnections(0) > 0)
        {
          all->Update();
          surface = all->GetOutput();
        }
      if (!write(surface, path))
        throw RunError("The surface '" + path +
                       "' cannot be written. Is the disk full, or the output directory gone?");
    });
    series.add(time, file);
  }

  template class SurfaceOutput<2>;
  template class SurfaceOutput<3>;
} // namespace magmpm
