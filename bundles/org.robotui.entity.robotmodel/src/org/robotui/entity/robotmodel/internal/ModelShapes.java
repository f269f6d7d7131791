package org.robotui.entity.robotmodel.internal;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.urdf.Color;
import org.robotui.urdf.Geometry;
import org.robotui.urdf.mesh.Mesh;

/** Makes shapes of forms; equal ones are one object, so that the graphics card has them once. Used by one thread. */
final class ModelShapes {
  /** The most memory of one model. */
  static final long MOST_BYTES = 1L << 30;

  private final MeshCache meshes;
  private final Map<Geometry, Optional<TriangleMesh>> plain = new HashMap<>();
  private final Map<Looks, List<Skin>> skins = new HashMap<>();
  private long bytes;

  ModelShapes(MeshCache meshes) {
    this.meshes = meshes;
  }

  /** A form whose own colours are filled up with what the model says. */
  private record Looks(Geometry geometry, Rgba otherwise, Optional<String> texture) {}

  boolean full() {
    return bytes > MOST_BYTES;
  }

  /** Without colours; none where its file cannot be read. */
  Optional<TriangleMesh> plain(Geometry geometry) {
    Optional<TriangleMesh> known = plain.get(geometry);
    if (known == null) {
      known = make(geometry);
      plain.put(geometry, known);
      known.ifPresent(mesh -> bytes += mesh.bytes());
    }
    return known;
  }

  /**
   * As it looks by itself: with colours and pictures of its file, as RViz shows it; they go before the model's
   * material.
   *
   * @param geometry the form
   * @param otherwise colour of what the file leaves open
   * @param texture URI of a picture on what the file leaves open
   * @return one surface or several; none where its file cannot be read
   */
  List<Skin> skins(Geometry geometry, Rgba otherwise, Optional<String> texture) {
    Looks looks = new Looks(geometry, otherwise, texture);
    List<Skin> known = skins.get(looks);
    if (known == null) {
      known = skins(looks);
      skins.put(looks, known);
    }
    return known;
  }

  private List<Skin> skins(Looks looks) {
    Optional<MeshFile> file =
        looks.geometry instanceof Geometry.MeshFile named ? meshes.mesh(named.uri()) : Optional.empty();
    Optional<Texture> fallback =
        looks.texture.filter(uri -> file.flatMap(f -> f.mesh().uv()).isPresent()).flatMap(meshes::texture);
    if (file.isPresent() && (fallback.isPresent() || !file.get().textures().isEmpty())
        && looks.geometry instanceof Geometry.MeshFile named) {
      List<Skin> cut = new Skins(file.get(), named.scale(), looks.otherwise, fallback).cut();
      bytes += cut.stream()
          .mapToLong(skin -> skin.shape().bytes() + skin.texture().map(t -> t.rgba().remaining()).orElse(0)).sum();
      return cut;
    }
    Optional<Mesh> colors =
        file.map(MeshFile::mesh).filter(mesh -> mesh.parts().stream().anyMatch(part -> part.color().isPresent()));
    return plain(looks.geometry)
        .map(plain -> new Skin(colors.map(mesh -> colored(mesh, plain, looks.otherwise)).orElse(plain), plain,
            Optional.empty(), colors.isPresent()))
        .stream().toList();
  }

  private TriangleMesh colored(Mesh mesh, TriangleMesh shape, Rgba otherwise) {
    ByteBuffer rgba = ByteBuffer.allocate(4 * (mesh.xyz().remaining() / 3));
    for (Mesh.Part part : mesh.parts()) {
      int packed = part.color().map(ModelShapes::rgba).orElse(otherwise).packed();
      for (int i = 0; i < part.corners(); i++) {
        rgba.putInt(4 * (part.firstCorner() + i), packed);
      }
    }
    bytes += rgba.remaining();
    return new TriangleMesh(shape.xyz(), shape.normals(), Optional.empty(), Optional.of(rgba), shape.triangles(),
        shape.bounds());
  }

  static Rgba rgba(Color color) {
    return new Rgba(color.red(), color.green(), color.blue(), color.alpha());
  }

  private Optional<TriangleMesh> make(Geometry geometry) {
    return switch (geometry) {
      case Geometry.Box box -> Optional.of(Scaled.by(Meshes.cube(), box.size()));
      case Geometry.Sphere sphere -> Optional.of(round(Meshes.sphere(), 2 * sphere.radius(), 2 * sphere.radius()));
      case Geometry.Cylinder cylinder -> Optional
          .of(round(Meshes.cylinder(), 2 * cylinder.radius(), cylinder.length()));
      case Geometry.MeshFile file -> meshes.mesh(file.uri()).map(found -> surface(found.mesh(), file.scale()));
    };
  }

  private static TriangleMesh round(TriangleMesh mesh, double across, double along) {
    return Scaled.by(mesh, new Vector3(across, across, along));
  }

  private static TriangleMesh surface(Mesh mesh, Vector3 scale) {
    FloatBuffer xyz = Scaled.places(mesh.xyz(), scale);
    return new TriangleMesh(xyz, Optional.of(Scaled.normals(mesh.normals(), scale)), Optional.empty(), Optional.empty(),
        mesh.triangles(), Box3.around(xyz));
  }
}
