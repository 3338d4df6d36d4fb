/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer's entry for the scene validator and the renderer, both backends: see scene_stages.h. `make fuzz` runs it.
 */
#include "tests/fuzz/scene_stages.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    check_scene_bytes(data, size);
    return 0;
}
