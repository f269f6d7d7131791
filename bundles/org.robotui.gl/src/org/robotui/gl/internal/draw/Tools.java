package org.robotui.gl.internal.draw;

import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.text.GlyphTexture;

/**
 * What all pictures of a context share.
 *
 * @param programs the shaders
 * @param glyphs of labels
 */
public record Tools(Programs programs, GlyphTexture glyphs) {
  /**
   * Makes them; each comes to the graphics card when it is first needed.
   *
   * @param gpu the context
   * @return the tools
   */
  public static Tools of(Gpu gpu) {
    return new Tools(new Programs(gpu), new GlyphTexture(gpu));
  }

  /** Frees them. */
  public void delete() {
    programs.delete();
    glyphs.delete();
  }
}
