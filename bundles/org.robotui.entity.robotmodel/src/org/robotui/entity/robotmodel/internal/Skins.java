package org.robotui.entity.robotmodel.internal;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.urdf.mesh.Mesh;

/** Cuts a mesh with pictures into one surface a picture, and one for the rest: a surface is drawn with one picture. */
final class Skins {
  private final MeshFile file;
  private final Vector3 scale;
  private final Rgba otherwise;
  private final Optional<Texture> fallback;

  /**
   * Prepares it.
   *
   * @param file the mesh with its pictures
   * @param scale along x, y, z
   * @param otherwise colour of parts that have neither colour nor picture
   * @param fallback picture of parts that have neither
   */
  Skins(MeshFile file, Vector3 scale, Rgba otherwise, Optional<Texture> fallback) {
    this.file = file;
    this.scale = scale;
    this.otherwise = otherwise;
    this.fallback = fallback;
  }

  /**
   * What parts of one surface have in common.
   *
   * @param name of the picture that was read; none without
   * @param open whether the file says neither a colour nor a picture
   */
  private record Look(Optional<String> name, boolean open) {}

  List<Skin> cut() {
    Map<Look, List<Mesh.Part>> byLook = new LinkedHashMap<>();
    file.mesh().parts().forEach(part -> byLook.computeIfAbsent(look(part), key -> new ArrayList<>()).add(part));
    return byLook.entrySet().stream().map(entry -> skin(texture(entry.getKey()), entry.getValue())).toList();
  }

  private Look look(Mesh.Part part) {
    return new Look(part.texture().filter(file.textures()::containsKey),
        part.color().isEmpty() && part.texture().isEmpty());
  }

  private Optional<Texture> texture(Look look) {
    return look.open ? fallback : look.name.map(file.textures()::get);
  }

  private Skin skin(Optional<Texture> texture, List<Mesh.Part> parts) {
    int corners = parts.stream().mapToInt(Mesh.Part::corners).sum();
    FloatBuffer xyz = FloatBuffer.allocate(3 * corners);
    FloatBuffer normals = FloatBuffer.allocate(3 * corners);
    FloatBuffer uv = FloatBuffer.allocate(2 * corners);
    ByteBuffer rgba = ByteBuffer.allocate(4 * corners);
    IntBuffer triangles = IntBuffer.allocate(3 * parts.stream().mapToInt(Mesh.Part::triangles).sum());
    for (Mesh.Part part : parts) {
      triangles(part, xyz.position() / 3, triangles);
      xyz.put(file.mesh().xyz().slice(3 * part.firstCorner(), 3 * part.corners()));
      normals.put(file.mesh().normals().slice(3 * part.firstCorner(), 3 * part.corners()));
      file.mesh().uv().ifPresent(places -> places(places, part, uv));
      int color = (texture.isPresent() ? part.color().map(c -> Rgba.WHITE.withAlpha(c.alpha())).orElse(Rgba.WHITE)
          : part.color().map(ModelShapes::rgba).orElse(otherwise)).packed();
      for (int i = 0; i < part.corners(); i++) {
        rgba.putInt(color);
      }
    }
    FloatBuffer scaled = Scaled.places(xyz.flip(), scale);
    TriangleMesh plain =
        new TriangleMesh(scaled, Optional.of(Scaled.normals(normals.flip(), scale)), Optional.empty(), Optional.empty(),
            triangles.flip(), Box3.around(scaled));
    TriangleMesh shape = new TriangleMesh(plain.xyz(), plain.normals(), texture.map(t -> uv.flip()),
        Optional.of(rgba.flip()), plain.triangles(),
        plain.bounds());
    return new Skin(shape, plain, texture, true);
  }

  private void triangles(Mesh.Part part, int first, IntBuffer into) {
    for (int i = 0; i < 3 * part.triangles(); i++) {
      into.put(file.mesh().triangles().get(3 * part.firstTriangle() + i) - part.firstCorner() + first);
    }
  }

  /** Files count from the bottom of the picture, textures from its first row. */
  private static void places(FloatBuffer from, Mesh.Part part, FloatBuffer into) {
    for (int i = part.firstCorner(); i < part.firstCorner() + part.corners(); i++) {
      into.put(from.get(2 * i)).put(1 - from.get(2 * i + 1));
    }
  }
}
