/* The four images as the generated headers convert them. */
#include "c887.h"
#include "double.h"
#include "s700.h"

#define IMAGE(name, header) \
    void generated_pack_##name(const struct header *from, uint8_t *to) { header##_pack(to, from); } \
    void generated_unpack_##name(const uint8_t *from, struct header *to) { header##_unpack(to, from); }

IMAGE(C887Outputs, c887_outputs)
IMAGE(C887Inputs, c887_inputs)
IMAGE(S700Inputs, s700_tx_1b0b)
IMAGE(PilzInputs, pmc_sc6_double_inputs)
