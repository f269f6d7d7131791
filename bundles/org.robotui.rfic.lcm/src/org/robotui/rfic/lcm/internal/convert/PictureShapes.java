package org.robotui.rfic.lcm.internal.convert;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.lcm.type.NumberArray;
import org.robotui.lcm.type.Primitive;
import org.robotui.rfic.lcm.internal.language.Field;
import org.robotui.rfic.lcm.internal.language.Form;
import org.robotui.rfic.lcm.internal.language.Quantity;
import org.robotui.rfic.lcm.internal.language.Values;

/** Pictures, maps and clouds. */
final class PictureShapes {
  private static final int PERCENT = 100;
  private static final int FOUR = 4;

  private PictureShapes() {}

  static Stream<Shape<?>> all() {
    return Stream.of(
        new Shape<>(Form.of("image", List.of("data", "encoding"), List.of(Field.bytes("data", "data", "image"),
            Field.text("encoding", "encoding", "pixelformat", "format"), Field.number("width", Quantity.PLAIN, "width"),
            Field.number("height", Quantity.PLAIN, "height"),
            Field.number("step", Quantity.PLAIN, "row_stride", "step"), Field.flag("big_endian"),
            Field.text("frame", "frame"), Field.stamp())), Image.class, PictureShapes::image),
        new Shape<>(Form.of("gridmap", List.of("cells", "resolution"),
            List.of(Field.numbers("cells", Quantity.PLAIN, "cells", "data"),
                Field.number("width", Quantity.PLAIN, "width"), Field.number("height", Quantity.PLAIN, "height"),
                Field.number("resolution", Quantity.LENGTH, "resolution", "meters_per_pixel"),
                Field.number("x", Quantity.LENGTH, "origin[0]", "x0"),
                Field.number("y", Quantity.LENGTH, "origin[1]", "y0"), Field.number("yaw", Quantity.ANGLE, "origin[2]"),
                Field.number("free", Quantity.PLAIN), Field.number("occupied", Quantity.PLAIN),
                Field.number("unknown", Quantity.PLAIN),
                Field.text("frame", "frame"), Field.stamp())),
            GridMap.class, PictureShapes::map),
        new Shape<>(Form.of("pointcloud", List.of("points | x y"), List.of(
            Field.numbers("points", Quantity.LENGTH, "points[].position", "points[].xyz"),
            Field.numbers("x", Quantity.LENGTH, "points[].x", "x").in("points"),
            Field.numbers("y", Quantity.LENGTH, "points[].y", "y").in("points"),
            Field.numbers("z", Quantity.LENGTH, "points[].z", "z").in("points"),
            Field.numbers("intensity", Quantity.PLAIN, "points[].intensity", "intensity"),
            Field.text("frame", "frame"), Field.stamp())), PointCloud.class, PictureShapes::cloud));
  }

  private static Image image(Values v, Reception r) {
    NumberArray data =
        v.array("data").orElseThrow(() -> new IllegalArgumentException("data must be one array of bytes"));
    Bytes bytes = Bytes.wrap(data.bytes());
    String encoding = PixelWords.of(v.text("encoding", ""));
    if (PixelWords.isCompressed(encoding)) {
      return new CompressedImage(r.frame(v.text("frame", "camera")), encoding, bytes);
    }
    PixelEncoding pixels = PixelEncoding.fromRos(encoding)
        .orElseThrow(() -> new IllegalArgumentException("pixels of the encoding '" + encoding
            + "' are not known; known are jpeg, png, rgb8, bgr8, rgba8, bgra8, mono8, mono16, 16UC1, 32FC1, yuv422 and others that ROS names"));
    int width = v.whole("width", 0);
    int step = v.whole("step", 0);
    return new RawImage(r.frame(v.text("frame", "camera")), width, v.whole("height", 0), pixels, v.flag("big_endian"),
        step > 0 ? step : Math.multiplyExact(width, pixels.bytesPerPixel()), bytes);
  }

  private static GridMap map(Values v, Reception r) {
    List<Integer> shape = v.shape("cells");
    int width = v.whole("width", shape.isEmpty() ? 0 : shape.getLast());
    int height = v.whole("height", shape.size() > 1 ? shape.getFirst() : 0);
    RigidTransform origin =
        new RigidTransform(new Vector3(v.number("x", 0), v.number("y", 0), 0), Quaternion.fromYaw(v.number("yaw", 0)));
    if (!origin.translation().isFinite()) {
      throw new IllegalArgumentException("the origin of a map must be finite, is " + origin.translation());
    }
    return new GridMap(r.frame(v.text("frame", "map")), v.number("resolution", 0), width, height, origin, cells(v));
  }

