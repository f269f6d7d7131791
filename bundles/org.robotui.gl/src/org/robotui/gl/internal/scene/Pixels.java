package org.robotui.gl.internal.scene;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Target;
import org.robotui.gl.internal.splat.Splats;
import org.robotui.gl.shape.Rgba;

/** What pictures of one size are drawn into and read from. */
final class Pixels {
  private static final int SAMPLES = 4;
  private static final int COLOR_BYTES = 4;

  private final Target plain;
  /** Several samples a pixel make edges smooth, and cost software three to five times the time. */
  private final Optional<Target> smooth;
  private final Optional<Splats> splats;

  Pixels(Gpu gpu, int width, int height) {
    boolean software = gpu.limits().software();
    plain =
        software ? Target.writable(gpu, width, height) : new Target(gpu, width, height, GL.GL_RGBA8, COLOR_BYTES, 0);
    smooth =
        software ? Optional.empty() : Optional.of(new Target(gpu, width, height, GL.GL_RGBA8, COLOR_BYTES, SAMPLES));
    splats = software ? Optional.of(new Splats(width, height, false)) : Optional.empty();
  }

  boolean fit(int width, int height) {
    return plain.fits(width, height);
  }

  /** Where points are written by the processor; none where OpenGL draws them. */
  Optional<Splats> splats() {
    return splats;
  }

  /** Makes them what is drawn into. */
  void bind(Rgba background) {
    splats.ifPresent(written -> written.clear(background.packed() >>> Byte.SIZE));
    smooth.orElse(plain).bind();
  }

  /** Whether the processor has painted anything. */
  boolean isPainted() {
    return splats.filter(Splats::used).isPresent();
  }

  /** Hands out what the processor has painted, where that is the whole picture: it need not go to OpenGL and back. */
  void copy(int[] rgb) {
    splats.ifPresent(written -> written.values(rgb));
  }

  /** Begins the picture with the splats, where there are some. */
  boolean beginWithSplats(Gpu gpu) {
    Optional<Splats> written = splats.filter(Splats::used);
    written.ifPresent(splatted -> write(gpu, splatted));
    return written.isPresent();
  }

  private void write(Gpu gpu, Splats from) {
    int most = Math.max(1, gpu.stage().capacity() / COLOR_BYTES / from.width());
    for (int row = 0; row < from.height(); row += most) {
      int rows = Math.min(most, from.height() - row);
      IntBuffer colors = gpu.stage().asIntBuffer();
      from.values(row * from.width(), rows * from.width(), colors);
      plain.writeColors(row, rows, colors);
      FloatBuffer depths = gpu.stage().asFloatBuffer();
      from.depths(row * from.width(), rows * from.width(), depths);
      plain.writeDepths(row, rows, depths);
    }
  }

  /** Reads what was drawn, some rows at a time, so that no second copy of a picture is ever held. */
  void read(Gpu gpu, int width, int height, int[] rgb) {
    smooth.ifPresent(samples -> samples.resolve(plain));
    IntBuffer piece = gpu.stage().asIntBuffer();
    int most = Math.max(1, piece.capacity() / width);
    for (int row = 0; row < height; row += most) {
      int rows = Math.min(most, height - row);
      gpu.gl().glReadPixels(0, row, width, rows, GL.GL_BGRA, GL2GL3.GL_UNSIGNED_INT_8_8_8_8_REV, piece);
      piece.get(0, rgb, row * width, rows * width);
    }
  }

  long bytes() {
    return plain.bytes() + smooth.map(Target::bytes).orElse(0L);
  }

  void delete() {
    plain.delete();
    smooth.ifPresent(Target::delete);
  }
}
