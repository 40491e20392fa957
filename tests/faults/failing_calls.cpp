// SPDX-License-Identifier: GPL-3.0-or-later
// A library to preload: it makes calls of the system fail, or kills or interrupts the process
// there. It counts from the first statement of main on.
//
//   ENDMILL_FAULT=CALL:N:EFFECT   the N-th call of CALL, from 1; N+ is the N-th and all later.
//                                 EFFECT is the number of an error, "kill", or "term": the
//                                 call succeeds and returns 30 ms after a SIGTERM.
//   ENDMILL_FAULT_ALONE=1         programs that it starts are without the fault.
//   ENDMILL_FAULT_COUNTS=FILE     writes how often each call was made, as "CALL COUNT" lines.
//
// The call "memory" stands for malloc, calloc, realloc, aligned_alloc and posix_memalign.
//
// Not caught are calls of other names: pread, pwrite, writev, close, ftruncate, fstat, lstat,
// renameat, mkdirat, readdir, mmap and sbrk, and system calls without a function of the C
// library. Neither are calls that the C library makes inside itself, such as the open and the
// write of fopen, fprintf and fflush, and the mmap of malloc. A call before main or after its
// end always succeeds. EFFECT "term" needs open, mkdir or rename.

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

extern "C" {
void* __libc_malloc(std::size_t);                 // NOLINT
void* __libc_calloc(std::size_t, std::size_t);    // NOLINT
void* __libc_realloc(void*, std::size_t);         // NOLINT
void* __libc_memalign(std::size_t, std::size_t);  // NOLINT
}

