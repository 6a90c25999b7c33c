#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/together.h>
#include <magmpm/simulation/output_lock.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace magmpm
{
  OutputLock::OutputLock(const MPI_Comm communicator,
                         const std::string &directory,
                         const bool makes_directory)
  {
    if (makes_directory)
      parallel::make_folder(communicator, directory, "the results");
    parallel::on_first_rank(communicator, [&]() {
      descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw InputError("another run is writing its results into '" + directory +
                         "'. Wait for its end, stop it (a file 'stop' in there does so), or choose "
                         "another 'Output directory'.");
    });
  }

  OutputLock::~OutputLock()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }
} // namespace magmpm
