package org.robotui.gl.internal.scene;

import java.util.Optional;
import org.robotui.gl.internal.draw.Drawn;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Texture;

/** A part on the graphics card. */
final class Resident {
  private final Pool pool;
  private final Object display;
  private Part part;
  private Drawn drawn;
  private Optional<Pool.Picture> picture;

  Resident(Pool pool, Object display, Part part) {
    this.pool = pool;
    this.display = display;
    this.part = part;
    drawn = pool.exchange(Optional.empty(), part.shape());
    picture = part.material().texture().map(pool::take);
  }

  /** Shows a newer part of the same key. */
  void update(Part newer) {
    if (newer.shape() != part.shape()) {
      drawn = pool.exchange(Optional.of(part.shape()), newer.shape());
    }
    Optional<Texture> texture = newer.material().texture();
    if (!same(texture, part.material().texture())) {
      Optional<Pool.Picture> taken = texture.map(pool::take);
      part.material().texture().ifPresent(pool::release);
      picture = taken;
    }
    part = newer;
  }

  /** Textures are compared as objects, for their pixels are many. */
  private static boolean same(Optional<Texture> a, Optional<Texture> b) {
    return a.isPresent() == b.isPresent() && (a.isEmpty() || a.get() == b.get());
  }

  Object display() {
    return display;
  }

  Part part() {
    return part;
  }

  Drawn drawn() {
    return drawn;
  }

  Optional<Pool.Picture> picture() {
    return picture;
  }

  /** Whether what lies behind may be seen through it. */
  boolean translucent() {
    Material material = part.material();
    return material.color().alpha() < 1 || drawn.translucent() || picture.map(Pool.Picture::translucent).orElse(false);
  }

  boolean onTop() {
    return part.material().depth() == Material.Depth.ON_TOP;
  }

  void release() {
    pool.release(part.shape());
    part.material().texture().ifPresent(pool::release);
  }
}
