/* Declares what of the EtherLab master's interface is used, and prints each call. */
#ifndef ECRT_H
#define ECRT_H

#include <stdint.h>
#include <stdio.h>

#define EC_END (~0U)

typedef struct ec_slave_config ec_slave_config_t;
typedef struct ec_domain ec_domain_t;
typedef enum { EC_DIR_INVALID, EC_DIR_OUTPUT, EC_DIR_INPUT, EC_DIR_BOTH, EC_DIR_COUNT } ec_direction_t;
typedef enum { EC_WD_DEFAULT, EC_WD_ENABLE, EC_WD_DISABLE } ec_watchdog_mode_t;
typedef struct { uint16_t index; uint8_t subindex; uint8_t bit_length; } ec_pdo_entry_info_t;
typedef struct { uint16_t index; unsigned int n_entries; ec_pdo_entry_info_t *entries; } ec_pdo_info_t;
typedef struct {
    uint8_t index;
    ec_direction_t dir;
    unsigned int n_pdos;
    ec_pdo_info_t *pdos;
    ec_watchdog_mode_t watchdog_mode;
} ec_sync_info_t;

static int ecrt_slave_config_pdos(ec_slave_config_t *sc, unsigned int n_syncs, const ec_sync_info_t syncs[])
{
    (void)sc;
    for (; n_syncs == EC_END && syncs->index != 0xFF; syncs++) {
        unsigned int pdo, entry;
        printf("sm %u %d %d\n", syncs->index, syncs->dir == EC_DIR_OUTPUT, syncs->watchdog_mode == EC_WD_ENABLE);
        for (pdo = 0; pdo < syncs->n_pdos; pdo++) {
            printf("pdo %04x\n", syncs->pdos[pdo].index);
            for (entry = 0; entry < syncs->pdos[pdo].n_entries; entry++) {
                const ec_pdo_entry_info_t *it = &syncs->pdos[pdo].entries[entry];
                printf("entry %04x %02x %u\n", it->index, it->subindex, it->bit_length);
            }
        }
    }
    return 0;
}

static int print_sdo(uint16_t index, uint8_t subindex, const void *data, size_t size)
{
    const uint8_t *at = (const uint8_t *)data;
    printf("sdo %04x %02x ", index, subindex);
    for (; size > 0; size--) { printf("%02x", *at++); }
    printf("\n");
    return 0;
}

static inline int ecrt_slave_config_sdo8(ec_slave_config_t *sc, uint16_t index, uint8_t subindex, uint8_t value)
{
    (void)sc;
    return print_sdo(index, subindex, &value, 1);
}

static inline int ecrt_slave_config_sdo16(ec_slave_config_t *sc, uint16_t index, uint8_t subindex, uint16_t value)
{
    const uint8_t data[] = { (uint8_t)(value & 0xFFu), (uint8_t)(value >> 8) };
    (void)sc;
    return print_sdo(index, subindex, data, 2);
}

static inline int ecrt_slave_config_sdo32(ec_slave_config_t *sc, uint16_t index, uint8_t subindex, uint32_t value)
{
    const uint8_t data[] = {
        (uint8_t)(value & 0xFFu), (uint8_t)(value >> 8 & 0xFFu), (uint8_t)(value >> 16 & 0xFFu), (uint8_t)(value >> 24)
    };
    (void)sc;
    return print_sdo(index, subindex, data, 4);
}

static inline int ecrt_slave_config_sdo(
    ec_slave_config_t *sc, uint16_t index, uint8_t subindex, const uint8_t *data, size_t size)
{
    (void)sc;
    return print_sdo(index, subindex, data, size);
}

/* Each sync manager has its place a thousand bytes behind the one before. */
static inline int ecrt_slave_config_reg_pdo_entry_pos(
    ec_slave_config_t *sc, uint8_t sync_index, unsigned int pdo_pos, unsigned int entry_pos, ec_domain_t *domain,
    unsigned int *bit_position)
{
    (void)sc;
    (void)domain;
    *bit_position = 0;
    return pdo_pos == 0 && entry_pos == 0 ? 1000 * sync_index : -1;
}

static inline void ecrt_slave_config_dc(
    ec_slave_config_t *sc, uint16_t assign_activate, uint32_t sync0_cycle, int32_t sync0_shift, uint32_t sync1_cycle,
    int32_t sync1_shift)
{
    (void)sc;
    printf("dc %04x %u %d %u %d\n", assign_activate, sync0_cycle, sync0_shift, sync1_cycle, sync1_shift);
}

#endif
