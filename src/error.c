/* SPDX-License-Identifier: MIT */
#include <glint/error.h>

const char *glint_error_text(int error)
{
    switch ((glint_error)error) {
    case GLINT_OK:
        return "no error";
    case GLINT_ERROR_NULL_ARGUMENT:
        return "scene, display, quality or memory is NULL";
    case GLINT_ERROR_NULL_CAMERA:
        return "the scene has no camera";
    case GLINT_ERROR_NULL_OBJECTS:
        return "the scene's objects are NULL although object_count is not 0";
    case GLINT_ERROR_NULL_LIGHTS:
        return "the scene's lights are NULL although light_count is not 0";
    case GLINT_ERROR_NULL_MESH:
        return "an object has no mesh, or its mesh lacks positions, normals or triangles";
    case GLINT_ERROR_NULL_MATERIAL:
        return "an object has no material";
    case GLINT_ERROR_NULL_FLUSH:
        return "the display has no flush function";
    case GLINT_ERROR_MESH_EMPTY:
        return "a mesh has fewer than 3 vertices or no triangle";
    case GLINT_ERROR_MESH_INDEX:
        return "a triangle names a vertex that its mesh does not have";
    case GLINT_ERROR_MESH_FRACTION:
        return "a mesh's fraction_bits is not 0..24";
    case GLINT_ERROR_PLACE_SINGULAR:
        return "an object's place is singular: it flattens the mesh";
    case GLINT_ERROR_PLACE_RANGE:
        return "an object's place has an entry out of range (linear 1024, origin 16384)";
    case GLINT_ERROR_REFLECTANCE:
        return "a material has a reflectance below 0 or above 1";
    case GLINT_ERROR_EXPONENT:
        return "a material's exponent is above 1024";
    case GLINT_ERROR_SPECULAR_MODEL:
        return "a material's specular_model is unknown";
    case GLINT_ERROR_EMISSION:
        return "a material has an emission below 0 or above 1";
    case GLINT_ERROR_SIDES:
        return "a material's sides are unknown";
    case GLINT_ERROR_TRANSMISSION:
        return "a material lets more light through than there is: its transmission is above 1";
    case GLINT_ERROR_GRAZING:
        return "a material mirrors a colour below 0 or above 1 at grazing angles";
    case GLINT_ERROR_WIRE:
        return "a material's wire is wider than 256 pixels, or its colour below 0 or above 1";
    case GLINT_ERROR_SHADOWS:
        return "a material's choice of shadows is unknown";
    case GLINT_ERROR_LIGHT_KIND:
        return "a light's kind is unknown";
    case GLINT_ERROR_LIGHT_DIRECTION:
        return "the direction of a directional light or a spot light is zero";
    case GLINT_ERROR_LIGHT_COLOUR:
        return "a light's colour is negative";
    case GLINT_ERROR_LIGHT_POSITION:
        return "a light's position is out of range (16384)";
    case GLINT_ERROR_LIGHT_COUNT:
        return "the scene has more than 4096 lights, samples of extended sources counted each";
    case GLINT_ERROR_AMBIENT:
        return "the scene's ambient light is negative";
    case GLINT_ERROR_BACKGROUND:
        return "the scene's background colour is below 0 or above 1";
    case GLINT_ERROR_LIGHT_DISTANCE:
        return "a light's attenuation has a distance out of range (1/256 to 16384 world units, or 0)";
    case GLINT_ERROR_LIGHT_CONE:
        return "a spot light's inner cone is not at least 1 degree within the outer one, or that is wider than 90 "
               "degrees";
    case GLINT_ERROR_LIGHT_EXTENT:
        return "a ball's radius is negative, or a panel or a ball reaches beyond 16384 world units";
    case GLINT_ERROR_LIGHT_SHADOWS:
        return "a panel or a ball is to cast shadows, which only lights without an extent can";
    case GLINT_ERROR_LIGHT_SAMPLES:
        return "an extended light source has more than 64 samples";
    case GLINT_ERROR_MIRROR:
        return "a mirror's reflectance is below 0 or above 1";
    case GLINT_ERROR_NULL_ENVIRONMENT:
        return "a material mirrors the environment, but the scene has none, or none with texels";
    case GLINT_ERROR_ENVIRONMENT_SIDE:
        return "the environment's side is not 8, 16, 32, 64 or 128";
    case GLINT_ERROR_FOG:
        return "the fog does not end at least 1/256 behind where it begins, or a field of it is out of range";
    case GLINT_ERROR_CAMERA_DIRECTION:
        return "the camera's eye and target are the same point";
    case GLINT_ERROR_CAMERA_UP:
        return "the camera's up direction lies within 0.1 degrees of its view direction";
    case GLINT_ERROR_CAMERA_FIELD:
        return "the camera's field of view is not 1..170 degrees";
    case GLINT_ERROR_CAMERA_NEAR:
        return "the camera's near distance is not 1/1024..16384";
    case GLINT_ERROR_CAMERA_RANGE:
        return "the camera's eye or target is out of range (16384)";
    case GLINT_ERROR_DISPLAY_SIZE:
        return "the display's width or height is not 1..2048";
    case GLINT_ERROR_DISPLAY_BAND:
        return "the page format needs band_px to be a multiple of 8";
    case GLINT_ERROR_DISPLAY_FORMAT:
        return "the display's pixel format is unknown";
    case GLINT_ERROR_DISPLAY_DITHER:
        return "the display's dither is unknown";
    case GLINT_ERROR_DISPLAY_BUFFERS:
        return "the display's buffer_count is above 2, or 2 without transfers";
    case GLINT_ERROR_DISPLAY_STRIDE:
        return "the display's stride_bytes is shorter than a row or above 1048575";
    case GLINT_ERROR_DISPLAY_AREA:
        return "the display's area is not within its rows, or not of whole pages";
    case GLINT_ERROR_SHADING:
        return "the quality's shading is unknown";
    case GLINT_ERROR_TOLERANCE:
        return "the tolerance is below 0.75 codes, or asked for together with a shading";
    case GLINT_ERROR_PART:
        return "the scene asks for what this variant of the backend leaves out: call another";
    case GLINT_ERROR_TEXTURE_SIZE:
        return "a texture's width or height is not 1..1024, or its texels do not fit the address space";
    case GLINT_ERROR_TEXTURE_TEXELS:
        return "a texture has no texels (NULL)";
    case GLINT_ERROR_TEXTURE_PALETTE:
        return "a texture's palette is NULL, or its palette_count not 1..256";
    case GLINT_ERROR_TEXTURE_FORMAT:
        return "a texture's format is unknown";
    case GLINT_ERROR_TEXTURE_FILTER:
        return "a texture's filter is unknown";
    case GLINT_ERROR_TEXTURE_WRAP:
        return "a texture's wrap_u or wrap_v is unknown";
    case GLINT_ERROR_TEXTURE_TEXCOORDS:
        return "a material has a texture, but the object's mesh no texcoords";
    case GLINT_ERROR_TEXCOORD_BITS:
        return "a textured mesh's texcoord_bits is not 9..15";
    case GLINT_ERROR_MEMORY_SIZE:
        return "the memory is smaller than the least that the scene and display need";
    case GLINT_ERROR_MEMORY_ALIGNMENT:
        return "the memory is not aligned like a uint32_t";
    }
    return "unknown error";
}
