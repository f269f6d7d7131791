package org.robotui.gl.internal.scene;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.gl.internal.draw.Drawn;
import org.robotui.gl.internal.draw.Opacity;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuTexture;
import org.robotui.gl.shape.Shape;
import org.robotui.gl.shape.Texture;

/** The shapes and textures of one scene on the graphics card, each once however many parts show it. */
final class Pool {
  private static final class Held<T> {
    private final T thing;
    private int users;

    Held(T thing) {
      this.thing = thing;
    }
  }

  /**
   * A texture.
   *
   * @param texture on the graphics card
   * @param translucent whether some pixels are
   */
  record Picture(GpuTexture texture, boolean translucent) {}

  private final Gpu gpu;
  private final Map<Shape, Held<Drawn>> shapes = new IdentityHashMap<>();
  private final Map<Texture, Held<Picture>> textures = new IdentityHashMap<>();
  private long sent;

  Pool(Gpu gpu) {
    this.gpu = gpu;
  }

  /** Exchanges the shape of a part. Where no other part shows the old one, its buffers are refilled. */
  Drawn exchange(Optional<Shape> old, Shape wanted) {
    Held<Drawn> held = shapes.get(wanted);
    if (held == null) {
      held = old.flatMap(shape -> refillable(shape, wanted)).orElseGet(() -> new Held<>(Drawn.of(gpu, wanted)));
      shapes.put(wanted, held);
      sent += held.thing.fill(wanted);
    } else {
      old.ifPresent(this::release);
    }
    held.users++;
    return held.thing;
  }

  /** The old shape's place, taken from it, where it has no other user. */
  private Optional<Held<Drawn>> refillable(Shape old, Shape wanted) {
    Held<Drawn> held = shapes.get(old);
    if (held.users > 1 || !held.thing.takes(wanted)) {
      release(old);
      return Optional.empty();
    }
    shapes.remove(old);
    held.users = 0;
    return Optional.of(held);
  }

  void release(Shape shape) {
    Held<Drawn> held = shapes.get(shape);
    if (--held.users == 0) {
      shapes.remove(shape);
      held.thing.delete();
    }
  }

  Picture take(Texture texture) {
    Held<Picture> held = textures.computeIfAbsent(texture, this::send);
    held.users++;
    return held.thing;
  }

  private Held<Picture> send(Texture texture) {
    sent += texture.rgba().remaining();
    return new Held<>(new Picture(GpuTexture.of(gpu, texture), Opacity.translucent(texture)));
  }

  void release(Texture texture) {
    Held<Picture> held = textures.get(texture);
    if (--held.users == 0) {
      textures.remove(texture);
      held.thing.texture().delete();
    }
  }

  /** The bytes sent since the last call. */
  long takeSent() {
    long result = sent;
    sent = 0;
    return result;
  }

  long bytes() {
    return shapes.values().stream().mapToLong(held -> held.thing.bytes()).sum()
        + textures.values().stream().mapToLong(held -> held.thing.texture().bytes()).sum();
  }

  void delete() {
    shapes.values().forEach(held -> held.thing.delete());
    textures.values().forEach(held -> held.thing.texture().delete());
    shapes.clear();
    textures.clear();
  }
}
