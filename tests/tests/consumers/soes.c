/* Prints the object list as the stack reads it: a subindex is looked for from the first row on and no further than the
 * highest, and a value is in memory if the row points there. */

#include <stdio.h>
#include <string.h>
#include "esc_coe.h"
#include "utypes.h"
#include "ecat_options.h"

/* As the stack does at the start, before it calls the hook of the application. */
static void defaults(const _objd *row)
{
    const uint32_t value = row->value;
    const uint64_t wide = value;
    const uint8_t narrow = (uint8_t)value;
    const uint16_t half = (uint16_t)value;
    switch (row->bitlength) {
    case 64: memcpy(row->data, &wide, sizeof wide); break;
    case 32: memcpy(row->data, &value, sizeof value); break;
    case 16: memcpy(row->data, &half, sizeof half); break;
    default: if (row->bitlength <= 8) { memcpy(row->data, &narrow, sizeof narrow); } break;
    }
}

int main(void)
{
    const _objectlist *object;
    int sub;
    for (object = SDOobjects; object->index != 0xFFFF; object++) {
        for (sub = 0; sub <= object->maxsub; sub++) {
            if (object->objdesc[sub].data != NULL) { defaults(&object->objdesc[sub]); }
        }
    }
    Obj_set_defaults();
    for (object = SDOobjects; object->index != 0xFFFF; object++) {
        printf("object %04x %x %d %s\n", object->index, object->objtype, object->maxsub, object->name);
        for (sub = 0; sub <= object->maxsub; sub++) {
            const _objd *row = object->objdesc;
            const uint8_t *bytes;
            unsigned at;
            while (row->subindex < sub && row - object->objdesc < object->maxsub) { row++; }
            if (row->subindex != sub) { return 1; }
            if (row->datatype == 0) { continue; }
            printf("%02x %04x %u %03x %s ", row->subindex, row->datatype, row->bitlength, row->flags, row->name);
            if (row->data == NULL && row->bitlength > 32) { return 2; }
            bytes = row->data != NULL ? (const uint8_t *)row->data : (const uint8_t *)&row->value;
            for (at = 0; at < (row->bitlength + 7u) / 8u; at++) { printf("%02x", bytes[at]); }
            printf("\n");
        }
    }
    printf("%d %d\n", USE_FOE, USE_EOE);
#ifdef MBX0_sma
    printf("%d %d %d %d\n", MBX0_sma, MBX0_sml, MBX1_sma, MBX1_sml);
    if (MBX0_sme != MBX0_sma + MBX0_sml - 1 || MBXSIZE < MBX0_sml || MBXSIZE < MBX1_sml) { return 3; }
#endif
#ifdef SM2_sma
    printf("%d %d\n", SM2_sma, SM2_smc);
#endif
#ifdef SM3_sma
    printf("%d %d\n", SM3_sma, SM3_smc);
#endif
    return 0;
}
