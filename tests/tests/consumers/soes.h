/* What esc_coe.h of SOES declares, as far as an object list needs it: the two structs, and the numbers of kinds, types and
 * access of ETG.1000.6 by the names of the stack. */

#ifndef ESC_COE_H
#define ESC_COE_H

#include <stdint.h>

typedef struct {
    uint16_t subindex;
    uint16_t datatype;
    uint16_t bitlength;
    uint16_t flags;
    const char *name;
    uint32_t value;
    void *data;
} _objd;

typedef struct {
    uint16_t index;
    uint16_t objtype;
    uint8_t maxsub;
    uint8_t pad1;
    const char *name;
    const _objd *objdesc;
} _objectlist;

enum { OTYPE_VAR = 7, OTYPE_ARRAY = 8, OTYPE_RECORD = 9 };

enum {
    DTYPE_BOOLEAN = 0x01, DTYPE_INTEGER8, DTYPE_INTEGER16, DTYPE_INTEGER32, DTYPE_UNSIGNED8, DTYPE_UNSIGNED16,
    DTYPE_UNSIGNED32, DTYPE_REAL32, DTYPE_VISIBLE_STRING, DTYPE_OCTET_STRING, DTYPE_UNICODE_STRING,
    DTYPE_INTEGER24 = 0x10, DTYPE_REAL64, DTYPE_INTEGER64 = 0x15, DTYPE_UNSIGNED24, DTYPE_UNSIGNED64 = 0x1B,
    DTYPE_BIT1 = 0x30, DTYPE_BIT2, DTYPE_BIT3, DTYPE_BIT4, DTYPE_BIT5, DTYPE_BIT6, DTYPE_BIT7, DTYPE_BIT8
};

#define ATYPE_Rpre 0x01
#define ATYPE_Rsafe 0x02
#define ATYPE_Rop 0x04
#define ATYPE_Wpre 0x08
#define ATYPE_Wsafe 0x10
#define ATYPE_Wop 0x20
#define ATYPE_RXPDO 0x40
#define ATYPE_TXPDO 0x80
#define ATYPE_BACKUP 0x100
#define ATYPE_SETTING 0x200
#define ATYPE_RO (ATYPE_Rpre | ATYPE_Rsafe | ATYPE_Rop)
#define ATYPE_WO (ATYPE_Wpre | ATYPE_Wsafe | ATYPE_Wop)
#define ATYPE_RW (ATYPE_RO | ATYPE_WO)

extern const _objectlist SDOobjects[];

#endif
