package org.robotui.gl.internal.splat;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.gpu.GpuTexture;
import org.robotui.gl.internal.gpu.Program;
import org.robotui.gl.internal.gpu.VertexArray;

/** Brings splats into the picture of OpenGL, with their depths, so that they hide and are hidden as if it had drawn them. */
public final class Overlay {
  private final GL3 gl;
  private final GpuTexture colors;
  private final GpuTexture depths;
  private final VertexArray nothing;

  /**
   * Makes room.
   *
   * @param gpu where
   * @param width pixels
   * @param height rows
   */
  public Overlay(Gpu gpu, int width, int height) {
    gl = gpu.gl();
    colors = GpuTexture.ofPixels(gpu, width, height, GL.GL_RGBA8, GL.GL_BGRA, GL2GL3.GL_UNSIGNED_INT_8_8_8_8_REV);
    depths = GpuTexture.ofPixels(gpu, width, height, GL.GL_R32F, GL2GL3.GL_RED, GL.GL_FLOAT);
    nothing = new VertexArray(gpu);
  }

  /**
   * Draws them.
   *
   * @param splats of this size
   * @param program that takes both textures to where they belong
   */
  public void draw(Splats splats, Program program) {
    if (!splats.used()) {
      return;
    }
    nothing.bind();
    program.use();
    program.unit("colors", 0);
    program.unit("depths", 1);
    depths.refill(1, splats.width(), splats.height(), FloatBuffer.wrap(splats.depths()));
    colors.refill(0, splats.width(), splats.height(), IntBuffer.wrap(splats.values()));
    gl.glDepthRange(0, 1);
    gl.glDrawArrays(GL.GL_TRIANGLES, 0, 3);
  }

  /**
   * What it takes.
   *
   * @return bytes
   */
  public long bytes() {
    return colors.bytes() + depths.bytes();
  }

  /** Frees it. */
  public void delete() {
    colors.delete();
    depths.delete();
    nothing.delete();
  }
}
