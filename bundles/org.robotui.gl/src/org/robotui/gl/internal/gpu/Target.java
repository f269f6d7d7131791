package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL2GL3;
import com.jogamp.opengl.GL3;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import org.robotui.gl.internal.gpu.Ledger.Kind;

/** What is drawn into: pixels of one format, and their depths. */
public final class Target {
  private static final int DEPTH_BYTES = 4;

  private final Gpu gpu;
  private final int width;
  private final int height;
  private final long bytes;
  private final int frame;
  private final List<Integer> buffers = new ArrayList<>();
  private final List<GpuTexture> textures = new ArrayList<>();

  /**
   * Makes one.
   *
   * @param gpu where
   * @param width pixels
   * @param height rows
   * @param format of the pixels
   * @param pixelBytes of one pixel
   * @param samples of each pixel, 0 for one without smoothing
   */
  public Target(Gpu gpu, int width, int height, int format, int pixelBytes, int samples) {
    this(gpu, width, height, (long) width * height * (pixelBytes + DEPTH_BYTES) * Math.max(1, samples));
    gpu.ledger().grew(bytes);
    attach(format, GL.GL_COLOR_ATTACHMENT0, samples);
    attach(GL.GL_DEPTH_COMPONENT24, GL.GL_DEPTH_ATTACHMENT, samples);
    requireComplete();
  }

  private Target(Gpu gpu, int width, int height, long bytes) {
    this.gpu = gpu;
    this.width = width;
    this.height = height;
    this.bytes = bytes;
    int[] ids = new int[1];
    gpu.gl().glGenFramebuffers(1, ids, 0);
    frame = gpu.made(Kind.FRAMEBUFFER, ids[0]);
    bind();
  }

  /**
   * Makes one of plain colours into which the processor may write, too.
   *
   * @param gpu where
   * @param width pixels
   * @param height rows
   * @return one without smoothing
   */
  public static Target writable(Gpu gpu, int width, int height) {
    Target made = new Target(gpu, width, height, 0);
    made.attach(GpuTexture.ofPixels(gpu, width, height, GL.GL_RGBA8, GL.GL_BGRA, GL2GL3.GL_UNSIGNED_INT_8_8_8_8_REV),
        GL.GL_COLOR_ATTACHMENT0);
    made.attach(
        GpuTexture.ofPixels(gpu, width, height, GL3.GL_DEPTH_COMPONENT32F, GL2ES2.GL_DEPTH_COMPONENT, GL.GL_FLOAT),
        GL.GL_DEPTH_ATTACHMENT);
    made.requireComplete();
    return made;
  }

  private void attach(int format, int place, int samples) {
    GL3 gl = gpu.gl();
    int[] ids = new int[1];
    gl.glGenRenderbuffers(1, ids, 0);
    buffers.add(gpu.made(Kind.RENDERBUFFER, ids[0]));
    gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, ids[0]);
    gl.glRenderbufferStorageMultisample(GL.GL_RENDERBUFFER, samples, format, width, height);
    gl.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, place, GL.GL_RENDERBUFFER, ids[0]);
  }

  private void attach(GpuTexture texture, int place) {
    textures.add(texture);
    gpu.gl().glFramebufferTexture2D(GL.GL_FRAMEBUFFER, place, GL.GL_TEXTURE_2D, texture.id(), 0);
  }

  private void requireComplete() {
    int state = gpu.gl().glCheckFramebufferStatus(GL.GL_FRAMEBUFFER);
    if (state != GL.GL_FRAMEBUFFER_COMPLETE) {
      throw new GpuFailure(
          "OpenGL makes no picture of " + width + " x " + height + ": state 0x" + Integer.toHexString(state));
    }
  }

  /**
   * Whether it has this size.
   *
   * @param wantedWidth pixels
   * @param wantedHeight rows
   * @return true where it has
   */
  public boolean fits(int wantedWidth, int wantedHeight) {
    return width == wantedWidth && height == wantedHeight;
  }

  /** Makes it the one that is drawn into and read from. */
  public void bind() {
    gpu.gl().glBindFramebuffer(GL.GL_FRAMEBUFFER, frame);
    gpu.gl().glViewport(0, 0, width, height);
  }

  /**
   * Copies the pixels, each the mean of its samples, and makes the other the one that is read from.
   *
   * @param to of the same size, without samples
   */
  public void resolve(Target to) {
    gpu.gl().glBindFramebuffer(GL3.GL_READ_FRAMEBUFFER, frame);
    gpu.gl().glBindFramebuffer(GL3.GL_DRAW_FRAMEBUFFER, to.frame);
    gpu.gl().glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL.GL_COLOR_BUFFER_BIT, GL.GL_NEAREST);
    to.bind();
  }

  /**
   * Takes some rows in place of what is there. Only one that was made writable does.
   *
   * @param row the first
   * @param rows how many
   * @param pixels red in bits 16 to 23, green in 8 to 15, blue in 0 to 7
   */
  public void writeColors(int row, int rows, IntBuffer pixels) {
    textures.getFirst().refill(row, width, rows, pixels);
  }

  /**
   * Takes the depths of some rows in place of what is there. Only one that was made writable does.
   *
   * @param row the first
   * @param rows how many
   * @param depths 0 at the front to 1 at the back
   */
  public void writeDepths(int row, int rows, FloatBuffer depths) {
    textures.getLast().refill(row, width, rows, depths);
  }

  /**
   * What it takes.
   *
   * @return bytes
   */
  public long bytes() {
    return bytes + textures.stream().mapToLong(GpuTexture::bytes).sum();
  }

  /** Frees it. */
  public void delete() {
    gpu.gl().glDeleteFramebuffers(1, new int[]{frame}, 0);
    gpu.ledger().freed(Kind.FRAMEBUFFER);
    for (int buffer : buffers) {
      gpu.gl().glDeleteRenderbuffers(1, new int[]{buffer}, 0);
      gpu.ledger().freed(Kind.RENDERBUFFER);
    }
    textures.forEach(GpuTexture::delete);
    gpu.ledger().grew(-bytes);
  }
}
