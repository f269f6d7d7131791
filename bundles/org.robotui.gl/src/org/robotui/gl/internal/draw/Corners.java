package org.robotui.gl.internal.draw;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuBuffer;
import org.robotui.gl.internal.gpu.VertexArray;

/** Places with colours, as points, lines and meshes have them. */
final class Corners {
  static final int PLACE = 0;
  static final int COLOR = 1;

  private final Gpu gpu;
  private final GpuBuffer places;
  private Optional<GpuBuffer> colors = Optional.empty();
  private boolean colored;
  private boolean translucent;

  Corners(Gpu gpu) {
    this.gpu = gpu;
    places = GpuBuffer.ofVertices(gpu);
  }

  /** Takes them; answers the bytes sent. */
  long fill(FloatBuffer xyz, Optional<ByteBuffer> rgba) {
    long sent = places.fill(xyz);
    colored = rgba.isPresent();
    translucent = Opacity.translucent(rgba);
    if (colored) {
      GpuBuffer buffer = colors.orElseGet(() -> GpuBuffer.ofVertices(gpu));
      colors = Optional.of(buffer);
      sent += buffer.fill(rgba.get());
    }
    return sent;
  }

  /** Lays every n-th into the vertex array that is bound. */
  void lay(VertexArray array, int every) {
    array.floats(PLACE, places, 3, every);
    if (colored) {
      array.colors(COLOR, colors.orElseThrow(), every);
    } else {
      array.white(COLOR);
    }
  }

  /** A value for all vertices belongs to the context, not to the vertex array. */
  void whiten(VertexArray array) {
    if (!colored) {
      array.white(COLOR);
    }
  }

  boolean translucent() {
    return translucent;
  }

  long bytes() {
    return places.bytes() + colors.map(GpuBuffer::bytes).orElse(0L);
  }

  void delete() {
    places.delete();
    colors.ifPresent(GpuBuffer::delete);
  }
}
