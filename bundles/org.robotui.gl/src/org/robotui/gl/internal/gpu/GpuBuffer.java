package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import org.robotui.gl.internal.gpu.Ledger.Kind;

/** Numbers on the graphics card. Refilled where they fit; grown by half more than is needed where not. */
public final class GpuBuffer {
  private static final int UNIT = 4;

  private final Gpu gpu;
  private final int target;
  private final int id;
  private long capacity;

  private GpuBuffer(Gpu gpu, int target) {
    this.gpu = gpu;
    this.target = target;
    int[] ids = new int[1];
    gpu.gl().glGenBuffers(1, ids, 0);
    id = gpu.made(Kind.BUFFER, ids[0]);
  }

  /**
   * A buffer for vertices.
   *
   * @param gpu where
   * @return an empty one
   */
  public static GpuBuffer ofVertices(Gpu gpu) {
    return new GpuBuffer(gpu, GL.GL_ARRAY_BUFFER);
  }

  /**
   * A buffer for indices.
   *
   * @param gpu where
   * @return an empty one
   */
  public static GpuBuffer ofIndices(Gpu gpu) {
    return new GpuBuffer(gpu, GL.GL_ELEMENT_ARRAY_BUFFER);
  }

  /** Makes it the one that is meant. */
  public void bind() {
    gpu.gl().glBindBuffer(target, id);
  }

  /**
   * Takes numbers, from position to limit, whose position stays.
   *
   * @param numbers floats, integers or bytes in fours
   * @return the bytes sent
   */
  public long fill(Buffer numbers) {
    long bytes = (long) numbers.remaining() * (numbers instanceof ByteBuffer ? 1 : UNIT);
    // The binding of indices belongs to the vertex array that is bound, so that both are filled by the other target.
    gpu.gl().glBindBuffer(GL.GL_ARRAY_BUFFER, id);
    if (bytes > capacity) {
      reserve(capacity == 0 ? bytes : bytes + bytes / 2);
    }
    if (numbers.isDirect()) {
      gpu.gl().glBufferSubData(GL.GL_ARRAY_BUFFER, 0, bytes, numbers);
    } else {
      sendInPieces(numbers);
    }
    return bytes;
  }

  private void reserve(long bytes) {
    gpu.gl().glBufferData(GL.GL_ARRAY_BUFFER, bytes, null, GL3.GL_DYNAMIC_DRAW);
    gpu.check("making a buffer of " + bytes + " bytes");
    gpu.ledger().grew(bytes - capacity);
    capacity = bytes;
  }

  private void sendInPieces(Buffer numbers) {
    Buffer rest = numbers.duplicate();
    long at = 0;
    while (rest.hasRemaining()) {
      ByteBuffer stage = gpu.stage();
      int bytes = stagePiece(rest, stage);
      gpu.gl().glBufferSubData(GL.GL_ARRAY_BUFFER, at, bytes, stage.limit(bytes).position(0));
      at += bytes;
    }
  }

  private static int stagePiece(Buffer rest, ByteBuffer stage) {
    int unit = rest instanceof ByteBuffer ? 1 : UNIT;
    int count = Math.min(rest.remaining(), stage.capacity() / unit);
    switch (rest) {
      case FloatBuffer floats -> stage.asFloatBuffer().put(floats.slice(floats.position(), count));
      case IntBuffer ints -> stage.asIntBuffer().put(ints.slice(ints.position(), count));
      case ByteBuffer bytes -> stage.put(bytes.slice(bytes.position(), count));
      default -> throw new IllegalArgumentException("no numbers that are sent: " + rest.getClass());
    }
    rest.position(rest.position() + count);
    return count * unit;
  }

  /**
   * What it takes.
   *
   * @return bytes
   */
  public long bytes() {
    return capacity;
  }

  /** Frees it. */
  public void delete() {
    gpu.gl().glDeleteBuffers(1, new int[]{id}, 0);
    gpu.ledger().freed(Kind.BUFFER);
    gpu.ledger().grew(-capacity);
    capacity = 0;
  }
}
