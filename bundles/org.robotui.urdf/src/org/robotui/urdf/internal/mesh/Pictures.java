package org.robotui.urdf.internal.mesh;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.urdf.mesh.Mesh;
import org.robotui.urdf.mesh.Picture;
import org.robotui.urdf.mesh.PictureRead;
import org.robotui.urdf.mesh.PictureReader;

/** Reads the pictures of a mesh, each once. A surface whose picture cannot be read keeps its colour. */
public final class Pictures {
  private static final int MOST = 64;
  private static final long MOST_BYTES = 256L << 20;

  private final List<String> warnings;
  private final Function<String, Optional<byte[]>> beside;
  private final Map<String, Picture> pictures = new HashMap<>();
  private long bytes;

  /** Takes where warnings go, and what gives files beside the mesh. */
  public Pictures(List<String> warnings, Function<String, Optional<byte[]>> beside) {
    this.warnings = warnings;
    this.beside = beside;
  }

  /** The pictures that there are, by name as the parts have it. */
  public Map<String, Picture> read(Mesh mesh) {
    if (mesh.uv().isPresent()) {
      mesh.parts().stream().flatMap(part -> part.texture().stream()).distinct().forEach(this::read);
    }
    return pictures;
  }

  private void read(String name) {
    if (pictures.size() >= MOST || bytes > MOST_BYTES) {
      warn(name, "the mesh has more than " + MOST + " pictures, or they take more than " + (MOST_BYTES >> 20) + " MB");
      return;
    }
    Optional<byte[]> file = beside.apply(name).or(() -> decoded(name).flatMap(beside));
    if (file.isEmpty()) {
      warn(name, "there is no such file in its package");
      return;
    }
    switch (PictureReader.read(file.get())) {
      case PictureRead.Refused refused -> warn(name, refused.why());
      case PictureRead.Ok ok -> {
        pictures.put(name, ok.picture());
        bytes += ok.picture().rgba().remaining();
      }
    }
  }

  private void warn(String name, String why) {
    warnings.add("its picture '" + name + "' is not shown: " + why);
  }

  /** COLLADA writes URIs, where a space is {@code %20}. */
  private static Optional<String> decoded(String name) {
    try {
      return Optional.of(URLDecoder.decode(name.replace("+", "%2B"), StandardCharsets.UTF_8))
          .filter(text -> !text.equals(name));
    } catch (IllegalArgumentException e) {
      // a lonely % is a part of the name
      return Optional.empty();
    }
  }
}