  private static Bytes cells(Values v) {
    boolean plain = !v.has("free") && !v.has("occupied") && !v.has("unknown");
    NumberArray array = v.array("cells").orElse(null);
    if (plain && array != null && array.type() == Primitive.INT8) {
      return Bytes.wrap(array.bytes());
    }
    double free = v.number("free", 0);
    double occupied = v.number("occupied", PERCENT);
    double unknown = v.number("unknown", -1);
    double[] numbers = v.numbers("cells");
    byte[] cells = new byte[numbers.length];
    for (int i = 0; i < cells.length; i++) {
      double share = (numbers[i] - free) / (occupied - free);
      cells[i] = numbers[i] == unknown || Double.isNaN(share) ? GridMap.UNKNOWN
          : (byte) Math.round(Math.clamp(share, 0, 1) * PERCENT);
    }
    return Bytes.wrap(cells, 0, cells.length);
  }

  private static PointCloud cloud(Values v, Reception r) {
    int count = v.has("x") ? v.numbers("x").length : rows(v);
    Poses.Rows points = Poses.Rows.of(v, "points", count);
    double[] xs = axis(v, "x", count);
    double[] ys = axis(v, "y", count);
    double[] zs = axis(v, "z", count);
    double[] intensity = axis(v, "intensity", count);
    List<PointField> fields = new ArrayList<>();
    Stream.of("x", "y", "z").forEach(name -> fields.add(field(name, fields.size())));
    if (intensity.length > 0) {
      fields.add(field("intensity", fields.size()));
    }
    int step = fields.size() * Float.BYTES;
    ByteBuffer bytes = ByteBuffer.allocate(Math.multiplyExact(step, count)).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count; i++) {
      bytes.putFloat((float) (xs.length > 0 ? xs[i] : points.at(i, 0)))
          .putFloat((float) (ys.length > 0 ? ys[i] : points.at(i, 1)))
          .putFloat((float) (zs.length > 0 ? zs[i] : points.at(i, 2)));
      if (intensity.length > 0) {
        bytes.putFloat((float) intensity[i]);
      }
    }
    return new PointCloud(r.frame(v.text("frame", "base")), count, 1, fields, step, bytes.capacity(),
        ByteOrder.LITTLE_ENDIAN, false,
        Bytes.wrap(bytes.flip()));
  }

  /** A flat array has three numbers a point. */
  private static int rows(Values v) {
    int rows = v.rows("points");
    int numbers = v.numbers("points").length;
    return rows > 1 || numbers < FOUR ? Math.min(rows, numbers) : numbers / 3;
  }

  private static double[] axis(Values v, String field, int count) {
    double[] numbers = v.numbers(field);
    if (v.has(field) && numbers.length != count) {
      throw new IllegalArgumentException(field + " has " + numbers.length + " numbers for " + count + " points");
    }
    return numbers;
  }

  private static PointField field(String name, int index) {
    return new PointField(name, index * Float.BYTES, PointField.Format.FLOAT32, 1);
  }

  /** The names of encodings. */
  private static final class PixelWords {
    static String of(String written) {
      String word = written.matches("-?\\d+") ? fourCharacters(Long.parseLong(written)) : written;
      return switch (word.toUpperCase(Locale.ROOT)) {
        case "MJPG", "JPG", "JPEG", "MJPEG" -> "jpeg";
        case "PNG" -> "png";
        case "GREY", "GRAY", "GRAY8", "Y800" -> "mono8";
        case "Y16", "Y16 " -> "mono16";
        case "RGB3", "RGB" -> "rgb8";
        case "BGR3", "BGR" -> "bgr8";
        case "RGB4", "RGBA" -> "rgba8";
        case "BGR4", "BGRA" -> "bgra8";
        case "YUYV" -> "yuyv";
        case "UYVY" -> "uyvy";
        default -> word;
      };
    }

    static boolean isCompressed(String encoding) {
      return encoding.equals("jpeg") || encoding.equals("png");
    }

    /** Cameras name their formats by four characters in one number. */
    private static String fourCharacters(long number) {
      StringBuilder word = new StringBuilder();
      for (int i = 0; i < FOUR; i++) {
        int character = (int) (number >> Byte.SIZE * i & 0xff);
        word.append(character >= ' ' && character < 0x7f ? (char) character : '?');
      }
      return word.toString();
    }
  }
}
