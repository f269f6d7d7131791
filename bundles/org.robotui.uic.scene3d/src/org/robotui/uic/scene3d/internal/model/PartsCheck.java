package org.robotui.uic.scene3d.internal.model;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;

/** Compares what displays show without looking into buffers. */
final class PartsCheck {
  private PartsCheck() {}

  /** Whether a picture of both would be the same. */
  static boolean same(List<Part> some, List<Part> others) {
    if (some == others) {
      return true;
    }
    boolean same = some.size() == others.size();
    for (int i = 0; same && i < some.size(); i++) {
      same = same(some.get(i), others.get(i));
    }
    return same;
  }

  private static boolean same(Part one, Part other) {
    return one == other || one.shape() == other.shape() && one.key().equals(other.key())
        && one.fixedFromShape().equals(other.fixedFromShape()) && same(one.material(), other.material())
        && one.handle().isPresent() == other.handle().isPresent();
  }

  private static boolean same(Material one, Material other) {
    return one == other || one.color().equals(other.color()) && one.lit() == other.lit() && one.depth() == other.depth()
        && one.texture().orElse(null) == other.texture().orElse(null);
  }

  /** A display that gives two parts one key would make the renderer show only one of them, and not say which. */
  static void distinct(List<Part> parts) {
    Set<Object> keys = new HashSet<>();
    for (Part part : parts) {
      if (!keys.add(part.key())) {
        throw new IllegalStateException("two parts have the key " + part.key());
      }
    }
  }

  /** The memory of shapes, each counted once. */
  static long bytes(List<Part> parts) {
    Set<Integer> seen = new HashSet<>();
    long shapes = parts.stream().map(Part::shape).filter(s -> seen.add(System.identityHashCode(s)))
        .mapToLong(s -> s.bytes()).sum();
    long pictures =
        parts.stream().flatMap(p -> p.material().texture().stream()).filter(t -> seen.add(System.identityHashCode(t)))
            .mapToLong(t -> t.rgba().remaining()).sum();
    return shapes + pictures;
  }
}
