package org.robotui.gl.internal.splat;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Arrays;

/**
 * Pixels with their depths, into which points and small triangles are written by the processor. Where OpenGL is
 * software, that takes a tenth of the time that they take there: most of it goes into what they do not need.
 */
public final class Splats {
  /** The depth where nothing is. */
  public static final float NOTHING = 1;

  private static final long VALUE = 0xffffffffL;
  /**
   * Pixels beyond the left and upper edge, as far as is looked at; a number small enough to leave a float its
   * hundredths of pixels.
   */
  private static final int FAR = 4096;

  private final int width;
  private final int height;
  private final boolean picking;
  /**
   * Bits of the depth above those of the value. Depths are not negative: the smaller number is the nearer point, and
   * its value comes with it.
   */
  private long[] cells = {};
  private int[] parts = {};
  private final FacetBuffers buffers = new FacetBuffers();
  private int background;
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

  /**
   * Forgets what was written.
   *
   * @param value of pixels where nothing will be
   */
  public void clear(int value) {
    background = value;
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
    if (cells.length == 0) {
      cells = new long[width * height];
      parts = new int[picking ? width * height : 0];
    }
    Arrays.fill(cells, cell(NOTHING, background));
    used = true;
  }

  /** Room for what is computed of a mesh; its next user overwrites it. */
  FacetBuffers buffers(Facets facets) {
    buffers.fit(facets.placeCount(), facets.normalCount(), facets.count());
    return buffers;
  }

  /** What was written: the bits of the depth above those of the value. The least is what is seen. */
  long[] cells() {
    return cells;
  }

  /** A value with its depth, of at least 0. */
  static long cell(float depth, int value) {
    return (long) Float.floatToRawIntBits(depth) << Integer.SIZE | value & VALUE;
  }

  /**
   * The first pixel whose middle is not before a place. Casting rounds towards 0, which is down for what is moved far
   * enough.
   */
  static int firstPixel(float place) {
    return (int) (Math.max(place, -FAR) + FAR + 0.5f) - FAR;
  }

  /** Writes a square of pixels, which must lie within, where nothing nearer is. */
  void put(int left, int top, int right, int bottom, long cell, int part) {
    if (picking) {
      for (int row = top; row < bottom; row++) {
        for (int column = left; column < right; column++) {
          put(row * width + column, cell, part);
        }
      }
      return;
    }
    long[] all = cells;
    int end = bottom * width;
    for (int from = top * width + left, to = top * width + right; from < end; from += width, to += width) {
      for (int at = from; at < to; at++) {
        all[at] = Math.min(all[at], cell);
      }
    }
  }

  /** Writes one pixel, unless something nearer is there. */
  void put(int at, long cell, int part) {
    if (cell < cells[at]) {
      cells[at] = cell;
      if (picking) {
        parts[at] = part;
      }
    }
  }

  /**
   * Hands out values.
   *
   * @param first pixel, counted by rows
   * @param count of pixels
   * @param into from its start
   */
  public void values(int first, int count, IntBuffer into) {
    for (int i = 0; i < count; i++) {
      into.put(i, (int) cells[first + i]);
    }
  }

  /**
   * Hands out all values, row by row.
   *
   * @param into as many as there are pixels, at least
   */
  public void values(int[] into) {
    for (int i = 0; i < cells.length; i++) {
      into[i] = (int) cells[i];
    }
  }

  /**
   * Hands out depths.
   *
   * @param first pixel, counted by rows
   * @param count of pixels
   * @param into from its start; as OpenGL keeps them
   */
  public void depths(int first, int count, FloatBuffer into) {
    for (int i = 0; i < count; i++) {
      into.put(i, depth(first + i));
    }
  }

  /**
   * How near the point at a pixel is.
   *
   * @param pixel counted by rows
   * @return as OpenGL keeps it; {@link #NOTHING} where there is none
   */
  public float depth(int pixel) {
    return used ? Float.intBitsToFloat((int) (cells[pixel] >>> Integer.SIZE)) : NOTHING;
  }

  /**
   * Which point is at a pixel.
   *
   * @param pixel where there is one
   * @return the element
   */
  public int element(int pixel) {
    return (int) cells[pixel];
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
}
