package org.robotui.gl.internal.gpu;

/** OpenGL did not do what it was told; its context is not to be used any more. */
public final class GpuFailure extends RuntimeException {
  private static final long serialVersionUID = 1;

  /**
   * Names the failure.
   *
   * @param message a sentence
   */
  public GpuFailure(String message) {
    super(message);
  }
}
