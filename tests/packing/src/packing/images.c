/* The four images as firmware and masters in C convert them: each field shifted into its bytes, and a packed struct
 * that is laid over the frame. The fields are those of `images.rs`. */
#include <stdint.h>

#define C887_OUTPUTS(FIELD) FIELD(uint16_t, 16, controlword) FIELD(int8_t, 8, mode) FIELD(int32_t, 32, position)

#define C887_INPUTS(FIELD) \
    FIELD(uint16_t, 16, statusword) FIELD(int8_t, 8, mode) FIELD(int32_t, 32, position) \
    FIELD(int32_t, 32, following_error)

#define S700_INPUTS(FIELD) \
    FIELD(int32_t, 32, position_1) FIELD(int32_t, 32, position_2) FIELD(int32_t, 32, velocity) \
    FIELD(int16_t, 16, current) FIELD(uint16_t, 16, statusword) FIELD(int32_t, 32, errors) \
    FIELD(int32_t, 32, warnings) FIELD(uint32_t, 32, digital_io) FIELD(int16_t, 16, analog_1) \
    FIELD(int16_t, 16, analog_2) FIELD(int32_t, 32, following_error) FIELD(int32_t, 32, motion_task)

#define PILZ_INPUTS(FIELD) \
    FIELD(uint16_t, 16, statusword) FIELD(int8_t, 8, mode) FIELD(int32_t, 32, position) \
    FIELD(int32_t, 32, velocity) FIELD(int16_t, 16, torque) FIELD(int32_t, 32, following_error) \
    FIELD(uint32_t, 32, digital_inputs) FIELD(int32_t, 32, additional_position) \
    FIELD(uint16_t, 16, statusword_2) FIELD(uint16_t, 16, statusword_user)

static uint8_t *put8(uint8_t *at, uint8_t value) { at[0] = value; return at + 1; }
static uint8_t *put16(uint8_t *at, uint16_t value) { return put8(put8(at, value), value >> 8); }
static uint8_t *put32(uint8_t *at, uint32_t value) { return put16(put16(at, value), value >> 16); }
static uint8_t get8(const uint8_t *at) { return at[0]; }
static uint16_t get16(const uint8_t *at) { return get8(at) | get8(at + 1) << 8; }
static uint32_t get32(const uint8_t *at) { return get16(at) | (uint32_t)get16(at + 2) << 16; }

#define MEMBER(type, bits, field) type field;
#define PUT(type, bits, field) at = put##bits(at, pdos[pdo].field);
#define GET(type, bits, field) pdos[pdo].field = get##bits(at); at += bits / 8;
#define PLACE(type, bits, field) frame[pdo].field = pdos[pdo].field;
#define FETCH(type, bits, field) pdos[pdo].field = frame[pdo].field;
#define EACH(count, FIELDS, DO) for (int pdo = 0; pdo < count; pdo++) { FIELDS(DO) }

#define IMAGE(name, FIELDS, count) \
    struct name { FIELDS(MEMBER) }; \
    struct __attribute__((packed)) name##_packed { FIELDS(MEMBER) }; \
    void pack_##name(const struct name *pdos, uint8_t *at) { EACH(count, FIELDS, PUT) } \
    void unpack_##name(const uint8_t *at, struct name *pdos) { EACH(count, FIELDS, GET) } \
    void place_##name(const struct name *pdos, struct name##_packed *frame) { EACH(count, FIELDS, PLACE) } \
    void fetch_##name(const struct name##_packed *frame, struct name *pdos) { EACH(count, FIELDS, FETCH) }

IMAGE(C887Outputs, C887_OUTPUTS, 6)
IMAGE(C887Inputs, C887_INPUTS, 6)
IMAGE(S700Inputs, S700_INPUTS, 1)
IMAGE(PilzInputs, PILZ_INPUTS, 2)