namespace {

enum Call {
    Open,
    Mkdir,
    Rename,
    Unlink,
    Rmdir,
    Write,
    Read,
    Sync,
    Mode,
    Lock,
    List,
    Thread,
    Memory,
    Calls
};
constexpr const char* names[Calls] = {"open",    "mkdir",  "rename", "unlink", "rmdir",
                                      "write",   "read",   "fsync",  "fchmod", "flock",
                                      "opendir", "thread", "memory"};

std::atomic<bool> is_on = false;
std::atomic<long> counts[Calls];
int faulty = -1;
long first = 0;
bool and_later = false;
int error_number = 0;  // 0: a signal
bool interrupts = false;
thread_local bool is_interrupting = false;

bool fails(Call call)
{
    if (!is_on)
        return false;
    const long number = ++counts[call];
    if (call != faulty || number < first || (number > first && !and_later))
        return false;
    if (interrupts) {
        is_interrupting = true;
        return false;
    }
    if (error_number == 0)
        ::kill(::getpid(), SIGKILL);
    errno = error_number;
    return true;
}

// The result of a call that was made.
int made(int result)
{
    if (is_interrupting) {
        is_interrupting = false;
        ::kill(::getpid(), SIGTERM);
        ::usleep(30'000);
    }
    return result;
}

void read_settings()
{
    const char* setting = std::getenv("ENDMILL_FAULT");
    char name[16] = {};
    char effect[16] = {};
    char plus[2] = {};
    if (!setting)
        return;
    if (std::sscanf(setting, "%15[a-z]:%ld:%15s", name, &first, effect) != 3 &&
        std::sscanf(setting, "%15[a-z]:%ld%1[+]:%15s", name, &first, plus, effect) != 4) {
        std::fprintf(stderr, "ENDMILL_FAULT=%s: expected CALL:N:EFFECT\n", setting);
        std::abort();
    }
    and_later = plus[0] == '+';
    for (int call = 0; call < Calls; ++call)
        if (std::strcmp(names[call], name) == 0)
            faulty = call;
    if (faulty < 0)
        std::abort();
    error_number = std::atoi(effect);
    interrupts = std::strcmp(effect, "term") == 0;
    if (std::getenv("ENDMILL_FAULT_ALONE"))
        ::unsetenv("ENDMILL_FAULT");
}

void write_counts()
{
    const char* file = std::getenv("ENDMILL_FAULT_COUNTS");
    std::FILE* out = file ? std::fopen(file, "w") : nullptr;
    if (!out)
        return;
    for (int call = 0; call < Calls; ++call)
        std::fprintf(out, "%s %ld\n", names[call], counts[call].load());
    std::fclose(out);
}

template <typename Function>
Function* real(const char* name)
{
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

using Main = int (*)(int, char**, char**);
Main real_main = nullptr;

int counted_main(int argc, char** argv, char** environment)
{
    read_settings();
    is_on = true;
    const int status = real_main(argc, argv, environment);
    is_on = false;
    write_counts();
    return status;
}

mode_t mode_of(int flags, std::va_list& rest)
{
    return (flags & O_CREAT) != 0 ? static_cast<mode_t>(va_arg(rest, int)) : 0;
}

}  // namespace

extern "C" {

// The C library fixes name and parameters.
// NOLINTNEXTLINE(bugprone-*, readability-*)
int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end)
{
    real_main = main;
    return real<int(Main, int, char**, void (*)(), void (*)(), void (*)(), void*)>(
        "__libc_start_main")(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

int open(const char* path, int flags, ...)
{
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return fails(Open)
               ? -1
               : made(real<int(const char*, int, ...)>("open")(path, flags, mode));
}

int openat(int folder, const char* path, int flags, ...)
{
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = mode_of(flags, rest);
    va_end(rest);
    return fails(Open) ? -1
                       : real<int(int, const char*, int, ...)>("openat")(folder, path,
                                                                         flags, mode);
}

int mkdir(const char* path, mode_t mode) noexcept
{
    return fails(Mkdir) ? -1 : made(real<int(const char*, mode_t)>("mkdir")(path, mode));
}

int rename(const char* from, const char* to) noexcept
{
    return fails(Rename) ? -1
                         : made(real<int(const char*, const char*)>("rename")(from, to));
}

int unlink(const char* path) noexcept
{
    return fails(Unlink) ? -1 : real<int(const char*)>("unlink")(path);
}

int unlinkat(int folder, const char* path, int flags) noexcept
{
    return fails(Unlink)
               ? -1
               : real<int(int, const char*, int)>("unlinkat")(folder, path, flags);
}

int rmdir(const char* path) noexcept
{
    return fails(Rmdir) ? -1 : real<int(const char*)>("rmdir")(path);
}

ssize_t write(int file, const void* bytes, std::size_t count)
{
    return fails(Write) ? -1
                        : real<ssize_t(int, const void*, std::size_t)>("write")(
                              file, bytes, count);
}

ssize_t read(int file, void* bytes, std::size_t count)
{
    return fails(Read)
               ? -1
               : real<ssize_t(int, void*, std::size_t)>("read")(file, bytes, count);
}

int fsync(int file)
{
    return fails(Sync) ? -1 : real<int(int)>("fsync")(file);
}

int fchmod(int file, mode_t mode) noexcept
{
    return fails(Mode) ? -1 : real<int(int, mode_t)>("fchmod")(file, mode);
}

int flock(int file, int operation) noexcept
{
    return fails(Lock) ? -1 : real<int(int, int)>("flock")(file, operation);
}

DIR* opendir(const char* path)
{
    return fails(List) ? nullptr : real<DIR*(const char*)>("opendir")(path);
}

DIR* fdopendir(int folder)
{
    return fails(List) ? nullptr : real<DIR*(int)>("fdopendir")(folder);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                   void* (*start)(void*), void* argument) noexcept
{
    if (fails(Thread))
        return errno;
    return real<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>(
        "pthread_create")(thread, attributes, start, argument);
}

void* malloc(std::size_t size) noexcept
{
    return fails(Memory) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept
{
    return fails(Memory) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept
{
    return fails(Memory) ? nullptr : __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
{
    return fails(Memory) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept
{
    if (fails(Memory))
        return errno;
    *memory = __libc_memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
}

}  // extern "C"
