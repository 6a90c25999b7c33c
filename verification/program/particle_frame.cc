#include <verification/program/particle_frame.h>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace magmpm::verification
{
  namespace
  {
    /** The value of an attribute in a line of XML, or "". */
    std::string
    attribute(const std::string &line, const std::string &name)
    {
      const std::string opening = name + "=\"";
      const auto begin          = line.find(opening);
      if (begin == std::string::npos)
        return "";
      const auto value = begin + opening.size();
      return line.substr(value, line.find('"', value) - value);
    }

    ParticleFrame
    read_frame(const std::string &path, const double time)
    {
      vtkNew<vtkXMLPUnstructuredGridReader> reader;
      reader->SetFileName(path.c_str());
      reader->Update();
      vtkUnstructuredGrid *grid = reader->GetOutput();
      ParticleFrame frame;
      frame.time = time;
      for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
        {
          const double *x = grid->GetPoint(p);
          frame.positions.push_back({{x[0], x[1], x[2]}});
        }
      for (int a = 0; a < grid->GetPointData()->GetNumberOfArrays(); ++a)
        {
          vtkDataArray *array = grid->GetPointData()->GetArray(a);
          auto &values        = frame.quantities[array->GetName()];
          values.resize(frame.size(), std::vector<double>(array->GetNumberOfComponents()));
          for (std::size_t p = 0; p < frame.size(); ++p)
            array->GetTuple(static_cast<vtkIdType>(p), values[p].data());
        }
      return frame;
    }
  } // namespace

  std::vector<ParticleFrame>
  particle_frames(const std::string &folder)
  {
    std::ifstream record(folder + "/particles.pvd");
    if (!record)
      throw std::runtime_error("There is no '" + folder + "/particles.pvd'.");
    std::vector<ParticleFrame> frames;
    for (std::string line; std::getline(record, line);)
      {
        const std::string file = attribute(line, "file");
        if (!file.empty())
          frames.push_back(read_frame(folder + "/" + file,
                                      std::strtod(attribute(line, "timestep").c_str(), nullptr)));
      }
    return frames;
  }

  std::vector<std::vector<std::array<double, 3>>>
  particle_positions(const std::string &folder)
  {
    std::vector<std::vector<std::array<double, 3>>> positions;
    for (ParticleFrame &frame : particle_frames(folder))
      positions.push_back(std::move(frame.positions));
    return positions;
  }
} // namespace magmpm::verification
