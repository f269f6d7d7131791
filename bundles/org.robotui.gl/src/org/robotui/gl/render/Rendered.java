package org.robotui.gl.render;

import java.util.List;

/** What became of a request for a picture. */
public sealed interface Rendered {
  /**
   * A picture.
   *
   * @param width pixels
   * @param height pixels
   * @param rgb row by row from the top, red in bits 16 to 23, green in 8 to 15, blue in 0 to 7; belongs to the
   * receiver, who may hand it back by {@link Renderer#recycle(Picture)}
   * @param figures how it was made
   * @param problems parts that could not be drawn, each a sentence; empty where all is well
   */
  record Picture(int width, int height, int[] rgb, Figures figures, List<String> problems) implements Rendered {}

  /** A newer request took its place, or it was given up. */
  record Skipped() implements Rendered {}

  /**
   * There is no OpenGL.
   *
   * @param reason a sentence: what is missing
   * @param remedy a sentence: what to install or to set
   */
  record Unavailable(String reason, String remedy) implements Rendered {}

  /**
   * How a picture was made.
   *
   * @param seconds from taking the request to having the pixels
   * @param points drawn
   * @param pointsLeftOut by thinning
   * @param triangles drawn
   * @param trianglesLeftOut by thinning
   * @param uploadedBytes sent to the graphics card for this picture
   * @param residentBytes held there for this scene
   */
  record Figures(double seconds, long points, long pointsLeftOut, long triangles, long trianglesLeftOut,
      long uploadedBytes, long residentBytes) {
    /**
     * Whether a picture of the same without thinning looks the same.
     *
     * @return true where nothing was left out
     */
    public boolean complete() {
      return pointsLeftOut == 0 && trianglesLeftOut == 0;
    }
  }
}
