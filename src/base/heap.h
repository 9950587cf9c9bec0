// How the program's memory comes from the system.
#pragma once

#include <cstddef>

namespace saddle {

/// Lets the heap, one for all threads, grow in large steps of huge pages and keep what is freed, so
/// that memory is got from the system a few times, not page by page: a picture's framebuffer alone
/// is 4000 pages, and each costs an interruption of 2 microseconds. Call it once, before much is
/// allocated. Does nothing, and returns false, where the heap is not glibc's or the system has no
/// huge pages.
bool use_huge_pages();

/// Asks for huge pages for a new block, if one fits into it: to get the small pages of a large
/// array costs more than to fill them.
void prefer_huge_pages(void* block, std::size_t bytes);

/// Gives the system what is free of the heap, and from now on what large arrays take once they are
/// freed: those of 2 MiB or more get memory of their own. In the heap they leave holes, with
/// which a fine mesh would take a tenth more.
void set_large_arrays_apart();

/// Gives the system what is free of the heap, in whole pages. It takes a millisecond or two, and
/// what is then allocated is got from the system anew: for programs that wait for a person.
void give_back_free_memory();

/// Gives the calling thread, the first one, a mebibyte of stack now, or half of what it may have. A
/// stack that grows where the address space has come to its limit ends the program by a signal.
void reserve_stack();

}  // namespace saddle
