package org.robotui.gl.internal.splat;

/** Which corners of triangles lie at each place. */
final class Stars {
  private final int[] first;
  private final int[] corners;

  /**
   * Sorts corners by their places.
   *
   * @param placesOf the place of each corner
   * @param count of corners that there are
   * @param places how many
   */
  Stars(int[] placesOf, int count, int places) {
    first = new int[places + 1];
    corners = new int[count];
    for (int i = 0; i < count; i++) {
      first[placesOf[i] + 1]++;
    }
    for (int i = 0; i < places; i++) {
      first[i + 1] += first[i];
    }
    int[] next = first.clone();
    for (int i = 0; i < count; i++) {
      corners[next[placesOf[i]]++] = i;
    }
  }

  /** Where the corners of a place begin. */
  int begin(int place) {
    return first[place];
  }

  /** Behind the last corner of a place. */
  int end(int place) {
    return first[place + 1];
  }

  /** One of the corners, from {@link #begin} to before {@link #end}. */
  int corner(int at) {
    return corners[at];
  }
}
