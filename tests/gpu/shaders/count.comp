#version 460
// Counts its own threads.
layout(local_size_x = 32) in;
layout(set = 0, binding = 0) buffer Counter { uint value; } counter;
void main() { atomicAdd(counter.value, 1u); }
