# SPDX-License-Identifier: MIT
#
# Raspberry Pi Pico: firmware.uf2 for its USB drive, firmware.bin (the same, for a debug probe), host-picture for what
# its panel has to show.

BOARDS += pico_st7789
PICO := examples/pico_st7789
PICO_SOURCES := $(wildcard $(PICO)/*.c) examples/panels/st7789.c
PICO_SCRIPTS := $(PICO)/rp2040.ld $(PICO)/hot_code.ld
TARGET_SOURCES += $(PICO_SOURCES)

board-build-pico_st7789: $(B)/boards/pico_st7789/host-picture $(B)/glint-panel-decode $(B)/pico-uf2
	@+command -v npm >/dev/null || test -d $(COST_NODE)/node_modules/rp2040js || \
		echo "pico_st7789: npm is missing, which gets the emulator rp2040js (Debian: npm)" >&2
	@+$(SUBMAKE) -s $(COST_NODE)/node_modules/rp2040js || true
	@+$(SUBMAKE) pico-firmware

# Needs the compiler alone.
.PHONY: pico-firmware
pico-firmware: $(B)/pico-uf2
	@+$(call board_make,pico_st7789,m0plus,-O2 -g,$(B)/boards/pico_st7789/firmware.elf)
	@arm-none-eabi-objcopy -O binary $(B)/boards/pico_st7789/firmware.elf $(B)/boards/pico_st7789/unsealed.bin
	@$(B)/pico-uf2 $(B)/boards/pico_st7789/unsealed.bin -o $(B)/boards/pico_st7789/firmware.uf2 \
		--bin $(B)/boards/pico_st7789/firmware.bin

ifeq ($(BOARD),pico_st7789)
$(B)/firmware.elf: $(call objects,$(PICO_SOURCES)) $(PICO)/boot2.S $(SCENES) $(LIBRARY) $(PICO_SCRIPTS)
	$(call run,LINK)$(CC) $(LIBRARY_FLAGS) -nostdlib -Wl,--gc-sections -Wl,-T,$(PICO)/rp2040.ld \
		-Wl,-Map=$(B)/firmware.map -o $@ $(filter %.o,$^) $(PICO)/boot2.S $(SCENES) $(LIBRARY) $(m0plus_LIBS)
endif
