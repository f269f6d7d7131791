package org.robotui.core.internal.port;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.robotui.data.Data;
import org.robotui.data.geometry.Footprint;
import org.robotui.data.geometry.Pose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.geometry.Twist;
import org.robotui.data.image.CameraInfo;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.navigation.Path;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.RangeReading;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.geometry.RigidTransform;

/** A short text of a value, for lists of ports. */
public final class ValueText {
  private static final int LONGEST = 60;
  /** So much of a text is looked at: one of a megabyte would take milliseconds, at each look at the ports. */
  private static final int SEEN = 1000;
  private static final int FIELDS = 3;
  private static final int DIGITS = 3;
  private static final int PERCENT = 100;

  private ValueText() {}

  /** A text of at most 60 characters in one line. */
  public static String of(Data value) {
    String text = begin(text(value)).replaceAll("\\p{Cntrl}+", " ").strip();
    return text.length() <= LONGEST ? text : text.substring(0, LONGEST - 1) + "…";
  }

  private static String begin(String text) {
    return text.length() <= SEEN ? text : text.substring(0, SEEN);
  }

  private static String text(Data value) {
    return switch (value) {
      case LaserScan scan -> scan.ranges().size() + " beams" + nearest(scan);
      case RangeReadings readings -> readings.readings().size() + " ranges" + nearest(readings);
      case Bumpers bumpers -> bumpers.bumpers().size() + " bumpers, "
          + (bumpers.pressed() == 0 ? "free" : bumpers.pressed() + " pressed");
      case RawImage image -> image.width() + "x" + image.height() + " "
          + image.encoding().name().toLowerCase(Locale.ROOT);
      case CompressedImage image -> image.format() + ", " + size(image.data().size());
      case CameraInfo info -> info.width() + "x" + info.height() + " " + info.distortionModel();
      case PointCloud cloud -> cloud.size() + " points";
      case GridMap map -> map.width() + "x" + map.height() + " cells, " + figure(map.resolution()) + " m";
      case Footprint outline -> outline.corners().size() + " corners";
      case Path path -> path.poses().size() + " poses";
      case TransformSet set -> set.transforms().size() + " transforms";
      case JointState joints -> joints.joints().size() + " joints";
      case Battery battery -> battery(battery);
      case GpsFix fix -> gps(fix);
      case Imu imu -> imu(imu);
      case Diagnostics diagnostics -> diagnostics(diagnostics);
      case NavigationStatus status -> status.state().name().toLowerCase(Locale.ROOT)
          + (status.text().isEmpty() ? "" : ": " + status.text());
      case LogEntry entry -> entry.severity() + " " + entry.origin() + ": " + entry.message();
      case Pose pose -> planar(pose.pose());
      case Twist twist -> format("%.2f m/s %.2f rad/s", twist.linear().x(), twist.angular().z());
      case DynamicRecord dynamic -> dynamic(dynamic);
      default -> value.getClass().getSimpleName();
    };
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values).replace('-', '−');
  }

  /** At most three significant digits, and no zeros behind them. */
  private static String figure(double value) {
    return new BigDecimal(value).round(new MathContext(DIGITS)).stripTrailingZeros().toPlainString();
  }

  private static String nearest(LaserScan scan) {
    float nearest = Float.POSITIVE_INFINITY;
    for (int i = 0; i < scan.ranges().size(); i++) {
      nearest = scan.isEcho(i) ? Math.min(nearest, scan.ranges().get(i)) : nearest;
    }
    return Float.isFinite(nearest) ? format(", min %.2f m", nearest) : ", no echo";
  }

  private static String nearest(RangeReadings readings) {
    return readings.readings().stream().filter(RangeReading::isEcho).mapToDouble(RangeReading::range).min().stream()
        .mapToObj(r -> format(", min %.2f m", r)).findFirst().orElse(", no echo");
  }

  private static String planar(RigidTransform pose) {
    double yaw = Math.toDegrees(pose.rotation().yaw());
    return format("x %.2f y %.2f m %.0f°", pose.translation().x(), pose.translation().y(), yaw);
  }

  private static String battery(Battery battery) {
    String charge = Double.isNaN(battery.charge()) ? "" : format("%.0f %% ", battery.charge() * PERCENT);
    return charge + (Double.isNaN(battery.voltage()) ? "" : format("%.1f V", battery.voltage()));
  }

  private static String gps(GpsFix fix) {
    boolean known = fix.quality() != GpsFix.Quality.NO_FIX;
    return known
        ? format("%.6f° %.6f°", Math.toDegrees(fix.latitude()), Math.toDegrees(fix.longitude()))
        : "no fix";
  }

  private static String imu(Imu imu) {
    return imu.orientation()
        .map(q -> format("roll %.0f° pitch %.0f° yaw %.0f°",
            Math.toDegrees(q.roll()), Math.toDegrees(q.pitch()), Math.toDegrees(q.yaw())))
        .or(() -> imu.angularVelocity().map(w -> format("turning %.2f rad/s", w.norm())))
        .orElse("no orientation");
  }

  private static String diagnostics(Diagnostics diagnostics) {
    List<Diagnostics.Item> bad =
        diagnostics.items().stream().filter(i -> i.level() != Diagnostics.Level.OK).toList();
    return diagnostics.items().size() + " items" + (bad.isEmpty() ? ", all ok"
        : ", " + bad.size() + " not ok: "
            + bad.getFirst().name() + " " + bad.getFirst().message());
  }

  private static String size(int bytes) {
    return bytes < 1 << 10 ? bytes + " B" : (bytes >> 10) + " kB";
  }

  private static String dynamic(DynamicRecord value) {
    String numbers = value.fields().stream()
        .flatMap(name -> value.field(name).flatMap(ValueText::plain).map(v -> name + " " + v).stream())
        .limit(FIELDS).collect(Collectors.joining(" "));
    return numbers.isEmpty() ? value.schema() : numbers;
  }

  private static Optional<String> plain(FieldValue value) {
    Function<Object, Optional<String>> text = v -> Optional.of(v.toString());
    return switch (value) {
      case FieldValue.Num n -> text.apply(n.exact());
      case FieldValue.Flag f -> text.apply(f.value());
      case FieldValue.Text t -> text.apply("'" + begin(t.value()) + "'");
      case FieldValue.Numbers n -> text.apply("[" + n.values().size() + "]");
      default -> Optional.empty();
    };
  }
}
