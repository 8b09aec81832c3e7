#pragma once

#include <hachure/runtime/assets/model.h>

#include <filesystem>

/// Readers of plain mesh files. Each gives a valid Model with one scene; nothing in a file is trusted.
///
/// What they share:
/// - The name may end in `.gz`: the file is then inflated, to at most 2 GiB and 64 times its size.
/// - Polygons are cut into triangles (convex and concave, see geometry/triangulate.h) that keep their winding.
/// - `normals` is filled only where the file has usable ones, and then of unit length; otherwise it stays empty, to be
///   computed. Tangents stay empty.
/// - Texture coordinates are counted from the top of the image, as in glTF; in the files it is the bottom.
/// - Colours of vertices and materials are taken as sRGB, as the tools that write them do, and given as linear RGBA.
/// - Faces with fewer than three corners are dropped, triangles that repeat a vertex are kept (they cover no pixel, and
///   geometry/mesh_health.h counts them); `Model::warnings` has one line for each kind, with its count.
/// - Materials that come from a file have `metallic` 0; without any, primitives have material -1.
///
/// Errors: hachure::Error with the file, the fault and "line 12", "byte 132" or "face 7". Faults are an unreadable,
/// empty or truncated file, a directory, an unknown header, an index out of range, a count larger than the file can
/// hold, a position that is not finite, and a file without a single triangle.
namespace hachure::assets {

/// Wavefront OBJ. `o` starts a mesh with a node of its own, named after it; `usemtl` starts a primitive of that mesh,
/// or continues the one with the same material. `g` and `s` do not split, since they cut through connected surfaces.
/// Corners `v`, `v/t`, `v//n` and `v/t/n`, absolute or relative; a distinct triple becomes a vertex. `v` may carry a
/// colour. Of material libraries `newmtl`, `Kd`, `Ke`, `d`, `Tr`, `Pr`, `Pm` and `map_Kd` are read, and they and their
/// images only from beside the file: no absolute path, no "..", no URL. What is missing or not understood is a warning.
[[nodiscard]] Model read_obj(const std::filesystem::path& file);

/// Stanford PLY, ascii and binary of either byte order: any order and type of properties, faces as lists of any count
/// type, Stanford's triangle strips, normals (nx ny nz), colours (red green blue alpha, diffuse_*), texture coordinates
/// (s t, u v, texture_u texture_v, texture_s texture_t). Other elements and properties are skipped with a warning.
[[nodiscard]] Model read_ply(const std::filesystem::path& file);

/// Geomview OFF with any of the prefixes ST, C and N, ascii or BINARY. Face colours are skipped.
[[nodiscard]] Model read_off(const std::filesystem::path& file);

/// STL, ascii and binary; which one is told from the size, since binary headers may start with "solid". Vertices at
/// bit-equal positions become one. The winding decides the side; facet normals are only compared with it, and those
/// that oppose it are counted in a warning.
[[nodiscard]] Model read_stl(const std::filesystem::path& file);

/// Whether `read_mesh` knows the extension (.obj, .ply, .off, .stl, any case, each with .gz or without).
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& file);

/// The reader for the extension of `file`; hachure::Error when there is none.
[[nodiscard]] Model read_mesh(const std::filesystem::path& file);

} // namespace hachure::assets
