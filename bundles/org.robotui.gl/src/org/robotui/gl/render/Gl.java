package org.robotui.gl.render;

/** The graphics of this machine; a singleton OSGi service, which is there also where OpenGL is not. */
public interface Gl {
  /**
   * Makes a renderer. Returns at once: whether OpenGL works is seen with the first picture.
   *
   * @param name for messages
   * @return a renderer that the caller closes
   */
  Renderer open(String name);
}
