/* SPDX-License-Identifier: MIT */
/*
 * libFuzzer's entry for the model importer: see import_check.h. `make fuzz` runs it through run-import.sh, which tells
 * what is found in assimp from what is found in this project.
 */
#include "tests/fuzz/import_check.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static char folder[64];

static void remove_folder(void)
{
    (void)rmdir(folder);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (folder[0] == '\0') {
        make_folder(folder, sizeof folder);
        (void)atexit(remove_folder);
    }
    check_import_bytes(folder, data, size);
    return 0;
}
