package org.robotui.uic.map.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;

/** Reads maps of the navigation stack, binary PGM in three values. */
final class MapFiles {
  private static final int FREE_ABOVE = 206;
  private static final int OCCUPIED_BELOW = 90;

  private MapFiles() {}

  static GridMap pgm(Path file, double resolution, RigidTransform origin, FrameId frame) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    int[] at = {2};
    int width = number(bytes, at);
    int height = number(bytes, at);
    number(bytes, at);
    int start = at[0] + 1;
    byte[] cells = new byte[width * height];
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        int grey = bytes[start + (height - 1 - row) * width + column] & 0xff;
        cells[row * width + column] = (byte) (grey > FREE_ABOVE ? 0 : grey < OCCUPIED_BELOW ? 100 : -1);
      }
    }
    return new GridMap(frame, resolution, width, height, origin, Bytes.wrap(cells, 0, cells.length));
  }

  private static int number(byte[] bytes, int[] at) {
    while (Character.isWhitespace(bytes[at[0]]) || bytes[at[0]] == '#') {
      at[0]++;
      if (bytes[at[0] - 1] == '#') {
        while (bytes[at[0]] != '\n') {
          at[0]++;
        }
      }
    }
    int value = 0;
    while (Character.isDigit(bytes[at[0]])) {
      value = 10 * value + bytes[at[0]++] - '0';
    }
    return value;
  }
}
