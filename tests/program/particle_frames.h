#pragma once

#include "program/program.h"

#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPUnstructuredGridReader.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace magmpm::testing
{
  /** Positions of all particles in the frames that particles.pvd of a folder names, by VTK's reader. */
  inline std::vector<std::vector<std::array<double, 3>>>
  particle_frames(const std::string &folder)
  {
    std::vector<std::vector<std::array<double, 3>>> frames;
    std::istringstream record(contents(folder + "/particles.pvd"));
    for (std::string line; std::getline(record, line);)
      {
        const auto place = line.find("file=\"");
        if (place == std::string::npos)
          continue;
        const std::string file = line.substr(place + 6, line.rfind('"') - place - 6);
        vtkNew<vtkXMLPUnstructuredGridReader> reader;
        reader->SetFileName((folder + "/" + file).c_str());
        reader->Update();
        frames.emplace_back();
        for (vtkIdType p = 0; p < reader->GetOutput()->GetNumberOfPoints(); ++p)
          {
            std::array<double, 3> position;
            reader->GetOutput()->GetPoint(p, position.data());
            frames.back().push_back(position);
          }
      }
    return frames;
  }
} // namespace magmpm::testing
