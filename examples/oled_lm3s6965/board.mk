# SPDX-License-Identifier: MIT
#
# EK-LM3S6965: firmware.elf and firmware.bin for its flash, host-picture for what its panel has to show.

BOARDS += oled_lm3s6965
OLED := examples/oled_lm3s6965
OLED_SOURCES := $(wildcard $(OLED)/*.c) examples/panels/ssd0323.c
TARGET_SOURCES += $(OLED_SOURCES)

board-build-oled_lm3s6965: $(B)/boards/oled_lm3s6965/host-picture $(B)/boards/shrink
	@+$(call board_make,oled_lm3s6965,m3,-O2 -g,$(B)/boards/oled_lm3s6965/firmware.elf)


ifeq ($(BOARD),oled_lm3s6965)
$(B)/firmware.elf: $(call objects,$(OLED_SOURCES)) $(SCENES) $(LIBRARY) $(STARTUP)/cortex_m.ld \
		$(STARTUP)/cortex_m_startup.c
	$(call run,LINK)$(CC) $(LIBRARY_FLAGS) $(m3_SCRIPT) -Wl,--gc-sections -Wl,--defsym=link_ram_bytes=64K \
		-Wl,-Map=$(B)/firmware.map -o $@ $(filter %.o,$^) $(STARTUP)/cortex_m_startup.c \
		$(SCENES) $(LIBRARY) $(m3_LIBS)
	@arm-none-eabi-objcopy -O binary $@ $(B)/firmware.bin
endif
