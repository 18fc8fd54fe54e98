// Lets one call fail: preloaded before the C library and MPI by faults.py.
//
//   IXOS_FAULT=KIND:N        the N-th call of a kind fails, from 1; N = 0 counts only
//   IXOS_FAULT_RANK=R        on this rank only (default 0)
//   IXOS_FAULT_COUNT=FILE    the number of calls goes there at the end
//
// Kinds: open, close, read, write, sync, rename, truncate, remove (of files and folders; errno EIO, and ENOSPC for
// full), short_read, short_write (half of what was asked for), full (every write from the N-th on, ENOSPC), allocate,
// mpi. Calls count between the end of MPI_Init and the beginning of MPI_Finalize. Calls on files count where they are
// regular files, folders, or standard output: sockets and pipes are the launcher's.
#include <dlfcn.h>
#include <fcntl.h>
#include <mpi.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" {
void* __libc_malloc(std::size_t);                 // NOLINT: glibc's names
void* __libc_calloc(std::size_t, std::size_t);    // NOLINT
void* __libc_realloc(void*, std::size_t);         // NOLINT
void* __libc_memalign(std::size_t, std::size_t);  // NOLINT
}

namespace {

std::atomic<bool> armed{false};
std::atomic<long>* calls = nullptr;  ///< shared with the children, so that a call counts once
long wanted = 0;
char kind[32] = "";

void arm() {
  const char *fault = std::getenv("IXOS_FAULT"), *rank = std::getenv("IXOS_FAULT_RANK");
  const char* mine = std::getenv("OMPI_COMM_WORLD_RANK");
  if (fault == nullptr || std::strcmp(rank == nullptr ? "0" : rank, mine == nullptr ? "0" : mine) != 0) return;
  if (std::sscanf(fault, "%31[^:]:%ld", kind, &wanted) != 2) return;
  void* shared = mmap(nullptr, sizeof(*calls), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return;
  calls = new (shared) std::atomic<long>(0);
  armed = true;
}

void disarm() {
  if (!armed.exchange(false)) return;
  const char* path = std::getenv("IXOS_FAULT_COUNT");
  if (path == nullptr) return;
  if (FILE* file = std::fopen(path, "w")) {
    std::fprintf(file, "%ld\n", calls->load());
    std::fclose(file);
  }
}

bool is(const char* name) { return std::strcmp(kind, name) == 0; }

/// Counts a call of that kind; whether it is the one that fails.
bool strikes(const char* name) {
  if (!armed || !is(name)) return false;
  return ++*calls == wanted;
}

bool counts(int descriptor) {
  if (!armed) return false;
  if (descriptor == STDOUT_FILENO) return true;
  struct stat status {};
  return fstat(descriptor, &status) == 0 && (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode));
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int failed(int error) {
  errno = error;
  return -1;
}

/// A write fails, writes a half, or meets a full disk.
template <class Call>
ssize_t disturbed_write(int descriptor, std::size_t size, const Call& call) {
  if (counts(descriptor)) {
    if (strikes("write")) return failed(EIO);
    if (size > 1 && strikes("short_write")) return call(size / 2);
    if (armed && is("full") && ++*calls >= wanted && wanted > 0) return failed(ENOSPC);
  }
  return call(size);
}
template <class Call>
ssize_t disturbed_read(int descriptor, std::size_t size, const Call& call) {
  if (descriptor != STDOUT_FILENO && counts(descriptor)) {
    if (strikes("read")) return failed(EIO);
    if (size > 1 && strikes("short_read")) return call(size / 2);
  }
  return call(size);
}
template <class Call>
int disturbed(const char* name, bool counted, const Call& call) {
  if (counted && strikes(name)) return failed(EIO);
  return call();
}

/// What an MPI that fails does: it calls the communicator's handler.
int mpi_failure(MPI_Comm communicator) {
  armed = false;  // the handler may call MPI
  MPI_Comm_call_errhandler(communicator, MPI_ERR_OTHER);
  return MPI_ERR_OTHER;
}

}  // namespace

extern "C" {

// ---- files

int open(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = va_arg(list, mode_t);
  va_end(list);
  return disturbed("open", armed, [&] { return next<int (*)(const char*, int, ...)>("open")(path, flags, mode); });
}
int open64(const char* path, int flags, ...) {
  va_list list;
  va_start(list, flags);
  const mode_t mode = va_arg(list, mode_t);
  va_end(list);
  return disturbed("open", armed, [&] { return next<int (*)(const char*, int, ...)>("open64")(path, flags, mode); });
}
FILE* fopen(const char* path, const char* mode) {
  if (strikes("open")) {
    errno = EIO;
    return nullptr;
  }
  return next<FILE* (*)(const char*, const char*)>("fopen")(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  if (strikes("open")) {
    errno = EIO;
    return nullptr;
  }
  return next<FILE* (*)(const char*, const char*)>("fopen64")(path, mode);
}
int close(int descriptor) {
  const bool fails = counts(descriptor) && strikes("close");
  const int status = next<int (*)(int)>("close")(descriptor);
  return fails ? failed(EIO) : status;
}
ssize_t write(int descriptor, const void* data, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  return disturbed_write(descriptor, size, [&](std::size_t part) { return real(descriptor, data, part); });
}
ssize_t pwrite(int descriptor, const void* data, std::size_t size, off_t position) {
  static const auto real = next<ssize_t (*)(int, const void*, std::size_t, off_t)>("pwrite");
  return disturbed_write(descriptor, size, [&](std::size_t part) { return real(descriptor, data, part, position); });
}
ssize_t pwrite64(int descriptor, const void* data, std::size_t size, off64_t position) {
  return pwrite(descriptor, data, size, position);
}
ssize_t read(int descriptor, void* data, std::size_t size) {
  static const auto real = next<ssize_t (*)(int, void*, std::size_t)>("read");
  return disturbed_read(descriptor, size, [&](std::size_t part) { return real(descriptor, data, part); });
}
ssize_t pread(int descriptor, void* data, std::size_t size, off_t position) {
  static const auto real = next<ssize_t (*)(int, void*, std::size_t, off_t)>("pread");
  return disturbed_read(descriptor, size, [&](std::size_t part) { return real(descriptor, data, part, position); });
}
ssize_t pread64(int descriptor, void* data, std::size_t size, off64_t position) {
  return pread(descriptor, data, size, position);
}
int fsync(int descriptor) {
  return disturbed("sync", counts(descriptor), [&] { return next<int (*)(int)>("fsync")(descriptor); });
}
int fdatasync(int descriptor) {
  return disturbed("sync", counts(descriptor), [&] { return next<int (*)(int)>("fdatasync")(descriptor); });
}
int ftruncate(int descriptor, off_t length) {
  return disturbed("truncate", counts(descriptor),
                   [&] { return next<int (*)(int, off_t)>("ftruncate")(descriptor, length); });
}
int ftruncate64(int descriptor, off64_t length) { return ftruncate(descriptor, length); }
int truncate(const char* path, off_t length) {
  return disturbed("truncate", armed, [&] { return next<int (*)(const char*, off_t)>("truncate")(path, length); });
}
int fallocate(int descriptor, int mode, off_t offset, off_t length) {
  return disturbed("truncate", counts(descriptor), [&] {
    return next<int (*)(int, int, off_t, off_t)>("fallocate")(descriptor, mode, offset, length);
  });
}
int fallocate64(int descriptor, int mode, off64_t offset, off64_t length) {
  return fallocate(descriptor, mode, offset, length);
}
int rename(const char* from, const char* to) {
  return disturbed("rename", armed, [&] { return next<int (*)(const char*, const char*)>("rename")(from, to); });
}
int symlink(const char* target, const char* path) {
  return disturbed("rename", armed, [&] { return next<int (*)(const char*, const char*)>("symlink")(target, path); });
}
int unlink(const char* path) {
  return disturbed("remove", armed, [&] { return next<int (*)(const char*)>("unlink")(path); });
}
int remove(const char* path) {
  return disturbed("remove", armed, [&] { return next<int (*)(const char*)>("remove")(path); });
}
int mkdir(const char* path, mode_t mode) {
  return disturbed("remove", armed, [&] { return next<int (*)(const char*, mode_t)>("mkdir")(path, mode); });
}

// ---- memory

void* malloc(std::size_t size) {
  if (strikes("allocate")) return errno = ENOMEM, nullptr;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  if (strikes("allocate")) return errno = ENOMEM, nullptr;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  if (strikes("allocate")) return errno = ENOMEM, nullptr;
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  if (strikes("allocate")) return errno = ENOMEM, nullptr;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr && size > 0 ? ENOMEM : 0;
}

// ---- MPI

int MPI_Init(int* argc, char*** argv) {
  const int status = PMPI_Init(argc, argv);
  arm();
  return status;
}
int MPI_Init_thread(int* argc, char*** argv, int required, int* provided) {
  const int status = PMPI_Init_thread(argc, argv, required, provided);
  arm();
  return status;
}
int MPI_Finalize() {
  disarm();
  return PMPI_Finalize();
}
int MPI_Abort(MPI_Comm communicator, int status) {
  disarm();
  return PMPI_Abort(communicator, status);
}

#define IXOS_FAULTY(name, communicator, parameters, arguments) \
  int MPI_##name parameters { return strikes("mpi") ? mpi_failure(communicator) : PMPI_##name arguments; }
IXOS_FAULTY(Allreduce, c, (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c), (a, b, n, t, o, c))
IXOS_FAULTY(Reduce, c, (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, int r, MPI_Comm c),
            (a, b, n, t, o, r, c))
IXOS_FAULTY(Scan, c, (const void* a, void* b, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c), (a, b, n, t, o, c))
IXOS_FAULTY(Bcast, c, (void* a, int n, MPI_Datatype t, int r, MPI_Comm c), (a, n, t, r, c))
IXOS_FAULTY(Barrier, c, (MPI_Comm c), (c))
IXOS_FAULTY(Allgather, c, (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, MPI_Comm c),
            (a, n, t, b, m, u, c))
IXOS_FAULTY(Gather, c, (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, int r, MPI_Comm c),
            (a, n, t, b, m, u, r, c))
IXOS_FAULTY(Gatherv, c,
            (const void* a, int n, MPI_Datatype t, void* b, const int m[], const int d[], MPI_Datatype u, int r,
             MPI_Comm c),
            (a, n, t, b, m, d, u, r, c))
IXOS_FAULTY(Scatterv, c,
            (const void* a, const int m[], const int d[], MPI_Datatype t, void* b, int n, MPI_Datatype u, int r,
             MPI_Comm c),
            (a, m, d, t, b, n, u, r, c))
IXOS_FAULTY(Alltoall, c, (const void* a, int n, MPI_Datatype t, void* b, int m, MPI_Datatype u, MPI_Comm c),
            (a, n, t, b, m, u, c))
IXOS_FAULTY(Isend, c, (const void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Request* q),
            (a, n, t, r, g, c, q))
IXOS_FAULTY(Irecv, c, (void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Request* q), (a, n, t, r, g, c, q))
IXOS_FAULTY(Send, c, (const void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c), (a, n, t, r, g, c))
IXOS_FAULTY(Recv, c, (void* a, int n, MPI_Datatype t, int r, int g, MPI_Comm c, MPI_Status* s), (a, n, t, r, g, c, s))
IXOS_FAULTY(Comm_dup, c, (MPI_Comm c, MPI_Comm* d), (c, d))
IXOS_FAULTY(Comm_split, c, (MPI_Comm c, int k, int r, MPI_Comm* d), (c, k, r, d))
IXOS_FAULTY(Waitall, MPI_COMM_WORLD, (int n, MPI_Request q[], MPI_Status s[]), (n, q, s))
IXOS_FAULTY(Wait, MPI_COMM_WORLD, (MPI_Request * q, MPI_Status* s), (q, s))

}  // extern "C"
