package org.robotui.gl.internal.pick;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2ES3;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Optional;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.Target;
import org.robotui.gl.internal.splat.Splats;

/** The few pixels around the pointer, each with the part and the element that is there. */
public final class Picker {
  /** Pixels along an edge; an odd number, so that one is in the middle. */
  public static final int SIDE = 13;

  private static final int ID_BYTES = 8;

  /**
   * What is at a pixel.
   *
   * @param part id of the part
   * @param element of the part
   * @param x pixels right of the middle
   * @param y pixels below the middle
   * @param depth 0 at the front to 1 at the back, as OpenGL keeps it
   */
  public record Found(int part, int element, int x, int y, double depth) {}

  private final Gpu gpu;
  private final Target target;

  /**
   * Makes the pixels.
   *
   * @param gpu where
   */
  public Picker(Gpu gpu) {
    this.gpu = gpu;
    target = new Target(gpu, SIDE, SIDE, GL3.GL_RG32UI, ID_BYTES, 0);
  }

  /** Makes them what is drawn into, and clears them: nothing is there. */
  public void begin() {
    target.bind();
    GL3 gl = gpu.gl();
    gl.glColorMask(true, true, true, true);
    gl.glDepthMask(true);
    gl.glClear(GL.GL_DEPTH_BUFFER_BIT);
    gl.glClearBufferuiv(GL2ES3.GL_COLOR, 0, new int[4], 0);
  }

  /**
   * Reads what was drawn.
   *
   * @param splats what was written beside OpenGL
   * @return what is nearest to the middle
   */
  public Optional<Found> nearest(Splats splats) {
    IntBuffer ids = direct(SIDE * SIDE * ID_BYTES).asIntBuffer();
    FloatBuffer depths = direct(SIDE * SIDE * Float.BYTES).asFloatBuffer();
    gpu.gl().glReadPixels(0, 0, SIDE, SIDE, GL3.GL_RG_INTEGER, GL.GL_UNSIGNED_INT, ids);
    gpu.gl().glReadPixels(0, 0, SIDE, SIDE, GL2ES2.GL_DEPTH_COMPONENT, GL.GL_FLOAT, depths);
    for (int i = 0; i < SIDE * SIDE; i++) {
      if (splats.depth(i) < Math.min(depths.get(i), Splats.NOTHING)) {
        ids.put(2 * i, splats.part(i)).put(2 * i + 1, splats.element(i));
        depths.put(i, splats.depth(i));
      }
    }
    int best = -1;
    for (int i = 0; i < SIDE * SIDE; i++) {
      if (ids.get(2 * i) != 0 && (best < 0 || distance(i) < distance(best))) {
        best = i;
      }
    }
    return best < 0
        ? Optional.empty()
        : Optional.of(new Found(ids.get(2 * best), ids.get(2 * best + 1), column(best), row(best), depths.get(best)));
  }

  private static ByteBuffer direct(int bytes) {
    return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
  }

  private static int distance(int pixel) {
    return column(pixel) * column(pixel) + row(pixel) * row(pixel);
  }

  private static int column(int pixel) {
    return pixel % SIDE - SIDE / 2;
  }

  private static int row(int pixel) {
    return pixel / SIDE - SIDE / 2;
  }

  /** Frees them. */
  public void delete() {
    target.delete();
  }
}
