package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Locale;

/**
 * What a context can do.
 *
 * @param picture pixels along an edge of what is drawn into
 * @param texture pixels along an edge of a texture
 * @param lineWidth pixels
 * @param stride bytes from one vertex to the next
 * @param software whether the processor draws
 */
public record Limits(int picture, int texture, float lineWidth, int stride, boolean software) {
  private static final List<String> PROCESSORS = List.of("llvmpipe", "softpipe", "swrast", "software", "swr");

  /** What every implementation takes, and OpenGL 3 does not tell. */
  private static final int SAFE_STRIDE = 2048;

  static Limits of(GL3 gl) {
    int picture = Math.min(Math.min(asInt(gl, GL.GL_MAX_RENDERBUFFER_SIZE), asInt(gl, GL.GL_MAX_TEXTURE_SIZE)),
        asInt(gl, GL3.GL_MAX_VIEWPORT_DIMS));
    String renderer = gl.glGetString(GL.GL_RENDERER).toLowerCase(Locale.ROOT);
    boolean software = PROCESSORS.stream().anyMatch(renderer::contains);
    return new Limits(picture, asInt(gl, GL.GL_MAX_TEXTURE_SIZE), lineWidth(gl), SAFE_STRIDE, software);
  }

  private static int asInt(GL3 gl, int what) {
    int[] value = new int[2];
    gl.glGetIntegerv(what, value, 0);
    return value[0];
  }

  private static float lineWidth(GL3 gl) {
    float[] range = new float[2];
    gl.glGetFloatv(GL.GL_ALIASED_LINE_WIDTH_RANGE, range, 0);
    return Math.max(1, range[1]);
  }
}
