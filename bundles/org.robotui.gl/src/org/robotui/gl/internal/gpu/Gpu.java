package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.gl.internal.gpu.Ledger.Kind;

/**
 * One context of OpenGL while it lives, and the count of what it holds. Used on the thread of OpenGL alone. What was
 * made by one is forgotten with it: nothing is moved to another.
 */
public final class Gpu {
  /** Bytes of a piece. */
  private static final int STAGE = 1 << 20;

  private final GL3 gl;
  private final Ledger ledger = new Ledger();
  private final Limits limits;
  private final ByteBuffer stage = ByteBuffer.allocateDirect(STAGE).order(ByteOrder.nativeOrder());

  /**
   * Takes a current context.
   *
   * @param gl its functions
   */
  public Gpu(GL3 gl) {
    this.gl = gl;
    limits = Limits.of(gl);
  }

  /**
   * The functions.
   *
   * @return of the context
   */
  public GL3 gl() {
    return gl;
  }

  /**
   * What it holds.
   *
   * @return the count
   */
  public Ledger ledger() {
    return ledger;
  }

  /**
   * What it can do.
   *
   * @return its limits
   */
  public Limits limits() {
    return limits;
  }

  /**
   * Memory by which numbers travel between the heap and the graphics card, a piece at a time.
   *
   * @return {@value #STAGE} bytes, the same ones in each call
   */
  public ByteBuffer stage() {
    return stage.clear();
  }

  /**
   * Fails where OpenGL has noted an error since the last call, so that the context is made anew.
   *
   * @param doing for the message
   */
  public void check(String doing) {
    int error = gl.glGetError();
    if (error != GL.GL_NO_ERROR) {
      throw new GpuFailure("OpenGL fails at " + doing + ": " + name(error));
    }
  }

  private static String name(int error) {
    return switch (error) {
      case GL.GL_OUT_OF_MEMORY -> "out of memory";
      case GL.GL_INVALID_ENUM -> "invalid name";
      case GL.GL_INVALID_VALUE -> "invalid value";
      case GL.GL_INVALID_OPERATION -> "invalid operation";
      case GL.GL_INVALID_FRAMEBUFFER_OPERATION -> "invalid framebuffer";
      default -> "error 0x" + Integer.toHexString(error);
    };
  }

  int made(Kind kind, int id) {
    ledger.made(kind);
    return id;
  }
}
