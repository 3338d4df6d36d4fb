# SPDX-License-Identifier: MIT
# The built-in meshes, made by build/generate-mesh. Included by the Makefile.

GENERATE_MESH_SOURCES := $(wildcard tools/mesh/*.c)
MESH_SOURCES := $(wildcard examples/meshes/*.c)

# The commands are in tools/mesh/regenerate.sh.
.PHONY: meshes check-meshes
meshes: build/generate-mesh
	tools/mesh/regenerate.sh build/generate-mesh examples/meshes

# Fails when a committed mesh is not what the generator makes.
check-meshes: build/generate-mesh
	rm -rf build/check-meshes
	mkdir -p build/check-meshes
	tools/mesh/regenerate.sh build/generate-mesh build/check-meshes
	for made in build/check-meshes/*.c; do cmp "$$made" examples/meshes/$$(basename "$$made") || exit 1; done
