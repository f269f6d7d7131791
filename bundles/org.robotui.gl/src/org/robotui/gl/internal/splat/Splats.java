package org.robotui.gl.internal.splat;

import java.util.Arrays;

/**
 * Pixels with their depths, into which points are written by the processor. Where OpenGL is software, that takes a tenth of the time that points
 * take there: most of it goes into what points do not need.
 */
public final class Splats {
  /** The depth where nothing is. */
  public static final float NOTHING = 1;

  private final int width;
  private final int height;
  private final boolean picking;
  private int[] values = {};
  private int[] parts = {};
  private float[] depths = {};
  private boolean used;

  /**
   * Takes no memory yet.
   *
   * @param width pixels
   * @param height rows
   * @param picking whether values are elements, and parts are kept too
   */
  public Splats(int width, int height, boolean picking) {
    this.width = width;
    this.height = height;
    this.picking = picking;
  }

  /** Forgets what was written. */
  public void clear() {
    used = false;
  }

  /**
   * Whether anything may have been written.
   *
   * @return false where nothing was
   */
  public boolean used() {
    return used;
  }

  /** Takes the memory, and says that something will be written. */
  void use() {
    if (used) {
      return;
    }
    if (depths.length == 0) {
      depths = new float[width * height];
      values = new int[width * height];
      parts = new int[picking ? width * height : 0];
    }
    Arrays.fill(depths, NOTHING);
    used = true;
  }

  /** Writes one pixel, unless something nearer is there. */
  void put(int x, int y, float depth, int value, int part) {
    int at = y * width + x;
    if (depth < depths[at]) {
      depths[at] = depth;
      values[at] = value;
      if (picking) {
        parts[at] = part;
      }
    }
  }

  /**
   * How near the point at a pixel is.
   *
   * @param pixel counted by rows from the top
   * @return as OpenGL keeps it; {@link #NOTHING} where there is none
   */
  public float depth(int pixel) {
    return used ? depths[pixel] : NOTHING;
  }

  /**
   * Which point is at a pixel.
   *
   * @param pixel where there is one
   * @return the element
   */
  public int element(int pixel) {
    return values[pixel];
  }

  /**
   * Of which part the point at a pixel is.
   *
   * @param pixel where there is one
   * @return the id of the part
   */
  public int part(int pixel) {
    return parts[pixel];
  }

  /**
   * The size.
   *
   * @return pixels of a row
   */
  public int width() {
    return width;
  }

  /**
   * The size.
   *
   * @return rows
   */
  public int height() {
    return height;
  }

  boolean picking() {
    return picking;
  }

  int[] values() {
    return values;
  }

  float[] depths() {
    return depths;
  }
}
