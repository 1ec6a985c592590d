// Large blocks of memory come in large pages, where the system has them to give: grids, meshes and models of millions
// of samples are made anew in every step, and filling them by pages of 4 KB takes the system a quarter of the time.

#include <cstdlib>
#include <new>
#if defined(__linux__) && defined(__GLIBC__)
#include <sys/mman.h>
#endif

#if defined(__linux__) && defined(__GLIBC__) && defined(MADV_HUGEPAGE) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)

namespace {

constexpr std::size_t kPage = std::size_t{1} << 21;
// Up to a page of a block is filled in vain.
constexpr std::size_t kLarge = 4 * kPage;

void* block(std::size_t size) {
  if (size < kLarge) return std::malloc(size == 0 ? 1 : size);
  const std::size_t pages = size / kPage + 1;
  void* const large = std::aligned_alloc(kPage, pages * kPage);
  if (large != nullptr) madvise(large, pages * kPage, MADV_HUGEPAGE);
  return large;
}

}  // namespace

void* operator new(std::size_t size) {
  while (true) {
    if (void* const result = block(size)) return result;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t /*size*/) noexcept {
  std::free(block);
}

#endif
