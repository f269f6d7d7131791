package org.robotui.entity.marker.internal;

import java.io.IOException;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Texture;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.urdf.mesh.Mesh;
import org.robotui.urdf.mesh.MeshRead;
import org.robotui.urdf.mesh.MeshReader;
import org.robotui.urdf.pack.PackageFile;
import org.robotui.urdf.pack.PackageFolders;

/**
 * Meshes by their addresses, read once each and in the background. Holds {@link #MOST} meshes and {@link #MOST_BYTES}
 * bytes at most. Safe for all threads.
 */
final class MeshShelf {
  static final int MOST = 256;
  static final long MOST_BYTES = 512L << 20;

  private final DisplayContext context;
  private final Map<String, State> meshes = new ConcurrentHashMap<>();
  private final AtomicLong bytes = new AtomicLong();

  MeshShelf(DisplayContext context) {
    this.context = context;
  }

  /** How far a mesh is. */
  sealed interface State {
    /** It is being read. */
    record Reading() implements State {}

    /**
     * It can be shown.
     *
     * @param surfaces of it
     * @param lack what is missing of them, as a sentence; empty where all is there
     */
    record Ready(List<Surface> surfaces, String lack) implements State {}

    /** It cannot be shown. */
    record Failed(String why) implements State {}
  }

  /**
   * Triangles of one surface.
   *
   * @param mesh the triangles
   * @param color as the file says
   * @param texture its picture
   */
  record Surface(TriangleMesh mesh, Optional<Rgba> color, Optional<Texture> texture) {
    private long bytes() {
      return mesh.bytes() + texture.map(picture -> picture.rgba().remaining()).orElse(0);
    }
  }

  /**
   * Answers at once; a mesh that is asked for the first time is read in the background, and the scene woken when that
   * is done.
   */
  State of(String uri, PackageFolders folders) {
    State known = meshes.get(uri);
    if (known != null) {
      return known;
    }
    if (meshes.size() >= MOST) {
      return new State.Failed("more than " + MOST + " meshes are not read");
    }
    State reading = new State.Reading();
    meshes.put(uri, reading);
    context.background().execute(() -> {
      State read = read(uri, folders);
      if (meshes.replace(uri, reading, read)) {
        context.wake();
      }
    });
    return meshes.getOrDefault(uri, reading);
  }

  void clear() {
    meshes.clear();
    bytes.set(0);
  }

  private State read(String uri, PackageFolders folders) {
    return switch (folders.find(uri)) {
      case PackageFile.Refused refused -> new State.Failed(refused.why());
      case PackageFile.Found file -> read(uri, file, folders);
    };
  }

  private State read(String uri, PackageFile.Found file, PackageFolders folders) {
    try {
      MeshRead read = MeshReader.read(uri, file.bytes(), name -> beside(folders, file, name));
      return switch (read) {
        case MeshRead.Refused refused -> new State.Failed(uri + ": " + refused.why());
        case MeshRead.Ok ok -> kept(uri, surfaces(ok),
            ok.warnings().stream().findFirst().map(words -> uri + ": " + words).orElse(""));
      };
    } catch (IOException e) {
      return new State.Failed(uri + " cannot be read: " + e.getMessage());
    }
  }

  private State kept(String uri, List<Surface> surfaces, String lack) {
    long size = surfaces.stream().mapToLong(Surface::bytes).sum();
    if (bytes.addAndGet(size) > MOST_BYTES) {
      bytes.addAndGet(-size);
      return new State.Failed(uri + ": meshes would take more than " + (MOST_BYTES >> 20) + " MiB");
    }
    return new State.Ready(surfaces, lack);
  }

  private static Optional<byte[]> beside(PackageFolders folders, PackageFile.Found file, String name) {
    return folders.beside(file, name).found().flatMap(found -> {
      try {
        return Optional.of(found.bytes());
      } catch (IOException e) {
        return Optional.empty(); // the reader says that the materials are missing
      }
    });
  }

  private static List<Surface> surfaces(MeshRead.Ok read) {
    Map<String, Texture> textures = new HashMap<>();
    read.pictures().forEach((name, picture) -> textures.put(name,
        new Texture(picture.width(), picture.height(), picture.rgba(), true, true)));
    return read.mesh().parts().stream().map(part -> surface(read.mesh(), part, part.texture().map(textures::get)))
        .toList();
  }

  private static Surface surface(Mesh mesh, Mesh.Part part, Optional<Texture> texture) {
    FloatBuffer xyz = mesh.xyz().slice(3 * part.firstCorner(), 3 * part.corners());
    FloatBuffer normals = mesh.normals().slice(3 * part.firstCorner(), 3 * part.corners());
    Optional<FloatBuffer> uv = texture.flatMap(picture -> mesh.uv()).map(places -> places(places, part));
    IntBuffer triangles = IntBuffer.allocate(3 * part.triangles());
    for (int i = 0; i < triangles.capacity(); i++) {
      triangles.put(i, mesh.triangles().get(3 * part.firstTriangle() + i) - part.firstCorner());
    }
    TriangleMesh shape = new TriangleMesh(xyz, Optional.of(normals), uv, Optional.empty(), triangles, Box3.around(xyz));
    return new Surface(shape, part.color().map(c -> new Rgba(c.red(), c.green(), c.blue(), c.alpha())), texture);
  }

  /** Files count from the bottom of the picture, textures from its first row. */
  private static FloatBuffer places(FloatBuffer from, Mesh.Part part) {
    FloatBuffer places = FloatBuffer.allocate(2 * part.corners());
    for (int i = part.firstCorner(); i < part.firstCorner() + part.corners(); i++) {
      places.put(from.get(2 * i)).put(1 - from.get(2 * i + 1));
    }
    return places.flip();
  }
}
