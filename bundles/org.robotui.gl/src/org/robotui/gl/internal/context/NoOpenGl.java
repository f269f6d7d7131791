package org.robotui.gl.internal.context;

/** There is no OpenGL. The message is the reason. */
public final class NoOpenGl extends Exception {
  private static final long serialVersionUID = 1;

  private final String remedy;

  NoOpenGl(String reason, String remedy) {
    super(reason);
    this.remedy = remedy;
  }

  /**
   * What would help.
   *
   * @return a sentence
   */
  public String remedy() {
    return remedy;
  }
}
