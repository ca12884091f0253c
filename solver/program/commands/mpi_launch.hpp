// What mpirun or srun says of the processes that it has started, before MPI does.
#pragma once

namespace stationary::cli {

/// The rank that this process will have; 0 where neither started it.
int coming_rank();

/// Throws InputError where MPI, which sees this process alone, was to see others too: each of them would
/// do all of the work and write the same table.
void require_alone();

/// While it lives this process says nothing: every rank reads the same arguments and the same case, and
/// what is wrong with them is said once.
class HeldMessages {
 public:
  HeldMessages();
  HeldMessages(const HeldMessages&) = delete;
  HeldMessages& operator=(const HeldMessages&) = delete;
  ~HeldMessages();

  /// Says on standard error what was said since, with the rank's number.
  void tell(int rank) const;

 private:
  int error_ = -1;  ///< the standard error that there was
  int said_ = -1;   ///< end of a pipe; what does not fit in is lost
};

}  // namespace stationary::cli
