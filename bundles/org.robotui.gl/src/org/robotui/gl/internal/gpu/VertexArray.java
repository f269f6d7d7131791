package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import org.robotui.gl.internal.gpu.Ledger.Kind;

/** How vertices lie in buffers. */
public final class VertexArray {
  private static final int FLOAT = 4;

  private final Gpu gpu;
  private final int id;

  /**
   * An empty one.
   *
   * @param gpu where
   */
  public VertexArray(Gpu gpu) {
    this.gpu = gpu;
    int[] ids = new int[1];
    gpu.gl().glGenVertexArrays(1, ids, 0);
    id = gpu.made(Kind.VERTEX_ARRAY, ids[0]);
  }

  /** Makes it the one that is meant. */
  public void bind() {
    gpu.gl().glBindVertexArray(id);
  }

  /**
   * Floats of a buffer, one after the other.
   *
   * @param slot of the shader
   * @param buffer where they are
   * @param each how many a vertex
   * @param every 1 for all vertices, n for every n-th
   */
  public void floats(int slot, GpuBuffer buffer, int each, int every) {
    floats(slot, buffer, each, FLOAT * each * every, 0);
  }

  /**
   * Some floats of longer rows.
   *
   * @param slot of the shader
   * @param buffer where they are
   * @param each how many a vertex
   * @param stride bytes from one row to the next
   * @param offset bytes before the first
   */
  public void floats(int slot, GpuBuffer buffer, int each, int stride, int offset) {
    buffer.bind();
    gpu.gl().glVertexAttribPointer(slot, each, GL.GL_FLOAT, false, stride, offset);
    gpu.gl().glEnableVertexAttribArray(slot);
  }

  /**
   * Colours of four bytes.
   *
   * @param slot of the shader
   * @param buffer where they are
   * @param every 1 for all vertices, n for every n-th
   */
  public void colors(int slot, GpuBuffer buffer, int every) {
    buffer.bind();
    gpu.gl().glVertexAttribPointer(slot, 4, GL.GL_UNSIGNED_BYTE, true, 4 * every, 0);
    gpu.gl().glEnableVertexAttribArray(slot);
  }

  /**
   * One value for all vertices: white.
   *
   * @param slot of the shader
   */
  public void white(int slot) {
    gpu.gl().glDisableVertexAttribArray(slot);
    gpu.gl().glVertexAttrib4f(slot, 1, 1, 1, 1);
  }

  /**
   * One value for all vertices: nothing.
   *
   * @param slot of the shader
   */
  public void none(int slot) {
    gpu.gl().glDisableVertexAttribArray(slot);
  }

  /**
   * Moves on once an instance, and not once a vertex.
   *
   * @param slots of the shader
   */
  public void perInstance(int... slots) {
    for (int slot : slots) {
      gpu.gl().glVertexAttribDivisor(slot, 1);
    }
  }

  /** Frees it. */
  public void delete() {
    gpu.gl().glDeleteVertexArrays(1, new int[]{id}, 0);
    gpu.ledger().freed(Kind.VERTEX_ARRAY);
  }
}
