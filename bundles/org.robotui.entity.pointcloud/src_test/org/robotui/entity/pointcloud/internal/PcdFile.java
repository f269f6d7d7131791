package org.robotui.entity.pointcloud.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.testkit.display.FakePlaces;

/** Reads files of the Point Cloud Library whose fields are floats: as text, or compressed field by field. */
final class PcdFile {
  private static final int LITERALS = 32;
  private static final int LONGER = 7;

  private PcdFile() {}

  static PointCloud read(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    Map<String, String> head = new HashMap<>();
    int at = 0;
    while (!head.containsKey("DATA")) {
      int end = at;
      while (bytes[end] != '\n') {
        end++;
      }
      String[] line = new String(bytes, at, end - at, StandardCharsets.US_ASCII).split(" ", 2);
      head.put(line[0], line[1].strip());
      at = end + 1;
    }
    String[] names = head.get("FIELDS").split(" ");
    int count = Integer.parseInt(head.get("POINTS"));
    ByteBuffer body = ByteBuffer.wrap(bytes, at, bytes.length - at).slice().order(ByteOrder.LITTLE_ENDIAN);
    ByteBuffer points = switch (head.get("DATA")) {
      case "ascii" -> text(body);
      case "binary_compressed" -> points(unpacked(body), names.length, count);
      default -> throw new IOException(file + ": DATA " + head.get("DATA"));
    };
    return cloud(names, Integer.parseInt(head.get("WIDTH")), Integer.parseInt(head.get("HEIGHT")), points);
  }

  private static PointCloud cloud(String[] names, int width, int height, ByteBuffer points) {
    List<PointField> fields = new ArrayList<>();
    for (String name : names) {
      fields.add(Clouds.field(name, Float.BYTES * fields.size(), PointField.Format.FLOAT32));
    }
    int step = Float.BYTES * names.length;
    return new PointCloud(FakePlaces.frame("lidar"), width, height, fields, step, step * width, points.order(), false,
        Bytes.wrap(points.array(), 0,
            points.capacity()));
  }

  private static ByteBuffer text(ByteBuffer body) {
    String[] words = StandardCharsets.US_ASCII.decode(body).toString().strip().split("\\s+");
    ByteBuffer out = ByteBuffer.allocate(Float.BYTES * words.length).order(ByteOrder.LITTLE_ENDIAN);
    for (String word : words) {
      out.putFloat(Float.parseFloat(word));
    }
    return out;
  }

  /** From all x, then all y, and so on, to point after point. */
  private static ByteBuffer points(ByteBuffer byField, int fields, int count) {
    ByteBuffer out = ByteBuffer.allocate(byField.capacity()).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count * fields; i++) {
      out.putInt(Float.BYTES * (i % count * fields + i / count), byField.getInt(Float.BYTES * i));
    }
    return out;
  }

  /**
   * LZF: a control byte below 32 is followed by that many literals and one; another repeats what lies some bytes back.
   */
  private static ByteBuffer unpacked(ByteBuffer in) {
    int end = Integer.BYTES * 2 + in.getInt();
    ByteBuffer out = ByteBuffer.allocate(in.getInt()).order(ByteOrder.LITTLE_ENDIAN);
    while (in.position() < end) {
      int control = in.get() & 0xff;
      if (control < LITERALS) {
        out.put(in.slice(in.position(), control + 1));
        in.position(in.position() + control + 1);
      } else {
        int length = control >>> 5;
        length += (length == LONGER ? in.get() & 0xff : 0) + 2;
        int back = ((control & 0x1f) << Byte.SIZE | in.get() & 0xff) + 1;
        for (int i = 0; i < length; i++) {
          out.put(out.get(out.position() - back));
        }
      }
    }
    return out;
  }
}
