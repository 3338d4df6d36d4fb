# SPDX-License-Identifier: MIT
#
# ATmega1284P with an SSD1306: firmware.elf and firmware.hex, host-picture for what its panel has to show, and simulate,
# which runs the firmware.

BOARDS += avr_ssd1306
AVR_OLED := examples/avr_ssd1306
AVR_OLED_SOURCES := $(wildcard $(AVR_OLED)/*.c) examples/panels/ssd1306.c
TARGET_SOURCES += $(AVR_OLED_SOURCES)
FOREIGN_SOURCES += $(filter-out %/picture.c,$(wildcard $(AVR_OLED)/*.c))

# Speed first: 128 KB of flash are more than the model alone takes.
AVR_OLED_FLAGS := -O2 -g -mcall-prologues -mrelax

board-build-avr_ssd1306: avr_ssd1306-needs $(B)/boards/avr_ssd1306/host-picture $(B)/boards/avr_ssd1306/simulate
	@+$(call board_make,avr_ssd1306,avr,$(AVR_OLED_FLAGS),$(B)/boards/avr_ssd1306/firmware.elf)

.PHONY: avr_ssd1306-needs
avr_ssd1306-needs:
	@pkg-config --exists simavr || { echo "avr_ssd1306: libsimavr is missing (Debian: libsimavr-dev)" >&2; exit 1; }

# Headers of simavr are not written to this project's warnings.
SIMAVR_FLAGS = $(patsubst -I%,-isystem %,$(shell pkg-config --cflags simavrparts simavr 2>/dev/null))
SIMAVR_LIBS = $(shell pkg-config --libs simavrparts simavr 2>/dev/null) -lelf
$(B)/obj/tools/boards/simulate_avr.o: HOST_FLAGS += $(SIMAVR_FLAGS)
$(B)/boards/avr_ssd1306/simulate: $(call objects,tools/boards/simulate_avr.c) $(HOST_ARCHIVES)
	@mkdir -p $(@D)
	$(call run,LINK)$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $^ $(SIMAVR_LIBS) $(OPTIONAL_LIBS) -lm
-include $(patsubst %.o,%.d,$(call objects,tools/boards/simulate_avr.c))

ifeq ($(BOARD),avr_ssd1306)
$(B)/firmware.elf: $(call objects,$(AVR_OLED_SOURCES)) $(SCENES) $(LIBRARY)
	$(call run,LINK)$(CC) $(LIBRARY_FLAGS) -Wl,--gc-sections -Wl,-Map=$(B)/firmware.map -o $@ \
		$(filter %.o,$^) $(SCENES) $(LIBRARY)
	@avr-objcopy -O ihex -R .eeprom $@ $(B)/firmware.hex
endif
