package org.robotui.gl.internal.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import org.robotui.gl.internal.gpu.Ledger.Kind;

/** What is drawn into: pixels of one format, and their depths. */
public final class Target {
  private static final int DEPTH_BYTES = 4;

  private final Gpu gpu;
  private final int width;
  private final int height;
  private final long bytes;
  private final int frame;
  private final int[] pixels = new int[2];

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
    this.gpu = gpu;
    this.width = width;
    this.height = height;
    bytes = (long) width * height * (pixelBytes + DEPTH_BYTES) * Math.max(1, samples);
    int[] ids = new int[1];
    gpu.gl().glGenFramebuffers(1, ids, 0);
    frame = gpu.made(Kind.FRAMEBUFFER, ids[0]);
    gpu.gl().glGenRenderbuffers(2, pixels, 0);
    gpu.made(Kind.RENDERBUFFER, pixels[0]);
    gpu.made(Kind.RENDERBUFFER, pixels[1]);
    gpu.ledger().grew(bytes);
    bind();
    attach(pixels[0], format, GL.GL_COLOR_ATTACHMENT0, samples);
    attach(pixels[1], GL.GL_DEPTH_COMPONENT24, GL.GL_DEPTH_ATTACHMENT, samples);
    requireComplete();
  }

  private void attach(int buffer, int format, int place, int samples) {
    GL3 gl = gpu.gl();
    gl.glBindRenderbuffer(GL.GL_RENDERBUFFER, buffer);
    gl.glRenderbufferStorageMultisample(GL.GL_RENDERBUFFER, samples, format, width, height);
    gl.glFramebufferRenderbuffer(GL.GL_FRAMEBUFFER, place, GL.GL_RENDERBUFFER, buffer);
  }

  private void requireComplete() {
    int state = gpu.gl().glCheckFramebufferStatus(GL.GL_FRAMEBUFFER);
    if (state != GL.GL_FRAMEBUFFER_COMPLETE) {
      throw new GpuFailure("OpenGL makes no picture of " + width + " x " + height + ": state 0x" + Integer.toHexString(state));
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
   * What it takes.
   *
   * @return bytes
   */
  public long bytes() {
    return bytes;
  }

  /** Frees it. */
  public void delete() {
    gpu.gl().glDeleteFramebuffers(1, new int[] {frame}, 0);
    gpu.gl().glDeleteRenderbuffers(2, pixels, 0);
    gpu.ledger().freed(Kind.FRAMEBUFFER);
    gpu.ledger().freed(Kind.RENDERBUFFER);
    gpu.ledger().freed(Kind.RENDERBUFFER);
    gpu.ledger().grew(-bytes);
  }
}
