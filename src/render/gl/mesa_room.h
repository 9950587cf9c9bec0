// Whether Mesa can have the threads and the memory that it takes for granted. llvmpipe waits for
// ever for threads that it could not start: its fences count the threads that it wanted, and only
// those that run signal them. Where memory ends, it crashes.
#pragma once

namespace saddle {

/// Lets Mesa draw on the calling thread, by its variable LP_NUM_THREADS, if the system does not
/// start as many threads as Mesa may want while this program has its own. The pictures are the same
/// to the bit. Throws Error (Machine) if there is not enough memory to start with. Called before a
/// context is made, with Mesa's library loaded.
void make_room_for_mesa();

}  // namespace saddle
