/* The images of the C-887, as firmware and masters in C convert them. */
#include <stdint.h>
#include <string.h>

struct out { uint16_t controlword; int8_t mode; int32_t position; };
struct in { uint16_t statusword; int8_t mode; int32_t position; int32_t following_error; };

struct __attribute__((packed)) packed_out { uint16_t controlword; int8_t mode; int32_t position; };
struct __attribute__((packed)) packed_in { uint16_t statusword; int8_t mode; int32_t position, following_error; };

static uint8_t *put16(uint8_t *at, uint16_t value) { at[0] = value; at[1] = value >> 8; return at + 2; }
static uint8_t *put32(uint8_t *at, uint32_t value) { return put16(put16(at, value), value >> 16); }
static uint16_t get16(const uint8_t *at) { return at[0] | at[1] << 8; }
static uint32_t get32(const uint8_t *at) { return get16(at) | (uint32_t)get16(at + 2) << 16; }

void c_pack_outputs(const struct out *axes, uint8_t *at)
{
    for (int axis = 0; axis < 6; axis++) {
        at = put16(at, axes[axis].controlword);
        *at++ = axes[axis].mode;
        at = put32(at, axes[axis].position);
    }
}

void c_unpack_outputs(const uint8_t *at, struct out *axes)
{
    for (int axis = 0; axis < 6; axis++, at += 7) {
        axes[axis].controlword = get16(at);
        axes[axis].mode = at[2];
        axes[axis].position = get32(at + 3);
    }
}

void c_pack_inputs(const struct in *axes, uint8_t *at)
{
    for (int axis = 0; axis < 6; axis++) {
        at = put16(at, axes[axis].statusword);
        *at++ = axes[axis].mode;
        at = put32(at, axes[axis].position);
        at = put32(at, axes[axis].following_error);
    }
}

void c_unpack_inputs(const uint8_t *at, struct in *axes)
{
    for (int axis = 0; axis < 6; axis++, at += 11) {
        axes[axis].statusword = get16(at);
        axes[axis].mode = at[2];
        axes[axis].position = get32(at + 3);
        axes[axis].following_error = get32(at + 7);
    }
}

void c_place_outputs(const struct out *axes, struct packed_out *frame)
{
    for (int axis = 0; axis < 6; axis++) {
        frame[axis].controlword = axes[axis].controlword;
        frame[axis].mode = axes[axis].mode;
        frame[axis].position = axes[axis].position;
    }
}

void c_fetch_outputs(const struct packed_out *frame, struct out *axes)
{
    for (int axis = 0; axis < 6; axis++) {
        axes[axis].controlword = frame[axis].controlword;
        axes[axis].mode = frame[axis].mode;
        axes[axis].position = frame[axis].position;
    }
}

void c_place_inputs(const struct in *axes, struct packed_in *frame)
{
    for (int axis = 0; axis < 6; axis++) {
        frame[axis].statusword = axes[axis].statusword;
        frame[axis].mode = axes[axis].mode;
        frame[axis].position = axes[axis].position;
        frame[axis].following_error = axes[axis].following_error;
    }
}

void c_fetch_inputs(const struct packed_in *frame, struct in *axes)
{
    for (int axis = 0; axis < 6; axis++) {
        axes[axis].statusword = frame[axis].statusword;
        axes[axis].mode = frame[axis].mode;
        axes[axis].position = frame[axis].position;
        axes[axis].following_error = frame[axis].following_error;
    }
}
