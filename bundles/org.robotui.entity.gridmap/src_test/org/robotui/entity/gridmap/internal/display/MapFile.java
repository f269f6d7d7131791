package org.robotui.entity.gridmap.internal.display;

import java.awt.image.BufferedImage;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Scanner;
import javax.imageio.ImageIO;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.display.FakePlaces;

/** Reads the maps that map_server reads: a picture, and a text of keys that says what its greys mean. */
final class MapFile {
  private static final int WHITE = 255;

  private final Map<String, String> keys = new HashMap<>();

  private MapFile() {}

  static GridMap read(Path yaml) throws IOException {
    MapFile map = new MapFile();
    for (String line : Files.readAllLines(yaml)) {
      String[] parts = line.split(":", 2);
      if (parts.length == 2) {
        map.keys.put(parts[0].strip(), parts[1].strip());
      }
    }
    Path picture = yaml.resolveSibling(map.keys.get("image"));
    return map.of(picture.toString().endsWith(".pgm") ? pgm(Files.readAllBytes(picture)) : grey(picture));
  }

  /** Of a picture whose first row is the one farthest from the origin. */
  private GridMap of(int[][] grey) {
    double occupied = Double.parseDouble(keys.get("occupied_thresh"));
    double free = Double.parseDouble(keys.get("free_thresh"));
    int width = grey[0].length;
    byte[] cells = new byte[width * grey.length];
    for (int row = 0; row < grey.length; row++) {
      for (int column = 0; column < width; column++) {
        double dark = (WHITE - grey[grey.length - 1 - row][column]) / (double) WHITE;
        cells[row * width + column] = dark > occupied ? 100 : dark < free ? 0 : GridMap.UNKNOWN;
      }
    }
    double[] origin = Arrays.stream(keys.get("origin").replaceAll("[\\[\\]]", "").split(","))
        .mapToDouble(Double::parseDouble).toArray();
    return new GridMap(FakePlaces.frame("map"), Double.parseDouble(keys.get("resolution")), width, grey.length,
        RigidTransform.planar(origin[0], origin[1], origin[2]), Bytes.of(cells));
  }

  private static int[][] pgm(byte[] file) {
    String head = new String(file, StandardCharsets.ISO_8859_1).replaceAll("#[^\n]*", "");
    try (Scanner words = new Scanner(head)) {
      words.next("P5");
      int width = words.nextInt();
      int height = words.nextInt();
      int[][] grey = new int[height][width];
      for (int i = 0, at = file.length - width * height; i < width * height; i++) {
        grey[i / width][i % width] = file[at + i] & 0xff;
      }
      return grey;
    }
  }

  private static int[][] grey(Path picture) throws IOException {
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(Files.readAllBytes(picture)));
    Raster raster = image.getRaster();
    int[][] grey = new int[image.getHeight()][image.getWidth()];
    for (int y = 0; y < grey.length; y++) {
      for (int x = 0; x < grey[y].length; x++) {
        grey[y][x] =
            (int) Math.round(Arrays.stream(raster.getPixel(x, y, (int[]) null)).limit(3).average().orElseThrow());
      }
    }
    return grey;
  }
}
