package org.robotui.rfic.yarp.internal.convert;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.geometry.RigidTransform;
import org.robotui.net.packed.Zlib;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.YarpValue;

/**
 * Questions to servers of navigation, localisation and maps, and their answers, as YARP 3.9 and 4.0 have them: the
 * former begin an answer with a word, the latter with a list of one, which begins answers that are alone as well.
 */
public final class NavigationForms {
  private static final int LONGEST_VOCAB = 4;
  private static final int MAP_PARTS = 10;
  private static final int MOST_CELLS = 1 << 26;
  private static final int CERTAIN = 100;
  private static final int BYTE = 0xff;

  private NavigationForms() {}

  /** A question by the name of its function: the words between underscores, the short ones as vocabularies. */
  public static Bottle question(String function, YarpValue... arguments) {
    List<YarpValue> values = new ArrayList<>();
    for (String word : function.split("_")) {
      values.add(word.length() <= LONGEST_VOCAB ? YarpValue.Vocab.of(word) : new YarpValue.Text(word));
    }
    values.addAll(List.of(arguments));
    return new Bottle(values, 0);
  }

  /** Whether an answer says that all is well; else it may be any other word. */
  public static boolean isDone(Bottle answer) {
    YarpValue first = answer.get(0);
    return (first instanceof Bottle list ? list.get(0) : first).text().equals("ok");
  }

  /** A place on a map; its angle is in degrees. */
  public static Bottle location(String map, RigidTransform pose) {
    return Bottle.of(map, pose.translation().x(), pose.translation().y(), Math.toDegrees(pose.rotation().yaw()), "");
  }

  /** What navigation says of a goal; empty where it says that it has none. */
  public static Optional<NavigationStatus.State> state(Bottle answer) {
    String word = answer.get(1).text();
    return switch (word) {
      case "idle" -> Optional.empty();
      case "prep", "movg", "wait", "paus", "thnk" -> Optional.of(NavigationStatus.State.ACTIVE);
      case "rech" -> Optional.of(NavigationStatus.State.SUCCEEDED);
      case "abrt" -> Optional.of(NavigationStatus.State.CANCELED);
      case "fail", "err" -> Optional.of(NavigationStatus.State.ABORTED);
      default -> throw new IllegalArgumentException("'" + word + "' is no state of navigation that is known");
    };
  }

  /** A map: sizes, where its lower left corner lies, its cells from the upper left on, maybe packed. */
  public static GridMap map(Bottle m, FrameId frame) {
    double width = m.get(0).number();
    double height = m.get(1).number();
    if (m.size() != MAP_PARTS || !(width >= 1) || !(height >= 1) || width * height > MOST_CELLS
        || !(m.get(8) instanceof YarpValue.Blob cells)) {
      throw new IllegalArgumentException("what came is no map of at most " + MOST_CELLS + " cells, but has " + m.size()
          + " parts, for " + width + " x " + height + " cells");
    }
    RigidTransform origin = RigidTransform.planar(YarpSensing.finite(m, 2), YarpSensing.finite(m, 3),
        YarpSensing.degrees(m, 4));
    byte[] rows = rows(cells.bytes(), m.get(7).number() != 0, (int) width, (int) height);
    return new GridMap(frame, YarpSensing.finite(m, 5), (int) width, (int) height, origin,
        Bytes.wrap(rows, 0, rows.length));
  }

  private static byte[] rows(byte[] cells, boolean packed, int width, int height) {
    byte[] plain = packed ? Zlib.inflate(cells, width * height) : cells;
    if (plain.length != width * height) {
      throw new IllegalArgumentException(plain.length + " bytes are not those of " + width + " x " + height + " cells");
    }
    byte[] rows = new byte[plain.length];
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        int occupied = plain[(height - 1 - y) * width + x] & BYTE;
        rows[y * width + x] = occupied <= CERTAIN ? (byte) occupied : GridMap.UNKNOWN;
      }
    }
    return rows;
  }
}
